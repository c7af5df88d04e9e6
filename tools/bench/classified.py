#!/usr/bin/env python3
"""Are resolved meshes right? Points near their surfaces, classified by exact winding numbers of the meshes as they were.

Usage: tools/bench/classified.py BUILD [--points N] [--rule winding|even-odd] MESH...

BUILD is a build folder with the programs strata and strata-bench; a MESH is a file, or one of the collection that STRATA_CORPUS names. Of each,
points are chosen at random about its vertices, at distances from 1e-6 of its size to all of it, and everywhere in its box; such a point must be
inside the result of `strata resolve` exactly where its winding number about the mesh is positive, or odd. Winding numbers are computed with integers
and without the library (exact_winding.py). Prints a row per mesh; ends with 1 if any point is on the wrong side. Needs NumPy.
"""
import argparse
import json
import os
import pathlib
import random
import subprocess
import sys
import tempfile
import time

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).parent / "peers"))
import exact_winding  # noqa: E402
import peer  # noqa: E402


def points_about(vertices, count, generator):
    lower, upper = vertices.min(0), vertices.max(0)
    size = float((upper - lower).max())
    for i in range(count):
        if i % 4 == 0:
            yield [generator.uniform(*map(float, ends)) for ends in zip(lower, upper)]
        else:
            reach = size * 10 ** generator.uniform(-6, 0)
            yield [float(x) + generator.uniform(-reach, reach) for x in vertices[generator.randrange(len(vertices))]]


def classify(build, path, rule, count, folder):
    """Triangles, pairs that cross, seconds, points that agree, points on the wrong side, points on a surface."""
    def read(file):
        subprocess.run([build / "tools/bench/strata-bench", "read", file, folder / "case"], check=True, stdout=subprocess.DEVNULL)
        return peer.read_case(folder / "case")[0]

    out, report = folder / "out.ply", folder / "report.json"
    start = time.perf_counter()
    subprocess.run([build / "tools/strata/strata", "resolve", path, "--keep", rule, "-o", out, "-q"], check=True)
    seconds = time.perf_counter() - start
    subprocess.run([build / "tools/strata/strata", "check", path, "-q", "--report", report])
    defects = json.loads(report.read_text())["operands"][0]["defects"]
    pairs = max([d["count"] for d in defects if d["kind"] == "self-intersection"], default=0)
    given, result = read(path), read(out)
    right, wrong, on = 0, 0, 0
    for point in points_about(given[0], count, random.Random(7)):
        try:
            number = exact_winding.winding_number(point, *given)
            inside = number > 0 if rule == "winding" else number % 2 == 1
            agrees = exact_winding.winding_number(point, *result) == (1 if inside else 0)
        except exact_winding.Degenerate:
            on += 1
            continue
        right, wrong = right + agrees, wrong + (not agrees)
    return len(given[1]), pairs, seconds, right, wrong, on


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("meshes", nargs="+")
    parser.add_argument("--points", type=int, default=100)
    parser.add_argument("--rule", choices=["winding", "even-odd"], default="winding")
    options = parser.parse_args()
    corpus = pathlib.Path(os.environ.get("STRATA_CORPUS", "."))
    print("| mesh | triangles | pairs that cross | seconds | microseconds per triangle | points right | wrong | on a surface |")
    print("|---|---|---|---|---|---|---|---|")
    failures = 0
    with tempfile.TemporaryDirectory() as folder:
        for name in options.meshes:
            path = pathlib.Path(name) if pathlib.Path(name).exists() else corpus / name
            triangles, pairs, seconds, right, wrong, on = classify(options.build.absolute(), path, options.rule, options.points, pathlib.Path(folder))
            print(f"| {path.name} | {triangles} | {pairs} | {seconds:.3f} | {1e6 * seconds / triangles:.1f} | {right} | {wrong} | {on} |", flush=True)
            failures += wrong
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
