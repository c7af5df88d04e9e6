#!/usr/bin/env python3
"""Are rounded results of real meshes solids? Booleans of every solid of a collection with a box and with its own turned copy.

Usage: tools/bench/rounded.py BUILD [--most-triangles N] [--files N] [--seconds N] [--judge PROGRAM] [-o CSV]

BUILD is a build folder with the program strata, the collection the folder that STRATA_CORPUS names. Each mesh that `strata check` calls a
solid is united with, intersected with and diminished by a box over half of it, and its own copy turned about its middle. Results are
written as PLY (doubles) and STL (floats) with `--rounding valid`, and checked by `strata check`. With --judge, PROGRAM RESULT must end with
exit code 0 as well: build/dev/tests/oracle/strata_is_embedded does so where CGAL finds no self-intersection.
"""
import argparse
import collections
import csv
import json
import math
import pathlib
import subprocess
import sys
import tempfile
import time

from corpus import meshes

OPERATIONS = ["union", "intersection", "difference"]
# A rotation that is none about a coordinate axis, nor by a nice angle.
TURN = [[0.8727, -0.4321, 0.2269], [0.4830, 0.8346, -0.2649], [-0.0749, 0.3408, 0.9372]]


def read_off(path):
    words = path.read_text().split()
    count, faces = int(words[1]), int(words[2])
    numbers = [float(x) for x in words[4:4 + 3 * count]]
    points = [numbers[3 * v:3 * v + 3] for v in range(count)]
    return points, words[4 + 3 * count:4 + 3 * count + 4 * faces]


def write_off(path, points, faces):
    lines = ["OFF", f"{len(points)} {len(faces) // 4} 0"]
    lines += [" ".join(map(repr, p)) for p in points]
    lines += [" ".join(faces[4 * f:4 * f + 4]) for f in range(len(faces) // 4)]
    path.write_text("\n".join(lines) + "\n")


def box(lower, upper):
    points = [[(upper if n >> i & 1 else lower)[i] for i in range(3)] for n in range(8)]
    sides = [(0, 2, 3), (0, 3, 1), (4, 5, 7), (4, 7, 6), (0, 1, 5), (0, 5, 4), (2, 6, 7), (2, 7, 3), (0, 4, 6), (0, 6, 2), (1, 3, 7), (1, 7, 5)]
    return points, [str(x) for s in sides for x in (3, *s)]


def second_operands(folder, points, faces):
    lower = [min(p[i] for p in points) for i in range(3)]
    upper = [max(p[i] for p in points) for i in range(3)]
    extent = [u - l for l, u in zip(lower, upper)]
    middle = [(l + u) / 2 for l, u in zip(lower, upper)]
    low = [l + e * part for l, e, part in zip(lower, extent, (0.5013, -0.1007, -0.0991))]
    high = [u + e * part for u, e, part in zip(upper, extent, (0.0973, 0.1019, 0.1031))]
    write_off(folder / "box.off", *box(low, high))
    turned = [[m + sum(t * (x - c) for t, x, c in zip(row, p, middle)) for row, m in zip(TURN, middle)] for p in points]
    write_off(folder / "turned.off", turned, faces)
    return [folder / "box.off", folder / "turned.off"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--most-triangles", type=int, default=100000)
    parser.add_argument("--files", type=int, default=300)
    parser.add_argument("--seconds", type=float, default=60)
    parser.add_argument("--judge", type=pathlib.Path)
    parser.add_argument("-o", "--output", type=pathlib.Path)
    given = parser.parse_args()
    strata = given.build / "tools/strata/strata"
    corpus, names = meshes("rounded.py", given.most_triangles)

    def run(*arguments):
        try:
            return subprocess.run([strata, *arguments], capture_output=True, text=True, timeout=given.seconds)
        except subprocess.TimeoutExpired:
            return None

    rows, files = [], 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for mesh in names:
            if files == given.files:
                break
            if run("check", corpus / mesh, "-q").returncode != 0:
                continue
            own = folder / "own.off"
            if run("resolve", corpus / mesh, "--attributes", "none", "-o", own, "-q").returncode != 0:
                continue
            points, faces = read_off(own)
            if not points:
                continue
            files += 1
            for other in second_operands(folder, points, faces):
                for operation in OPERATIONS:
                    for kind in ("ply", "stl"):
                        result, report = folder / f"result.{kind}", folder / "report.json"
                        start = time.perf_counter()
                        done = run(operation, own, other, "-o", result, "--rounding", "valid", "--report", report, "-q")
                        row = {"mesh": mesh, "other": other.stem, "operation": operation, "format": kind, "verdict": "valid",
                               "seconds": round(time.perf_counter() - start, 3)}
                        if done is None:
                            row["verdict"] = "out of time"
                        elif done.returncode != 0:
                            row["verdict"] = f"exit code {done.returncode}"
                        elif run("check", result, "-q").returncode != 0:
                            row["verdict"] = "no solid"
                        elif given.judge and subprocess.run([given.judge, result]).returncode != 0:
                            row["verdict"] = "judged otherwise"
                        if row["verdict"] == "valid":
                            seconds = json.loads(report.read_text())["seconds"]
                            rounding = json.loads(report.read_text())["result"]["rounding"]
                            row |= {"evaluate": seconds["evaluate"], "round": seconds["round"]}
                            row |= {k: rounding[k] for k in ("rounds", "triangles", "moved_vertices", "far_vertices", "vanished_faces")}
                            row["units"] = rounding["largest_movement"] / rounding["unit"] if rounding["unit"] else 0
                        rows.append(row)
                        if row["verdict"] != "valid":
                            print(row, flush=True)

    if given.output:
        with given.output.open("w", newline="") as out:
            writer = csv.DictWriter(out, sorted({k for r in rows for k in r}))
            writer.writeheader()
            writer.writerows(rows)
    print(f"{files} meshes, {len(rows)} results")
    for kind in ("ply", "stl"):
        here = [r for r in rows if r["format"] == kind]
        valid = [r for r in here if r["verdict"] == "valid"]
        again = [r for r in valid if r["rounds"]]
        moved = sum(r["moved_vertices"] for r in again)
        print(f"{kind}: {dict(collections.Counter(r['verdict'] for r in here))}; rearranged {len(again)}, rounds at most "
              f"{max((r['rounds'] for r in again), default=0)}, movement at most {max((r['units'] for r in valid), default=0):.3g} units, "
              f"far vertices {sum(r['far_vertices'] for r in again)} of {moved} moved ones, "
              f"rounding / evaluation {sum(r['round'] for r in valid) / max(sum(r['evaluate'] for r in valid), math.ulp(0)):.3f}")
    return 0 if all(r["verdict"] == "valid" for r in rows) else 1


if __name__ == "__main__":
    sys.exit(main())
