#!/usr/bin/env python3
"""Chains of Booleans through binary STL: is each file that was written a solid for the next step?

Usage: tools/bench/stl_chains.py BUILD [--chains N] [--steps N] [--seed N]

BUILD is a build folder with the program strata. A chain begins with a box; each step unites it with, intersects it with or takes from it a
random box, tetrahedron or sphere, reads the STL of the step before and writes the next one. The same is done through XOFF, exactly. Any step that is
refused, and any file that `strata check` does not call a solid, is a failure. At the end the volumes of both are compared.
"""
import argparse
import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile

from rounded import box, write_off


def turned(points, turn, middle):
    a, b, c = turn
    matrix = [[math.cos(a) * math.cos(b), math.cos(a) * math.sin(b) * math.sin(c) - math.sin(a) * math.cos(c),
               math.cos(a) * math.sin(b) * math.cos(c) + math.sin(a) * math.sin(c)],
              [math.sin(a) * math.cos(b), math.sin(a) * math.sin(b) * math.sin(c) + math.cos(a) * math.cos(c),
               math.sin(a) * math.sin(b) * math.cos(c) - math.cos(a) * math.sin(c)],
              [-math.sin(b), math.cos(b) * math.sin(c), math.cos(b) * math.cos(c)]]
    return [[m + sum(x * y for x, y in zip(row, p)) for row, m in zip(matrix, middle)] for p in points]


def sphere(radius, sides):
    points, faces = [[0, 0, -radius]], []
    for i in range(1, sides):
        for j in range(sides):
            theta, phi = math.pi * i / sides, 2 * math.pi * j / sides
            points.append([radius * math.sin(theta) * math.cos(phi), radius * math.sin(theta) * math.sin(phi), -radius * math.cos(theta)])
    points.append([0, 0, radius])
    at = lambda i, j: 1 + (i - 1) * sides + j % sides
    for j in range(sides):
        faces += [(0, at(1, j + 1), at(1, j)), (at(sides - 1, j), at(sides - 1, j + 1), len(points) - 1)]
        for i in range(1, sides - 1):
            faces += [(at(i, j), at(i, j + 1), at(i + 1, j + 1)), (at(i, j), at(i + 1, j + 1), at(i + 1, j))]
    return points, [str(x) for f in faces for x in (3, *f)]


def random_tool(rng):
    middle = [rng.uniform(-1, 1) for _ in range(3)]
    turn = [rng.choice([0, 0, rng.uniform(0, 6)]) for _ in range(3)]
    kind = rng.randrange(3)
    if kind == 0:
        size = [rng.uniform(0.1, 0.8) for _ in range(3)]
        points, faces = box([-s for s in size], size)
    elif kind == 1:
        size = rng.uniform(0.2, 0.9)
        points = [[size, size, size], [size, -size, -size], [-size, size, -size], [-size, -size, size]]
        faces = [str(x) for f in ((0, 1, 2), (0, 3, 1), (0, 2, 3), (1, 3, 2)) for x in (3, *f)]
    else:
        points, faces = sphere(rng.uniform(0.2, 0.7), rng.choice([6, 10, 16]))
    return turned(points, turn, middle), faces


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--chains", type=int, default=200)
    parser.add_argument("--steps", type=int, default=50)
    parser.add_argument("--seed", type=int, default=1)
    given = parser.parse_args()
    strata = given.build / "tools/strata/strata"

    def run(*arguments):
        return subprocess.run([strata, *arguments], capture_output=True, text=True)

    failures, drifts, rearranged = 0, [], 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        report = folder / "report.json"
        for chain in range(given.chains):
            rng = random.Random(given.seed * 1000003 + chain)
            write_off(folder / "start.off", *box([-1, -1, -1], [1, 1, 1]))
            now, exact = folder / "now.stl", folder / "exact.xoff"
            run("union", folder / "start.off", "-o", now, "-q")
            run("union", folder / "start.off", "-o", exact, "-q")
            for step in range(given.steps):
                write_off(folder / "tool.off", *random_tool(rng))
                operation = rng.choice(["union", "union", "difference", "difference", "xor", "intersection" if rng.random() < 0.1 else "union"])
                done = run(operation, now, folder / "tool.off", "-o", now, "-q", "--report", report)
                also = run(operation, exact, folder / "tool.off", "-o", exact, "-q")
                if done.returncode or also.returncode or run("check", now, "-q").returncode:
                    failures += 1
                    print(f"chain {chain}, step {step}, {operation}: exit codes {done.returncode}, {also.returncode}: {done.stderr.strip()}")
                    break
                rearranged += json.loads(report.read_text())["result"]["rounding"]["rounds"] > 0
            else:
                run("info", now, "--report", report)
                volume = json.loads(report.read_text())["operands"][0]["volume"]
                run("info", exact, "--report", report)
                truth = json.loads(report.read_text())["operands"][0]["volume"]
                drifts.append(abs(volume - truth) / max(truth, 1e-9))
    drifts.sort()
    print(f"{given.chains} chains of {given.steps} steps: {failures} failures, {rearranged} files rearranged; volume off by "
          f"{drifts[len(drifts) // 2]:.2g} (median), {drifts[-1]:.2g} (most)" if drifts else f"{failures} failures")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
