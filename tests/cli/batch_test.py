"""strata batch: records, limits, crashes, going on, stops."""
import json
import os
import pathlib
import signal
import subprocess
import time
import unittest

from tool import DATA, FILE, INVALID, NEGATIVE, OK, STOPPED, TOOL, USAGE, ToolTest, cube, open_cube

sanitized = bool(os.environ.get("STRATA_SANITIZED"))


def children(process):
    """Process ids of its workers."""
    found = []
    for stat in pathlib.Path("/proc").glob("[0-9]*/stat"):
        try:
            if int(stat.read_text().rsplit(")", 1)[1].split()[1]) == process:
                found.append(int(stat.parent.name))
        except OSError:
            pass  # it has ended
    return found


def wait_until(condition, seconds=30):
    end = time.monotonic() + seconds
    while not condition():
        if time.monotonic() > end:
            raise AssertionError("it did not happen")
        time.sleep(0.01)


class BatchTest(ToolTest):
    def setUp(self):
        super().setUp()
        self.file("a.off", cube())
        self.file("b.off", cube(0.5, 0.5, 0.5))

    def jobs(self, *jobs, name="jobs.jsonl"):
        return self.file(name, "".join(json.dumps(job) + "\n" for job in jobs))

    def union(self, k, **others):
        return {"id": f"job {k}", "args": ["union", "a.off", "b.off", "-o", f"out{k}.off"], **others}

    def heavy(self, k=0, **others):
        """A job that takes far longer than these tests wait."""
        lines = (DATA / "sphere.off").read_text().splitlines()
        count = int(lines[1].split()[0])
        for n in range(40):
            if self.path(f"sphere{n}.off").exists():
                continue
            moved = [" ".join([str(float(line.split()[0]) + n / 1024), *line.split()[1:]])
                     for line in lines[2:2 + count]]
            self.file(f"sphere{n}.off", "\n".join(lines[:2] + moved + lines[2 + count:]) + "\n")
        spheres = [f"sphere{n}.off" for n in range(40)]
        return {"id": f"heavy {k}", "args": ["xor", *spheres, "-o", f"heavy{k}.off"], **others}

    def records(self, name="records.jsonl"):
        text = self.path(name).read_text()
        self.assertTrue(text == "" or text.endswith("\n"))
        return [json.loads(line) for line in text.splitlines()]

    def batch(self, *jobs, options=(), expect=OK):
        """Runs the jobs and returns the records."""
        self.run_tool("batch", self.jobs(*jobs), "-o", "records.jsonl", *options, expect=expect)
        return self.records()

    def begin(self, *arguments, **others):
        process = subprocess.Popen([TOOL, "batch", *map(str, arguments)], cwd=self.folder, stderr=subprocess.PIPE,
                                   **others)
        self.addCleanup(process.stderr.close)
        return process


