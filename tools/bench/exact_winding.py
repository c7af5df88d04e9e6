"""Winding numbers and volumes of meshes of doubles, exact and independent of the library: integers of Python, one ray per point."""
import fractions
import random

import numpy


def integers(*arrays):
    """All numbers times one power of two, as integers of any length; the exponent of that power."""
    parts = [numpy.frexp(numpy.asarray(array, float)) for array in arrays]
    exponent = max([int((53 - power[fraction != 0]).max(initial=0)) for fraction, power in parts])
    made = []
    for fraction, power in parts:
        digits = (fraction * 2.0**53).astype(numpy.int64).astype(object)
        made.append(digits << numpy.where(fraction != 0, exponent - 53 + power, 0).astype(object))
    return made, exponent


def volume(vertices, triangles):
    """Signed, of a closed mesh: a fraction."""
    (points,), exponent = integers(vertices)
    a, b, c = (points[numpy.asarray(triangles)[:, k]] for k in range(3))
    sixfold = (a[:, 0] * (b[:, 1] * c[:, 2] - b[:, 2] * c[:, 1]) + a[:, 1] * (b[:, 2] * c[:, 0] - b[:, 0] * c[:, 2]) +
               a[:, 2] * (b[:, 0] * c[:, 1] - b[:, 1] * c[:, 0])).sum()
    return fractions.Fraction(int(sixfold), 6 * 2**(3 * exponent))


class Degenerate(Exception):
    """The ray meets an edge or a vertex, or the point is on a face."""


def number_of_origin(points, triangles, direction):
    """By the ray from the origin along `direction`, whose last coordinate is positive."""
    x = points[:, 0] * direction[2] - points[:, 2] * direction[0]  # the ray is the half line x = y = 0, z > 0
    y = points[:, 1] * direction[2] - points[:, 2] * direction[1]
    z = points[:, 2]
    near = numpy.ones(len(triangles), bool)
    for side in (x >= 0, x <= 0, y >= 0, y <= 0):
        near &= side.astype(bool)[triangles].any(axis=1)
    total = 0
    for corners in triangles[near]:
        (ax, ay, az), (bx, by, bz), (cx, cy, cz) = ((x[v], y[v], z[v]) for v in corners)
        of_c, of_a, of_b = ax * by - ay * bx, bx * cy - by * cx, cx * ay - cy * ax  # barycentric coordinates of the ray
        if min(of_a, of_b, of_c) < 0 < max(of_a, of_b, of_c):
            continue
        height = az * of_a + bz * of_b + cz * of_c
        if of_a == 0 or of_b == 0 or of_c == 0 or height == 0:
            raise Degenerate
        upwards = of_a > 0
        if (height > 0) == upwards:
            total += 1 if upwards else -1
    return total


def winding_number(point, vertices, triangles):
    """How often a mesh goes round a point, three doubles. Raises Degenerate for a point on a face."""
    (points, origin), _ = integers(vertices, [point])
    generator = random.Random(1)
    for attempt in range(20):
        try:
            direction = generator.randrange(-997, 998), generator.randrange(-997, 998), 1009
            return number_of_origin(points - origin[0], numpy.asarray(triangles), direction)
        except Degenerate:
            if attempt == 19:
                raise


if __name__ == "__main__":  # a tetrahedron, once and three times
    corner = numpy.array([[0, 0, 0], [4, 0, 0], [0, 4, 0], [0, 0, 4.5]]), numpy.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
    assert volume(*corner) == 12
    assert winding_number([1, 1, 1], *corner) == 1 and winding_number([3, 3, 3], *corner) == 0
    assert winding_number([1, 1, 1], corner[0], numpy.tile(corner[1], (3, 1))[:, ::-1]) == -3
    assert winding_number([1, 1, 1e-300], *corner) == 1 and winding_number([1, 1, -1e-300], *corner) == 0
