"""The protocol of strata-benchmark-runner. Usage: runner_test.py RUNNER STRATA-BENCH"""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

RUNNER, BENCH = sys.argv.pop(1), sys.argv.pop(1)
UNIT = ((0, 0, 0), (1, 1, 1))


def box(lower, upper) -> str:
    corners = [[(lower, upper)[n >> k & 1][k] for k in range(3)] for n in range(8)]
    sides = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    lines = ["v " + " ".join(map(repr, map(float, v))) for v in corners]
    return "\n".join(lines + ["f " + " ".join(str(n + 1) for n in side) for side in sides]) + "\n"


def volume(file: str) -> float:
    vertices, total = [], 0.0
    for line in pathlib.Path(file).read_text().splitlines():
        kind, *words = line.split() or [""]
        if kind == "v":
            vertices.append([float(w) for w in words[:3]])
        if kind == "f":
            a, b, c = (vertices[int(w.split("/")[0]) - 1] for w in words)
            total += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2])
            total += a[2] * (b[0] * c[1] - b[1] * c[0])
    return total / 6


class Protocol(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.folder = pathlib.Path(place.name)

    def mesh(self, name, lower, upper):
        (self.folder / name).write_text(box(lower, upper))
        return {"op": "load-mesh", "path": str(self.folder / name), "name": name}

    def ask(self, *runs, arguments=(), returns=0, **top):
        asked = [{"case_id": f"case {n}", "out_dir": str(self.folder / f"out {n}"), "operations": operations}
                 for n, operations in enumerate(runs)]  # fmt: skip
        request = {"kind": "boolean-benchmark", "version": 1, "id": "an id", "system_snapshot": {"?": 1}, "runs": asked}
        (self.folder / "request.json").write_text(json.dumps(request | top))
        command = [RUNNER, "--request", self.folder / "request.json", "--result", self.folder / "result.json"]
        done = subprocess.run([*command, *arguments], capture_output=True, text=True)
        self.assertEqual(done.returncode, returns, done.stderr)
        self.assertFalse((self.folder / "result.json.tmp").exists())
        result = self.folder / "result.json"
        return json.loads(result.read_text()) if result.exists() else done.stderr

    def test_booleans_of_two_operands(self):
        loads = [self.mesh("a.obj", *UNIT), self.mesh("b.obj", (0.5, 0.5, 0.5), (1.5, 1.5, 1.5))]
        names = ["boolean-union", "boolean-intersection", "boolean-difference"]
        answer = self.ask(loads + [{"op": name, "args": [0, 1]} for name in names])
        self.assertEqual((answer["kind"], answer["version"], answer["id"]), ("boolean-benchmark", 1, "an id"))
        run = answer["runs"][0]
        self.assertEqual((run["case_id"], run["status"]), ("case 0", "success"))
        self.assertEqual([volume(op["file"]) for op in run["ops"]], [1, 1, 1.875, 0.125, 0.875])
        for op in run["ops"][:2]:
            self.assertLessEqual(op["io_ms"] + op["import_ms"], op["total_ms"])
        for op in run["ops"][2:]:
            self.assertLessEqual(op["operation_ms"] + op["export_ms"], op["total_ms"])
        self.assertEqual(pathlib.Path(run["ops"][2]["file"]), self.folder / "out 0/op_2.obj")

    def test_one_operand_and_many(self):
        loads = [self.mesh(f"{n}.obj", (n, 0, 0), (n + 1.5, 1, 1)) for n in range(4)]
        many = {"op": "boolean-difference", "args": [0, 1, 2, 3]}
        answer = self.ask(loads + [many, {"op": "boolean-union", "args": [4]}], arguments=["--threads", "1"])
        self.assertEqual([volume(op["file"]) for op in answer["runs"][0]["ops"][4:]], [1, 1])

    def test_results_are_operands_and_long_chains_are_exact(self):
        """40 steps: incremental. Thirds are no doubles, and stay exact: what is added again closes everything."""
        third = 1 / 3
        loads = [self.mesh("a.obj", *UNIT), self.mesh("b.obj", (third, third, -1), (2 * third, 2 * third, 2))]
        steps = [{"op": ("boolean-difference", "boolean-union")[n % 2], "args": [n + 1 if n else 0, (1, 0)[n % 2]]}
                 for n in range(40)]  # fmt: skip
        ops = self.ask(loads + steps)["runs"][0]["ops"]
        self.assertEqual([op["status"] for op in ops], ["success"] * 42)
        self.assertEqual(volume(ops[-1]["file"]), 1)
        self.assertAlmostEqual(volume(ops[-2]["file"]), 8 / 9)

    def test_what_fails_ends_its_run_and_no_other(self):
        (self.folder / "open.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        good = self.mesh("a.obj", *UNIT)
        never = {"op": "boolean-union", "args": [0, 0]}
        answer = self.ask(
            [{"op": "load-mesh", "path": str(self.folder / "open.obj")}, never],
            [{"op": "load-mesh", "path": str(self.folder / "missing.obj")}],
            [good, {"op": "boolean-xor", "args": [0, 0]}],
            [good, {"op": "boolean-union", "args": [0, 7]}],
            [good, {"op": "boolean-union", "args": []}],
            [good, {"op": "boolean-union", "args": [-1]}],
            [good, {"op": "minkowski", "args": [0, 0]}],
            [{"op": "boolean-union"}],
            [good, never],
            returns=1,
        )
        runs = answer["runs"]
        statuses = ["invalid_input"] * 2 + ["unsupported"] + ["invalid_input"] * 3 + ["unsupported", "invalid_input"]
        self.assertEqual([run["status"] for run in runs], statuses + ["success"])
        self.assertEqual(len(runs[0]["ops"]), 1)
        self.assertIn("open edge", runs[0]["ops"][0]["error"])
        self.assertIn("missing.obj", runs[1]["ops"][0]["error"])

    def test_other_requests_are_refused(self):
        self.assertIn("version 2", self.ask(returns=1, version=2))
        self.assertIn("kind", self.ask(returns=1, kind="something"))

    def test_cases_of_the_benchmark_are_requests(self):
        subprocess.run([BENCH, "request", "k_nine_steps", self.folder / "nine"], check=True)
        command = [RUNNER, "--request", self.folder / "nine/request.json", "--result", self.folder / "nine/result.json"]
        subprocess.run(command, check=True, capture_output=True)
        run = json.loads((self.folder / "nine/result.json").read_text())["runs"][0]
        self.assertEqual((run["status"], len(run["ops"])), ("success", 19))
        subprocess.run([BENCH, "make", "k_nine", self.folder / "case"], check=True, capture_output=True)
        at_once = [BENCH, "run", self.folder / "case", "--operation", "difference", "--repetitions", "1"]
        subprocess.run([*at_once, "--result", self.folder / "result"], check=True, capture_output=True)
        judged = subprocess.run([BENCH, "judge", self.folder / "result"], check=True, capture_output=True).stdout
        self.assertAlmostEqual(volume(run["ops"][-1]["file"]), json.loads(judged)["volume"], places=6)


if __name__ == "__main__":
    unittest.main()
