"""Sheets about one edge, planes through one point, towers of tips."""
import math

from solids import box, octahedron, prism, pyramid, tetrahedron, together

CORNERS = [(8, 0), (8, 3), (7, 4), (6, 6), (4, 7), (3, 8), (0, 8), (-3, 8), (-4, 7), (-6, 6), (-7, 4), (-8, 3), (-8, 0),
           (-8, -3), (-7, -4), (-6, -6), (-4, -7), (-3, -8), (0, -8), (3, -8), (4, -7), (6, -6), (7, -4), (8, -3)]


def ring(n):
    """n points around the origin in order, with integer coordinates and different directions."""
    import math
    points = []
    for k in range(n):
        t = 2 * math.pi * k / n
        points.append((round(1000 * math.cos(t)), round(1000 * math.sin(t))))
    return points


def wedges(n, size=2):
    """n wedges about the z axis, every second sector of 2n."""
    p = ring(2 * n)
    return [tetrahedron((0, 0, 0), (0, 0, size), (*p[2 * k], 1), (*p[2 * k + 1], 1)) for k in range(n)]


def add_to(cases):
    for sheets in (4, 6, 8, 12, 16, 24, 32, 48, 64):
        n = sheets // 2
        parts = wedges(n)
        whole = together(parts, weld=True)
        facts = {"components": 1, "euler": n + 1}
        cases.add(f"fan-{sheets}-block-difference", {"a": box((-2000, -2000, -1), (2000, 2000, 3)), "b": whole}, "a - b",
                  ["fan", "non-manifold", "difference"], f"a solid with {sheets} sheets about one edge is cut out")
        cases.add(f"fan-{sheets}-half-union", {"a": whole, "b": box((-2000, -2000, 0), (2000, 2000, 1))}, "a | b",
                  ["fan", "non-manifold", "union"], f"{sheets} sheets about an edge that ends within a slab")
        if n <= 16:
            solids = {f"w{k}": w for k, w in enumerate(parts)}
            for operation, sign in (("union", "|"), ("xor", "^")):
                cases.add(f"fan-{sheets}-{operation}", solids, f" {sign} ".join(solids),
                          ["fan", "n-ary", "non-manifold", operation],
                          f"{n} wedges about one edge, {sheets} sheets ({operation})", facts)
    for n in (3, 4, 6, 8, 12):
        p = ring(n)
        solids = {f"w{k}": tetrahedron((0, 0, 0), (0, 0, 2), (*p[k], 1), (*p[(k + 1) % n], 1)) for k in range(n)}
        cases.add(f"fan-closed-{n}", solids, " | ".join(solids), ["fan", "n-ary", "union"],
                  f"{n} wedges about an edge close the circle: the edge goes", {"components": 1, "euler": 2})
        cases.add(f"fan-closed-{n}-but-one", solids, " | ".join(list(solids)[:-1]) + " - " + list(solids)[-1],
                  ["fan", "n-ary", "difference"], f"{n - 1} of {n} wedges about an edge, the last one taken away",
                  {"components": 1, "euler": 2})
    planes_through_a_point(cases)
    towers(cases)


def planes_through_a_point(cases):
    for n in (3, 4, 5, 6, 8, 10, 12):
        p = ring(n)
        cone = pyramid([(x, y) for x, y in p], 1000, (0, 0, 0))
        block = box((-1500, -1500, 0), (1500, 1500, 500))
        cases.add(f"apex-{n}-difference", {"a": block, "b": cone}, "a - b", ["many-planes", "difference"],
                  f"{n} planes through one point, which is on a face of the other solid")
        cases.add(f"apex-{n}-union", {"a": block.moved(0, 0, -500), "b": cone}, "a | b",
                  ["many-planes", "non-manifold", "union"], f"a cone of {n} planes stands on its tip")
        mirrored = pyramid([(x, y) for x, y in p], -1000, (0, 0, 0))
        cases.add(f"apex-{n}-double-union", {"a": cone, "b": mirrored}, "a | b",
                  ["many-planes", "non-manifold", "union"], f"two cones of {n} planes, tip to tip",
                  {"components": 1, "euler": 3})
    for n in (2, 3, 4, 6, 8):
        solids = {f"o{k}": octahedron((0, 0, 0), 12).mapped(
            lambda q, k=k: (q[0] + k * q[1], q[1] + k * q[2], q[2] + k * q[0])) for k in range(n)}
        for operation, sign in (("union", "|"), ("intersection", "&"), ("xor", "^")):
            if n > 3 and operation != "union":
                continue
            cases.add(f"sheared-octahedra-{n}-{operation}", solids, f" {sign} ".join(solids),
                      ["many-planes", "n-ary", operation],
                      f"{n} sheared octahedra about one centre cross everywhere ({operation})", measured=n < 4)
    slabs = {f"s{k}": prism([(-9 - k, -1), (9 + k, -1), (9 + k, 1), (-9 - k, 1)], -3, 3).mapped(
        lambda q, k=k: (q[0] * 4 - q[1] * k, q[0] * k + q[1] * 4, q[2] + k)) for k in range(8)}
    for n in (3, 5, 8):
        part = {name: slabs[name] for name in list(slabs)[:n]}
        cases.add(f"slabs-about-axis-{n}", part, " | ".join(part), ["many-planes", "n-ary", "union"],
                  f"{n} slabs turned about one axis cross one another", measured=n < 4)


def towers(cases):
    for n in (2, 3, 5, 10, 20):
        solids = [tetrahedron((0, 0, 3 * k), (4, 0, 3 * k + 3), (0, 4, 3 * k + 3), (-4, -4, 3 * k + 3)) for k in range(n)]
        named = {f"t{k}": t for k, t in enumerate(solids)}
        cases.add(f"tower-{n}-union", named, " | ".join(named), ["tower", "n-ary", "non-manifold", "union"],
                  f"{n} tetrahedra, each on its tip in the middle of the one below",
                  {"components": 1, "euler": n + 1, "volume": 24 * n})
        whole = together(solids)
        cases.add(f"tower-{n}-drilled", {"a": whole, "b": box((-1, -1, -1), (1, 1, 3 * n + 1))}, "a - b",
                  ["tower", "difference"], f"a tower of {n} tetrahedra, drilled along its tips")
        tips = [octahedron((0, 0, 4 * k), 2) for k in range(n)]
        cases.add(f"tower-octahedra-{n}", {"a": together(tips[::2], weld=True), "b": together(tips[1::2], weld=True)}
                  if n > 1 else {}, "a | b", ["tower", "non-manifold", "union"],
                  f"{n} octahedra tip to tip, every second one in the same operand",
                  {"components": 1, "euler": n + 1, "volume": 0 + n * 32 // 3 if n % 3 == 0 else f"{32 * n}/3"})
