#!/usr/bin/env python3
"""What `strata eval` makes of the .csg files beneath a folder: evaluated, or refused and why, and how long it took.

    tools/bench/csg_models.py build/release/tools/strata/strata FOLDER
"""
import collections
import pathlib
import subprocess
import sys
import tempfile
import time


def run(program, model, folder):
    """'shape' or 'solid', or the reason of a refusal."""
    for kind, name in (("solid", "out.off"), ("shape", "out.wkt")):
        done = subprocess.run([program, "eval", model, "--quiet", "--timeout", "120", "-o", folder / name], capture_output=True, text=True)
        if "is a shape in the plane" not in done.stderr:
            break
    return kind if done.returncode == 0 else done.stderr.strip().partition("column ")[2].partition(": ")[2] or done.stderr.strip()


def main():
    program, folder = sys.argv[1:]
    outcomes = collections.Counter()
    with tempfile.TemporaryDirectory() as scratch:
        for model in sorted(pathlib.Path(folder).rglob("*.csg")):
            start = time.monotonic()
            outcome = run(program, model, pathlib.Path(scratch))
            print(f"{time.monotonic() - start:8.2f} s  {model.name}: {outcome}", flush=True)
            outcomes[outcome] += 1
    for outcome, count in outcomes.most_common():
        print(f"{count:5}  {outcome}")


if __name__ == "__main__":
    main()
