#!/usr/bin/env python3
"""Minkowski sums beside manifold3d's: minkowski.py BENCH A.off TOOL [--size S] [--runs N].

BENCH is the program minkowski_bench (tests/oracle), TOOL is ball:FACETS, cube or a file. Both are given the same meshes;
medians of the runs are printed, and both volumes. manifold3d rounds; its result need not be the same solid."""
import argparse
import pathlib
import statistics
import subprocess
import tempfile
import time

import manifold3d
import numpy


def read_off(path):
    words = [w for line in pathlib.Path(path).read_text().splitlines() for w in line.split("#")[0].split()]
    vertex_count, face_count = int(words[1]), int(words[2])
    at = 4 + 3 * vertex_count
    vertices = numpy.array(words[4:at], dtype=numpy.float64).reshape(-1, 3)
    faces = []
    for _ in range(face_count):
        n = int(words[at])
        loop = [int(w) for w in words[at + 1:at + 1 + n]]
        faces += [(loop[0], loop[i - 1], loop[i]) for i in range(2, n)]
        at += 1 + n
    return vertices, numpy.array(faces, dtype=numpy.uint64)


def manifold(path):
    vertices, faces = read_off(path)
    mesh = manifold3d.Mesh64(vert_properties=vertices, tri_verts=faces)
    mesh.merge()
    return manifold3d.Manifold(mesh)


def seconds_of_manifold(a, b, runs):
    times = []
    for _ in range(runs):
        start = time.perf_counter()
        volume = a.minkowski_sum(b).volume()  # evaluation is lazy
        times.append(time.perf_counter() - start)
    return statistics.median(times), volume


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("bench")
    parser.add_argument("a")
    parser.add_argument("tool")
    parser.add_argument("--size", default="0.05")
    parser.add_argument("--runs", type=int, default=5)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        b, prepared = pathlib.Path(folder, "b.off"), pathlib.Path(folder, "a.off")
        done = subprocess.run([options.bench, options.a, options.tool, "--size", options.size, "--runs",
                               str(options.runs), "--operands", prepared, b], check=True, capture_output=True, text=True)
        print(f"{pathlib.Path(options.a).name} + {options.tool}:", done.stdout.strip())
        seconds, volume = seconds_of_manifold(manifold(prepared), manifold(b), options.runs)
        print(f"    manifold3d {seconds:.4f} s, volume {volume:.12g}")


if __name__ == "__main__":
    main()
