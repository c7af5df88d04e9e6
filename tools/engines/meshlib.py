#!/usr/bin/env python3
"""MeshLib (https://meshlib.io), whose coordinates are floats. No symmetric difference of its own."""
from engine import Refused, main, xor_by_differences


def pair(operation, a, b):
    import numpy
    from meshlib import mrmeshnumpy, mrmeshpy
    kind = {"union": mrmeshpy.BooleanOperation.Union, "intersection": mrmeshpy.BooleanOperation.Intersection,
            "difference": mrmeshpy.BooleanOperation.DifferenceAB}[operation]
    meshes = [mrmeshnumpy.meshFromFacesVerts(t.astype(numpy.int32), v) for v, t in (a, b)]
    result = mrmeshpy.boolean(*meshes, kind)
    if not result.valid():
        raise Refused(result.errorString)
    result.mesh.pack()
    return mrmeshnumpy.getNumpyVerts(result.mesh), mrmeshnumpy.getNumpyFaces(result.mesh.topology).astype(numpy.int64)


def run(operation, a, b):
    return xor_by_differences(pair, a, b) if operation == "symmetric-difference" else pair(operation, a, b)


if __name__ == "__main__":
    import sys
    sys.path.pop(0)  # this folder: the package has the name of this file
    main("meshlib meshlib", run, floats=True)
