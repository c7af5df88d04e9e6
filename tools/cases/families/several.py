"""Many operands at one place; expressions; laws."""
from fractions import Fraction
from itertools import product

from solids import Solid, box, cube, octahedron, tetrahedron, together
from measure import ConvexPart


def add_to(cases):
    unit = cube()
    for n in (2, 3, 4, 7, 16):
        same = {f"c{k}": unit for k in range(n)}
        odd = n % 2
        for operation, sign, v in (("union", "|", 1), ("intersection", "&", 1), ("xor", "^", odd), ("difference", "-", 0)):
            cases.add(f"same-{n}-{operation}", same, f" {sign} ".join(same), ["n-ary", "identical", operation],
                      f"one cube as {n} operands ({operation})", {"volume": v, "facets": 6 * v})
    eight = {f"c{k}": cube(x - 1, y - 1, z - 1) for k, (x, y, z) in enumerate(product(range(2), repeat=3))}
    cases.add("octants-union", eight, " | ".join(eight), ["n-ary", "many-planes", "union"],
              "eight cubes about one point", {"volume": 8, "facets": 6, "components": 1, "euler": 2})
    cases.add("octants-but-one", eight, " | ".join(list(eight)[:-1]) + " - " + list(eight)[-1],
              ["n-ary", "many-planes"], "seven of eight cubes about one point",
              {"volume": 7, "components": 1, "euler": 2, "facets": 9})
    cases.add("octants-checkerboard", eight, " ^ ".join(list(eight)[:4]) + " - (" + " | ".join(list(eight)[4:]) + ")",
              ["n-ary", "many-planes"], "the lower four of eight cubes about one point", {"volume": 4, "facets": 6})
    laws(cases)
    sizes(cases)
    rational(cases)
    retriangulated(cases)


def laws(cases):
    a = octahedron((0, 0, 0), 4)
    b = box((0, -2, -1), (6, 2, 3))
    c = tetrahedron((-3, -3, -3), (5, 0, 0), (0, 5, 0), (0, 0, 5))
    solids = {"a": a, "b": b, "c": c}
    for name, expression, used in (
            ("xor-by-differences", "(a - b) | (b - a)", "ab"), ("xor-by-union", "(a | b) - (a & b)", "ab"),
            ("partition", "(a - b) ^ (a & b) ^ (b - a)", "ab"), ("nothing", "(a | b) - a - b", "ab"),
            ("itself", "(a & b) | (a - b) | (a & ~b)", "ab"), ("majority", "(a & b) | (b & c) | (c & a)", "abc"),
            ("exactly-one", "(a ^ b ^ c) - (a & b & c)", "abc"), ("de-morgan", "(a | b) & ~(b & c)", "abc"),
            ("absorbed", "(a | b) & (a | c) - (b & c)", "abc"), ("chain", "a - b - c", "abc"),
            ("nested", "a - (b - c)", "abc"), ("complements", "~(~a | b) & ~(~c & b)", "abc")):
        cases.add(f"law-{name}", {n: solids[n] for n in used}, expression, ["expression"],
                  f"several operations about the same crossing surfaces: {name}")


def sizes(cases):
    """Cubes and octahedra of many sizes about one corner, all faces through common planes."""
    solids = {}
    for k in range(1, 7):
        solids[f"s{k}"] = cube(0, 0, 0, k) if k % 2 else octahedron((k / 2, k / 2, k / 2), k * 0.75)
    for operation, sign in (("union", "|"), ("intersection", "&"), ("xor", "^")):
        for n in (2, 4, 6):
            part = dict(list(solids.items())[:n])
            cases.add(f"sizes-{n}-{operation}", part, f" {sign} ".join(part), ["n-ary", "coplanar", operation],
                      f"{n} cubes and octahedra of growing size about one corner ({operation})", measured=n < 6)
    for n in (3, 5, 9):
        stairs = {f"b{k}": box((0, 0, k), (n - k, n - k, k + 1)) for k in range(n)}
        cases.add(f"stairs-{n}-union", stairs, " | ".join(stairs), ["n-ary", "coplanar", "union"],
                  f"{n} slabs on top of one another, two sides coplanar", {"components": 1, "euler": 2})
        crossing = {f"b{k}": box((0, k, 0), (n + 1, k + 2, 2 if k % 2 else 1)) for k in range(n)}
        cases.add(f"overlapping-row-{n}-union", crossing, " | ".join(crossing), ["n-ary", "coplanar", "union"],
                  f"{n} boxes in a row, each over half of the next, bottoms coplanar")