class Records(BatchTest):
    def test_records_are_in_the_order_of_the_jobs(self):
        jobs = [self.union(k) for k in range(50)]
        jobs[0] = {"id": "slow", "args": ["union", str(DATA / "sphere.off"), "a.off", "-o", "slow.off"]}
        records = self.batch(*jobs, options=("--workers", "3"))
        self.assertEqual([r["id"] for r in records], [job["id"] for job in jobs])
        self.assertEqual([r["line"] for r in records], list(range(1, 51)))
        self.assertEqual({(r["status"], r["exit_code"], r["signal"]) for r in records}, {("ok", 0, None)})
        self.assertEqual([r["output"] for r in records], [job["args"][-1] for job in jobs])
        self.run_tool("union", "a.off", "b.off", "-o", "one.off")
        for k in range(1, 50):
            self.assertEqual(self.path(f"out{k}.off").read_bytes(), self.path("one.off").read_bytes())
        for record in records:
            self.assertGreater(record["seconds"], 0)
            self.assertGreater(record["peak_memory_bytes"], 1 << 20)

    def test_records_tell_what_jobs_wrote(self):
        self.file("open.off", open_cube())
        records = self.batch({"args": ["union", "a.off", "open.off", "-o", "x.off"]},
                             {"args": ["info", "a.off"]},
                             {"args": ["compare", "a.off", "b.off"], "id": 7},
                             {"args": ["union", "missing.off", "a.off", "-ox.off"]},
                             {"args": ["weld", "a.off"]},
                             {"args": ["info", "-", "--input-format", "off"]},
                             {"args": ["--version"]}, options=("--workers", "2"), expect=NEGATIVE)
        self.assertEqual([r["exit_code"] for r in records], [INVALID, OK, NEGATIVE, FILE, USAGE, FILE, OK])
        self.assertEqual([r["status"] for r in records], ["failed", "ok", "failed", "failed", "failed", "failed", "ok"])
        self.assertEqual([r["id"] for r in records], [None, None, 7, None, None, None, None])
        self.assertIn("open edge", "\n".join(records[0]["messages"]))
        self.assertIn(b"triangles", records[1]["stdout"].encode())
        self.assertEqual(records[1]["messages"], [])
        self.assertIn("missing.off", records[3]["messages"][0])
        self.assertEqual(records[3]["output"], "x.off")
        self.assertRegex(records[6]["stdout"], r"^strata \d")

    def test_long_texts_are_cut_in_the_middle(self):
        self.file("sphere.off", (DATA / "sphere.off").read_text())
        record, = self.batch({"args": ["union", "sphere.off", "-o", "-", "--format", "off"]})
        self.assertLess(len(record["stdout"]), 10000)
        self.assertTrue(record["stdout"].startswith("OFF"))
        self.assertRegex(record["stdout"], r"\n\[\d+ bytes\]\n")

    def test_jobs_come_from_standard_input_and_records_go_to_standard_output(self):
        lines = [json.dumps(self.union(k)) for k in range(3)]
        done = self.run_tool("batch", "-", "-q", stdin="\n\n".join(lines).encode())  # no line end at the end
        self.assertEqual(done.stderr, b"")
        records = [json.loads(line) for line in done.stdout.splitlines()]
        self.assertEqual([(r["id"], r["line"]) for r in records], [("job 0", 1), ("job 1", 3), ("job 2", 5)])

    def test_no_jobs_are_no_records(self):
        self.assertEqual(self.batch(), [])

    def test_many_small_jobs_leave_nothing_open(self):
        records = self.batch(*[self.union(k % 10) for k in range(1500)], options=("--workers", "1"))
        self.assertEqual([r["line"] for r in records if r["status"] == "ok"], list(range(1, 1501)))

    def test_a_job_runs_on_one_thread(self):
        self.jobs(self.heavy())
        process = self.begin("jobs.jsonl", "-o", "records.jsonl", "--timeout", "2")
        wait_until(lambda: children(process.pid))
        worker, = children(process.pid)
        most = 0
        while process.poll() is None:
            try:
                most = max(most, len(os.listdir(f"/proc/{worker}/task")))
            except OSError:
                pass
            time.sleep(0.05)
        self.assertLessEqual(most, 2)  # one that computes, and one that watches
        self.assertEqual(process.returncode, NEGATIVE)

    def test_verbs_of_the_other_program_are_jobs_as_well(self):
        if not (pathlib.Path(TOOL).parent.parent / "verify").exists():
            self.skipTest("strata-verify is not built")
        record, = self.batch({"args": ["verify", "--help"]}, expect=None)
        if record["exit_code"] == FILE:
            self.skipTest("strata-verify is not built")
        self.assertEqual((record["status"], "Usage" in record["stdout"]), ("ok", True))

    def run_tool(self, *arguments, expect=OK, **others):
        if expect is not None:
            return super().run_tool(*arguments, expect=expect, **others)
        return subprocess.run([TOOL, *map(str, arguments)], cwd=self.folder, capture_output=True, timeout=120)


