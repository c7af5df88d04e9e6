"""Exact volumes of Boolean expressions about solids that are made of convex parts, in fractions.

An answer that owes nothing to the library: space is cut into tetrahedra by the planes of the parts, one after the
other, and every tetrahedron lies inside or outside of every solid.
"""
from fractions import Fraction


def subtract(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def volume(tetrahedron):
    a, b, c, d = tetrahedron
    return abs(dot(cross(subtract(b, a), subtract(c, a)), subtract(d, a))) / 6


class ConvexPart:
    """The hull of outward planar faces: half spaces n.x <= d, and tetrahedra over the faces from one corner."""

    def __init__(self, points, faces):
        points = [tuple(Fraction(x) for x in p) for p in points]
        self.half_spaces, self.tetrahedra = [], []
        for face in faces:
            corners = [points[i] for i in face]
            normal = face_normal(corners)
            plane = (normal, dot(normal, corners[0]))
            if plane not in self.half_spaces:
                self.half_spaces.append(plane)
            for b, c in zip(corners[1:], corners[2:]):
                tetrahedron = (points[faces[0][0]], corners[0], b, c)
                if volume(tetrahedron):
                    self.tetrahedra.append(tetrahedron)


def face_normal(corners):
    """Of a convex polygon: of its first three corners that are not on a line."""
    for b, c in zip(corners[1:], corners[2:]):
        normal = cross(subtract(b, corners[0]), subtract(c, corners[0]))
        if any(normal):
            return normal
    raise ValueError("a face of zero area")


class TooLong(Exception):
    """An expression needs more cuts than are worth their time."""


class Budget:
    """How many tetrahedra may be looked at for one expression."""
    left = 6_000

    def take(self):
        self.left -= 1
        if self.left < 0:
            raise TooLong


def split(tetrahedron, plane, budget):
    """The tetrahedra on the inner and those on the outer side of a plane."""
    normal, d = plane
    inside, outside, todo = [], [], [tetrahedron]
    while todo:
        t = todo.pop()
        budget.take()
        heights = [dot(normal, p) - d for p in t]
        low = next((i for i in range(4) if heights[i] < 0), None)
        high = next((i for i in range(4) if heights[i] > 0), None)
        if high is None:
            inside.append(t)
        elif low is None:
            outside.append(t)
        else:
            at = heights[low] / (heights[low] - heights[high])
            middle = tuple(p + at * (q - p) for p, q in zip(t[low], t[high]))
            todo += [t[:high] + (middle,) + t[high + 1:], t[:low] + (middle,) + t[low + 1:]]
    return inside, outside


def cut_by_part(tetrahedra, part, budget):
    """What of the tetrahedra is in a convex part, and what is not."""
    inside, outside = list(tetrahedra), []
    for plane in part.half_spaces:
        kept = []
        for t in inside:
            low, high = split(t, plane, budget)
            kept += low
            outside += high
        inside = kept
    return inside, outside


def cut_by_solid(tetrahedra, parts, budget):
    inside, outside = [], list(tetrahedra)
    for part in parts:
        more, outside = cut_by_part(outside, part, budget)
        inside += more
    return inside, outside


class Flag:
    """A truth value with the operators of expressions, whose precedence is that of Python."""

    def __init__(self, value):
        self.value = value

    def __or__(self, other):
        return Flag(self.value or other.value)

    __add__ = __or__

    def __and__(self, other):
        return Flag(self.value and other.value)

    def __sub__(self, other):
        return Flag(self.value and not other.value)

    def __xor__(self, other):
        return Flag(self.value != other.value)

    def __invert__(self):
        return Flag(not self.value)


def expression_volume(expression, solids):
    """The volume of an expression about {name: list of convex parts that do not overlap}. Raises TooLong."""
    names = list(solids)
    code = compile(expression, "expression", "eval")
    budget = Budget()
    cells = []  # tetrahedra with the set of solids that they are in
    for k, name in enumerate(names):
        parts, new = solids[name], []
        for tetrahedron, inside_of in cells:
            low, high = cut_by_solid([tetrahedron], parts, budget)
            new += [(t, inside_of | {name}) for t in low] + [(t, inside_of) for t in high]
        rest = [t for part in parts for t in part.tetrahedra]
        for other in names[:k]:
            rest = cut_by_solid(rest, solids[other], budget)[1]
        cells = new + [(t, frozenset([name])) for t in rest]
    holds = {}
    total = Fraction(0)
    for tetrahedron, inside_of in cells:
        if inside_of not in holds:
            holds[inside_of] = eval(code, {}, {n: Flag(n in inside_of) for n in names}).value
        if holds[inside_of]:
            total += volume(tetrahedron)
    return total
