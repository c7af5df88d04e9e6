"""Huge faces, thousands of holes, combs, spirals, high genus, thousands of parts; inputs that cross themselves."""
from measure import expression_volume
from solids import box, extruded, generated, octahedron, together


def add_to(cases):
    huge = box((-1e6, -1e6, 0.0), (1e6, 1e6, 1.0))
    for operation, sign in (("union", "|"), ("difference", "-"), ("xor", "^")):
        cases.add(f"huge-face-stud-{operation}", {"a": huge, "b": box((0.001, 0.001, 0.5), (0.002, 0.002, 1.5))},
                  f"a {sign} b", ["huge-face", operation], f"a stud of 1e-3 on a face of 2e6 ({operation})")
    for n in (4, 12, 30, 60):
        pillars = generated("grid", count=[n, n, 1], lower=[1, 1, -1], pitch=[2, 2, 1], size=[1, 1, 3])
        plate = box((0, 0, 0), (2 * n + 1, 2 * n + 1, 1))
        side, holes = 2 * n + 1, n * n
        tags = ["holes", "high-genus"] + (["large"] if n > 12 else [])
        cases.add(f"plate-{holes}-holes", {"a": plate, "b": pillars}, "a - b", [*tags, "difference"],
                  f"{holes} square holes in one plate", {"volume": side * side - holes, "components": 1,
                                                        "euler": 2 - 2 * holes, "facets": 6 + 4 * holes,
                                                        "area": 2 * (side * side - holes) + 4 * side + 4 * holes})
        cases.add(f"plate-{holes}-pillars", {"a": plate, "b": pillars}, "a | b", [*tags, "union"],
                  f"{holes} pillars through one plate",
                  {"volume": side * side + 2 * holes, "components": 1, "euler": 2})
        flush = generated("grid", count=[n, n, 1], lower=[1, 1, 0], pitch=[2, 2, 1], size=[1, 1, 1])
        cases.add(f"plate-{holes}-plugs", {"a": plate, "b": pillars, "c": flush}, "(a - b) | c", [*tags, "coplanar"],
                  f"{holes} holes are cut into a plate and plugged again",
                  {"volume": side * side, "facets": 6, "components": 1, "euler": 2})
    for n in (10, 150, 1000):
        teeth = generated("grid", count=[n, 1, 1] if n <= 400 else [n // 5, 5, 1], lower=[0, 0, 1], pitch=[2, 2, 1],
                          size=[1, 1, 1])
        plate = box((0, 0, 0), (2 * n, 1, 1)) if n <= 400 else box((0, 0, 0), (2 * n // 5, 9, 1))
        base = 2 * n if n <= 400 else 2 * n // 5 * 9
        tags = ["comb", "coplanar"] + (["large"] if n > 400 else [])
        cases.add(f"comb-{n}-union", {"a": plate, "b": teeth}, "a | b", [*tags, "union"],
                  f"{n} teeth on a plate, fronts and backs coplanar", {"volume": base + n, "components": 1, "euler": 2})
        cases.add(f"comb-{n}-xor", {"a": plate.moved(0, 0, 0.5), "b": teeth}, "a ^ b", [*tags, "xor"],
                  f"{n} teeth half in a plate", {"volume": base})
    for n in (2, 5, 9):
        parts, polygon = spiral(n)
        wall = extruded(polygon, 0, 2, parts)
        side = 4 * n + 4
        for operation, sign in (("union", "|"), ("intersection", "&"), ("difference", "-")):
            cases.add(f"spiral-{n}-slab-{operation}", {"a": wall, "b": box((-side, -side, 1), (side, side, 3))},
                      f"a {sign} b", ["spiral", "coplanar", operation],
                      f"a spiral wall of {n} turns and a slab over its upper half ({operation})")
        cases.add(f"spiral-{n}-ray", {"a": wall, "b": box((0, 0, 0), (side, 1, 2))}, "a - b", ["spiral", "difference"],
                  f"a spiral of {n} turns, cut by a slot through all its turns")
        combs = interlocked(n)
        cases.operations(f"combs-interlocked-{n}", *combs, ["comb", "coplanar"],
                         f"two combs of {n} teeth that fill each other's gaps")
    genus(cases)
    many_parts(cases)
    overlapping(cases)


def spiral(turns):
    """A wall of thickness 1 with gaps of 1 about the origin: its boxes, and its outline counter-clockwise."""
    boxes, left, right = [], [], []
    x, y, length = 0, 0, 2
    directions = [(1, 0), (0, 1), (-1, 0), (0, -1)]
    middle = [(0, 0)]
    for k in range(4 * turns):
        dx, dy = directions[k % 4]
        step = 2 * (k // 2 + 1)
        x, y = x + dx * step, y + dy * step
        middle.append((x, y))
    for k in range(len(middle) - 1):
        (a, b), (c, d) = middle[k], middle[k + 1]
        dx, dy = directions[k % 4]
        start = 0 if k == 0 else 1  # the corner belongs to the stretch before
        lower = (min(a + dx * start, c), min(b + dy * start, d))
        upper = (max(a + dx * start, c), max(b + dy * start, d))
        boxes.append(box((lower[0], lower[1], 0), (upper[0] + 1, upper[1] + 1, 2)))
    outline_out, outline_in = [], []
    for k in range(len(middle)):
        px, py = middle[k]
        before, after = directions[(k - 1) % 4], directions[k % 4]
        if k == 0:
            outline_out.append((px, py))
            outline_in.append((px, py + 1))
            continue
        if k == len(middle) - 1:
            after = before
            corner_out, corner_in = end_corners(px, py, before)
        else:
            corner_out, corner_in = turn_corners(px, py, before, after)
        outline_out.append(corner_out)
        outline_in.append(corner_in)
    return boxes, outline_out + list(reversed(outline_in))


def turn_corners(x, y, before, after):
    """The corner cell of a left turn: its outer and its inner corner."""
    sx, sy = before[0] - after[0], before[1] - after[1]  # towards the outer corner
    out = (x + (sx > 0), y + (sy > 0))
    return out, (x + (sx <= 0), y + (sy <= 0))


def end_corners(x, y, direction):
    """The right and the left corner of the end of a stretch that runs in a direction."""
    dx, dy = direction
    right, left = (dy, -dx), (-dy, dx)
    def corner(side):
        sx, sy = dx + side[0], dy + side[1]
        return (x + (sx > 0), y + (sy > 0))
    return corner(right), corner(left)


def interlocked(n):
    """Two combs in a plate: teeth of width 1 that touch along their sides."""
    def comb(first, spine):
        teeth = [box((2 * k + first, 1, 0), (2 * k + first + 1, 5, 1)) for k in range(n)]
        return together([box((0, spine, 0), (2 * n, spine + 1, 1))]), teeth
    solids = []
    for first, spine in ((0, 0), (1, 5)):
        base, teeth = comb(first, spine)
        polygon = comb_outline(n, first, spine)
        solids.append(extruded(polygon, 0, 1, [base, *teeth]))
    return solids


def comb_outline(n, first, spine):
    points = []
    if spine == 0:  # teeth upwards
        points = [(0, 0), (2 * n, 0), (2 * n, 1)]
        for k in reversed(range(n)):
            points += [(2 * k + first + 1, 1), (2 * k + first + 1, 5), (2 * k + first, 5), (2 * k + first, 1)]
    else:  # teeth downwards
        points = [(2 * n, 6), (0, 6), (0, 5)]
        for k in range(n):
            points += [(2 * k + first, 5), (2 * k + first, 1), (2 * k + first + 1, 1), (2 * k + first + 1, 5)]
    clean = []
    for p in points:
        if not clean or clean[-1] != p:
            clean.append(p)
    return clean if clean[0] != clean[-1] else clean[:-1]


def genus(cases):
    for n in (3, 5, 9, 15):
        frame = generated("cells", count=[n] * 3, pattern="frame", lower=[0, 0, 0], size=[1, 1, 1])
        half = (n + 1) // 2
        filled = half**3 + 3 * half**2 * (n // 2)
        tags = ["high-genus"] + (["large"] if n > 9 else [])
        cases.add(f"frame-{n}-filled", {"a": frame, "b": box((0, 0, 0), (n, n, n))}, "a | b", [*tags, "union"],
                  f"a lattice of bars in {n}^3 cells, and the block it is in", {"volume": n**3, "facets": 6})
        cases.add(f"frame-{n}-complement", {"a": box((0, 0, 0), (n, n, n)), "b": frame}, "a - b", [*tags, "difference"],
                  f"what a lattice of bars leaves of {n}^3 cells", {"volume": n**3 - filled})
        moved = generated("cells", count=[n] * 3, pattern="frame", lower=[0.5, 0.25, 0.125], size=[1, 1, 1])
        cases.add(f"frame-{n}-moved", {"a": frame, "b": moved}, "a | b", [*tags, "union"],
                  f"two lattices of bars in {n}^3 cells through one another")


def many_parts(cases):
    for n in (5, 10, 15):
        one = generated("grid", count=[n] * 3, lower=[0, 0, 0], pitch=[2, 2, 2], size=[1, 1, 1])
        two = generated("grid", count=[n] * 3, lower=[1, 0, 0], pitch=[2, 2, 2], size=[1, 1, 1])
        half = generated("grid", count=[n] * 3, lower=[0.5, 0, 0], pitch=[2, 2, 2], size=[1, 1, 1])
        tags = ["parts", "large"] if n > 5 else ["parts"]
        count = n**3
        cases.add(f"parts-{count}-touching-union", {"a": one, "b": two}, "a | b", [*tags, "coplanar", "union"],
                  f"{count} cubes and {count} more beside them: rows", {"volume": 2 * count, "components": n * n})
        cases.add(f"parts-{count}-shifted-xor", {"a": one, "b": half}, "a ^ b", [*tags, "coplanar", "xor"],
                  f"{count} cubes, each crossed by another one of its size, sides coplanar", {"volume": count})
        cases.add(f"parts-{count}-same-difference", {"a": one, "b": one}, "a - b", [*tags, "identical", "difference"],
                  f"{count} cubes without themselves", {"volume": 0})


def volume_of(expression, solids):
    return expression_volume(expression, {name: solid.parts for name, solid in solids.items()})


def overlapping(cases):
    a = together([box((0, 0, 0), (4, 4, 4)), box((2, 2, 2), (6, 6, 6))])
    b = box((3, 3, -1), (5, 5, 9))
    a.parts = None
    apart = {"c": box((0, 0, 0), (4, 4, 4)), "d": box((2, 2, 2), (6, 6, 6)), "b": b}
    for operation, sign in (("union", "|"), ("difference", "-"), ("xor", "^")):
        known = {"volume": volume_of(f"(c | d) {sign} b", apart)}
        cases.add(f"overlapping-boxes-{operation}", {"a": a, "b": b}, f"a {sign} b", ["overlapping", operation],
                  f"an operand of two boxes that cross each other ({operation})", known, input="overlapping")
    star = together([octahedron((0, 0, 0), 4), box((-3, -3, -1), (3, 3, 1)), box((-1, -3, -3), (1, 3, 3))])
    star.parts = None
    for operation, sign in (("union", "|"), ("difference", "-")):
        cases.add(f"overlapping-star-{operation}", {"a": star, "b": box((0, 0, 0), (9, 9, 9))}, f"a {sign} b",
                  ["overlapping", operation], f"an operand of three solids through one another ({operation})",
                  input="overlapping")
    walls = together([box((k, 0, 0), (k + 1, 2, 2)) for k in range(4)])
    walls.parts = None
    cases.add("overlapping-walls", {"a": walls, "b": box((4, 0, 0), (5, 2, 2))}, "a | b",
              ["overlapping", "coplanar", "union"], "an operand of boxes with walls between them",
              {"volume": 20, "facets": 6, "components": 1, "euler": 2}, input="overlapping")
