#!/usr/bin/env python3
"""The volume of every mesh of a collection that crosses itself, resolved by Strata and by libigl.

Usage: tools/bench/resolved_volumes.py BUILD [--all] [--most-triangles N] [--seconds N] [-o CSV] [MESH...]

BUILD is a build folder with the programs strata and strata-bench, the collection the folder that STRATA_CORPUS names. Closed meshes of
which `strata resolve --keep winding` says that they cross themselves, or have winding numbers other than 0 and 1, are resolved by libigl
as well: its union with nothing, which keeps the points with a positive winding number, too. It is exact until it rounds its result. Volumes
are computed from the results; Strata's is that of its report, before rounding. They are equal if they differ by 1e-12, relatively.
Needs the peers' Python with libigl. With --all what crosses nothing is compared as well: Strata does not change it, and libigl would show what
it overlooked. Every difference is explained:

  rounding    no more than what moving all of the surface by half of the last place of its largest coordinate explains
  strata, libigl, both, nobody is right    by winding numbers about points which one result contains and the other does not, and which are far
              from both surfaces (exact_winding.py, exact integers without the library)
  not found   there are no such points
"""
import argparse
import collections
import csv
import fractions
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time

import exact_winding
from corpus import meshes

sys.path.insert(0, str(pathlib.Path(__file__).parent / "peers"))
import peer  # noqa: E402

EQUAL = 1e-12
POINTS = 40  # of so many components of the symmetric difference of two results some points are tried


def libigl(case, result):
    """In a process of its own: it may run out of time or memory."""
    from igl.copyleft import cgal
    import numpy

    vertices, triangles = peer.read_case(case)[0]
    start = time.perf_counter()
    points, faces, _ = cgal.mesh_boolean(numpy.array(vertices), triangles.astype(numpy.int64), numpy.zeros((0, 3)),
                                         numpy.zeros((0, 3), numpy.int64), "union")
    print(time.perf_counter() - start)
    peer.write_result(result, points, faces)
    sys.stdout.flush()
    os._exit(0)


class Tools:
    def __init__(self, build, seconds):
        self.strata, self.bench = build / "tools/strata/strata", build / "tools/bench/strata-bench"
        self.seconds = seconds

    def run(self, *arguments):
        try:
            return subprocess.run([*map(str, arguments)], capture_output=True, text=True, errors="replace", timeout=self.seconds)
        except subprocess.TimeoutExpired:
            return None

    def mesh(self, path, folder):
        case = folder / "read"
        subprocess.run([self.bench, "read", path, case], check=True, stdout=subprocess.DEVNULL)
        return peer.read_case(case)[0]


def components(vertices, triangles):
    """The number of the connected component of every triangle."""
    import numpy

    label = numpy.arange(len(vertices))
    while True:
        lowest = label[triangles].min(1)
        before = label.copy()
        for corner in range(3):
            numpy.minimum.at(label, triangles[:, corner], lowest)
        label = label[label]
        if (label == before).all():
            return label[triangles[:, 0]]


def inner_points(vertices, triangles):
    """Points in the middle of what lies behind the largest triangles of the thickest components, those farthest from the surface first."""
    import numpy

    corners = vertices[triangles]
    first, second = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    normals = numpy.cross(first, second)
    area = numpy.linalg.norm(normals, axis=1)
    label = components(vertices, triangles)
    size = numpy.bincount(label, area)
    volume = numpy.bincount(label, ((corners[:, 0] - vertices[label]) * normals).sum(1))
    thickness = numpy.where(size > 0, abs(volume) / numpy.maximum(size, 1e-300), 0)
    found = []
    for component in numpy.argsort(-thickness)[:POINTS]:
        for face in (faces := numpy.flatnonzero(label == component))[numpy.argsort(-area[faces])[:4]]:
            if area[face] == 0:
                continue
            origin, inwards = corners[face].mean(0), -normals[face] / area[face]
            with numpy.errstate(all="ignore"):
                across = numpy.cross(inwards, second)
                scale = 1 / (first * across).sum(1)
                offset = origin - corners[:, 0]
                u = (offset * across).sum(1) * scale
                turned = numpy.cross(offset, first)
                v, t = turned @ inwards * scale, (second * turned).sum(1) * scale
                hit = (u >= 0) & (v >= 0) & (u + v <= 1) & (t > 0) & (numpy.arange(len(t)) != face)
            if hit.any():
                found.append((t[hit].min() / 2, origin + inwards * t[hit].min() / 2))
    return sorted(found, key=lambda f: -f[0])