class Limits(BatchTest):
    def test_a_hang_costs_one_job(self):
        jobs = [self.union(0), self.heavy(timeout=0.4), *[self.union(k) for k in range(1, 20)]]
        start = time.monotonic()
        records = self.batch(*jobs, options=("--workers", "1"), expect=NEGATIVE)
        self.assertLess(time.monotonic() - start, 20)
        self.assertEqual([r["status"] for r in records], ["ok", "timeout"] + 19 * ["ok"])
        self.assertEqual((records[1]["exit_code"], records[1]["signal"]), (None, signal.SIGKILL))
        self.assertGreaterEqual(records[1]["seconds"], 0.4)
        self.assertLess(records[1]["seconds"], 2)
        self.assertFalse(self.path("heavy0.off").exists())

    def test_the_limit_of_a_job_counts_more_than_that_of_the_batch(self):
        records = self.batch(self.heavy(0), self.heavy(1, timeout=1), options=("--timeout", "0.3", "--workers", "2"),
                             expect=NEGATIVE)
        self.assertEqual([r["status"] for r in records], ["timeout", "timeout"])
        self.assertLess(records[0]["seconds"], 0.9)
        self.assertGreaterEqual(records[1]["seconds"], 1)

    def test_the_time_limit_of_the_verb_itself_costs_one_job(self):
        heavy = self.heavy()
        heavy["args"] += ["--timeout", "0.3"]
        records = self.batch(heavy, self.union(1), options=("--workers", "1"), expect=NEGATIVE)
        self.assertEqual([(r["status"], r["exit_code"]) for r in records], [("failed", STOPPED), ("ok", OK)])
        self.assertIn("time limit", records[0]["messages"][-1])

    @unittest.skipIf(sanitized, "sanitizers take address space of their own")
    def test_memory_that_runs_out_costs_one_job(self):
        records = self.batch(self.union(0), self.heavy(memory="16M"), self.union(1),
                             {"args": ["union", "a.off", "b.off", "-o", "x.off"], "memory": 64 << 20},
                             options=("--workers", "1", "--timeout", "60"), expect=NEGATIVE)
        self.assertEqual([r["status"] for r in records], ["ok", "memory", "ok", "ok"])

    @unittest.skipIf(sanitized, "sanitizers take address space of their own")
    def test_the_memory_limit_of_the_batch_is_that_of_all_jobs(self):
        records = self.batch(self.heavy(0), self.heavy(1, memory="1T", timeout=1), self.union(1),
                             options=("--workers", "1", "--memory", "16M"), expect=NEGATIVE)
        self.assertEqual([r["status"] for r in records], ["memory", "timeout", "ok"])

    @unittest.skipIf(sanitized, "sanitizers keep memory that was freed")
    def test_the_peak_is_that_of_the_job(self):
        sphere = self.file("sphere.off", (DATA / "sphere.off").read_text())
        records = self.batch(self.union(0), *[{"args": ["info", str(sphere)]}] * 2, self.union(1),
                             options=("--workers", "1"))
        peaks = [r["peak_memory_bytes"] for r in records]
        self.assertLess(peaks[3], peaks[1] + (64 << 20))

    def test_a_crash_costs_one_job(self):
        handled = {signal.SIGSEGV} if sanitized else set()  # sanitizers make an exit of it
        for number in sorted({signal.SIGSEGV, signal.SIGKILL, signal.SIGABRT} - handled):
            with self.subTest(signal=number):
                self.jobs(self.union(0), self.heavy(), *[self.union(k) for k in range(1, 6)])
                self.path("out0.off").unlink(missing_ok=True)
                process = self.begin("jobs.jsonl", "-o", "records.jsonl", "--workers", "1")
                wait_until(lambda: self.path("out0.off").exists())
                time.sleep(0.3)
                worker, = children(process.pid)
                os.kill(worker, number)
                self.assertEqual(process.wait(timeout=60), NEGATIVE)
                records = self.records()
                self.assertEqual([r["status"] for r in records], ["ok", "crashed"] + 5 * ["ok"])
                self.assertEqual((records[1]["exit_code"], records[1]["signal"]), (None, number))
                self.assertGreater(records[1]["seconds"], 0.1)

    def test_an_error_of_the_program_costs_one_job(self):
        environment = {**os.environ, "STRATA_TEST_LOGIC_ERROR": "1"}
        self.jobs(self.union(0), {"args": ["info", "a.off"]})
        self.run_tool("batch", "jobs.jsonl", "-o", "records.jsonl", env=environment, expect=NEGATIVE)
        self.assertEqual([(r["status"], r["exit_code"]) for r in self.records()], [("failed", 70), ("ok", 0)])
        self.assertTrue(self.path("strata-reproduction-1").is_dir())


