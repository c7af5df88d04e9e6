"""batch(): order, failures, limits, crashes, going on, stops. Plain functions stand for Booleans."""

from __future__ import annotations

import doctest
import json
import os
import pathlib
import signal
import subprocess
import sys
import textwrap
import time

import pytest
from strata_csg import _batch
from strata_csg._batch import Record, batch

package = pathlib.Path(_batch.__file__).parent


def double(job):
    return 2 * job


def wait_for(seconds):
    time.sleep(seconds)
    return seconds


def obey(job):
    """Does what the job says."""
    what, *others = job if isinstance(job, tuple) else (job,)
    if what == "raise":
        raise ValueError(*others)
    if what == "exit":
        sys.exit(3)
    if what == "end":
        os._exit(others[0])
    if what == "signal":
        os.kill(os.getpid(), others[0])
    if what == "hang":
        time.sleep(1000)
    if what == "hang with a child":
        pathlib.Path(others[0]).write_text(str(subprocess.Popen(["sleep", "1000"]).pid))
        time.sleep(1000)
    if what == "allocate":
        return len(bytearray(others[0]))
    if what == "return a function":
        return lambda: None
    if what == "count":
        with open(others[0], "a") as file:
            file.write(".")
    return what


def statuses(records):
    return [record.status for record in records]


def is_alive(process):
    try:
        return pathlib.Path(f"/proc/{process}/stat").read_text().rsplit(")", 1)[1].split()[0] != "Z"
    except OSError:
        return False


def wait_until(condition, seconds=20):
    end = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < end, "it did not happen"
        time.sleep(0.02)


def test_results_are_in_the_order_of_the_jobs():
    records = batch(double, range(1000), workers=3)
    assert [r.index for r in records] == list(range(1000))
    assert [r.result for r in records] == [2 * k for k in range(1000)]
    assert set(statuses(records)) == {"ok"}
    assert all(r.error is None and r.seconds >= 0 and r.peak_memory > 1 << 20 for r in records)


def test_no_jobs_are_no_records():
    assert batch(double, []) == []


def test_an_exception_costs_one_job():
    records = batch(obey, ["a", ("raise", "wrong"), "exit", "return a function", "b"], workers=1)
    assert statuses(records) == ["ok", "failed", "failed", "failed", "ok"]
    assert records[1].error.startswith("ValueError: wrong\nTraceback")
    assert "in obey" in records[1].error
    assert records[2].error.startswith("SystemExit: 3")


@pytest.mark.parametrize("how", [("signal", signal.SIGSEGV), ("signal", signal.SIGKILL), ("end", 5)])
def test_a_crash_costs_one_job(how):
    records = batch(obey, [*range(20), how, *range(20)], workers=2)
    assert statuses(records) == 20 * ["ok"] + ["crashed"] + 20 * ["ok"]
    text = "exit code 5" if how[0] == "end" else f"signal {how[1].name}"
    assert text in records[20].error


def test_a_hang_costs_one_job():
    start = time.monotonic()
    records = batch(obey, [*range(20), "hang", *range(20), "hang"], workers=1, timeout=0.5)
    assert time.monotonic() - start < 15
    assert statuses(records) == 20 * ["ok"] + ["timeout"] + 20 * ["ok"] + ["timeout"]
    assert 0.5 <= records[20].seconds < 2
    assert "0.5 s" in records[20].error


def test_what_a_job_started_ends_with_it(tmp_path):
    records = batch(obey, [("hang with a child", tmp_path / "child")], timeout=1)
    assert statuses(records) == ["timeout"]
    wait_until(lambda: not is_alive(int((tmp_path / "child").read_text())))


def test_the_time_of_a_job_does_not_begin_while_it_waits_for_its_turn():
    assert statuses(batch(wait_for, [0.2] * 10, workers=1, timeout=0.5)) == 10 * ["ok"]


def test_memory_that_runs_out_costs_one_job():
    records = batch(obey, [0, ("allocate", 1 << 20), ("allocate", 1 << 30), 1, 2], workers=1, memory=256 << 20)
    assert statuses(records) == ["ok", "ok", "memory", "ok", "ok"]
    assert records[1].result == 1 << 20


def test_the_peak_is_that_of_the_job():
    records = batch(obey, [0, ("allocate", 200 << 20), 1, 2], workers=1)
    assert records[1].peak_memory > 200 << 20 > records[2].peak_memory


def test_jobs_behind_a_long_one_are_taken_by_others():
    start = time.monotonic()
    records = batch(wait_for, [0.001] * 200 + [3] + [0.001] * 60 + [0.2] * 8, workers=2)
    assert set(statuses(records)) == {"ok"}
    assert time.monotonic() - start < 5


def test_large_jobs_and_results_pass():
    jobs = [bytes([k]) * (1 << 21) for k in range(12)]
    assert [r.result for r in batch(double, jobs, workers=2)] == [2 * job for job in jobs]


def test_progress_ends_with_one():
    seen = []
    batch(double, range(10), workers=2, progress=seen.append)
    assert seen == sorted(seen)
    assert (len(seen), seen[-1]) == (10, 1.0)


