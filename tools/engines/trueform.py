#!/usr/bin/env python3
"""trueform (https://github.com/polydera/trueform), meshes in doubles. No symmetric difference of its own."""
from engine import main, xor_by_differences


def pair(operation, a, b):
    import numpy
    import trueform as api
    meshes = [api.Mesh(numpy.ascontiguousarray(t, numpy.int32), numpy.ascontiguousarray(v)) for v, t in (a, b)]
    (triangles, vertices), *_ = getattr(api, "boolean_" + operation)(*meshes)
    return numpy.array(vertices), numpy.array(triangles).astype(numpy.int64)


def run(operation, a, b):
    return xor_by_differences(pair, a, b) if operation == "symmetric-difference" else pair(operation, a, b)


if __name__ == "__main__":
    import sys
    sys.path.pop(0)  # this folder: the package has the name of this file
    main("trueform trueform", run)
