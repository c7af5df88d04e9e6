#!/usr/bin/env python3
"""Cases in which rounding has the hardest time: is each result a solid in the numbers of its file?

Usage: tools/bench/worst_rounded.py BUILD [--only NAME]

BUILD is a build folder with the program strata. Each case is written as doubles (PLY) and as floats (binary STL), and read again by `strata check`.
What floats cannot hold is refused by name. Exits with 1 if a file is no solid, a case ends otherwise than it should, or takes a minute.
"""
import argparse
import json
import math
import pathlib
import random
import struct
import subprocess
import sys
import tempfile
import time
from fractions import Fraction

from rounded import box, write_off
from stl_chains import turned

WORST = pathlib.Path(__file__).parent / "worst"
TURN = (1.1, 0.7, math.sqrt(2))
TETRAHEDRON = [str(x) for f in ((0, 1, 2), (0, 3, 1), (0, 2, 3), (1, 3, 2)) for x in (3, *f)]


def tetrahedron(*corners):
    """Oriented outwards."""
    a, *others = [[Fraction(x) for x in p] for p in corners]
    u, v, w = ([x - y for x, y in zip(q, a)] for q in others)
    volume = sum(u[i] * (v[i - 2] * w[i - 1] - v[i - 1] * w[i - 2]) for i in range(3))
    first, second, third, fourth = corners
    return [first, second, third, fourth] if volume < 0 else [first, third, second, fourth], TETRAHEDRON


def joined(meshes):
    points, faces = [], []
    for p, f in meshes:
        faces += [str(int(x) + len(points)) if i % 4 else x for i, x in enumerate(f)]
        points = points + p
    return points, faces


def turned_box(low, high, scale=1.0):
    points, faces = box([low] * 3, [high] * 3)
    return [[scale * x for x in p] for p in turned(points, TURN, (0, 0, 0))], faces


def needles():
    """200 needles thinner than an ulp where they leave a box."""
    rng = random.Random(5)
    sharp = []
    for _ in range(200):
        tip = [rng.uniform(0.2, 0.8) for _ in range(3)]
        end = [t + rng.uniform(1, 2) * rng.choice([-1, 1]) for t in tip]
        tiny = 2.0 ** -51
        sharp.append(tetrahedron(tip, end, [end[0] + tiny, end[1], end[2]], [end[0], end[1] + tiny, end[2] + tiny]))
    return [box([0, 0, 0], [1, 1, 1]), joined(sharp)]


def shell(scale):
    """A turned box, from which one is taken that is an ulp smaller, cut by a box."""
    inner, faces = turned_box(-1, 1, scale)
    inner = [[math.nextafter(x, 0) for x in p] for p in inner]
    return [turned_box(-1, 1, scale), (inner, faces), ([[scale * x for x in p] for p in box([0, 0, 0], [2, 2, 2])[0]], faces)]


def ulp_apart():
    """Turned boxes, the second an ulp beside the first, and the third through the gap."""
    first, faces = turned_box(-1, 1)
    corners = turned(box([1, -1, -1], [3, 1, 1])[0], TURN, (0, 0, 0))
    second = [[math.nextafter(x, math.inf) for x in p] for p in corners]
    third = turned(box([-0.5, -0.5, -0.3], [2, 0.7, 0.9])[0], TURN, (0.01, 0.02, 0.03))
    return [(first, faces), (second, faces), (third, faces)]


def fan():
    """1,000 sheets about one edge, which ends within a box: its end is rounded."""
    p, q = [0.1, 0.2, 0.3], [2.3, 1.9, 2.7]
    axis = [b - a for a, b in zip(p, q)]
    length = math.sqrt(sum(x * x for x in axis))
    w = [x / length for x in axis]
    u = [w[1], -w[0], 0]
    size = math.hypot(*u)
    u = [x / size for x in u]
    v = [w[1] * u[2] - w[2] * u[1], w[2] * u[0] - w[0] * u[2], w[0] * u[1] - w[1] * u[0]]

    def at(k):
        angle = 2 * math.pi * k / 1000
        return [a + math.cos(angle) * x + math.sin(angle) * y for a, x, y in zip(p, u, v)]
    wedges = [tetrahedron(p, q, at(2 * k), at(2 * k + 1)) for k in range(500)]
    return [joined(wedges), box([-1, -1, -1], [1.5, 1.5, 1.5])]


def checkerboard():
    """Every second cell of 20^3, turned, and a box."""
    cells = [box([i, j, k], [i + 1, j + 1, k + 1]) for i in range(20) for j in range(20) for k in range(20) if (i + j + k) % 2 == 0]
    index, points, faces = {}, [], []
    for p, f in cells:
        for i, x in enumerate(f):
            if i % 4 == 0:
                faces.append(x)
                continue
            corner = tuple(p[int(x)])
            if corner not in index:
                index[corner] = len(points)
                points.append(corner)
            faces.append(str(index[corner]))
    return [(turned([[x - 10 for x in p] for p in points], TURN, (0, 0, 0)), faces), box([-7, -6, -5], [5, 6, 7])]