class Resume(BatchTest):
    def resume(self, *options, expect=OK):
        return self.run_tool("batch", "jobs.jsonl", "-o", "records.jsonl", "--resume", *options, expect=expect)

    def test_after_the_parent_was_killed(self):
        jobs = [self.union(k % 7) for k in range(400)] + [self.heavy()] + [self.union(k) for k in range(3)]
        self.jobs(*jobs)
        process = self.begin("jobs.jsonl", "-o", "records.jsonl", "--workers", "2")
        wait_until(lambda: self.path("records.jsonl").exists() and len(self.path("records.jsonl").read_text()) > 30000)
        workers = children(process.pid)
        process.kill()
        process.wait()
        wait_until(lambda: not any(pathlib.Path(f"/proc/{worker}").exists() for worker in workers))
        text = self.path("records.jsonl").read_text()
        done = text.count("\n")
        self.path("records.jsonl").write_text(text + '{"id":"job 1","li')  # as a write that was cut short
        self.path("out3.off").unlink()
        message = self.resume("--timeout", "1", expect=NEGATIVE).stderr.decode()
        self.assertIn("404 of 404 jobs done: 403 ok, 1 timeout", message)
        self.assertTrue(self.path("records.jsonl").read_text().startswith(text))
        self.assertEqual([r["line"] for r in self.records()], list(range(1, 405)))
        self.assertLess(done, 404)

    def test_what_is_done_is_not_run_again(self):
        self.batch(*[self.union(k) for k in range(5)])
        before = self.path("records.jsonl").read_bytes()
        self.path("out2.off").unlink()
        self.resume()
        self.assertEqual(self.path("records.jsonl").read_bytes(), before)
        self.assertFalse(self.path("out2.off").exists())

    def test_a_job_that_was_changed_runs_again_and_its_record_is_in_its_place(self):
        jobs = [self.union(k) for k in range(6)]
        before = self.batch(*jobs)
        jobs[2] = {"id": "changed", "args": ["intersection", "a.off", "b.off", "-o", "other.off"]}
        self.jobs(*jobs, self.union(6))
        self.resume()
        after = self.records()
        self.assertEqual([r["line"] for r in after], list(range(1, 8)))
        self.assertEqual(after[2]["id"], "changed")
        self.assertEqual(after[:2] + after[3:6], before[:2] + before[3:])
        self.assertTrue(self.path("other.off").exists())

    def test_what_is_not_ok_is_run_again_on_request(self):
        self.path("b.off").rename(self.path("later.off"))
        jobs = [{"args": ["info", "a.off"]}, self.union(1), {"args": ["info", "a.off"]}]
        before = self.batch(*jobs, expect=NEGATIVE)
        self.path("later.off").rename(self.path("b.off"))
        self.resume(expect=NEGATIVE)
        self.assertEqual(self.records(), before)
        self.resume("--retry")
        after = self.records()
        self.assertEqual([r["status"] for r in after], ["ok", "ok", "ok"])
        self.assertEqual((after[0], after[2]), (before[0], before[2]))

    def test_without_records_it_begins(self):
        self.jobs(self.union(0))
        self.resume()
        self.assertEqual(len(self.records()), 1)

    def test_a_file_of_something_else_is_left_alone(self):
        self.jobs(self.union(0))
        for text in ("OFF\n", '{"line": 1}\n', '{"line": 1, "job": "x", "status": "good"}\n'):
            self.file("records.jsonl", text)
            self.assertIn("records.jsonl:1: ", self.resume(expect=FILE).stderr.decode())
            self.assertEqual(self.path("records.jsonl").read_text(), text)


