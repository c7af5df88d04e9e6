#!/usr/bin/env python3
"""Times the Python package, arrays in and arrays out, beside manifold3d and trueform in the same run.

Usage: python.py [--repeat N] [--json FILE]; the interpreter must find strata_csg, and the peers that are to be compared.
Spheres are subdivided icosahedra, the second one moved; a time is the median of N. `overhead` is the time of a call beyond
what the library counts in its stages.
"""

import argparse
import json
import statistics
import subprocess
import sys
import time

import numpy
import strata_csg

LEVELS = {20: 0, 20480: 5, 81920: 6, 1310720: 8}


def sphere(level, shift):
    """A subdivided icosahedron on the unit sphere, moved."""
    g = (1 + 5**0.5) / 2
    corners = [(-1, g, 0), (1, g, 0), (-1, -g, 0), (1, -g, 0), (0, -1, g), (0, 1, g), (0, -1, -g), (0, 1, -g), (g, 0, -1),
               (g, 0, 1), (-g, 0, -1), (-g, 0, 1)]
    faces = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4), (11, 10, 2), (10, 7, 6),
             (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10),
             (8, 6, 7), (9, 8, 1)]
    vertices, triangles = numpy.array(corners, dtype=float), numpy.array(faces)
    for _ in range(level):
        sides = numpy.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
        edges, number = numpy.unique(sides, axis=0, return_inverse=True)
        middle = number.reshape(-1, 3) + len(vertices)
        vertices = numpy.vstack([vertices, vertices[edges].mean(axis=1)])
        a, b, c, (ab, bc, ca) = *triangles.T, middle.T
        triangles = numpy.vstack([numpy.stack(t, axis=1) for t in ((a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca))])
    vertices /= numpy.linalg.norm(vertices, axis=1)[:, None]
    return numpy.ascontiguousarray(vertices + shift), triangles.astype(numpy.uint32)


def median(call, repeat):
    times = []
    for _ in range(repeat):
        begin = time.perf_counter()
        call()
        times.append(time.perf_counter() - begin)
    return statistics.median(times)


def peers(a, b):
    """Calls by name, of the peers that are installed."""
    calls = {}
    try:
        import manifold3d

        def manifold(mesh):
            return manifold3d.Manifold(manifold3d.Mesh64(mesh[0], mesh[1].astype(numpy.uint64)))
        calls["manifold3d"] = lambda: (manifold(a) + manifold(b)).to_mesh64()
    except ImportError:
        pass
    try:
        import trueform
        calls["trueform"] = lambda: trueform.boolean_union(trueform.Mesh(a[1].astype(numpy.int32), a[0]),
                                                           trueform.Mesh(b[1].astype(numpy.int32), b[0]))
    except ImportError:
        pass
    return calls


def row(triangles, level, repeat):
    a, b = sphere(level, 0), sphere(level, numpy.array([0.31, 0.23, 0.17]))
    repeat = 1000 if triangles < 100 else repeat
    times = {"solid": median(lambda: strata_csg.boolean("union", [a, b], input="solid"), repeat),
             "automatic": median(lambda: strata_csg.boolean("union", [a, b]), repeat)}
    beyond = []
    for _ in range(repeat):
        begin = time.perf_counter()
        result = strata_csg.boolean("union", [a, b], input="solid")
        beyond.append(time.perf_counter() - begin - sum(result.seconds.values()))
    times["overhead"] = statistics.median(beyond)
    for name, call in peers(a, b).items():
        times[name] = median(call, repeat)
    return times


def import_time(repeat):
    program = "import time; t = time.perf_counter(); import strata_csg; print(time.perf_counter() - t)"
    return statistics.median(float(subprocess.run([sys.executable, "-c", program], capture_output=True, text=True,
                                                  check=True).stdout) for _ in range(repeat))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--repeat", type=int, default=5)
    parser.add_argument("--json")
    options = parser.parse_args()
    table = {"import": {"seconds": import_time(options.repeat)}}
    print(f"import strata_csg: {1e3 * table['import']['seconds']:.1f} ms")
    for triangles, level in LEVELS.items():
        table[f"2 x {triangles}"] = times = row(triangles, level, options.repeat)
        print(f"2 x {triangles}: " + ", ".join(f"{name} {1e3 * t:.3f} ms" for name, t in times.items()), flush=True)
    if options.json:
        with open(options.json, "w") as file:
            json.dump(table, file, indent=1)


if __name__ == "__main__":
    main()
