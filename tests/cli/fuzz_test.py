"""strata fuzz: broken engines are found and shrunk, ours holds, rounds can be asked again."""
import json
import signal
import subprocess
import sys
import time
import unittest

from tool import INVALID, NEGATIVE, OK, STOPPED, TOOL, USAGE
from verify_case import VerifyTest

# The intersection without its smallest part, where it has more than one; all else is right.
LOSES_A_PART = """
v, f = right()
if operation == "intersection" and f:
    places = {}
    label = [places.setdefault(tuple(p), i) for i, p in enumerate(v)]
    def root(i):
        while label[i] != i:
            i = label[i]
        return i
    for t in f:
        for i in t:
            label[root(i)] = root(t[0])
    parts = {}
    for t in f:
        parts.setdefault(root(t[0]), []).append(t)
    if len(parts) > 1:
        f = sum(sorted(parts.values(), key=len)[1:], [])
    write(v, f)
"""

# The union of solids is as wide as it should be, but a thousandth wider where it is widest.
GROWS = """
v, f = right()
if operation == "union" and f:
    most = max(p[0] for p in v)
    write([[p[0] * (1.001 if p[0] == most else 1), p[1], p[2]] for p in v], f)
"""


class Fuzz(VerifyTest):
    def fuzz(self, *arguments, expect=OK):
        return self.run_tool("fuzz", *arguments, expect=expect).stdout.decode()

    def kept(self, folder="strata-fuzz-findings"):
        return sorted(self.path(folder).iterdir()) if self.path(folder).exists() else []

    def faces(self, case):
        return sum(int((case / file).read_text().split()[2])
                   for file in json.loads((case / "case.json").read_text())["operands"].values())

    def test_our_laws_hold_in_200_rounds(self):
        start = time.monotonic()
        said = self.fuzz("--seed", 1, "--rounds", 200, "--keep", self.path("kept"))
        self.assertIn("0 findings", said)
        self.assertGreater(int(said.split("rounds asked")[0].split()[-1]), 150, said)
        self.assertLess(time.monotonic() - start, 300)
        self.assertEqual(self.kept("kept"), [])

    def broken(self, body, check, most_faces, *rounds):
        engine = self.engine(body, "broken")
        said = self.fuzz(*rounds, "--engine", engine, "--shrink-seconds", 30, expect=NEGATIVE)
        case, = [c for c in self.kept() if c.name.startswith(f"fuzz-{check}-")]
        self.assertLessEqual(self.faces(case), most_faces, said)
        document = json.loads((case / "case.json").read_text())
        self.assertEqual(document["tags"], ["fuzz", check])
        self.assertIn(f"'{check}' does not hold", document["why"])
        self.assertIn("Nobody but the engine has said", document["why"])
        self.assertFalse((case / "expected.json").exists())
        self.run_tool("fuzz", "--case", case, "--engine", engine, expect=NEGATIVE)
        self.run_tool("fuzz", "--case", case)
        return case, document["why"], engine

    def test_an_engine_whose_unions_grow_is_found_and_shrunk(self):
        case, why, engine = self.broken(GROWS, "volumes", 8, "--seed", 1, "--rounds", 2)
        number = case.name.split("-")[3].split(".")[0]
        self.assertIn(f"strata fuzz --seed 1 --round {number} --engine", why)
        said = self.fuzz("--seed", 1, "--round", number, "--engine", engine, "--shrink-seconds", 0,
                         "--keep", self.path("again"), expect=NEGATIVE)
        self.assertIn(f"round {number}: ", said)
        self.assertGreater(self.faces(self.kept("again")[0]), self.faces(case))

    def test_an_engine_whose_intersections_lose_a_part_is_found(self):
        self.broken(LOSES_A_PART, "volumes", 24, "--seed", 2, "--round", 64)  # whose intersection has two parts

    def test_crashes_hangs_and_open_results_are_findings(self):
        for body, check in (("os.kill(os.getpid(), signal.SIGSEGV)", "crash"), ("time.sleep(60)", "hang"),
                            ("v, f = right()\nwrite(v, f[1:])", "closed")):
            with self.subTest(check=check):
                said = self.fuzz("--seed", 1, "--rounds", 4, "--engine", self.engine(body, check), "--seconds", 2,
                                 "--shrink-seconds", 0, expect=NEGATIVE)
                self.assertIn(f"{check}.py: {check}: ", said)

    def test_the_same_seed_asks_the_same_questions(self):
        def questions(folder, seed):
            self.fuzz("--seed", seed, "--rounds", 12, "--questions", self.path(folder))
            return {p.parent.name.split("-")[1] + p.name: p.read_bytes() for p in self.path(folder).rglob("*.*")}
        first, again, other = questions("one", 5), questions("two", 5), questions("three", 6)
        self.assertEqual(first, again)
        self.assertNotEqual(first, other)
        self.assertGreater(len(first), 30)

    def test_findings_are_not_overwritten(self):
        engine = self.engine(GROWS, "broken")
        for _ in range(2):
            self.fuzz("--seed", 1, "--rounds", 2, "--engine", engine, "--shrink-seconds", 0, expect=NEGATIVE)
        self.assertEqual(sum(c.name.endswith("-2") for c in self.kept()), len(self.kept()) // 2)

    def oracle(self, body):
        start = f"#!{sys.executable}\nimport sys\nexpression, out, *bindings = sys.argv[1:]\n"
        path = self.file("oracle", start + body + "\n")
        path.chmod(0o755)
        return path

    def test_an_oracle_that_says_something_else_is_a_finding(self):
        liar = self.oracle("open(out, 'w').write('{\"volume\": \"1/7\", \"hash\": \"0\"}')")
        said = self.fuzz("--seed", 1, "--rounds", 3, "--oracle", liar, "--shrink-seconds", 0, expect=NEGATIVE)
        self.assertIn("oracle: the oracle has another solid: volume 1/7", said)
        silent = self.oracle("sys.exit(3)")
        self.fuzz("--seed", 1, "--rounds", 3, "--oracle", silent)
        self.fuzz("--oracle", "nowhere", expect=USAGE)

    def test_an_oracle_that_agrees_with_this_engine_certifies_a_finding_about_another(self):
        agrees = self.oracle(f"""
import json, pathlib, shutil, subprocess, tempfile
case = pathlib.Path(tempfile.mkdtemp()) / "case"
case.mkdir()
operands = dict(b.split("=", 1) for b in bindings)
for name, file in operands.items():
    shutil.copy(file, case)
document = dict(why="x", expression=expression, tags=[],
                operands={{name: pathlib.Path(file).name for name, file in operands.items()}})
(case / "case.json").write_text(json.dumps(document))
subprocess.run([{TOOL!r}, "verify", "--certify", "-q", "--cases", str(case.parent)], check=True)
e = json.loads((case / "expected.json").read_text())
json.dump({{key: e[key] for key in ("volume", "vertices", "edges", "facets", "hash")}}, open(out, "w"))
""")
        self.fuzz("--seed", 1, "--rounds", 2, "--engine", self.engine(GROWS, "broken"), "--oracle", agrees,
                  "--shrink-seconds", 0, expect=NEGATIVE)
        case = self.kept()[0]
        self.assertEqual(json.loads((case / "expected.json").read_text())["origin"], ["nef", "strata"])
        self.assertNotIn("Nobody", json.loads((case / "case.json").read_text())["why"])

    def test_operands_that_are_no_solids_are_no_question(self):
        folder = self.case("crossing", certified=False)
        text = (folder / "a.off").read_text()
        (folder / "a.off").write_text(text.replace("1 1 1\n", "-3 -3 -3\n"))
        self.assertIn("is no solid", self.run_tool("fuzz", "--case", folder, expect=INVALID).stderr.decode())

    def test_an_interrupted_search_says_how_far_it_came(self):
        for signal_sent in (signal.SIGTERM, signal.SIGINT):
            running = subprocess.Popen([TOOL, "fuzz", "--seed", "1", "--minutes", "10"], stdout=subprocess.PIPE,
                                       cwd=self.path("."))
            time.sleep(2)
            running.send_signal(signal_sent)
            said = running.communicate(timeout=30)[0].decode()
            self.assertRegex(said, r"seed 1: [1-9]\d* rounds asked, \d+ passed over, 0 findings, .* s, interrupted")
            self.assertEqual(running.returncode, STOPPED)

    def test_usage(self):
        self.fuzz("--rounds", 3, "--minutes", 1, expect=USAGE)
        self.fuzz("--engine", "nowhere", expect=USAGE)


if __name__ == "__main__":
    unittest.main()