class Stops(BatchTest):
    def test_a_signal_stops_all_workers_and_leaves_whole_records(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            with self.subTest(signal=number):
                self.jobs(self.union(0), self.heavy(), *[self.union(k) for k in range(1, 9)])
                self.path("out8.off").unlink(missing_ok=True)
                process = self.begin("jobs.jsonl", "-o", "records.jsonl", "--workers", "2")
                wait_until(lambda: self.path("out8.off").exists())
                time.sleep(0.2)
                workers = children(process.pid)
                start = time.monotonic()
                process.send_signal(number)
                self.assertEqual(process.wait(timeout=30), STOPPED)
                self.assertLess(time.monotonic() - start, 5)
                self.assertIn("interrupted; 9 of 10 jobs done: 9 ok", process.stderr.read().decode())
                self.assertFalse(any(pathlib.Path(f"/proc/{worker}").exists() for worker in workers))
                self.assertEqual([r["line"] for r in self.records()], [1, *range(3, 11)])
                done = self.run_tool("batch", "jobs.jsonl", "-o", "records.jsonl", "--resume", "--timeout", "0.3",
                                     expect=NEGATIVE)
                self.assertIn("10 of 10 jobs done: 9 ok, 1 timeout", done.stderr.decode())
                self.assertEqual([r["line"] for r in self.records()], list(range(1, 11)))

    def test_a_signal_ends_waiting_for_jobs(self):
        process = self.begin("-", stdin=subprocess.PIPE)
        time.sleep(0.3)
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(timeout=5), STOPPED)
        process.stdin.close()

    def test_records_that_nobody_reads_end_it(self):
        self.jobs(*[self.union(0)] * 2000)
        process = self.begin("jobs.jsonl", stdout=subprocess.PIPE)
        process.stdout.close()
        self.assertEqual(process.wait(timeout=30), FILE)


class Misuse(BatchTest):
    def test_a_line_that_is_no_job_is_named_before_anything_runs(self):
        good = json.dumps(self.union(0))
        for line, message in (
                ("{", "jobs.jsonl:3: column 2: "),
                ("[1]", "jobs.jsonl:3: expected an object, found [1]"),
                ('{"id": "x"}', "jobs.jsonl:3: 'args' is missing"),
                ('{"args": []}', "jobs.jsonl:3: args: a job needs a verb"),
                ('{"args": "union"}', "jobs.jsonl:3: args: expected an array"),
                ('{"args": ["union", 3]}', "jobs.jsonl:3: args[1]: expected a string"),
                ('{"args": ["batch", "-"]}', "jobs.jsonl:3: args: a job cannot be a batch"),
                ('{"args": ["info"], "id": []}', "jobs.jsonl:3: id: expected a string or an integer"),
                ('{"args": ["info"], "timeout": 0}', "jobs.jsonl:3: timeout: expected a positive number of seconds"),
                ('{"args": ["info"], "timeout": "1"}', "jobs.jsonl:3: timeout: expected"),
                ('{"args": ["info"], "memory": "1.5Q"}', "jobs.jsonl:3: memory: expected a number of bytes"),
                ('{"args": ["info"], "memory": -1}', "jobs.jsonl:3: memory: expected"),
                ('{"args": ["info"], "args": ["info"]}', "jobs.jsonl:3: args: this key stands twice"),
                ('{"args": ["info"], "time": 1}', "jobs.jsonl:3: time: no such key")):
            with self.subTest(line=line):
                self.file("jobs.jsonl", f"{good}\n\n{line}\n{good}\n")
                error = self.run_tool("batch", "jobs.jsonl", "-o", "records.jsonl", expect=FILE).stderr.decode()
                self.assertIn(message, error)
        self.assertEqual(self.left_over(), ["a.off", "b.off", "jobs.jsonl"])

    def test_misuse(self):
        self.jobs(self.union(0))
        for arguments in (("--resume",), ("--retry", "-o", "r"), ("-o", "jobs.jsonl"), ("--workers", "0"),
                          ("--workers", "two"), ("--timeout", "-1"), ("--memory", "much"), ("--memory", "0")):
            with self.subTest(arguments=arguments):
                self.run_tool("batch", "jobs.jsonl", *arguments, expect=USAGE)
        self.run_tool("batch", "missing.jsonl", expect=FILE)
        self.run_tool("batch", "jobs.jsonl", "-o", "no/such/folder", expect=FILE)
        self.assertEqual(self.left_over(), ["a.off", "b.off", "jobs.jsonl"])


if __name__ == "__main__":
    unittest.main()
