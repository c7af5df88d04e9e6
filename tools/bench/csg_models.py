#!/usr/bin/env python3
"""What `strata eval` makes of the .csg files beneath a folder: evaluated, or refused and why, and how long it took.

    tools/bench/csg_models.py build/release/tools/strata/strata FOLDER
    tools/bench/csg_models.py build/release/tools/strata/strata FOLDER --against openscad

The second also runs OpenSCAD (2021.01 is meant) and compares volumes, connected components and Euler characteristics of solids,
and areas of shapes. Where OpenSCAD takes longer than the limit there is nothing to compare.
"""
import argparse
import collections
import pathlib
import re
import subprocess
import tempfile
import time
from typing import NamedTuple


class Made(NamedTuple):
    """What a program made of a model: a measure of its size, and what else is to be equal; or why it made nothing."""
    seconds: float
    size: float | None = None
    features: tuple = ()
    reason: str = ""


def solid_in(path):
    """Volume, and (components, Euler characteristic), of an OFF file."""
    words = iter([w for line in path.read_text().splitlines() for w in line.partition("#")[0].split()][1:])
    vertex_count, face_count, _ = (int(next(words)) for _ in range(3))
    vertices = [tuple(float(next(words)) for _ in range(3)) for _ in range(vertex_count)]
    faces = [[int(next(words)) for _ in range(int(next(words)))] for _ in range(face_count)]
    parent = list(range(vertex_count))

    def root(v):
        while parent[v] != v:
            parent[v] = parent[parent[v]]
            v = parent[v]
        return v

    volume, edges = 0.0, set()
    for face in faces:
        for u, v in zip(face, face[1:] + face[:1]):
            edges.add((min(u, v), max(u, v)))
            parent[root(u)] = root(v)
        a = vertices[face[0]]
        for u, v in zip(face[1:], face[2:]):
            b, c = vertices[u], vertices[v]
            volume += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6
    used = {v for face in faces for v in face}
    return volume, (len({root(v) for v in used}), len(used) - len(edges) + face_count)


def shape_in(path):
    """Area of an SVG file of straight lines. Holes are wound the other way."""
    twice = 0.0
    for path_data in re.findall(r' d="([^"]*)"', path.read_text(), re.DOTALL):
        for loop in path_data.split("M")[1:]:
            numbers = [float(n) for n in re.findall(r"-?[\d.]+(?:e[-+]?\d+)?", loop)]
            points = list(zip(numbers[::2], numbers[1::2]))
            twice += sum(x * v - u * y for (x, y), (u, v) in zip(points, points[1:] + points[:1]))
    return abs(twice / 2), ()


READERS = {"solid": ("off", solid_in), "shape": ("svg", shape_in)}


def run(command, kind, folder, limit):
    """What a command makes that is given the name of a file."""
    suffix, reader = READERS[kind]
    path = pathlib.Path(folder) / f"out.{suffix}"
    path.unlink(missing_ok=True)
    start = time.monotonic()
    try:
        done = subprocess.run([*map(str, command), "-o", str(path)], capture_output=True, text=True, timeout=limit, check=False)
    except subprocess.TimeoutExpired:
        return Made(limit, reason="out of time")
    seconds = time.monotonic() - start
    if done.returncode != 0 or not path.exists():
        return Made(seconds, reason=done.stderr.strip() or "no result")
    return Made(seconds, *reader(path))


def made_by_strata(program, model, folder, limit):
    """The kind of result, and the result."""
    for kind in READERS:
        made = run([program, "eval", model, "--quiet"], kind, folder, limit)
        if "is a shape in the plane" not in made.reason:
            break
    reason = made.reason.partition("column ")[2].partition(": ")[2] or made.reason
    return kind, made._replace(reason=reason)


def difference(ours, theirs):
    """In words; empty if there is none that matters."""
    if theirs.size is None:
        return "theirs: " + theirs.reason.splitlines()[-1][:80]
    found = []
    relative = abs(ours.size - theirs.size) / max(abs(theirs.size), 1e-300)
    if relative > 1e-6 and ours.size != theirs.size:
        found.append(f"size {ours.size:.9g}, theirs {theirs.size:.9g}")
    if ours.features != theirs.features:
        found.append(f"components and Euler characteristic {ours.features}, theirs {theirs.features}")
    return "; ".join(found)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("strata")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--against", metavar="OPENSCAD")
    parser.add_argument("--limit", type=float, default=120, help="seconds for each model")
    parser.add_argument("--pattern", default="", help="take models that contain this text only")
    options = parser.parse_args()
    outcomes = collections.Counter()
    compared, ours_total, theirs_total = 0, 0.0, 0.0
    with tempfile.TemporaryDirectory() as scratch:
        for model in sorted(options.folder.rglob("*.csg")):
            if options.pattern not in model.read_text(errors="replace"):
                continue
            kind, ours = made_by_strata(options.strata, model, scratch, options.limit)
            outcome = ours.reason or kind
            outcomes[outcome] += 1
            line = f"{ours.seconds:8.2f} s  {model.name}: {outcome}"
            if options.against and not ours.reason:
                theirs = run([options.against, model], kind, scratch, options.limit)
                found = difference(ours, theirs)
                if theirs.size is not None:
                    compared += 1
                    ours_total += ours.seconds
                    theirs_total += theirs.seconds
                line += f", theirs {theirs.seconds:.2f} s, {found or 'equal'}"
                outcomes["compared with theirs: " + ("different" if found and theirs.size is not None else "none" if found else "equal")] += 1
            print(line, flush=True)
    for outcome, count in outcomes.most_common():
        print(f"{count:5}  {outcome}")
    if compared:
        print(f"{compared} compared: {ours_total:.1f} s, theirs {theirs_total:.1f} s, ratio {theirs_total / ours_total:.1f}")


if __name__ == "__main__":
    main()