def test_a_record_is_a_line_and_nothing_done_is_done_again(tmp_path):
    file, counts = tmp_path / "records.jsonl", tmp_path / "counts"
    jobs = [("count", str(counts)), ("raise", "no"), "a", {"b": [1]}]
    first = batch(obey, jobs, workers=2, records=file)
    lines = [json.loads(line) for line in file.read_text().splitlines()]
    assert sorted(line["index"] for line in lines) == [0, 1, 2, 3]
    assert {line["index"]: line["status"] for line in lines} == {0: "ok", 1: "failed", 2: "ok", 3: "ok"}
    assert batch(obey, jobs, records=file, resume=True) == first
    assert counts.read_text() == "."
    changed = batch(obey, [jobs[0], "other", *jobs[2:], "more"], records=file, resume=True)
    assert statuses(changed) == 5 * ["ok"]
    assert [changed[k] for k in (0, 2, 3)] == [first[k] for k in (0, 2, 3)]
    assert counts.read_text() == "."
    assert [r.result for r in batch(obey, ["a"], records=file)] == ["a"]  # without resume, a new file
    assert len(file.read_text().splitlines()) == 1


def test_a_line_that_was_cut_short_is_dropped(tmp_path):
    file = tmp_path / "records.jsonl"
    first = batch(double, range(5), workers=1, records=file)
    text = file.read_text()
    file.write_text(text[:-10])
    again = batch(double, range(5), records=file, resume=True)
    assert [r.result for r in again] == [r.result for r in first]
    assert again[:4] == first[:4]
    assert len(file.read_text().splitlines()) == 5


def test_what_is_no_file_of_records_is_refused(tmp_path):
    (tmp_path / "x").write_text("OFF\n")
    with pytest.raises(ValueError, match="x:1: is no record"):
        batch(double, [1], records=tmp_path / "x", resume=True)
    assert (tmp_path / "x").read_text() == "OFF\n"


def test_misuse():
    with pytest.raises(ValueError):
        batch(double, [1], resume=True)
    with pytest.raises(ValueError):
        batch(double, [1], workers=0)
    with pytest.raises(Exception, match="pickle|local object"):
        batch(lambda job: job, [1])


SCRIPT = """
    import pathlib, sys, time
    sys.path.insert(0, {packages!r})
    from strata_csg._batch import batch

    def work(job):
        if job >= 20:
            pathlib.Path({folder!r}, f"worker{{job}}").write_text(str(__import__("os").getpid()))
            time.sleep(1000)
        return job

    if __name__ == "__main__":
        try:
            batch(work, range(22), workers=2, records={folder!r} + "/records.jsonl")
        except KeyboardInterrupt:
            print("interrupted")
"""


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGKILL])
def test_workers_end_with_their_parent(tmp_path, number):
    script = tmp_path / "script.py"
    script.write_text(textwrap.dedent(SCRIPT.format(packages=str(package.parent), folder=str(tmp_path))))
    process = subprocess.Popen([sys.executable, script], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    files = [tmp_path / "worker20", tmp_path / "worker21"]
    wait_until(lambda: all(file.exists() and file.read_text() for file in files))
    process.send_signal(number)
    out, err = process.communicate(timeout=20)
    if number == signal.SIGINT:
        assert (out, err) == ("interrupted\n", "")
    wait_until(lambda: not any(is_alive(int(file.read_text())) for file in files))
    lines = (tmp_path / "records.jsonl").read_text().splitlines()
    assert sorted(json.loads(line)["index"] for line in lines) == list(range(20))


def test_a_function_that_workers_cannot_import_is_named(tmp_path):
    script = tmp_path / "script.py"
    script.write_text(f"import sys\nsys.path.insert(0, {str(package.parent)!r})\n"
                      "from strata_csg._batch import batch\n"
                      "if __name__ == '__main__':\n    def work(job): return job\n    batch(work, [1])\n")
    done = subprocess.run([sys.executable, script], capture_output=True, text=True, timeout=60)
    assert "RuntimeError: the function cannot be loaded in another process: AttributeError" in done.stderr


def test_small_jobs_cost_the_parent_little():
    """Less than a fifth of jobs of 1 ms. Processor time, because others may use the machine."""
    batch(wait_for, [0.001], workers=1)
    start = time.process_time()
    batch(wait_for, [0.001] * 2000, workers=1)
    assert time.process_time() - start < 2000 * 0.0002


def test_the_examples_of_the_docstring_are_right():
    assert doctest.testmod(_batch).failed == 0


def test_records_are_values():
    record = Record(0, "ok", 1, None, 0.5, 0)
    assert record == Record(0, "ok", 1, None, 0.5, 0)
    with pytest.raises(AttributeError):
        record.index = 1


def kill_by_number(number: int) -> None:
    os.kill(os.getpid(), number)


class Unspeakable(Exception):
    def __str__(self) -> str:
        raise RuntimeError("no text")


def raise_unspeakable(job: int) -> None:
    raise Unspeakable


def test_signals_without_names_and_errors_without_texts() -> None:
    records = batch(kill_by_number, [40, 9], workers=1, timeout=60)
    assert [r.status for r in records] == ["crashed", "crashed"]
    assert batch(raise_unspeakable, [1], workers=1, timeout=60)[0].status == "failed"


@pytest.mark.parametrize("wrong", [{"timeout": 0}, {"timeout": float("nan")}, {"memory": 0}, {"workers": 0}])
def test_limits_that_are_none(wrong: dict[str, float]) -> None:
    with pytest.raises(ValueError, match=next(iter(wrong))):
        batch(kill_by_number, [], **wrong)  # type: ignore[arg-type]
