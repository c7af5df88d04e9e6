"""What the numbers depend on."""

import datetime
import os
import pathlib
import platform
import re
import subprocess


def facts(build: pathlib.Path, root: pathlib.Path) -> dict:
    cache = cmake_cache(build)
    flags = [cache.get("CMAKE_CXX_FLAGS", ""), cache.get(f"CMAKE_CXX_FLAGS_{cache['CMAKE_BUILD_TYPE'].upper()}", "")]
    return {
        "date": datetime.datetime.now(datetime.timezone.utc).strftime("%Y-%m-%d %H:%M UTC"),
        "commit": commit(root),
        "processor": first_match("/proc/cpuinfo", r"model name\s*: (.*)"),
        "cpus": len(os.sched_getaffinity(0)),
        "memory_gb": round(int(first_match("/proc/meminfo", r"MemTotal:\s+(\d+) kB")) / 2**20),
        "system": first_match("/etc/os-release", r'PRETTY_NAME="?([^"\n]*)') + ", Linux " + platform.release(),
        "compiler": output(cache["CMAKE_CXX_COMPILER"], "--version").splitlines()[0],
        "flags": " ".join(f for f in flags if f),
        "checks": cache.get("STRATA_CHECKED", "OFF"),
        "load_at_start": round(os.getloadavg()[0], 2),
    }


def commit(root: pathlib.Path) -> str:
    name = output("git", "-C", root, "rev-parse", "--short", "HEAD").strip()
    changed = output("git", "-C", root, "status", "--porcelain", "--", "lib", "tools/bench/*.cpp", "tools/bench/*.h")
    return (name or "unknown") + (" with changes" if changed.strip() else "")


def cmake_cache(build: pathlib.Path) -> dict:
    text = (build / "CMakeCache.txt").read_text()
    return dict(re.findall(r"^(\w+):\w+=(.*)$", text, re.MULTILINE))


def first_match(path: str, pattern: str) -> str:
    found = re.search(pattern, pathlib.Path(path).read_text())
    return found[1] if found else "unknown"


def output(*command) -> str:
    try:
        return subprocess.run([str(c) for c in command], capture_output=True, text=True).stdout
    except OSError:
        return ""
