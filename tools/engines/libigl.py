#!/usr/bin/env python3
"""libigl (https://libigl.github.io), its Booleans over CGAL: exact inside, results rounded to doubles."""
from engine import Refused, main


def run(operation, a, b):
    import numpy
    from igl.copyleft import cgal
    word = {"union": "union", "intersection": "intersect", "difference": "minus", "symmetric-difference": "xor"}[operation]
    try:
        vertices, triangles, _ = cgal.mesh_boolean(*a, *b, word)
    except RuntimeError as error:
        raise Refused(str(error)) from error
    return numpy.asarray(vertices).reshape(-1, 3), numpy.asarray(triangles).reshape(-1, 3)


if __name__ == "__main__":
    main("libigl igl.copyleft.cgal", run)
