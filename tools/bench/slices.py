#!/usr/bin/env python3
"""A mesh in many planes: Strata's `slice` beside trimesh and manifold3d.

Usage: tools/bench/slices.py BUILD CASE [--planes N] [--seconds N]

BUILD is a build folder with the programs strata and strata-bench, CASE the name of a case of the benchmark, whose first operand is cut. Strata's time is that
of the whole command, files in, file out; the peers' that of their functions, arrays in, polygons out, without making their mesh. All areas are
added up, to see that they found the same. A peer that is not done after N seconds is stopped between planes, and its time is told for the planes that it did.
Medians of 3 for Strata, once for peers. Needs Python with NumPy, trimesh (with shapely and networkx) and manifold3d.
"""
import argparse
import csv
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).parent / "peers"))
import peer  # noqa: E402
from snap_rounding import write  # noqa: E402


def strata(build, path, step, folder):
    out, seconds = folder / "out.csv", []
    for _ in range(3):
        start = time.perf_counter()
        subprocess.run([build / "tools/strata/strata", "slice", path, "--step", repr(step), "-o", out, "-q"], check=True)
        seconds.append(time.perf_counter() - start)
    csv.field_size_limit(10**9)
    with open(out, newline="") as file:
        rows = list(csv.DictReader(file))
    return statistics.median(seconds), len(rows), sum(float(row["area"]) for row in rows), [float(row["at"]) for row in rows]


def trimesh_slices(vertices, triangles, heights, limit):
    import trimesh

    mesh = trimesh.Trimesh(vertices, triangles, process=False)
    start, done, area = time.perf_counter(), 0, 0.0
    for first in range(0, len(heights), 20):  # planes at once, to be stopped in time
        some = heights[first:first + 20]
        for section in mesh.section_multiplane([0, 0, 0], [0, 0, 1], some):
            area += section.area if section is not None else 0
            done += 1
        if time.perf_counter() - start > limit:
            break
    return time.perf_counter() - start, done, area


def manifold_slices(vertices, triangles, heights, limit):
    import manifold3d

    solid = manifold3d.Manifold(manifold3d.Mesh64(vertices.astype(float), triangles.astype(numpy.uint64)))
    assert solid.num_tri() > 0
    start, done, area = time.perf_counter(), 0, 0.0
    for height in heights:
        area += solid.slice(height).area()
        done += 1
        if time.perf_counter() - start > limit:
            break
    return time.perf_counter() - start, done, area


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("case")
    parser.add_argument("--planes", type=int, default=1000)
    parser.add_argument("--seconds", type=float, default=120)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        subprocess.run([options.build / "tools/bench/strata-bench", "make", options.case, folder / "case"], check=True, capture_output=True)
        vertices, triangles = peer.read_case(folder / "case")[0]
        write(folder / "mesh.ply", vertices, triangles)
        step = float(vertices[:, 2].max() - vertices[:, 2].min()) / options.planes
        seconds, planes, area, heights = strata(options.build.absolute(), folder / "mesh.ply", step, folder)
    print("| engine | planes | seconds | ms per plane | sum of areas |\n|---|---|---|---|---|")
    print(f"| Strata | {planes} | {seconds:.2f} | {1000 * seconds / planes:.2f} | {area:.9g} |", flush=True)
    for engine, slices in ("trimesh", trimesh_slices), ("manifold3d", manifold_slices):
        try:
            seconds, done, area = slices(vertices, triangles, heights, options.seconds)
        except ImportError as error:
            print(f"| {engine} | | | | not here: {error} |")
            continue
        print(f"| {engine} | {done} | {seconds:.2f} | {1000 * seconds / done:.2f} | {area:.9g} |", flush=True)


if __name__ == "__main__":
    main()
