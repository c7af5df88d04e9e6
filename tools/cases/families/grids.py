"""Cells of one lattice: whole grids, checkerboards, Menger sponges, bars."""
from itertools import product

from solids import cells, cube, generated, box, together


def named_cubes(filled):
    return {f"c{k}": cube(*c) for k, c in enumerate(filled)}


def add_to(cases):
    for n in (2, 3, 4):
        block = list(product(range(n), repeat=3))
        facts = {"volume": n**3, "area": 6 * n * n, "components": 1, "euler": 2, "facets": 6, "edges": 12, "vertices": 8}
        solids = named_cubes(block)
        for operation, sign in (("union", "|"), ("xor", "^")):
            cases.add(f"grid-{n}-{operation}", solids, f" {sign} ".join(solids), ["grid", "n-ary", operation],
                      f"{n}^3 unit cubes, listed one by one, make one cube: all walls go ({operation})", facts)
    even = [c for c in product(range(3), repeat=3) if sum(c) % 2 == 0]
    solids = named_cubes(even)
    cases.add("grid-checkerboard-3-union", solids, " | ".join(solids), ["grid", "n-ary", "union", "non-manifold"],
              "14 cubes of a checkerboard touch in edges and corners only", {"volume": 14, "area": 84, "facets": 84})
    for n in (4, 6, 8):
        board = {"count": [n] * 3, "lower": [0, 0, 0], "size": [1, 1, 1]}
        odd = {**board, "lower": [1, 0, 0], "count": [n - 1, n, n]}
        block = cube(0, 0, 0, n)
        half = n**3 // 2
        for operation, sign, volume in (("union", "|", n**3), ("intersection", "&", half), ("xor", "^", n**3 - half)):
            cases.add(f"grid-checkerboard-{n}-block-{operation}",
                      {"a": generated("cells", pattern="checkerboard", **board), "b": block}, f"a {sign} b",
                      ["grid", "checkerboard", "non-manifold", operation],
                      f"a checkerboard of {n}^3 cells and the block that it fills half ({operation})",
                      {"volume": volume})
        cases.add(f"grid-checkerboard-{n}-shifted-union",
                  {"a": generated("cells", pattern="checkerboard", **board),
                   "b": generated("cells", pattern="checkerboard", **odd)}, "a | b",
                  ["grid", "checkerboard", "non-manifold", "union"],
                  "a checkerboard and one moved by a cell, which fills its gaps but for those at x = 0")
    menger(cases)
    bars(cases)
    brick_walls(cases)


def menger(cases):
    bars = {"x": box((-1, 1, 1), (4, 2, 2)), "y": box((1, -1, 1), (2, 4, 2)), "z": box((1, 1, -1), (2, 2, 4))}
    flush = {"x": box((0, 1, 1), (3, 2, 2)), "y": box((1, 0, 1), (2, 3, 2)), "z": box((1, 1, 0), (2, 2, 3))}
    facts = {"volume": 20, "area": 72, "components": 1, "euler": -8}
    for name, solids in (("through", bars), ("flush", flush)):
        whole = {"cube": cube(0, 0, 0, 3), **solids}
        cases.add(f"menger-1-{name}", whole, "cube - x - y - z", ["menger", "n-ary", "difference"],
                  f"a cube with three square holes that meet in its middle, made by bars that go {name}", facts)
        cases.add(f"menger-1-{name}-joined", whole, "cube - (x | y | z)", ["menger", "n-ary", "difference"],
                  f"the same, the bars joined first ({name})", facts)
    nine = {"cube": cube(0, 0, 0, 9)}
    for axis, name in enumerate("xyz"):
        spans = [(3, 6, 3, 6)] + [(i, i + 1, j, j + 1) for i in (1, 4, 7) for j in (1, 4, 7) if (i, j) != (4, 4)]
        nine[name] = together([turned_bar(axis, s, -1, 10) for s in spans])
    expression = "cube - x - y - z"
    cases.add("menger-2-bars", nine, expression, ["menger", "n-ary", "difference", "high-genus"],
              "the sponge of two levels by 27 bars", {"volume": 400, "area": 1056, "components": 1}, measured=False)
    for n, level in ((9, 2), (27, 3)):
        sponge = generated("cells", count=[n] * 3, pattern="menger", lower=[0, 0, 0], size=[1, 1, 1])
        block = cube(0, 0, 0, n)
        volume = 20**level
        for operation, sign, v in (("union", "|", n**3), ("intersection", "&", volume), ("xor", "^", n**3 - volume)):
            cases.add(f"menger-{level}-block-{operation}", {"a": sponge, "b": block}, f"a {sign} b",
                      ["menger", "high-genus", operation] + (["large"] if level == 3 else []),
                      f"the sponge of {level} levels and its cube ({operation})", {"volume": v})
        diagonal = box((n / 2, 0, 0), (n, n, n))
        cases.add(f"menger-{level}-halved", {"a": sponge, "b": diagonal}, "a - b",
                  ["menger", "high-genus", "difference"] + (["large"] if level == 3 else []),
                  f"half of the sponge of {level} levels, cut in the middle of cells", {"volume": f"{volume}/2"})


def turned_bar(axis, span, low, high):
    (a, b, c, d) = span
    lower, upper = [a, c], [b, d]
    lower.insert(axis, low)
    upper.insert(axis, high)
    return box(tuple(lower), tuple(upper))


def bars(cases):
    for n in (2, 4, 8):
        lattice = [together([box((0, 2 * k, 0), (2 * n, 2 * k + 1, 1)) for k in range(n)]),
                   together([box((2 * k, 0, 0), (2 * k + 1, 2 * n, 1)) for k in range(n)])]
        stacked = lattice[1].moved(0, 0, 1)
        cases.operations(f"bars-flush-{n}", *lattice, ["grid", "coplanar"],
                         f"{n} bars and {n} bars across them in the same layer: tops and bottoms coplanar")
        cases.operations(f"bars-stacked-{n}", lattice[0], stacked, ["grid", "coplanar"],
                         f"{n} bars with {n} bars across on top of them: they touch in squares")


def brick_walls(cases):
    for rows in (2, 3, 5):
        bricks = {}
        for j in range(rows):
            for i in range(3):
                x = 2 * i + j % 2
                bricks[f"b{j}_{i}"] = box((x, 0, j), (x + 2, 1, j + 1))
        cases.add(f"brick-wall-{rows}", bricks, " | ".join(bricks), ["grid", "n-ary", "coplanar", "union"],
                  f"{rows} rows of bricks in a running bond: walls meet in T-junctions", {"volume": 6 * rows})
    board = cells([(i, j, 0) for i in range(4) for j in range(4) if (i + j) % 2 == 0])
    cases.operations("checkerboard-plates", board, board.moved(0, 1, 0), ["grid", "checkerboard", "coplanar"],
                     "two plates of squares that fill each other's gaps but for the border")
    cases.operations("checkerboard-plates-stacked", board, board.moved(0, 0, 1), ["grid", "checkerboard", "coplanar"],
                     "a plate of squares on an equal one")
