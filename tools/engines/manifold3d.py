#!/usr/bin/env python3
"""Manifold (https://github.com/elalish/manifold), meshes in doubles. No symmetric difference of its own."""
from engine import Refused, main, xor_by_differences


def solid(api, mesh):
    import numpy
    made = api.Manifold(api.Mesh64(numpy.array(mesh[0]), mesh[1].astype(numpy.uint64)))
    if made.status() != api.Error.NoError:
        raise Refused(str(made.status()))
    return made


def pair(operation, a, b):
    import manifold3d as api
    import numpy
    kind = {"union": api.OpType.Add, "intersection": api.OpType.Intersect, "difference": api.OpType.Subtract}[operation]
    whole = api.Manifold.batch_boolean([solid(api, a), solid(api, b)], kind)
    if whole.status() != api.Error.NoError:
        raise Refused(str(whole.status()))
    mesh = whole.to_mesh64()
    vertices, triangles = numpy.asarray(mesh.vert_properties)[:, :3], numpy.asarray(mesh.tri_verts).astype(numpy.int64)
    if len(mesh.merge_from_vert):
        same = numpy.arange(len(vertices))
        same[numpy.asarray(mesh.merge_from_vert, numpy.int64)] = numpy.asarray(mesh.merge_to_vert, numpy.int64)
        triangles = same[triangles]
    return vertices, triangles


def run(operation, a, b):
    return xor_by_differences(pair, a, b) if operation == "symmetric-difference" else pair(operation, a, b)


if __name__ == "__main__":
    import sys
    sys.path.pop(0)  # this folder: the package has the name of this file
    main("manifold3d manifold3d", run)
