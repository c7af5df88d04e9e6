#!/usr/bin/env python3
"""Do all verbs of the command line still write the same bytes?

record.py PROGRAM           compares with hashes.json and names every difference
record.py PROGRAM --write   writes hashes.json

Each operation is run on 1, 2 and 8 threads where its verb takes `-j`; these must agree. What is kept is the exit code and
SHA-256 of standard output and of every file written. Of reports, times, memory and counters of stages are left out.
"""
import argparse
import hashlib
import json
import math
import os
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
DATA = HERE.parents[1] / "data"
SPOT, GEAR, BRACKET, TORUS, SPHERE = (DATA / n for n in
                                      ("spot.obj", "gear.off", "bracket.off", "torus.off", "sphere.off"))
UNSTABLE = {"seconds", "counts", "peak_bytes", "strata"}
RENAMED = {"symmetric-difference": "xor"}  # words that were changed on purpose since the hashes were recorded


def ball(path, rings, shift):
    """A sphere of 2 * rings^2 triangles or so, moved by `shift`."""
    columns = 2 * rings
    points = [(0, 0, 1)]
    for i in range(1, rings):
        for j in range(columns):
            a, b = math.pi * i / rings, 2 * math.pi * j / columns
            points.append((math.sin(a) * math.cos(b), math.sin(a) * math.sin(b), math.cos(a)))
    points.append((0, 0, -1))
    at = lambda i, j: 1 + (i - 1) * columns + j % columns
    faces = [(0, at(1, j), at(1, j + 1)) for j in range(columns)]
    for i in range(1, rings - 1):
        for j in range(columns):
            faces += [(at(i, j), at(i + 1, j), at(i + 1, j + 1)), (at(i, j), at(i + 1, j + 1), at(i, j + 1))]
    last = len(points) - 1
    faces += [(last, at(rings - 1, j + 1), at(rings - 1, j)) for j in range(columns)]
    rounded = [[round(x + s, 9) for x, s in zip(p, shift)] for p in points]
    lines = ["OFF", f"{len(points)} {len(faces)} 0"] + [" ".join(map(repr, p)) for p in rounded]
    path.write_text("\n".join(lines + ["3 " + " ".join(map(str, f)) for f in faces]) + "\n")


def box(path, low, high, open_face=False):
    corners = [[(low, high)[(k >> i) & 1][i] for i in range(3)] for k in range(8)]
    quads = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)][1 if open_face else 0:]
    faces = [t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))]
    lines = ["OFF", f"8 {len(faces)} 0"] + [" ".join(map(str, p)) for p in corners]
    path.write_text("\n".join(lines + ["3 " + " ".join(map(str, f)) for f in faces]) + "\n")


def make_inputs(folder):
    ball(folder / "a.off", 40, (0, 0, 0))
    ball(folder / "b.off", 40, (0.3, 0.2, 0.1))
    ball(folder / "small.off", 6, (0.1, 0, 0))
    box(folder / "cube.off", (0, 0, 0), (1, 1, 1))
    box(folder / "beside.off", (1, 0, 0), (2, 1, 1))
    box(folder / "inside.off", (0.25, 0.25, 0.25), (0.75, 0.75, 1))
    box(folder / "open.off", (0, 0, 0), (1, 1, 1), open_face=True)
    (folder / "bow.wkt").write_text("POLYGON ((0 0, 3 0, 0 1, 3 2))\n")
    (folder / "square.wkt").write_text("POLYGON ((0.5 0, 2.5 0, 2.5 1.5, 0.5 1.5), (1 0.5, 1.5 0.5, 1 1))\n")
    (folder / "points.csv").write_text("x,y,z\n" + "".join(f"{i / 7},{i / 11},{i / 13}\n" for i in range(-9, 20)))
    (folder / "rays.csv").write_text("x,y,z,dx,dy,dz\n" + "".join(f"-3,{i / 9},{i / 8},1,{i / 50},0\n" for i in range(-9, 9)))
    (folder / "model.csg").write_text("difference() { cube(size = [4, 3, 2], center = false);\n"
                                      "multmatrix([[1, 0, 0, 1], [0, 1, 0, 1], [0, 0, 1, 1], [0, 0, 0, 1]]) "
                                      "sphere($fn = 12, $fa = 12, $fs = 2, r = 1); }\n")


