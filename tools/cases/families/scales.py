"""One ulp apart, ends of the range of doubles, scales mixed."""
from math import inf, nextafter

from solids import box, octahedron, pyramid, tetrahedron, together


def stepped(x, steps):
    """The double so many steps above or below."""
    for _ in range(abs(steps)):
        x = nextafter(x, inf if steps > 0 else -inf)
    return x


def power(exponent):
    return 2.0**exponent


# The powers of two next to 1e-300, 1e-30, 1e30 and 1e150: scaling by them is exact.
SCALES = {"1e-300": power(-997), "1e-30": power(-100), "1e30": power(100), "1e150": power(498)}


def add_to(cases):
    ulps(cases)
    scaled_contacts(cases)
    mixed(cases)


def ulps(cases):
    unit = box((0.0, 0.0, 0.0), (1.0, 1.0, 1.0))
    names = {-1: "overlap", 0: "touch", 1: "gap"}
    for step, name in names.items():
        x = stepped(1.0, step)
        seconds = {
            "face": box((x, 0.0, 0.0), (2.0, 1.0, 1.0)),
            "edge": box((x, x, 0.0), (2.0, 2.0, 1.0)),
            "vertex": box((x, x, x), (2.0, 2.0, 2.0)),
            "apex": pyramid([(0.25, 0.25), (0.75, 0.25), (0.75, 0.75), (0.25, 0.75)], 2.0, (0.5, 0.5, x)),
            "tilted": tetrahedron((x, 0.5, 0.5), (2.0, 0.0, 0.0), (2.0, 1.0, 0.25), (2.0, 0.25, 1.0)),
        }
        for feature, b in seconds.items():
            parts = 2 if step == 1 else 1
            for operation, sign in (("union", "|"), ("intersection", "&"), ("difference", "-")):
                known = {"components": parts} if operation == "union" else None
                cases.add(f"ulp-{name}-{feature}-{operation}", {"a": unit, "b": b}, f"a {sign} b",
                          ["ulp", f"ulp-{name}", operation],
                          f"a {feature} one step of doubles from the other solid: {name}, which must stay ({operation})",
                          known)
    far = 2.0**52
    for step, name in names.items():
        a = box((far - 4, 0.0, 0.0), (far, 4.0, 4.0))
        b = box((far + step, 0.0, 0.0), (far + 4, 4.0, 4.0))
        cases.add(f"ulp-{name}-far-away", {"a": a, "b": b}, "a | b", ["ulp", f"ulp-{name}", "union"],
                  f"boxes at 2^52, where doubles are integers: {name} of 1", {"components": 2 if step == 1 else 1})
    tiny = 5e-324
    for operation, sign in (("union", "|"), ("intersection", "&"), ("xor", "^")):
        cases.add(f"ulp-denormal-{operation}", {"a": box((0, 0, 0), (4 * tiny, 4 * tiny, 4 * tiny)),
                                                "b": box((2 * tiny, tiny, tiny), (6 * tiny, 3 * tiny, 3 * tiny))},
                  f"a {sign} b", ["ulp", "scale", operation], f"boxes of a few denormal steps ({operation})")


def scaled_contacts(cases):
    block = box((0.0, 0.0, 0.0), (4.0, 4.0, 4.0))
    pairs = {
        "corner": (block, box((2.0, 2.0, 2.0), (6.0, 6.0, 6.0)), ("union", "difference")),
        "face": (block, box((4.0, 1.0, 1.0), (8.0, 3.0, 3.0)), ("union", "xor")),
        "edge": (block, box((4.0, 4.0, 1.0), (8.0, 8.0, 3.0)), ("union",)),
        "apex": (block, tetrahedron((2.0, 2.0, 4.0), (1.0, 1.0, 3.0), (2.0, 3.0, 3.0), (3.0, 2.0, 3.0)), ("difference",)),
        "octahedra": (octahedron((0.0, 0.0, 0.0), 2.0), octahedron((1.0, 1.0, 0.0), 2.0), ("union", "intersection")),
        "tilted": (block, tetrahedron((1.0, 2.0, 3.0), (7.0, 1.0, 1.0), (2.0, 7.0, 1.0), (3.0, 3.0, 9.0)),
                   ("union", "difference")),
    }
    sign = {"union": "|", "difference": "-", "xor": "^", "intersection": "&"}
    for size, s in SCALES.items():
        for name, (a, b, operations) in pairs.items():
            for operation in operations:
                cases.add(f"scale-{size}-{name}-{operation}", {"a": a.scaled(s), "b": b.scaled(s)},
                          f"a {sign[operation]} b", ["scale", f"scale-{size}", operation],
                          f"coordinates of about {size}: {name} ({operation})")


def mixed(cases):
    tags = ["scale", "mixed-scale"]
    for huge, tiny in ((1e200, 1e-200), (1e30, 1e-30), (1e15, 1e-15)):
        a = box((-huge, -huge, 0.0), (huge, huge, huge))
        b = box((-tiny, -tiny, -tiny), (tiny, tiny, 0.0))
        for operation, sign in (("union", "|"), ("difference", "-")):
            cases.add(f"mixed-{huge:.0e}-{operation}".replace("+", ""), {"a": a, "b": b}, f"a {sign} b",
                      [*tags, operation], f"a cube of size {tiny:.0e} hangs under one of size {huge:.0e} ({operation})")
        inside = box((-tiny, -tiny, 0.0), (tiny, tiny, tiny))
        cases.add(f"mixed-dent-{huge:.0e}".replace("+", ""), {"a": a, "b": inside}, "a - b", [*tags, "difference"],
                  f"a dent of size {tiny:.0e} in a cube of size {huge:.0e}", {"components": 1, "euler": 2, "facets": 11})
    thin = box((0.0, 0.0, 0.0), (1e300, 1.0, 1e-300))
    post = box((1.0, 0.25, -1.0), (2.0, 0.75, 1.0))
    cases.operations("mixed-thin-plate", thin, post, tags, "a plate of 1e300 by 1 by 1e-300, and a post through it")
    flat = tetrahedron((0.0, 0.0, 0.0), (1e150, 0.0, 0.0), (0.0, 1e-150, 0.0), (0.0, 0.0, 1.0))
    cases.operations("mixed-tetrahedron", flat, box((-1.0, -1.0, -1.0), (1.0, 1.0, 0.5)), tags,
                     "a tetrahedron with edges of 1e150, 1 and 1e-150")
    sizes = [box((0.0, 0.0, 0.0), (x, x, x)) for x in (1e-100, 1e-10, 1.0, 1e10, 1e100)]
    for operation, sign in (("union", "|"), ("xor", "^"), ("intersection", "&")):
        cases.add(f"mixed-corner-{operation}", {f"b{k}": b for k, b in enumerate(sizes)},
                  f" {sign} ".join(f"b{k}" for k in range(5)), [*tags, "n-ary", operation],
                  f"five cubes of sizes 1e-100 to 1e100 about one corner ({operation})")
    grains = together([box((x, 1.0, 1.0), (x + 1e-9, 1.0 + 1e-9, 2.0)) for x in (0.5, 1.0, 1.5)])
    cases.operations("mixed-grains", box((0.0, 0.0, 0.0), (3.0, 1.0, 1.5)), grains, tags,
                     "grains of 1e-9 stand in the plane of a face and pass a top")
