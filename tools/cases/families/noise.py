"""Coordinates that are no nice numbers: floats, doubles, both; turned lattices."""
import random
import struct

from solids import box, cells, generated, octahedron, tetrahedron


def as_float(x):
    return struct.unpack("f", struct.pack("f", x))[0]


def random_tetrahedron(chance, convert):
    while True:
        try:
            return tetrahedron(*[tuple(convert(chance.random()) for _ in range(3)) for _ in range(4)])
        except ValueError:
            continue


def add_to(cases):
    for bits, convert in (("float", as_float), ("double", float)):
        for seed in range(6):
            chance = random.Random(seed)
            a, b = random_tetrahedron(chance, convert), random_tetrahedron(chance, convert)
            cases.operations(f"noise-{bits}-{seed}", a, b, ["noise", f"noise-{bits}"],
                             f"two random tetrahedra of {bits}s (seed {seed})")
        chance = random.Random(100)
        for seed in range(3):
            solids = {f"t{k}": random_tetrahedron(chance, convert) for k in range(5)}
            for operation, sign in (("union", "|"), ("xor", "^")):
                cases.add(f"noise-{bits}-five-{seed}-{operation}", solids, f" {sign} ".join(solids),
                          ["noise", f"noise-{bits}", "n-ary", operation],
                          f"five random tetrahedra of {bits}s ({operation}, set {seed})", measured=False)
    turned(cases)
    spheres(cases)


def turned(cases):
    """Lattice solids turned by an angle, rounded: coplanar faces are coplanar no more, by an ulp or so."""
    from math import cos, sin
    for degrees, t in (("1", 0.017453292519943295), ("30", 0.5235987755982988), ("nearly-0", 1e-15)):
        c, s = cos(t), sin(t)
        c, s = round(c * 2**50) / 2**50, round(s * 2**60) / 2**60

        def turn(p):
            return (c * p[0] - s * p[1], s * p[0] + c * p[1], float(p[2]))

        a, b = box((0, 0, 0), (1, 1, 1)), box((0, 0, 0), (1, 1, 1))
        rotated = b.mapped(turn)
        rotated.parts = None  # sides are planar before they are rounded only
        rotated.faces = [t for f in rotated.faces for t in ((f[0], f[1], f[2]), (f[0], f[2], f[3]))]
        cases.operations(f"turned-{degrees}", a, rotated, ["noise", "turned"],
                         f"a cube and the same, turned by {degrees} degrees about an edge and rounded")


def spheres(cases):
    for level in (1, 2, 3):
        a = generated("sphere", centre=[0, 0, 0], radius=1, level=level)
        for name, centre in (("far", [1.3, 0.2, 0.1]), ("near", [0.01, 0.003, 0.002]), ("nearly-same", [1e-12, 0, 0])):
            b = generated("sphere", centre=centre, radius=1, level=level)
            cases.operations(f"spheres-{level}-{name}", a, b, ["noise", "sphere"],
                             f"two spheres of {20 * 4**level} triangles, the second moved ({name})")
        for seed in (1, 2):
            noisy = [generated("sphere", centre=[0.1 * k, 0, 0], radius=1, level=level, noise=0.3, seed=seed + 10 * k,
                               float=seed == 2) for k in range(2)]
            cases.operations(f"noisy-spheres-{level}-{seed}", *noisy, ["noise", "sphere"],
                             f"two rough spheres of {20 * 4**level} triangles cross in most of them (seed {seed})")
