"""Measures Strata and its peers on the cases of the benchmark; writes results.json and RESULTS.md.

Called by tools/bench/run, which builds what is measured.
"""

import argparse
import json
import pathlib
import subprocess
import sys
import time

import engines
import machine
import measuring
import report
import rightness
import runs

ROOT = pathlib.Path(__file__).resolve().parents[3]


def parse(arguments: list[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="tools/bench/run", description=__doc__.splitlines()[0])
    parser.add_argument("--build", type=pathlib.Path, required=True, help=argparse.SUPPRESS)
    parser.add_argument("--python", type=pathlib.Path, required=True, help=argparse.SUPPRESS)
    parser.add_argument("--cases", type=names, help="a20k,a327k: only these")
    parser.add_argument("--peers", type=names, help=f"only these of {','.join(engines.PEER_NAMES)}; 'none' for none")
    parser.add_argument("--threads", type=numbers, help="1,2 (the default)")
    parser.add_argument("--quick", action="store_true", help="three repetitions, little patience")
    parser.add_argument("--repetitions", type=int)
    parser.add_argument("--budget", type=float, help="seconds after which no repetition begins")
    parser.add_argument("--timeout", type=float, help="seconds after which an engine is stopped")
    parser.add_argument("--output", type=pathlib.Path, help="folder for results.json and RESULTS.md")
    parser.add_argument("--list", action="store_true", help="list the cases")
    parser.add_argument("--report", action="store_true", help="measure nothing: RESULTS.md anew from results.json")
    parser.add_argument(
        "--combine", type=pathlib.Path, nargs="+", metavar="FOLDER", help="measure nothing: one table of these runs"
    )
    return parser.parse_args(arguments)


def names(text: str) -> list[str]:
    return [] if text == "none" else text.split(",")


def numbers(text: str) -> list[int]:
    return [int(n) for n in text.split(",")]


def limits_of(wish: argparse.Namespace) -> measuring.Limits:
    repetitions, budget, timeout = (3, 1, 10) if wish.quick else (5, 5, 20)
    return measuring.Limits(wish.repetitions or repetitions, wish.budget or budget, wish.timeout or timeout)


def output_folder(wish: argparse.Namespace) -> pathlib.Path:
    """The table that the README links to is only written by a whole run."""
    chosen = wish.cases or wish.peers is not None or wish.threads or wish.quick
    return wish.output or (wish.build / "results" if chosen else ROOT / "tools/bench")


def choose_cases(all_cases: list[dict], wanted: list[str] | None) -> list[dict]:
    known = {case["name"]: case for case in all_cases}
    if wanted is None:
        return [case for case in all_cases if case["group"] not in ("smoke", "slow")]
    unknown = [name for name in wanted if name not in known]
    if unknown:
        sys.exit(f"There is no case {', '.join(unknown)}; --list lists them.")
    return [known[name] for name in wanted]


def choose_peers(wish: argparse.Namespace) -> tuple[list[engines.Engine], dict[str, str]]:
    found, missing = engines.find_peers(wish.build, wish.python, succeeds)
    if wish.peers is not None:
        unknown = [name for name in wish.peers if name not in engines.PEER_NAMES]
        if unknown:
            sys.exit(f"There is no peer {', '.join(unknown)}; there are {', '.join(engines.PEER_NAMES)}.")
        found = [engine for engine in found if engine.name in wish.peers]
        missing |= {name: "not asked for" for name in engines.PEER_NAMES if name not in wish.peers}
    return found, missing


def succeeds(command) -> bool:
    return subprocess.run(command, capture_output=True).returncode == 0


def choose_threads(wish: argparse.Namespace, cpus: int) -> list[int]:
    wanted = wish.threads or [1, 2]
    possible = [n for n in wanted if 1 <= n <= cpus]
    if possible != wanted:
        print(f"There are {cpus} CPUs: measuring with {possible} threads only.")
    if not possible:
        sys.exit("No number of threads is left to measure.")
    return possible


class Rounds:
    """Measures one case with all engines; those that were stopped once are not tried with fewer threads."""

    def __init__(self, place: measuring.Workplace, case: dict):
        self.place, self.case, self.stopped = place, case, {}

    def measure(self, engine: engines.Engine, threads: int) -> dict:
        if self.case["triangles"] > engine.most_triangles:
            return {"status": "not tried", "why": f"more than {engine.most_triangles:,} triangles"}
        if engine.name in self.stopped:
            return self.stopped[engine.name]
        found = self.place.measure(engine, self.case, threads)
        if found["status"] == "timeout":
            self.stopped[engine.name] = found
        return found

    def add(self, engine: engines.Engine, threads: int, found: dict) -> None:
        header = {"engine": engine.name, "family": engine.family, "sequential": engine.sequential}
        self.case["measurements"].append(header | found | {"threads": threads})


def measure_case(place, case: dict, ours, peers, thread_counts: list[int]) -> None:
    """All engines close together in time, so that what slows the machine slows all; ours before and after the peers."""
    case["measurements"] = []
    rounds = Rounds(place, case)
    for threads in sorted(thread_counts, reverse=True):
        before = rounds.measure(ours, threads)
        for engine in peers:
            if not engine.sequential or threads == min(thread_counts):
                rounds.add(engine, threads, rounds.measure(engine, threads))
        rounds.add(ours, threads, measuring.merged([before, rounds.measure(ours, threads)]))
    case["measurements"].sort(key=lambda m: m["threads"])
    rightness.settle(case)


def progress(case: dict, seconds: float) -> None:
    print(f"{case['name']:24} {seconds:6.1f} s")
    for m in case["measurements"]:
        if m["status"] == "not tried":
            continue
        figure = f"{1000 * m['median']:12.3f} ms" if "median" in m else " " * 15
        why = f": {m['why']}" if "why" in m else ""
        print(f"    {m['threads']} {m['engine']:16}{figure}  {m['status']}{why}", flush=True)


def measure_all(wish: argparse.Namespace) -> dict:
    place = measuring.Workplace(wish.build, limits_of(wish))
    cases = choose_cases(place.cases(), wish.cases)
    peers, missing = choose_peers(wish)
    thread_counts = choose_threads(wish, len(place.cpus))
    for name, why in sorted(missing.items()):
        print(f"Skipping {name}: {why}")
    results = {
        "machine": machine.facts(wish.build, ROOT),
        "settings": vars(place.limits) | {"threads": thread_counts},
        "peers": {engine.name: engine.label for engine in peers},
        "versions": {},
        "missing_peers": missing,
        "skipped_cases": {},
        "cases": [],
    }
    for case in cases:
        start = time.monotonic()
        why = place.make(case)
        if why is not None:
            print(f"Skipping {case['name']}: {why}")
            results["skipped_cases"][case["name"]] = why
            continue
        measure_case(place, case, engines.ours(wish.build), peers, thread_counts)
        results["cases"].append(case)
        progress(case, time.monotonic() - start)
    place.clear()
    results["versions"] = versions(results["cases"])
    return results


def versions(cases: list[dict]) -> dict:
    return {m["family"]: m["version"] for case in cases for m in case["measurements"] if "version" in m}


def main() -> None:
    wish = parse(sys.argv[1:])
    if wish.list:
        for case in measuring.Workplace(wish.build, limits_of(wish)).cases():
            print(f"{case['name']:24} {case['operation']:12} {case['about']}")
        return
    folder = output_folder(wish)
    folder.mkdir(parents=True, exist_ok=True)
    if wish.combine:
        measured = [run for other in wish.combine for run in read(other)]
        why = runs.difference(measured)
        if why is not None:
            sys.exit(f"These runs cannot be combined, they differ. {why}")
        write(folder, measured)
    elif not wish.report:
        write(folder, [measure_all(wish)])
    (folder / "RESULTS.md").write_text(report.markdown(runs.merged(read(folder))))
    print(f"Written: {folder / 'RESULTS.md'}")


def read(folder: pathlib.Path) -> list[dict]:
    return json.loads((folder / "results.json").read_text())["runs"]


def write(folder: pathlib.Path, measured: list[dict]) -> None:
    """A line per run: it is long."""
    lines = ",\n".join(json.dumps(run, separators=(",", ":")) for run in measured)
    (folder / "results.json").write_text(f'{{"runs":[\n{lines}\n]}}\n')


if __name__ == "__main__":
    main()
