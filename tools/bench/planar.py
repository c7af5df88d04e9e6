#!/usr/bin/env python3
"""Booleans of polygons beside Clipper2 (pyclipr) and GEOS (shapely): planar.py BENCH [--edges N] [--runs R] [CASE ...].

BENCH is the program planar_bench (tests/oracle). All get the same coordinates, which are integers, so that none of them rounds its
input; arrays in, arrays out, all in turn, medians of
the runs. Times are those of the processor: each of them runs on one thread. Clipper2 and GEOS round what they construct."""
import argparse
import json
import pathlib
import statistics
import subprocess
import tempfile
import time

import numpy
import pyclipr
import shapely

SCALE = 2.0**30


def ring(x, y):
    points = numpy.rint(numpy.stack([x, y], 1) * SCALE)
    keep = numpy.any(points != numpy.roll(points, 1, 0), 1)
    return points[keep]


def star(n, seed, depth, center=(0.0, 0.0)):
    """A circle whose radius is random within `depth`."""
    random = numpy.random.default_rng(seed)
    angle = numpy.arange(n) * 2 * numpy.pi / n
    radius = 0.4 * (1 - depth * random.random(n))
    return [ring(center[0] + radius * numpy.cos(angle), center[1] + radius * numpy.sin(angle))]


def blob(n, seed, center):
    """Smooth waves and a little noise."""
    random = numpy.random.default_rng(seed)
    angle = numpy.arange(n) * 2 * numpy.pi / n
    radius = 0.3 + sum(0.05 / k * numpy.cos(k * angle + random.random() * 7) for k in range(2, 40, 3))
    radius += 1e-6 * random.random(n)
    return [ring(center[0] + radius * numpy.cos(angle), center[1] + radius * numpy.sin(angle))]


def grid(n, even):
    """Cells of a map, every other one, moved nowhere: all borders coincide with those of the other half."""
    side = int((n / 2)**0.5)
    rings = []
    for i in range(side):
        for j in range(side):
            if (i + j) % 2 == even:
                x = numpy.array([i, i + 1, i + 1, i]) / side
                y = numpy.array([j, j, j + 1, j + 1]) / side
                rings.append(ring(x, y))
    return rings


def triangles(n, seed):
    """Many small ones, overlapping at random within an operand too."""
    random = numpy.random.default_rng(seed)
    center = random.random((n // 3, 1, 2))
    corners = center + (3 / n)**0.5 * (random.random((n // 3, 3, 2)) - 0.5)
    area = numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    corners[area < 0] = corners[area < 0][:, ::-1]
    return [ring(c[:, 0], c[:, 1]) for c in corners]


CASES = {
    "stars of 0.01 %": lambda n: (star(n, 1, 1e-4), star(n, 2, 1e-4)),
    "stars of 1 %": lambda n: (star(n, 1, 0.01), star(n, 2, 0.01)),
    "stars of 50 %": lambda n: (star(n, 1, 0.5), star(n, 2, 0.5)),
    "blobs": lambda n: (blob(n, 1, (0, 0)), blob(n, 2, (0.1, 0.05))),
    "map": lambda n: (grid(n, 0), grid(n, 1)),
    "triangles": lambda n: (triangles(n, 1), triangles(n, 2)),
}


def timed(work):
    start = time.process_time()
    result = work()
    return time.process_time() - start, result


def clipper(a, b, operation):
    kinds = {"union": pyclipr.Union, "intersection": pyclipr.Intersection, "difference": pyclipr.Difference, "xor": pyclipr.Xor}

    def work():
        engine = pyclipr.Clipper()
        engine.scaleFactor = 1
        engine.addPaths(a, pyclipr.Subject, False)
        engine.addPaths(b, pyclipr.Clip, False)
        return engine.execute(kinds[operation], pyclipr.FillRule.NonZero)

    seconds, rings = timed(work)
    area = sum((r[:, 0] * numpy.roll(r[:, 1], -1) - r[:, 1] * numpy.roll(r[:, 0], -1)).sum() / 2 for r in map(numpy.asarray, rings))
    return seconds, float(area)


def geos(a, b, operation):
    def polygons(rings):
        made = [shapely.Polygon(r) for r in rings]
        return made[0] if len(made) == 1 else shapely.union_all(made) if overlapping else shapely.MultiPolygon(made)

    overlapping = any(len(r) == 3 for r in a)
    function = {"union": shapely.union, "intersection": shapely.intersection, "difference": shapely.difference,
                "xor": shapely.symmetric_difference}[operation]

    def work():
        return function(polygons(a), polygons(b))

    seconds, result = timed(work)
    return seconds, result.area


def write(path, operands):
    numbers = [numpy.array([len(operands)], float)]
    for rings in operands:
        numbers.append(numpy.array([len(rings)], float))
        for r in rings:
            numbers += [numpy.array([len(r)], float), r.ravel()]
    numpy.concatenate(numbers).tofile(path)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("bench")
    parser.add_argument("cases", nargs="*", default=list(CASES))
    parser.add_argument("--edges", type=int, default=100000)
    parser.add_argument("--operations", default="union,intersection")
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--without", default="", help="clipper or geos: leave it out")
    options = parser.parse_args()
    peers = {name: peer for name, peer in (("clipper", clipper), ("geos", geos)) if name not in options.without}
    for name in options.cases:
        a, b = CASES[name](options.edges)
        for operation in options.operations.split(","):
            print(compare(options, name, operation, a, b, peers), flush=True)


def ours(bench, path, operation):
    """The median of five runs in a fresh process, of which the first ones get their memory from the system: the peers'
    process has got its own."""
    done = subprocess.run([bench, path, "--operation", operation, "--runs", "5"], check=True, capture_output=True, text=True)
    return json.loads(done.stdout)


def compare(options, name, operation, a, b, peers):
    times = {peer: [] for peer in ("strata", *peers)}
    areas, failed = {}, {}
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder, "operands")
        write(path, (a, b))
        for _ in range(options.runs):
            found = ours(options.bench, path, operation)
            times["strata"].append(found["seconds"])
            for peer, work in peers.items():
                try:
                    seconds, areas[peer] = work(a, b, operation)
                    times[peer].append(seconds)
                except Exception as error:  # a peer that fails is part of the comparison
                    failed[peer] = str(error)[:60]
    mine = statistics.median(times["strata"])
    line = f"{name:16} {operation:12} strata {mine:.4f} s ({found['vertices']} vertices, {found['rings']} rings)"
    for peer in peers:
        if peer in failed:
            line += f", {peer} failed: {failed[peer]}"
            continue
        seconds = statistics.median(times[peer])
        off = abs(areas[peer] - found["area"]) / max(abs(found["area"]), 1)
        line += f", {peer} {seconds:.4f} s (x{seconds / mine:.2f}, area off by {off:.0e})"
    return line


if __name__ == "__main__":
    main()
