#!/usr/bin/env python3
"""What each input class makes of a collection of meshes: a table, and a line per file.

Usage: tools/bench/input_classes.py [--tool STRATA] [--classes automatic,soup] [--most-triangles N] [--jobs N] [-o CSV]

The collection is the folder that STRATA_CORPUS names, with its INDEX.csv; files that it lists as duplicates are left out. Every
file becomes the result of a union with nothing else. Results are checked with `strata check`, the self-intersections of their exact
vertices included (they are written as XOFF). Outcomes:

  taken       as it is, without a note
  resolved    with a note: what crosses itself, what was welded, turned or filled
  refused     with the reason
  unreadable  no mesh in a known format
"""
import argparse
import collections
import concurrent.futures
import csv
import json
import pathlib
import subprocess
import tempfile

from corpus import meshes

TOOL = pathlib.Path(__file__).resolve().parents[2] / "build/bench/tools/strata/strata"


def run(tool, *arguments):
    return subprocess.run([tool, *map(str, arguments)], capture_output=True, text=True, errors="replace")


def outcome(tool, path, input_class, folder, seconds):
    result = pathlib.Path(folder) / "result.xoff"
    result.unlink(missing_ok=True)
    done = run(tool, "union", path, "-o", result, "--input", input_class, "--timeout", seconds, "-j", 1, "--report",
               result.with_suffix(".json"))
    if done.returncode == 3:
        return "unreadable", done.stderr.strip().splitlines()[-1:], None
    reasons = [line for line in done.stderr.splitlines() if "note" not in line]
    if done.returncode == 4:
        return "refused", reasons[:1] or done.stderr.splitlines()[:1], None
    if done.returncode != 0:
        return f"exit {done.returncode}", done.stderr.splitlines()[:1], None
    volume = json.loads(result.with_suffix(".json").read_text())["result"]["volume"]
    checked = run(tool, "check", result, "--timeout", seconds, "-j", 1)
    if checked.returncode != 0:
        return "no solid", checked.stderr.splitlines()[:1] or checked.stdout.splitlines()[:1], volume
    return ("resolved" if done.stderr.strip() else "taken"), [], volume


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--tool", default=TOOL)
    parser.add_argument("--classes", default="automatic,soup")
    parser.add_argument("--most-triangles", type=int, default=300000)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--seconds", type=int, default=60, help="for one file and class")
    parser.add_argument("-o", "--output", help="a CSV file of all outcomes")
    options = parser.parse_args()
    corpus, paths = meshes("input_classes", options.most_triangles)
    classes = options.classes.split(",")

    def job(path):
        with tempfile.TemporaryDirectory() as folder:
            return [outcome(options.tool, corpus / path, c, folder, options.seconds) for c in classes]

    table = {c: collections.Counter() for c in classes}
    lines = []
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for path, found in zip(paths, pool.map(job, paths)):
            for input_class, (what, why, volume) in zip(classes, found):
                table[input_class][what] += 1
                lines.append([path, input_class, what, volume, " ".join(why)])
    if options.output:
        with open(options.output, "w", newline="") as out:
            csv.writer(out).writerows([["path", "class", "outcome", "volume", "reason"], *lines])
    columns = sorted({what for counts in table.values() for what in counts})
    print("| class | files | " + " | ".join(columns) + " |")
    print("|---" * (len(columns) + 2) + "|")
    for input_class, counts in table.items():
        print(f"| {input_class} | {len(paths)} | " + " | ".join(str(counts[what]) for what in columns) + " |")
    readable = len(paths) - table[classes[-1]]["unreadable"]
    if readable:
        solids = table[classes[-1]]["taken"] + table[classes[-1]]["resolved"]
        print(f"{classes[-1]}: {solids} of {readable} readable files become solids ({100 * solids / readable:.1f} %)")


if __name__ == "__main__":
    main()