def verdict(tools, folder, given, ours, theirs):
    """Who is right where the results differ."""
    difference = folder / "difference.off"
    done = tools.run(tools.strata, "symmetric-difference", ours, theirs, "--input", "overlapping", "-o", difference, "-q")
    if done is None or done.returncode not in (0, 5):
        return "not found: " + (done.stderr.strip() if done else "out of time")
    results = tools.mesh(ours, folder), tools.mesh(theirs, folder)
    right = collections.Counter()
    example = ""
    for clearance, point in inner_points(*tools.mesh(difference, folder)):
        inside = [exact_winding.winding_number(point, *result) > 0 for result in results]
        if inside[0] == inside[1]:
            continue
        number = exact_winding.winding_number(point, *given)
        who = "strata" if inside[0] == (number > 0) else "libigl"
        right[who] += 1
        if right[who] == 1:
            example += f" {who}: about ({', '.join(map(repr, map(float, point)))}) the number is {number}, clearance {clearance:.2g};"
        if sum(right.values()) == 10:
            break
    if not right:
        return "not found"
    return f"{' and '.join(right)} right at {sum(right.values())} points:{example}"


def compared(tools, folder, path, all_meshes):
    """Outcome, volumes, triangles, seconds of both, and what explains a difference; None for what does not cross itself."""
    ours, report = folder / "ours.off", folder / "report.json"
    done = tools.run(tools.strata, "resolve", path, "--keep", "winding", "-o", ours, "--report", report)
    if done is None:
        return "strata: out of time", None, None, None, None, ""
    if done.returncode not in (0, 5):
        return ("unreadable" if done.returncode == 3 else "refused" if done.returncode == 4 else f"strata: exit {done.returncode}",
                None, None, None, None, (done.stderr.strip().splitlines() or [""])[0])
    facts = json.loads(report.read_text())
    if not all_meshes and not any(d["kind"] in ("self-intersection", "inside-out") for d in facts["operands"][0]["defects"]):
        return None
    exact, seconds = fractions.Fraction(facts["result"]["volume_exact"] or facts["result"]["volume"]), facts["seconds"]["evaluate"]
    mine = float(exact)
    given = tools.mesh(path, folder)
    case = folder / "case"
    peer.write_result(case, *given)
    result = folder / "theirs"
    result.unlink(missing_ok=True)
    done = tools.run(sys.executable, __file__, "--libigl", case, result)
    if done is None:
        return "libigl: out of time", mine, None, seconds, None, ""
    if done.returncode != 0:
        return "libigl: failed", mine, None, seconds, None, (done.stderr.strip().splitlines() or [f"signal {-done.returncode}"])[-1]
    vertices, triangles = peer.read_case(result)[0]
    other = exact_winding.volume(vertices, triangles)
    yours, took = float(other), float(done.stdout)
    off = abs(other - exact)
    if off <= EQUAL * abs(exact):
        return "equal", mine, yours, seconds, took, ""
    import numpy

    corners = vertices[triangles]
    area = numpy.linalg.norm(numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1).sum() / 2
    if off <= area * numpy.spacing(abs(vertices).max()) / 2:
        return "rounding", mine, yours, seconds, took, ""
    file = folder / "theirs.off"
    with open(file, "w") as out:
        out.write(f"OFF\n{len(vertices)} {len(triangles)} 0\n")
        out.writelines(" ".join(map(repr, row)) + "\n" for row in vertices.tolist())
        out.writelines("3 " + " ".join(map(str, row)) + "\n" for row in triangles.tolist())
    return "differ", mine, yours, seconds, took, verdict(tools, folder, given, ours, file)


def main():
    if sys.argv[1:2] == ["--libigl"]:
        libigl(*sys.argv[2:])
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("meshes", nargs="*", help="these of the collection, or other files")
    parser.add_argument("--most-triangles", type=int, default=300000)
    parser.add_argument("--seconds", type=int, default=120, help="for one mesh and engine")
    parser.add_argument("--all", action="store_true", help="also meshes that cross nothing")
    parser.add_argument("-o", "--output", help="a CSV file of all that was compared or refused")
    options = parser.parse_intermixed_args()
    sys.set_int_max_str_digits(0)  # exact volumes are long
    corpus, paths = meshes("resolved_volumes", options.most_triangles)
    tools = Tools(options.build.resolve(), options.seconds)
    table, lines = collections.Counter(), []
    for name in options.meshes or paths:
        with tempfile.TemporaryDirectory() as folder:
            found = compared(tools, pathlib.Path(folder), corpus / name, options.all)
        table[found[0] if found else "crosses nothing"] += 1
        if found is None or found[0] in ("unreadable", "refused"):
            continue
        lines.append([name, *found])
        what, mine, yours, *_, why = found
        if what != "equal":
            print(f"{name}: {what}, volumes {mine} {yours} {why}", flush=True)
    if options.output:
        with open(options.output, "w", newline="") as out:
            csv.writer(out).writerows([["path", "outcome", "strata", "libigl", "strata s", "libigl s", "why"], *lines])
    for what, count in table.most_common():
        print(f"{count:5} {what}")


if __name__ == "__main__":
    main()
