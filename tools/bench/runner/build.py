#!/usr/bin/env python3
"""Builds strata-benchmark-runner into bin/ beside this file, and says in bin/build-info.json what was built."""

import argparse
import datetime
import json
import pathlib
import re
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
PROGRAM = "strata-benchmark-runner"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--source", type=pathlib.Path, help="a checkout of Strata; else the one this file is in")
    parser.add_argument("--mode", choices=["release"], default="release")
    parser.add_argument("--clean", action="store_true", help="remove what was built")
    wish = parser.parse_args()
    if wish.clean:
        shutil.rmtree(HERE / "bin", ignore_errors=True)
        return
    source = checkout(wish.source)
    build = source / "build/benchmark-runner"
    configure = ["cmake", "--preset", "bench", "-B", build, "-DSTRATA_BUILD_TESTS=OFF"]
    subprocess.run(configure, cwd=source, check=True)
    subprocess.run(["cmake", "--build", build, "--parallel", "--target", "strata_benchmark_runner"], check=True)
    (HERE / "bin").mkdir(exist_ok=True)
    shutil.copy2(build / "tools/bench" / PROGRAM, HERE / "bin" / PROGRAM)
    (HERE / "bin/build-info.json").write_text(json.dumps(facts(source, build), indent=1) + "\n")


def checkout(wanted: pathlib.Path | None) -> pathlib.Path:
    places = [wanted.resolve()] if wanted else HERE.parents
    for place in places:
        if (place / "include/strata/strata.h").exists():
            return place
    sys.exit("There is no checkout of Strata here: name one with --source FOLDER")


def facts(source: pathlib.Path, build: pathlib.Path) -> dict:
    cache = dict(re.findall(r"^(\w+):\w+=(.*)$", (build / "CMakeCache.txt").read_text(), re.MULTILINE))
    manifest = (HERE / "runner.yaml").read_text()
    return {
        "runner_id": re.search(r"runner_id: (\S+)", manifest)[1],
        "build_mode": "release",
        "timestamp_utc": datetime.datetime.now(datetime.timezone.utc).strftime("%Y-%m-%dT%H:%M:%SZ"),
        "upstream": {"source": "git", "resolved_commit": said("git", "-C", source, "rev-parse", "HEAD")},
        "toolchain": {
            "compiler": said(cache["CMAKE_CXX_COMPILER"], "--version").partition("\n")[0],
            "cmake_version": said("cmake", "--version").partition("\n")[0].rpartition(" ")[2],
            "build_type": cache["CMAKE_BUILD_TYPE"],
        },
        "artifacts": [f"bin/{PROGRAM}"],
    }


def said(*command) -> str:
    return subprocess.run([str(word) for word in command], capture_output=True, text=True).stdout.strip()


if __name__ == "__main__":
    main()
