"""Random solids of tetrahedra of one subdivision of space: they touch themselves and each other in every way."""
import random
from itertools import permutations, product

from measure import ConvexPart, volume
from solids import Solid, cells, box, octahedron


def kuhn_tetrahedra(count):
    """The six tetrahedra along the main diagonal of every unit cube of a block, positively oriented."""
    found = []
    for corner in product(*map(range, count)):
        for order in permutations(range(3)):
            p, points = list(corner), [tuple(corner)]
            for axis in order:
                p[axis] += 1
                points.append(tuple(p))
            even = order in ((0, 1, 2), (1, 2, 0), (2, 0, 1))
            found.append(tuple(points) if even else (points[0], points[2], points[1], points[3]))
    return found


def kuhn_solid(taken):
    """The union of tetrahedra: triangles that two of them share go. Places are listed once."""
    sides = {}
    for a, b, c, d in taken:
        for face in ((a, c, b), (a, b, d), (a, d, c), (b, c, d)):
            key = frozenset(face)
            if sides.pop(key, None) is None:
                sides[key] = face
    numbers, points, faces = {}, [], []
    for face in sides.values():
        for p in face:
            if p not in numbers:
                numbers[p] = len(points)
                points.append(p)
        faces.append(tuple(numbers[p] for p in face))
    return Solid(points, faces)


def add_to(cases):
    for seed in range(10):
        chance = random.Random(seed)
        count = chance.choice([(1, 1, 1), (2, 1, 1), (2, 2, 1), (2, 2, 2)])
        every = kuhn_tetrahedra(count)
        share = chance.choice([0.3, 0.5, 0.7])
        flags = [[chance.random() < share for _ in every] for _ in range(2)]
        if not all(any(f) for f in flags):
            flags = [[k % 2 == 0 for k in range(len(every))], [k % 3 == 0 for k in range(len(every))]]
        a, b = (kuhn_solid([t for t, f in zip(every, one) if f]) for one in flags)
        rules = {"union": lambda x, y: x or y, "intersection": lambda x, y: x and y,
                 "difference": lambda x, y: x and not y, "xor": lambda x, y: x != y}
        known = {name: {"volume": f"{sum(rule(x, y) for x, y in zip(*flags))}/6"} for name, rule in rules.items()}
        cases.operations(f"kuhn-{seed}", a, b, ["touching", "self-touching", "coplanar"],
                         f"tetrahedra of one subdivision of {count} cubes, taken at random (seed {seed})", known)
    for seed in range(6):
        chance = random.Random(1000 + seed)
        every = kuhn_tetrahedra((2, 2, 1))
        flags = {n: [chance.random() < 0.5 for _ in every] for n in "abcd"}
        solids = {n: kuhn_solid([t for t, f in zip(every, one) if f]) for n, one in flags.items()}
        for expression in ("(a - b) & (c | d)", "a ^ b ^ c ^ d", "(a | b) - (c & ~d)"):
            code = compile(expression.replace("&", " and ").replace("|", " or ").replace("^", "!=")
                           .replace("~", " not ").replace("-", " and not "), "rule", "eval")
            if "^" in expression:
                count = sum(sum(f) % 2 for f in zip(*flags.values()))
            else:
                count = sum(bool(eval(code, {}, dict(zip("abcd", f)))) for f in zip(*flags.values()))
            name = {"(": "mixed", "a": "xor"}[expression[0]] + ("-late" if "~" in expression else "")
            cases.add(f"kuhn-four-{seed}-{name}", solids, expression, ["touching", "self-touching", "n-ary"],
                      f"an expression about four such solids (seed {seed})", {"volume": f"{count}/6"})
    self_touching(cases)


def self_touching(cases):
    shapes = {
        "edge": [(0, 0, 0), (1, 1, 0)], "vertex": [(0, 0, 0), (1, 1, 1)],
        "edges-ring": [(0, 0, 0), (1, 1, 0), (0, 1, 1), (1, 0, 1)],
        "pinched-hole": [(i, j, 0) for i in range(3) for j in range(3) if (i, j) not in ((1, 1), (2, 2))] + [(2, 2, 1)],
        "pinched-cavity": [(i, j, k) for i, j, k in product(range(3), repeat=3)
                           if (i, j, k) not in ((1, 1, 1), (0, 0, 0))],
        "cavity-edge": [(i, j, k) for i, j, k in product(range(4), range(3), range(3))
                        if (i, j, k) not in ((1, 1, 1), (0, 0, 1))],
    }
    for name, filled in shapes.items():
        solid = cells(filled)
        top = max(c[0] for c in filled) + 1
        others = {
            "half": box((0, 0, 0), (top, top, 0.5)), "corner": box((1, 1, 0), (top + 1, top + 1, 3)),
            "octahedron": octahedron((1, 1, 1), 1),
        }
        for other, b in others.items():
            for operation, sign in (("union", "|"), ("difference", "-")):
                cases.add(f"self-{name}-{other}-{operation}", {"a": solid, "b": b}, f"a {sign} b",
                          ["self-touching", "non-manifold", operation],
                          f"a solid that touches itself ({name}) and a {other} ({operation})")