def rational(cases):
    """Operands whose vertices are no doubles: exact files are the only way to say it."""
    third = Fraction(1, 3)
    a = box((0, 0, 0), (third, third, third))
    b = box((third, 0, 0), (1, third, third))
    cases.operations("thirds-face", a, b, ["rational", "face-contact"], "boxes that share a face at x = 1/3",
                     {"union": {"components": 1, "facets": 6}})
    gap = box((third + Fraction(1, 10**40), 0, 0), (1, third, third))
    cases.operations("thirds-gap", a, gap, ["rational"], "boxes with a gap of 1e-40 at x = 1/3",
                     {"union": {"components": 2, "facets": 12}})
    o = octahedron((0, 0, 0), 1)
    moved = o.mapped(lambda p: (p[0] + Fraction(3, 9), p[1] + Fraction(4, 9), p[2] + Fraction(5, 9)))
    cases.operations("thirds-octahedra", o, moved, ["rational"], "an octahedron and one moved by (3, 4, 5)/9")
    seven = tetrahedron((0, 0, 0), (Fraction(8, 7), 0, 0), (0, Fraction(9, 7), 0), (0, 0, Fraction(10, 7)))
    cases.operations("sevenths-tetrahedron", cube(), seven, ["rational"], "a cube and a tetrahedron of sevenths")
    corners = [(1, 3, 0), (2, 2, 0), (3, 0, 0), (3, 3, 1)]
    shared = tetrahedron(*([tuple(Fraction(4 * x, 3) for x in p) for p in corners]))
    o = octahedron((4, 2, 0), 2).mapped(lambda p: tuple(Fraction(4 * x, 3) for x in p))
    cases.operations("thirds-vertex", shared, o, ["rational"],
                     "a tetrahedron that crosses an octahedron and shares a corner with it, in thirds")


def retriangulated(cases):
    """The same cube with its faces divided otherwise: coplanar triangles that cross everywhere."""
    def divided(step):
        points, faces = [], []

        def add(corners):
            start = len(points)
            points.extend(corners)
            faces.append(tuple(range(start, start + len(corners))))

        low, high = (0, 0, 0), (4, 4, 4)
        for axis in range(3):
            u, v = (axis + 1) % 3, (axis + 2) % 3
            for side in (low, high):
                middle = [0, 0, 0]
                middle[axis], middle[u], middle[v] = side[axis], step, 4 - step if step != 2 else 2
                square = [(0, 0), (4, 0), (4, 4), (0, 4)]
                for (p, q), (r, s) in zip(square, square[1:] + square[:1]):
                    one, two = [0, 0, 0], [0, 0, 0]
                    one[axis] = two[axis] = side[axis]
                    one[u], one[v], two[u], two[v] = p, q, r, s
                    corners = [tuple(middle), tuple(one), tuple(two)]
                    add(corners if side is high else list(reversed(corners)))
        numbers, welded = {}, []
        for p in points:
            if p not in numbers:
                numbers[p] = len(welded)
                welded.append(p)
        solid = Solid(welded, [tuple(numbers[points[i]] for i in f) for f in faces])
        solid.hulls = [(cube(0, 0, 0, 4).points, [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6),
                                                  (3, 0, 4, 7)])]
        solid.parts = [ConvexPart(*h) for h in solid.hulls]
        return solid

    for step in (1, 2, 3):
        cases.operations(f"retriangulated-{step}", cube(0, 0, 0, 4), divided(step), ["identical", "coplanar"],
                         "the same cube, its faces divided otherwise")
    cases.operations("retriangulated-both", divided(1), divided(3).moved(4, 0, 0), ["coplanar", "face-contact"],
                     "two cubes share a face that each divides otherwise")
