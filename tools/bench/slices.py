#!/usr/bin/env python3
"""A mesh in many planes: Strata's `slice` beside trimesh and manifold3d.

Usage: tools/bench/slices.py BUILD CASE [--planes N] [--seconds N]

BUILD is a build folder with the programs strata and strata-bench, CASE the name of a case of the benchmark, whose first operand is cut. All engines are timed
from a solid that is made before to the polygons of all planes, in turn, on one plane after the other or, Strata and trimesh, all at once; Strata's whole command,
files in, check, text out, is timed as well. All areas are added up, to see that they found the same. A peer that is not done after N seconds is stopped between planes,
and its time is told for the planes that it did, once; all others are medians of R rounds. Needs Python with NumPy, trimesh (with shapely and networkx) and manifold3d.
"""
import argparse
import csv
import json
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


def strata_command(build, path, step, folder):
    out = folder / "out.csv"
    start = time.perf_counter()
    subprocess.run([build / "tools/strata/strata", "slice", path, "--step", repr(step), "-o", out, "-q"], check=True)
    seconds = time.perf_counter() - start
    csv.field_size_limit(10**9)
    with open(out, newline="") as file:
        rows = list(csv.DictReader(file))
    return seconds, [float(row["at"]) for row in rows], sum(float(row["area"]) for row in rows)


def strata_slices(build, case, planes):
    command = [build / "tools/bench/strata-bench", "slice", case, "--planes", str(planes), "--threads", "2"]
    answer = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
    return answer["median"], answer["planes"]


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
    parser.add_argument("--rounds", type=int, default=5)
    options = parser.parse_args()
    build = options.build.absolute()
    times, done, areas = {}, {}, {}

    def took(engine, seconds, planes, area=None):
        times.setdefault(engine, []).append(seconds)
        done[engine] = planes
        areas[engine] = "" if area is None else f"{area:.9g}"

    peers = {"manifold3d": manifold_slices, "trimesh": trimesh_slices}
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        subprocess.run([build / "tools/bench/strata-bench", "make", options.case, folder / "case"], check=True, capture_output=True)
        vertices, triangles = peer.read_case(folder / "case")[0]
        write(folder / "mesh.ply", vertices, triangles)
        step = float(vertices[:, 2].max() - vertices[:, 2].min()) / options.planes
        for _ in range(options.rounds):
            seconds, heights, area = strata_command(build, folder / "mesh.ply", step, folder)
            took("Strata, whole command", seconds, len(heights), area)
            took("Strata", *strata_slices(build, folder / "case", options.planes))
            for engine, slices in list(peers.items()):
                try:
                    took(engine, *slices(vertices, triangles, heights, options.seconds))
                except ImportError as error:
                    print(f"{engine} is not here: {error}", file=sys.stderr)
                    del peers[engine]
                    continue
                if done[engine] < len(heights) or times[engine][-1] > options.seconds / options.rounds:
                    del peers[engine]  # once is enough
    print("| engine | planes | seconds | ms per plane | over Strata | sum of areas |\n|---|---|---|---|---|---|")
    own = statistics.median(times["Strata"]) / done["Strata"]
    for engine, all_times in times.items():
        seconds = statistics.median(all_times)
        each = seconds / done[engine]
        print(f"| {engine} | {done[engine]} | {seconds:.3f} | {1000 * each:.2f} | {each / own:.1f} | {areas[engine]} |")


if __name__ == "__main__":
    main()