def operations():
    """Name and arguments; OUT.x stands for a file to be kept."""
    ops = {}
    for verb in ("union", "intersection", "difference", "symmetric-difference"):
        ops[f"{verb} balls"] = [verb, "a.off", "b.off", "-o", "OUT.off", "--report", "OUT.json"]
        ops[f"{verb} cubes that touch"] = [verb, "cube.off", "beside.off", "-o", "OUT.xoff"]
        ops[f"{verb} bsp"] = [verb, "small.off", "inside.off", "-o", "OUT.off", "--engine", "bsp"]
        ops[f"{verb} planar"] = ["planar", verb, "bow.wkt", "square.wkt", "--fill", "even-odd", "-o", "OUT.wkt", "--exact"]
    ops |= {
        "spot and gear, stl": ["difference", SPOT, GEAR, "-o", "OUT.stl", "--certify"],
        "spot and gear, ply": ["difference", SPOT, GEAR, "-o", "OUT.ply"],
        "spot and gear, obj": ["intersection", SPOT, GEAR, "-o", "OUT.obj"],
        "three, exact": ["union", "a.off", "b.off", "cube.off", "-o", "OUT.xoff"],
        "overlapping": ["union", "a.off", "inside.off", "-o", "OUT.off", "--input", "overlapping"],
        "repair": ["union", "a.off", "beside.off", "-o", "OUT.off", "--input", "repair"],
        "eval": ["eval", "(a - b) & c", "a=a.off", "b=b.off", "c=cube.off", "-o", "OUT.off", "--report", "OUT.json"],
        "eval model": ["eval", "model.csg", "-o", "OUT.xoff"],
        "chain": ["chain", DATA / "drilled_bracket.json", "-o", "OUT.xoff", "--report", "OUT.json", "--exact-volumes"],
        "check": ["check", SPOT], "check open": ["check", "open.off"],
        "info": ["info", GEAR], "info exact": ["info", BRACKET, "--report", "OUT.json"],
        "compare": ["compare", "cube.off", "beside.off"], "compare itself": ["compare", "cube.off", "cube.off"],
        "layers": ["layers", TORUS, GEAR, "-o", "OUT.ply", "--report", "OUT.json"],
        "layers along a direction": ["layers", SPHERE, "cube.off", "--origin", "direction:1,2,3", "-o", "OUT.ply"],
        "decompose": ["decompose", GEAR, "-o", "OUT.glb", "--exploded", "--report", "OUT.json"],
        "contacts": ["contacts", "cube.off", "beside.off", "inside.off", "a.off", "--report", "OUT.json", "--distance"],
        "hull": ["hull", SPOT, "-o", "OUT.off"], "hull of points": ["hull", "--points", "points.csv", "cube.off", "-o", "OUT.xoff"],
        "topology": ["topology", "cube.off", "beside.off", "--expression", "a | b", "-o", "OUT.sgc", "--report", "OUT.json"],
        "minkowski": ["minkowski", BRACKET, "cube.off", "-o", "OUT.xoff"],
        "minkowski of gear": ["minkowski", GEAR, "cube.off", "-o", "OUT.off"],
        "erosion": ["erosion", "a.off", "inside.off", "-o", "OUT.off"],
        "offset": ["offset", BRACKET, "--by", "0.1", "--facets", "80", "-o", "OUT.stl"],
        "offset inwards": ["offset", "cube.off", "--by", "-0.1", "-o", "OUT.off"],
        "planar check": ["planar", "check", "bow.wkt"], "planar info": ["planar", "info", "square.wkt"],
        "planar geojson": ["planar", "union", "bow.wkt", "square.wkt", "-o", "OUT.geojson"],
        "planar svg": ["planar", "union", "bow.wkt", "square.wkt", "-o", "OUT.svg"],
        "planar bsp engine": ["planar", "union", "bow.wkt", "square.wkt", "-o", "OUT.wkt", "--exact", "--engine", "bsp"],
        "planar bridge": ["planar", "bridge", "square.wkt", "-o", "OUT.wkt"],
        "planar contacts": ["planar", "contacts", "bow.wkt", "square.wkt", "--report", "OUT.json"],
        "planar decompose": ["planar", "decompose", "square.wkt", "--report", "OUT.json"],
        "decompose volumes": ["decompose", "cube.off", "--volumes", "--report", "OUT.json"],
        "locate nearest": ["locate", "cube.off", "beside.off", "--points", "points.csv", "-o", "OUT.csv", "--nearest"],
        "locate": ["locate", "a.off", "cube.off", "--points", "points.csv", "-o", "OUT.csv", "--all"],
        "locate bsp": ["locate", "cube.off", "--points", "points.csv", "-o", "OUT.csv", "--engine", "bsp"],
        "ray": ["ray", "a.off", "cube.off", "--rays", "rays.csv", "-o", "OUT.csv", "--all", "--exact"],
        "ray first": ["ray", GEAR, "--rays", "rays.csv", "-o", "OUT.csv"],
        "draw": ["draw", GEAR, "--direction=-2,3,-2", "-o", "OUT.svg"],
        "draw filled": ["draw", "a.off", "cube.off", "--from", "5,6,7", "--style", "both", "-o", "OUT.svg"],
        "soup": ["union", "open.off", "beside.off", "-o", "OUT.off", "--input", "soup"],
        "separate": ["xor", "cube.off", "inside.off", "-o", "OUT.off", "--touching", "separate", "--report", "OUT.json"],
        "split": ["split", GEAR, "a.off", "--plane", "1,2,3,1/3", "-o", "OUT", "--report", "OUT.json"],
        "clip": ["clip", "a.off", "b.off", "--keep", "outside", "-o", "OUT.off"],
        "clip on": ["clip", "beside.off", "cube.off", "--keep", "on", "-o", "OUT.off"],
        "imprint": ["imprint", "a.off", "b.off", "cube.off", "-o", "OUT"],
        "cells": ["cells", "a.off", "b.off", "open.off", "-o", "OUT", "--walls", "--format", "off"],
        "section": ["section", GEAR, "cube.off", "--plane", "1,1,1,1/3", "-o", "OUT.wkt", "--exact", "--report", "OUT.json"],
        "slice": ["slice", SPOT, "a.off", "--along", "y", "--step", "0.05", "-o", "OUT.csv", "--report", "OUT.json"],
        "slice svg": ["slice", "a.off", "--step", "0.1", "-o", "OUT.svg"],
        "refused: open": ["union", "open.off", "cube.off", "-o", "OUT.off"],
        "refused: missing": ["union", "missing.off", "cube.off", "-o", "OUT.off"],
        "refused: usage": ["union", "--nonsense"],
    }
    return ops


