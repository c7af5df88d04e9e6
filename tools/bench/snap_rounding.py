#!/usr/bin/env python3
"""Unions rounded to doubles by Strata, beside CGAL's iterative snap rounding of the same triangles.

Usage: tools/bench/snap_rounding.py BUILD SNAP_ROUNDING CASE...

BUILD is a build folder with the programs strata and strata-bench, SNAP_ROUNDING the program of tests/oracle/snap_rounding.cpp, and a CASE the name
of a case of the benchmark with two operands. Of CGAL only the function is timed, arrays in, arrays out; of Strata the whole command, files in,
file out, which also decides what is inside. Medians of 3. Untouched are triangles of the result that an operand has, coordinate by coordinate.
Needs the peers' Python.
"""
import argparse
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

HEADER = """ply
format binary_little_endian 1.0
element vertex {}
property double x
property double y
property double z
element face {}
property list uchar int vertex_indices
end_header
"""
FACE = numpy.dtype([("corners", "u1"), ("vertices", "<i4", 3)])


def write(path, vertices, triangles):
    faces = numpy.zeros(len(triangles), FACE)
    faces["corners"], faces["vertices"] = 3, triangles
    path.write_bytes(HEADER.format(len(vertices), len(triangles)).encode() + vertices.astype("<f8").tobytes() + faces.tobytes())


def read(path):
    head, body = path.read_bytes().split(b"end_header\n", 1)
    counts = [int(line.split()[2]) for line in head.decode().splitlines() if line.startswith("element")]
    vertices = numpy.frombuffer(body, "<f8", 3 * counts[0]).reshape(-1, 3)
    return vertices, numpy.frombuffer(body, FACE, counts[1], vertices.nbytes)["vertices"]


def corners(vertices, triangles):
    """Each triangle as bytes, from its least corner on."""
    points = (vertices + 0.0)[triangles]
    order = numpy.lexsort((points[:, :, 2], points[:, :, 1], points[:, :, 0]))[:, 0] if len(points) else numpy.zeros(0, int)
    turned = numpy.take_along_axis(points, ((order[:, None] + numpy.arange(3)) % 3)[:, :, None], axis=1)
    return {t.tobytes() for t in turned}


def compare(build, snap_rounding, case, folder):
    path = folder / "case"
    subprocess.run([build / "tools/bench/strata-bench", "make", case, path], check=True, capture_output=True)
    files, given = [], set()
    for i, (vertices, triangles) in enumerate(peer.read_case(path)):
        files.append(folder / f"{i}.ply")
        write(files[-1], vertices, triangles)
        given |= corners(vertices, triangles)
    ours, theirs, out = [], [], folder / "out.ply"
    for _ in range(3):
        start = time.perf_counter()
        subprocess.run([build / "tools/strata/strata", "union", *files, "-o", out, "-q"], check=True)
        ours.append(time.perf_counter() - start)
        theirs.append(json.loads(subprocess.run([snap_rounding, *files], check=True, capture_output=True).stdout))
    result = corners(*read(out))
    seconds, other = statistics.median(ours), statistics.median(t["seconds"] for t in theirs)
    print(f"| {case} | {seconds:.2f} | {other:.2f} | {other / seconds:.1f} | {len(result)} | {len(result & given)} "
          f"| {theirs[0]['triangles']} | {theirs[0]['untouched']} | {'yes' if theirs[0]['crosses'] else 'no'} |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("snap_rounding", type=pathlib.Path)
    parser.add_argument("cases", nargs="+")
    options = parser.parse_args()
    print("| case | Strata, s | CGAL, s | ratio | Strata's triangles | untouched | CGAL's triangles | untouched | CGAL's still cross |")
    print("|---|---|---|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        for case in options.cases:
            compare(options.build.absolute(), options.snap_rounding.absolute(), case, pathlib.Path(folder))


if __name__ == "__main__":
    main()
