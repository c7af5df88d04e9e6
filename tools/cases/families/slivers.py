"""Needles, slivers and plates; nested shells."""
from solids import box, cells, octahedron, pyramid, tetrahedron, together


def add_to(cases):
    block = box((0, 0, 0), (8, 8, 8))
    for exponent in (-3, -8, -15, -40):
        e = 10.0**exponent
        shapes = {
            "needle": tetrahedron((4.0, 4.0, -4.0), (4.0 + e, 4.0, -4.0), (4.0, 4.0 + e, -4.0), (4.5, 4.25, 12.0))
            if exponent > -10 else pyramid([(0.0, 0.0), (e, 0.0), (e, e), (0.0, e)], -4.0, (0.0, 0.0, 12.0)),
            "sliver": tetrahedron((-1.0, 2.0, 0.0), (9.0, 3.0, 0.0), (4.0, 7.0, e), (4.0, 4.0, -e)),
            "plate": box((-1.0, -1.0, 0.0), (9.0, 9.0, e)),
            "blade": tetrahedron((-1.0, 0.0, 4.0), (9.0, 0.0, 4.0), (4.0, -e, 3.0), (4.0, e, 12.0)),
        }
        for name, b in shapes.items():
            cases.operations(f"{name}-1e{exponent}", block, b, ["sliver", name],
                             f"a {name} of thickness 1e{exponent} and a block")
    crossing = [tetrahedron((-9, k, 0), (9, -k, 0), (0, 0, 1), (0, 1, 0)) for k in range(1, 7)]
    named = {f"n{k}": n for k, n in enumerate(crossing)}
    cases.add("slivers-crossing-union", named, " | ".join(named), ["sliver", "n-ary", "union"],
              "six slivers that share an edge and cross nearly coplanar", measured=False)
    cases.add("slivers-crossing-xor", named, " ^ ".join(named), ["sliver", "n-ary", "xor"],
              "the same, odd counts", measured=False)
    for k in (1, 2, 3, 5):
        a = tetrahedron((0, 0, 0), (10**k, 1, 0), (10**k, -1, 0), (10**k, 0, 1))
        b = tetrahedron((0, 0, 0), (10**k, 2, 1), (10**k, -1, 1), (10**k, 0, -1))
        cases.operations(f"narrow-cones-1e{k}", a, b, ["sliver", "vertex-contact"],
                         f"two cones of an opening of 1e-{k} from one tip")
    steps(cases)
    shells(cases)


def steps(cases):
    """A corner above a face, or below it, by the least that a lattice of 2^25 steps allows: the determinant is 1 or -1, and
    products of doubles round it away."""
    u, v, w = (5339397, -30670133, 22304293), (-20132623, -8602516, 6226413), (-8611000, -11480017, 8334109)
    opposite = tuple(x + y for x, y in zip(u, v))
    below, up = (0, 2**24, 2**24), 2**23
    for name, face, corner, facts in (
            ("above", ((0, 0, 0), u, v), w,
             {"union": {"components": 2}, "intersection": {"volume": 0}, "xor": {"components": 2}}),
            ("below", (u, v, opposite), tuple(x - y for x, y in zip(opposite, w)), None)):
        tip = tetrahedron(corner, *[tuple(x + y for x, y in zip(corner, f)) for f in
                                    ((0, -up, -up), (up, -up, -up), (0, -up, -up // 2))])
        cases.operations(f"step-{name}-face", tetrahedron(*face, below), tip, ["sliver", "ulp", "lattice"],
                         f"a tip is one step of a lattice {name} a face off the axes", facts)


def shells(cases):
    for n in (2, 3, 4, 6, 8):
        nested = {f"s{k}": box((k, k, k), (20 - k, 20 - k, 20 - k)) for k in range(n)}
        expression = "s0"
        for k in range(1, n):
            expression = f"({expression} {'-' if k % 2 else '|'} s{k})"
        cases.add(f"shells-{n}-alternating", nested, expression, ["shells", "n-ary"],
                  f"{n} nested boxes, taken away and put in again", {"components": n, "euler": 2 * n})
        cases.add(f"shells-{n}-xor", nested, " ^ ".join(nested), ["shells", "n-ary", "xor"],
                  f"what is in an odd number of {n} nested boxes", {"components": n, "euler": 2 * n})
        touching = {f"s{k}": box((0, 0, 0), (20 - k, 20 - k, 20 - k)) for k in range(n)}
        cases.add(f"shells-{n}-corner-xor", touching, " ^ ".join(touching), ["shells", "n-ary", "coplanar", "xor"],
                  f"the same with {n} boxes in one corner")
    hollow = cells([(i, j, k) for i in range(5) for j in range(5) for k in range(5)
                    if not (1 <= i <= 3 and 1 <= j <= 3 and 1 <= k <= 3)])
    hollow.parts = None
    core = box((1, 1, 1), (4, 4, 4))
    facts = {"union": {"volume": 125, "components": 1, "euler": 2, "facets": 6}, "intersection": {"volume": 0},
             "difference": {"volume": 98, "components": 2}, "xor": {"volume": 125, "facets": 6}}
    cases.operations("shells-core-fits", hollow, core, ["shells", "coplanar"], "a core that fills a cavity exactly", facts)
    cases.operations("shells-core-inscribed", hollow, octahedron((2.5, 2.5, 2.5), 1.5), ["shells"],
                     "an octahedron in a cavity touches its walls with its corners",
                     {"union": {"volume": "205/2"}, "intersection": {"volume": 0}})
    matryoshka = together([box((k, k, k), (20 - k, 20 - k, 20 - k)) if k % 2 == 0 else
                           box((k, k, k), (20 - k, 20 - k, 20 - k)).mapped(lambda p: p, turned=True) for k in range(6)])
    matryoshka.parts = None
    cases.operations("shells-cut-open", matryoshka, box((10, -1, -1), (21, 21, 21)), ["shells"],
                     "three hollow boxes in one another, cut in half",
                     {"difference": {"volume": (20**3 - 18**3 + 16**3 - 14**3 + 12**3 - 10**3) // 2}})
    pit = together([box((1, 1, 8), (19, 19, 20))])
    cases.operations("shells-pit-open-at-top", box((0, 0, 0), (20, 20, 20)), pit, ["shells", "coplanar"],
                     "a pit whose mouth lies in a face")
