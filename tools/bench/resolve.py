#!/usr/bin/env python3
"""What it takes to resolve meshes that cross themselves: Strata beside trueform, libigl and CGAL.

Usage: tools/bench/resolve.py BUILD [--most N] [--threads N] [--rounds R] [--budget SECONDS] [--list FILE] [MESH...]

BUILD is a build folder with the programs strata, strata-bench and, for CGAL, cgal_bench. Meshes are those named, in the collection of
STRATA_CORPUS, or else the N closed ones of it with the most pairs of faces that cross (`strata check`; --list keeps what was found).
`case:NAME` is a case of strata-bench with all its operands in one mesh. Needs the peers' Python with trueform and libigl. Arrays in, arrays out; every structure is built anew; medians of the rounds after one to warm up. All
on the same processors, in turn, each in a process of its own. A peer that takes longer than the budget is measured once. Engines do one of:

  cut       cut faces where they cross, no more: trueform polygon_arrangements, libigl remesh_self_intersections, CGAL's experimental
            autorefine. Right if it is closed and the signed volume is that of the input
  winding   keep the points with a positive winding number: Strata (`combine` of class automatic, which returns doubles, and `resolve`, which
            returns exact vertices too), libigl mesh_boolean
  outer     keep all that is closed off from infinity: Strata (`resolve`), trueform outer_shell, CGAL's experimental
            autorefine_and_remove_self_intersections

Ratios are to Strata's `resolve` with the rule `outer` for these, and to Strata's `combine` for all others. Volumes are compared with those of
Strata, to 1e-6; resolved_volumes.py and tests judge these. `crosses` marks results which, rounded, cross or touch themselves again.
"""
import argparse
import functools
import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

from corpus import meshes

sys.path.insert(0, str(pathlib.Path(__file__).parent / "peers"))
import peer  # noqa: E402

AGREE = 1e-6


def trueform(function, real):
    import numpy
    import trueform as api

    def prepare(vertices, triangles):
        arrays = numpy.array(triangles), numpy.array(vertices, real)

        def run():
            made = getattr(api, function)(api.Mesh(*arrays))
            faces, points = made[0] if isinstance(made, tuple) else (made.faces, made.points)
            return numpy.asarray(points), numpy.asarray(faces)

        return run

    return prepare


def libigl(function):
    import numpy
    from igl.copyleft import cgal

    def prepare(vertices, triangles):
        arrays = numpy.array(vertices), triangles.astype(numpy.int64)
        nothing = numpy.zeros((0, 3)), numpy.zeros((0, 3), numpy.int64)

        def boolean():
            return cgal.mesh_boolean(*arrays, *nothing, "union")[:2]

        def remesh():
            return cgal.remesh_self_intersections(*arrays, stitch_all=True, cutoff=2**31 - 1)[:2]

        return {"boolean": boolean, "remesh": remesh}[function]

    return prepare


def peers():
    import numpy

    made = {}
    for name, function, kind in (("arrangement", "polygon_arrangements", "cut"), ("shell", "outer_shell", "outer")):
        for bits, real in ((64, numpy.float64), (32, numpy.float32)):
            made[f"trueform {name} f{bits}"] = kind, functools.partial(trueform, function, real)
    return made | {"libigl remesh": ("cut", functools.partial(libigl, "remesh")), "libigl boolean": ("winding", functools.partial(libigl, "boolean"))}


def measure_peer(name, case, result, rounds, budget):
    """In this process; imports are not timed."""
    run = peers()[name][1]()(*peer.read_case(case)[0])
    seconds = []
    start = time.perf_counter()
    while len(seconds) <= rounds and (not seconds or time.perf_counter() - start < budget):
        before = time.perf_counter()
        made = run()
        seconds.append(time.perf_counter() - before)
    peer.write_result(result, *made)
    print(json.dumps({"median": statistics.median(seconds[1:] or seconds), "warm_up_only": len(seconds) == 1}), flush=True)
    os._exit(0)


def crossing_meshes(strata, corpus, paths, seconds):
    """All that are closed and cross themselves, with the number of pairs that cross, most first."""
    found = []
    with tempfile.TemporaryDirectory() as folder:
        report = pathlib.Path(folder, "report.json")
        for path in paths:
            report.unlink(missing_ok=True)
            subprocess.run([strata, "check", corpus / path, "--report", report, "-q", "--timeout", str(seconds)], check=False,
                           capture_output=True)
            if not report.exists():
                continue
            defects = json.loads(report.read_text())["operands"][0]["defects"]
            counts = {d["kind"]: d["count"] for d in defects if d["severity"] == "error"}
            if counts.get("self-intersection") and not counts.keys() & {"open edge", "inconsistent orientation"}:
                found.append((counts["self-intersection"], path))
    return sorted(found, reverse=True)


def judged(bench, result, kind, volumes):
    """`right`, or what is wrong."""
    facts = json.loads(subprocess.run([bench, "judge", result], check=True, capture_output=True, text=True).stdout)
    if not facts["well_formed"] or not facts["closed"]:
        return facts, "not closed"
    off = abs(facts["volume"] - volumes[kind]) / abs(volumes[kind])
    if off > AGREE:
        return facts, f"volume off by {off:.1e}"
    if kind == "cut":
        return facts, "right"
    done = subprocess.run([bench, "embedded", result, "--repetitions", "1"], check=True, capture_output=True, text=True)
    return facts, "right" if json.loads(done.stdout)["embedded"] else "right, crosses"


