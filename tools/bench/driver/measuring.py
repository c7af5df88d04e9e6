"""Measurements, each in a process of its own, pinned."""

import dataclasses
import json
import os
import pathlib
import statistics
import subprocess

from engines import Engine


@dataclasses.dataclass(frozen=True)
class Limits:
    repetitions: int  # after one to warm up
    budget: float  # seconds after which no repetition begins
    timeout: float  # seconds after which an engine is stopped: no answer


class Workplace:
    """Where cases and results lie while they are needed."""

    def __init__(self, build: pathlib.Path, limits: Limits):
        self.program = build / "tools/bench/strata-bench"
        self.folder = build / "cases"
        self.folder.mkdir(parents=True, exist_ok=True)
        self.limits = limits
        self.cpus = sorted(os.sched_getaffinity(0))

    def cases(self) -> list[dict]:
        return self._ask("list")

    def make(self, case: dict) -> str | None:
        """Writes the case and notes its size in it; None, or why it cannot be made."""
        answer = subprocess.run(
            [self.program, "make", case["name"], self.folder / "case.bm"], capture_output=True, text=True
        )
        if answer.returncode != 0:
            return answer.stderr.strip()
        case |= json.loads(answer.stdout)
        return None

    def measure(self, engine: Engine, case: dict, threads: int) -> dict:
        """What the engine printed, with a status: done, timeout, failed; done ones are judged."""
        result = self.folder / "result.bm"
        result.unlink(missing_ok=True)
        command = [*engine.command, self.folder / "case.bm", "--operation", case["operation"]]
        command += ["--threads", threads, "--repetitions", self.limits.repetitions, "--budget", self.limits.budget]
        command += ["--result", result] + (["--one-by-one"] if case["one_by_one"] else [])
        found = self._run([str(word) for word in command], threads)
        if found["status"] == "done":
            found["judged"] = self._ask("judge", result)
        result.unlink(missing_ok=True)
        return found

    def clear(self) -> None:
        (self.folder / "case.bm").unlink(missing_ok=True)

    def _run(self, command: list[str], threads: int) -> dict:
        def pin():
            os.sched_setaffinity(0, self.cpus[:threads])

        process = subprocess.Popen(
            command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, preexec_fn=pin, env=quiet_environment()
        )
        try:
            output, errors = process.communicate(timeout=self.limits.timeout)
        except subprocess.TimeoutExpired:
            process.kill()
            process.communicate()
            return {"status": "timeout", "timeout": self.limits.timeout}
        if process.returncode < 0:
            return {"status": "failed", "why": f"ended by signal {-process.returncode}"}
        if process.returncode != 0:
            return {"status": "failed", "why": last_line(errors).replace(str(self.folder), "cases")}
        return {"status": "done"} | json.loads(output.splitlines()[-1])

    def _ask(self, *words):
        answer = subprocess.run([self.program, *words], capture_output=True, text=True, check=True)
        return json.loads(answer.stdout)


def quiet_environment() -> dict:
    """Without what would steer the threads or allocators of some engines and not of others."""
    steering = ("OMP_", "TBB_", "MKL_", "OPENBLAS_", "MALLOC_", "LD_PRELOAD")
    return {k: v for k, v in os.environ.items() if not k.startswith(steering)}


def last_line(text: str) -> str:
    lines = text.strip().splitlines()
    return lines[-1][:200] if lines else "no message"


def merged(measurements: list[dict]) -> dict:
    """Of one engine on one case, made at different times: all repetitions count; any failure is a failure."""
    for m in measurements:
        if m["status"] != "done":
            return m
    whole = dict(measurements[0])
    timed = [m for m in measurements if not m["warm_up_only"]]
    whole["seconds"] = [s for m in timed or measurements for s in m["seconds"]]
    whole["warm_up_only"] = not timed
    whole["median"] = statistics.median(whole["seconds"])
    whole["memory_above_input"] = max(m["memory_above_input"] for m in measurements)
    if "copy_floor" in whole:
        whole["copy_floor"] = statistics.median(m["copy_floor"] for m in measurements)
    return whole