def smallest():
    """Boxes of a few steps of the smallest numbers, and a tetrahedron through them."""
    tiny = 5e-324
    a = [[tiny * x for x in p] for p in box([0, 0, 0], [1, 1, 1])[0]]
    b = tetrahedron([-2 * tiny, -tiny, 0], [3 * tiny, 0, tiny], [0, 4 * tiny, 0], [tiny, tiny, 5 * tiny])
    return [(a, box([0, 0, 0], [1, 1, 1])[1]), b]


def read_off(name):
    numbers = (WORST / name).read_text().split()
    points, faces = int(numbers[1]), int(numbers[2])
    return ([[float(x) for x in numbers[4 + 3 * n:7 + 3 * n]] for n in range(points)],
            numbers[4 + 3 * points:4 + 3 * points + 4 * faces])


def plates(names):
    """Plates a few to 150 units thick and parts of a unit apart, found by a random search."""
    return [read_off(f"plate_{name}.off") for name in names]


def stacks(count, thickness):
    """Two stacks of plates, each turned by angles of its own."""
    plates = joined([box([-1, -1, k / count - 0.5], [1, 1, k / count - 0.5 + thickness]) for k in range(count)])
    return [(turned(plates[0], turn, (0, 0, 0)), plates[1]) for turn in (TURN, (0.3, 1.2, 2.5))]


def chain_step(name):
    """A file of a chain of Booleans through floats, and the tool of the next step."""
    places, faces = {}, []
    for number in struct.iter_unpack("<12xfffffffff2x", (WORST / f"{name}.stl").read_bytes()[84:]):
        faces += ["3", *(str(places.setdefault(number[k:k + 3], len(places))) for k in (0, 3, 6))]
    return [([list(p) for p in places], faces), read_off(f"{name}_tool.off")]


def beyond_floats():
    """A box of 1e39 and one through it."""
    faces = box([0, 0, 0], [1, 1, 1])[1]
    return [(turned_box(-1, 1, 1e39)[0], faces), ([[1e39 * x for x in p] for p in box([0, 0, 0], [1, 1, 1])[0]], faces)]


# Name, operands, expression, and whether floats can hold it.
CASES = [("needles", needles, "a | b", True), ("needles, taken out", needles, "a - b", True),
         ("shell of an ulp", lambda: shell(1.0), "(a - b) & c", True), ("shell of an ulp, 1e300", lambda: shell(1e300), "(a - b) & c", False),
         ("shell of an ulp, 1e-300", lambda: shell(1e-300), "(a - b) & c", True),
         ("an ulp apart", ulp_apart, "a | b | c", True), ("an ulp apart, taken out", ulp_apart, "c - a - b", True),
         ("1,000 sheets", fan, "a & b", True), ("1,000 sheets, taken out", fan, "b - a", True),
         ("checkerboard", checkerboard, "a & b", True), ("checkerboard, taken out", checkerboard, "b - a", True),
         ("smallest numbers", smallest, "a | b", True), ("plates", lambda: plates("abcd"), "a ^ b ^ c ^ d", True),
         ("stacks of plates", lambda: stacks(40, 0.01), "a | b", True), ("stacks of sheets", lambda: stacks(20, 1e-7), "a | b", True),
         ("six plates", lambda: plates("efghij"), "a ^ b ^ c ^ d ^ e ^ f", True), ("chain step", lambda: chain_step("chain"), "a ^ b", True),
         ("chain step, other order", lambda: chain_step("chain"), "b ^ a", True), ("chain step b", lambda: chain_step("chain_b"), "a ^ b", True), ("1e39", beyond_floats, "a | b", False)]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--only", help="cases whose name has this")
    given = parser.parse_args()
    strata = given.build / "tools/strata/strata"
    failures = 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for case, make, expression, fits_floats in CASES:
            if given.only and given.only not in case:
                continue
            operands = []
            for letter, (points, faces) in zip("abcdef", make()):
                write_off(folder / f"{letter}.off", points, faces)
                operands += [f"{letter}={folder / letter}.off"]
            for file in ("out.ply", "out.stl"):
                begin = time.perf_counter()
                done = subprocess.run([strata, "eval", expression, *operands, "-o", folder / file, "--report", folder / "report.json",
                                       "--timeout", "60"],
                                      capture_output=True, text=True)
                seconds = time.perf_counter() - begin
                if file == "out.stl" and not fits_floats:
                    is_right = done.returncode == 3 and "beyond the largest number" in done.stderr
                    said = done.stderr.strip().splitlines()[-1] if done.stderr else "nothing"
                    print(f"{case:24} {file[4:]:4} {'refused' if is_right else 'WRONG':8} {done.returncode} {said}", flush=True)
                else:
                    checked = subprocess.run([strata, "check", folder / file], capture_output=True, text=True)
                    is_right = done.returncode in (0, 5) and checked.returncode == 0
                    rounding = json.loads((folder / "report.json").read_text())["result"]["rounding"] if done.returncode in (0, 5) else None
                    print(f"{case:24} {file[4:]:4} {'solid' if is_right else 'WRONG':8} {done.returncode} {seconds:.2f} s "
                          f"{rounding if is_right else done.stderr[-300:] + checked.stdout[-300:]}", flush=True)
                failures += not is_right
    print(f"{failures} failures")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