def engines(build, request):
    bench, cgal = build / "tools/bench/strata-bench", build / "tests/oracle/cgal_bench"
    options = ["--threads", str(request.threads), "--repetitions", str(request.rounds), "--budget", str(request.budget)]
    resolve = ["--input", "automatic", *options]
    made = {"strata combine": ("winding", [bench, "run", "CASE", "--operation", "union", *resolve]),
            "strata resolve": ("winding", [bench, "resolve", "CASE", *resolve]),
            "strata outer": ("outer", [bench, "resolve", "CASE", "--keep", "outer", *resolve])}
    for name, (kind, _) in peers().items():
        made[name] = kind, [sys.executable, __file__, build, "CASE", "--peer", name, *options[2:]]
    if cgal.exists():
        made["CGAL autorefine"] = "cut", [cgal, "autorefine_epick", "CASE", *options[2:]]
        made["CGAL remove"] = "outer", [cgal, "remove_epick", "CASE", *options[2:]]
    return made


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("meshes", nargs="*")
    parser.add_argument("--most", type=int, default=10)
    parser.add_argument("--most-triangles", type=int, default=300000)
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--budget", type=float, default=30, help="seconds after which no round of an engine begins")
    parser.add_argument("--limit", type=float, default=300, help="seconds after which an engine is stopped")
    parser.add_argument("--list", type=pathlib.Path, help="a file of the meshes found: read if it exists, else written")
    parser.add_argument("--peer", help=argparse.SUPPRESS)
    parser.add_argument("--result", help=argparse.SUPPRESS)
    parser.add_argument("--repetitions", type=int, help=argparse.SUPPRESS)
    request = parser.parse_intermixed_args()
    if request.peer:
        measure_peer(request.peer, request.meshes[0], request.result, request.repetitions, request.budget)
    build = request.build.resolve()
    corpus, paths = meshes("resolve", request.most_triangles)
    if request.meshes:
        found = [("", name) for name in request.meshes]
    elif request.list and request.list.exists():
        found = json.loads(request.list.read_text())
    else:
        found = crossing_meshes(build / "tools/strata/strata", corpus, paths, 120)
        if request.list:
            request.list.write_text(json.dumps(found, indent=1))
    pinned = ["taskset", "--cpu-list", ",".join(str(n) for n in range(request.threads))]
    print("| mesh | triangles | pairs | engine | keeps | ms | ratio | result | triangles |\n|---|---|---|---|---|---|---|---|---|")
    for pairs, name in found[:request.most]:
        with tempfile.TemporaryDirectory() as folder:
            measure_mesh(build, request, pinned, pathlib.Path(folder), corpus, name, pairs)


def make_case(bench, corpus, name, case):
    """A case of one mesh; its number of triangles."""
    if not name.startswith("case:"):
        made = subprocess.run([bench, "read", corpus / name, case], check=True, capture_output=True, text=True)
        return json.loads(made.stdout)["triangles"]
    import numpy

    subprocess.run([bench, "make", name.removeprefix("case:"), case], check=True, stdout=subprocess.DEVNULL)
    operands = peer.read_case(case)
    first = numpy.cumsum([0] + [len(vertices) for vertices, _ in operands])
    triangles = numpy.concatenate([corners + start for (_, corners), start in zip(operands, first)])
    peer.write_result(case, numpy.concatenate([vertices for vertices, _ in operands]), triangles)
    return len(triangles)


def measure_mesh(build, request, pinned, folder, corpus, name, pairs):
    bench, case, result = build / "tools/bench/strata-bench", folder / "case", folder / "result"
    triangles = make_case(bench, corpus, name, case)
    volumes = {"cut": json.loads(subprocess.run([bench, "judge", case], check=True, capture_output=True, text=True).stdout)["volume"]}
    mine = {}
    for engine, (kind, command) in engines(build, request).items():
        result.unlink(missing_ok=True)
        command = [*pinned, *(case if word == "CASE" else word for word in command), "--result", result]
        start = f"| {name.split('/')[-1]} | {triangles} | {pairs} | {engine} | {kind} |"
        try:
            done = subprocess.run(command, capture_output=True, text=True, errors="replace", timeout=request.limit, check=False)
        except subprocess.TimeoutExpired:
            print(f"{start} > {1e3 * request.limit:.0f} | | out of time | |", flush=True)
            continue
        if done.returncode != 0 or not result.exists():
            why = (done.stderr.strip().splitlines() or [f"signal {-done.returncode}"])[-1]
            print(f"{start} | | failed: {why[:80]} | |", flush=True)
            continue
        answer = json.loads(done.stdout)
        if kind not in volumes:
            volumes[kind] = json.loads(subprocess.run([bench, "judge", result], check=True, capture_output=True, text=True).stdout)["volume"]
            mine[kind] = answer["median"]
        facts, verdict = judged(bench, result, kind, volumes)
        ratio = answer["median"] / mine.get(kind, mine["winding"])
        once = " (once)" if answer["warm_up_only"] else ""
        print(f"{start} {1e3 * answer['median']:.1f}{once} | {ratio:.2f} | {verdict} | {facts['triangles']} |", flush=True)


if __name__ == "__main__":
    main()