def stable(value):
    if isinstance(value, dict):
        return {k: stable(v) for k, v in value.items() if k not in UNSTABLE}
    if isinstance(value, list):
        return [stable(v) for v in value]
    return RENAMED.get(value, value) if isinstance(value, str) else value


def digest(name, data, folder):
    data = data.replace(os.fsencode(folder), b"").replace(os.fsencode(DATA), b"")
    if name.endswith(".json"):
        data = json.dumps(stable(json.loads(data)), sort_keys=True).encode()
    return hashlib.sha256(data).hexdigest()


def run(program, arguments, threads):
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        make_inputs(folder)
        before = set(folder.iterdir())
        done = subprocess.run([program, *map(str, arguments), *(["-j", str(threads)] if threads else [])], cwd=folder,
                              stdin=subprocess.DEVNULL, capture_output=True, timeout=300, env={**os.environ, "STRATA_REPRODUCTIONS": name})
        record = {"exit": done.returncode, "stdout": digest("stdout", done.stdout, folder)}
        for path in sorted(set(folder.rglob("*")) - before):
            if path.is_file():
                record[path.relative_to(folder).as_posix()] = digest(path.name, path.read_bytes(), folder)
        return record


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program")
    parser.add_argument("--write", action="store_true")
    asked = parser.parse_args()
    program = Path(asked.program).resolve()
    kept = HERE / "hashes.json"
    known = {} if asked.write else json.loads(kept.read_text())
    found, wrong = {}, []
    for name, arguments in operations().items():
        records = [run(program, arguments, threads) for threads in (1, 2, 8)]
        found[name] = records[0]
        if any(r != records[0] for r in records):
            wrong.append(f"{name}: differs with the number of threads")
        elif not asked.write and found[name] != known.get(name):
            parts = [k for k in found[name] | known.get(name, {}) if found[name].get(k) != known.get(name, {}).get(k)]
            wrong.append(f"{name}: differs in {', '.join(parts)}")
    print(*wrong, sep="\n")
    if asked.write:
        kept.write_text(json.dumps(found, indent=1, sort_keys=True) + "\n")
    print(f"{len(found) - len(wrong)} passed, {len(wrong)} failed")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
