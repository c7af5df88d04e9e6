"""Solids for cases: what is written to a file or as a generator line, and the convex parts they are made of."""
from fractions import Fraction

from measure import ConvexPart


class Solid:
    """`parts` are convex and do not overlap; None where they are not known. Without a line, points and faces go to a
    file."""

    def __init__(self, points=None, faces=None, parts=None, line=None):
        self.points, self.faces, self.parts, self.line = points, faces, parts, line

    def mapped(self, f, turned=False):
        """The image under an affine map of points that is exact on their coordinates."""
        points = [tuple(f(p)) for p in self.points]
        faces = [tuple(reversed(face)) if turned else face for face in self.faces]
        parts = None
        if self.parts is not None:
            parts = [ConvexPart(*hull) for hull in mapped_hulls(self.hulls, f, turned)]
        solid = Solid(points, faces, parts)
        solid.hulls = mapped_hulls(self.hulls, f, turned)
        return solid

    def moved(self, x, y, z):
        return self.mapped(lambda p: (p[0] + x, p[1] + y, p[2] + z))

    def scaled(self, s):
        return self.mapped(lambda p: (p[0] * s, p[1] * s, p[2] * s))

    def text(self):
        rational = any(isinstance(x, Fraction) and x.denominator != 1 for p in self.points for x in p)
        lines = ["XOFF" if rational else "OFF", f"{len(self.points)} {len(self.faces)} 0"]
        lines += [" ".join(map(number_text, p)) for p in self.points]
        lines += [" ".join(map(str, (len(f), *f))) for f in self.faces]
        return "\n".join(lines) + "\n", "xoff" if rational else "off"


def number_text(x):
    return str(x) if not isinstance(x, float) else str(int(x)) if x.is_integer() and abs(x) < 2**53 else repr(x)


def mapped_hulls(hulls, f, turned):
    return [([tuple(f(p)) for p in points], [tuple(reversed(x)) if turned else x for x in faces])
            for points, faces in hulls]


def convex(points, faces, line=None):
    solid = Solid(list(points), list(faces), [ConvexPart(points, faces)], line)
    solid.hulls = [(list(points), list(faces))]
    return solid


BOX_FACES = [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]


def box(lower, upper):
    (a, b, c), (x, y, z) = lower, upper
    points = [(a, b, c), (x, b, c), (x, y, c), (a, y, c), (a, b, z), (x, b, z), (x, y, z), (a, y, z)]
    line = {"generate": "box", "lower": list(lower), "upper": list(upper)}
    rational = any(isinstance(v, Fraction) for v in (*lower, *upper))
    return convex(points, BOX_FACES, None if rational else line)


def cube(x=0, y=0, z=0, side=1):
    return box((x, y, z), (x + side, y + side, z + side))


def tetrahedron(a, b, c, d):
    points = [tuple(a), tuple(b), tuple(c), tuple(d)]
    u, v, w = ([Fraction(q) - Fraction(p) for p, q in zip(a, r)] for r in (b, c, d))
    six = (u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) + u[2] * (v[0] * w[1] - v[1] * w[0]))
    if six == 0:
        raise ValueError(f"flat: {points}")
    faces = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]
    return convex(points, faces if six > 0 else [tuple(reversed(f)) for f in faces])


def octahedron(centre, r):
    x, y, z = centre
    points = [(x + r, y, z), (x - r, y, z), (x, y + r, z), (x, y - r, z), (x, y, z + r), (x, y, z - r)]
    faces = [(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)]
    return convex(points, faces)


def prism(polygon, bottom, top):
    """Of a convex polygon, counter-clockwise seen from above."""
    n = len(polygon)
    points = [(x, y, z) for z in (bottom, top) for x, y in polygon]
    faces = [tuple(range(n - 1, -1, -1)), tuple(range(n, 2 * n))]
    faces += [(i, (i + 1) % n, n + (i + 1) % n, n + i) for i in range(n)]
    return convex(points, faces)


def pyramid(polygon, base, apex):
    """Over a convex polygon, counter-clockwise seen from above, in the plane z = base."""
    n = len(polygon)
    points = [(x, y, base) for x, y in polygon] + [tuple(apex)]
    if apex[2] > base:
        return convex(points, [tuple(range(n - 1, -1, -1))] + [(i, (i + 1) % n, n) for i in range(n)])
    return convex(points, [tuple(range(n))] + [((i + 1) % n, i, n) for i in range(n)])


def together(solids, weld=False):
    """Solids that do not overlap, as one. Where they touch, places are listed once if `weld`."""
    points, faces, numbers = [], [], {}
    for solid in solids:
        names = []
        for p in solid.points:
            key = p if weld else (len(points), p)
            if key not in numbers:
                numbers[key] = len(points)
                points.append(p)
            names.append(numbers[key])
        faces += [tuple(names[i] for i in face) for face in solid.faces]
    known = all(solid.parts is not None for solid in solids)
    whole = Solid(points, faces, [p for s in solids for p in s.parts] if known else None)
    whole.hulls = [hull for s in solids for hull in s.hulls]
    return whole


def cells(filled):
    """The union of unit cells (i, j, k): squares inside are left out, lattice points listed once."""
    filled = sorted(set(filled))
    inside, numbers, points, faces = set(filled), {}, [], []

    def number(p):
        if p not in numbers:
            numbers[p] = len(points)
            points.append(p)
        return numbers[p]

    for cell in filled:
        corners = [tuple(c + o for c, o in zip(cell, offset)) for offset in
                   [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]]
        beside = [(0, 0, -1), (0, 0, 1), (0, -1, 0), (1, 0, 0), (0, 1, 0), (-1, 0, 0)]
        for face, step in zip(BOX_FACES, beside):
            if tuple(c + s for c, s in zip(cell, step)) not in inside:
                faces.append(tuple(number(corners[i]) for i in face))
    solid = Solid(points, faces)
    solid.hulls = [(cube(*c).points, BOX_FACES) for c in filled]
    solid.parts = [ConvexPart(*hull) for hull in solid.hulls]
    return solid


def extruded(polygon, bottom, top, parts=None):
    """A simple polygon, counter-clockwise, not convex: faces of the file are polygons. `parts` are solids."""
    solid = prism_without_parts(polygon, bottom, top)
    if parts is not None:
        solid.parts = [p for part in parts for p in part.parts]
        solid.hulls = [h for part in parts for h in part.hulls]
    return solid


def prism_without_parts(polygon, bottom, top):
    n = len(polygon)
    points = [(x, y, z) for z in (bottom, top) for x, y in polygon]
    faces = [tuple(range(n - 1, -1, -1)), tuple(range(n, 2 * n))]
    return Solid(points, faces + [(i, (i + 1) % n, n + (i + 1) % n, n + i) for i in range(n)])


def generated(family, **parameters):
    """A generator line whose parts are not known here."""
    return Solid(line={"generate": family, **parameters})
