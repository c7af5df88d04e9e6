"""A case for every row of the tables of degenerate cases: lib/core/overlap, select and layers, theory.md."""
from itertools import product

from solids import box, cells, octahedron, tetrahedron, together

# Corners of the face of g that meets the plane z = 0, in which a face of f lies; by the signs of their heights.
PLACES = {"inside": [(1, 1), (3, 1), (1, 3)], "over-side": [(-2, 1), (2, -2), (1, 2)], "corner": [(0, 0), (3, 1), (1, 3)],
          "beside": [(4, 4), (6, 1), (7, 7)], "on-side": [(2, 0), (4, 4), (-2, 5)]}
SIGNS = [(1, 1, 1), (1, 1, -1), (0, 1, 1), (0, -1, -1), (0, 1, -1), (0, 0, 1), (0, 0, -1), (0, 0, 0)]


def add_to(cases):
    """f is a tetrahedron over a triangle in z = 0; of g three corners have the row's signs, the fourth is above all."""
    f = tetrahedron((0, 0, 0), (6, 0, 0), (0, 6, 0), (1, 1, -5))
    for signs, (where, places) in product(SIGNS, PLACES.items()):
        row = "".join("-0+"[s + 1] for s in signs)
        slug = "".join("mzp"[s + 1] for s in signs)
        try:
            g = tetrahedron(*[(x, y, 2 * s) for (x, y), s in zip(places, signs)], (2, 3, 9))
        except ValueError:
            continue
        for operation, expression in (("union", "f | g"), ("difference", "f - g")):
            cases.add(f"signs-{slug}-{where}-{operation}", {"f": f, "g": g}, expression, ["table", "overlap", operation],
                      f"corners with the signs {row} about the plane of a face, {where}: {operation}")
    select_table(cases)


def select_table(cases):
    unit = box((0, 0, 0), (2, 2, 2))
    tags = ["table", "select"]
    cases.operations("select-same-orientation", box((0, 0, 0), (4, 4, 2)), box((1, 1, 0), (6, 3, 1)), tags,
                     "coplanar faces that look the same way: one piece speaks for both")
    cases.operations("select-opposite-orientation", unit, box((0, 0, 2), (2, 2, 4)), tags,
                     "coplanar faces that look at each other: the wall goes")
    cases.operations("select-empty-result", unit, box((5, 5, 5), (6, 6, 6)), tags, "solids far apart")
    cases.operations("select-cavity", box((0, 0, 0), (6, 6, 6)), box((2, 2, 2), (4, 4, 4)), tags,
                     "one solid inside of the other: a cavity, or nothing",
                     {"difference": {"components": 2, "euler": 4}})
    ring = cells([(i, j, 0) for i in range(3) for j in range(3) if (i, j) != (1, 1)])
    cases.operations("select-plug-ring", ring, box((1, 1, 0), (2, 2, 1)), tags, "a plug closes a ring exactly",
                     {"union": {"components": 1, "euler": 2, "facets": 6}})
    cases.operations("select-plug-longer", ring, box((1, 1, -1), (2, 2, 2)), tags, "a plug longer than its hole")
    walls = together([box((0, 0, 0), (1, 3, 3)), box((2, 0, 0), (3, 3, 3))])
    cases.operations("select-between-walls", walls, box((1, 0, 0), (2, 3, 3)), tags,
                     "a slab between two walls of one operand, four coplanar faces around",
                     {"union": {"volume": 27, "components": 1, "euler": 2, "facets": 6}})
    shared = cells([(0, 0, 0), (1, 1, 0)])
    cases.operations("select-beside-shared-edge", shared, box((1, 0, 0), (2, 1, 1)), tags,
                     "a cell closes one of the gaps at an edge with four faces")
    corner = cells([(0, 0, 0), (1, 1, 1)])
    cases.operations("select-through-shared-vertex", corner, octahedron((1, 1, 1), 1), tags,
                     "an octahedron about the corner that two cells share")
    cases.operations("select-through-shared-edge", shared, box((0, 0, 0), (2, 2, 1)), tags,
                     "the hull of two cells that share an edge: all faces coplanar")
    pieces = {f"s{k}": octahedron((k % 2, k // 2, 0), 2) for k in range(4)}
    names = list(pieces)
    for operation, sign in (("union", "|"), ("intersection", "&"), ("difference", "-"), ("xor", "^")):
        cases.add(f"select-one-point-{operation}", pieces, f" {sign} ".join(names), [*tags, "n-ary", operation],
                  f"octahedra through one another, many names for the same points ({operation})")
