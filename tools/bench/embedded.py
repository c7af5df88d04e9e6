#!/usr/bin/env python3
"""Does a mesh intersect itself? Strata beside trueform and MeshLib: embedded.py BENCH [--threads N] [--rounds R] CASE...

BENCH is the program strata-bench, a CASE what `strata-bench list` names; its first mesh counts. Arrays in, answer out; the engines' own
structures are built anew each time. All on the same processors, in turn, medians of the rounds. Needs the peers' Python
(peers/install) to run this script, and STRATA_CORPUS for cases of real meshes. trueform and MeshLib do not count faces with a common vertex
as intersecting; trueform tests exactly on rounded coordinates, MeshLib in floats."""
import argparse
import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).parent / "peers"))
import peer  # noqa: E402


def trueform(real):
    import numpy
    import trueform as api

    def prepare(vertices, triangles):
        arrays = numpy.array(triangles), numpy.array(vertices, real)
        return lambda: api.has_self_intersections(api.Mesh(*arrays))

    return prepare


def meshlib():
    from meshlib import mrmeshnumpy, mrmeshpy

    def prepare(vertices, triangles):
        import numpy

        arrays = numpy.array(triangles), numpy.array(vertices)
        return lambda: len(mrmeshpy.findSelfCollidingTriangles(mrmeshpy.MeshPart(mrmeshnumpy.meshFromFacesVerts(*arrays)))) > 0

    return prepare


def peers():
    import numpy

    return {"trueform_f64": lambda: trueform(numpy.float64), "trueform_f32": lambda: trueform(numpy.float32), "meshlib": meshlib}


def measure_peer(name, case, rounds):
    """In this process: imports and the first run are not timed."""
    run = peers()[name]()(*peer.read_case(case)[0])
    answer = run()
    seconds = []
    for _ in range(rounds):
        start = time.perf_counter()
        answer = run()
        seconds.append(time.perf_counter() - start)
    print(json.dumps({"median": statistics.median(seconds), "intersects": bool(answer)}), flush=True)
    os._exit(0)


def json_of(command):
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    return json.loads(done.stdout) if done.returncode == 0 and done.stdout else None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("bench")
    parser.add_argument("cases", nargs="+")
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--peer", help=argparse.SUPPRESS)
    request = parser.parse_args()
    if request.peer:
        measure_peer(request.peer, request.cases[0], request.rounds)
    pinned = ["taskset", "--cpu-list", ",".join(str(n) for n in range(request.threads))]
    print(f"{'case':<18} {'triangles':>9} {'strata ms':>10} " + " ".join(f"{name + ' ms':>16} {'ratio':>6}" for name in peers()))
    with tempfile.TemporaryDirectory() as folder:
        for case in request.cases:
            file = str(pathlib.Path(folder) / "case")
            subprocess.run([request.bench, "make", case, file], check=True, stdout=subprocess.DEVNULL)
            own = json_of([*pinned, request.bench, "embedded", file, "--threads", str(request.threads), "--repetitions", str(request.rounds)])
            line = f"{case:<18} {own['triangles']:>9} {1e3 * own['median']:>10.1f} "
            for name in peers():
                other = json_of([*pinned, sys.executable, __file__, request.bench, file, "--peer", name, "--rounds", str(request.rounds)])
                if other is None:
                    line += f"{'failed':>16} {'':>6} "
                    continue
                differs = "" if other["intersects"] != own["embedded"] else "!"
                line += f"{1e3 * other['median']:>15.1f}{differs or ' '} {other['median'] / own['median']:>6.2f} "
            print(line, flush=True)


if __name__ == "__main__":
    main()
