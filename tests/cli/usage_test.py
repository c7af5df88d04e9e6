"""The command line itself: help, version, misuse (exit code 2)."""
import json
import os
import pty
import shutil
import subprocess
import unittest

from tool import TOOL, USAGE, ToolTest, cube

# What people type, and what the answer must contain.
MISTAKES = [
    ("", "a verb is missing"),
    ("unoin a.off b.off -o out.off", "did you mean 'union'?"),
    ("subtract a.off b.off -o out.off", "did you mean 'difference'?"),
    ("intersect a.off b.off -o out.off", "did you mean 'intersection'?"),
    ("a.off b.off", "strata: a verb is missing before a.off"),
    ("--union a.off b.off", "did you mean 'union'?"),
    ("version", "did you mean"),
    ("frobnicate", "there is no verb 'frobnicate'\n"),
    ("union a.off b.off", "--output OUT is missing"),
    ("union a.off b.off out.stl", "Meant?   strata union a.off b.off -o out.stl"),
    ("union -o out.off", "MESH is missing"),
    ("difference a.off -o out.off", "strata difference: it needs two operands or more, and a.off is one\nType:    strata difference MESH... -o OUT"),
    ("xor a.off -o out.off", "needs two operands"),
    ("slice a.off -o out.svg", "strata slice: give either --step or --at\nType:    strata slice"),
    ("split a.off -o out", "strata split: it needs a surface or a --plane"),
    ("draw a.off -o out.svg --from 1,2,3 --direction 0,0,1", "give either --from or --direction\nType:    strata draw"),
    ("union a.off b.off -o", "--output needs a value, OUT"),
    ("union a.off b.off --ouput out.off", "there is no option --ouput; did you mean '--output'?"),
    ("difference a.off b.off -o out.off --verbose", "there is no option --verbose"),
    ("union a.off b.off -o out.off --input overlaping", "did you mean 'overlapping'?"),
    ("union a.off b.off -o out.off -j two", "'two' is no N"),
    ("union a.off b.off -o out.off --timeout -1", "'-1' is no SECONDS"),
    ("compare a.off", "2 MESH needed, 1 given"),
    ("check a.off b.off", "'b.off' is one operand too many"),
    ("planar unoin p.wkt -o out.wkt", "did you mean 'union'?"),
    ("planar", "a verb is missing"),
    ("slice a.off --along w --step 1 -o out.svg", "'w' is none of x, y, z"),
    ("offset a.off -o out.off", "--by"),
    ("eval a-b a=a.off -o out.off", "b"),
    ("union a.off b.off -o out.xyz", "cannot tell a format from out.xyz; use --format with one of: stl"),
]


class Usage(ToolTest):
    def test_help_shows_examples_and_exit_codes(self):
        out = self.run_tool("--help").stdout.decode()
        self.assertIn("strata union left.stl right.stl -o both.stl", out)
        self.assertIn("Exit codes:", out)

    def test_every_verb_has_help(self):
        for verb in ("union", "intersection", "difference", "symmetric-difference", "resolve", "check", "info", "compare", "layers", "locate",
                     "ray", "eval", "chain", "draw", "batch"):
            self.assertIn("Exit codes:", self.run_tool(verb, "--help").stdout.decode())

    def test_version_is_a_number(self):
        self.assertRegex(self.run_tool("--version").stdout.decode(), r"^strata \d+\.\d+\.\d+\n$")

    def test_misuse_ends_with_two_and_says_why_on_stderr(self):
        a = self.file("a.off", cube())
        for arguments in ((), ("weld", a), ("union", "-o", "out.stl"), ("union", a, a), ("check",), ("check", a, a),
                          ("compare", a), ("union", a, a, "-o", "out.stl", "--input", "wrong"),
                          ("union", a, a, "-o", "out.stl", "--no-such-option"),
                          ("union", a, a, "-o", "out.stl", "--timeout", "soon"),
                          ("union", a, a, "-o", "out.stl", "-j", "-1"),
                          ("union", a, a, "-o", "out.unknown"), ("union", a, a, "-o", "no_extension"),
                          ("union", a, a, "-o", "out.stl", "--format", "fbx"),
                          ("info", a, "--input-format", "nonsense")):
            with self.subTest(arguments=arguments):
                done = self.run_tool(*arguments, expect=USAGE)
                self.assertEqual(done.stdout, b"")
                self.assertNotEqual(done.stderr, b"")
        self.assertEqual(self.left_over(), ["a.off"])

    def test_typical_mistakes_are_answered_with_what_to_type(self):
        self.file("a.off", cube())
        self.file("b.off", cube(1))
        for line, answer in MISTAKES:
            with self.subTest(line=line):
                done = self.run_tool(*line.split(), expect=USAGE)
                message = done.stderr.decode()
                self.assertIn(answer, message)
                self.assertEqual(done.stdout, b"")
                self.assertNotIn("\033", message)
                self.assertNotIn("CLI", message)
        self.assertEqual(self.left_over(), ["a.off", "b.off"])

    def test_help_is_a_verb_too(self):
        self.assertEqual(self.run_tool("help", "union").stdout, self.run_tool("union", "--help").stdout)
        self.assertEqual(self.run_tool("help", "planar", "union").stdout, self.run_tool("planar", "union", "--help").stdout)
        self.assertEqual(self.run_tool("help").stdout, self.run_tool("--help").stdout)

    def test_colours_are_for_terminals_only(self):
        """An error in a terminal of its own, with and without $NO_COLOR."""
        for variables, coloured in (({"TERM": "xterm"}, True), ({"TERM": "dumb"}, False),
                                    ({"TERM": "xterm", "NO_COLOR": "1"}, False), ({"TERM": "xterm", "NO_COLOR": ""}, True)):
            with self.subTest(variables=variables):
                ours, theirs = pty.openpty()
                environment = {k: v for k, v in os.environ.items() if k not in ("NO_COLOR", "TERM")} | variables
                subprocess.run([TOOL, "info", "missing.off"], stderr=theirs, cwd=self.folder, env=environment, check=False)
                os.close(theirs)
                text = os.read(ours, 4096)
                os.close(ours)
                self.assertEqual(b"\033[" in text, coloured, text)
                self.assertIn(b"missing.off", text)

    def test_streams_serve_once(self):
        a = self.file("a.off", cube())
        self.run_tool("union", "-", "-", "-o", "x.off", "--input-format", "off", expect=USAGE)
        self.run_tool("union", "-", a, "-o", "x.off", expect=USAGE)
        self.run_tool("union", a, a, "-o", "-", "--report", "-", expect=USAGE)


class About(ToolTest):
    """What the program says about itself: one description, from which everything else is made."""

    def setUp(self):
        super().setUp()
        self.program = json.loads(self.run_tool("describe").stdout)

    def verbs(self):
        """Paths and descriptions of all verbs, those of verbs included."""
        for verb in self.program["verbs"]:
            yield [verb["name"]], verb
            for inner in verb["verbs"]:
                yield [verb["name"], inner["name"]], inner

    def test_descriptions_are_whole(self):
        for path, verb in self.verbs():
            with self.subTest(path=path):
                self.assertNotEqual(verb["about"], "")
                self.assertTrue(verb["options"])
                for option in verb["options"]:
                    self.assertNotEqual(option["about"], "", option)
                    self.assertFalse(any("->" in word or " " in word for word in option["choices"]), option)

    def test_every_verb_has_a_manual_page_without_faults(self):
        self.run_tool("manual", "--all", "man1")
        pages = {entry.name for entry in self.path("man1").iterdir()}
        self.assertEqual(pages, {"strata.1"} | {"-".join(["strata", *path]) + ".1" for path, _ in self.verbs()})
        for path, verb in self.verbs():
            page = (self.path("man1") / ("-".join(["strata", *path]) + ".1")).read_text()
            for option in verb["options"]:
                self.assertIn(option["names"][0].replace("-", "\\-"), page)
        if shutil.which("mandoc"):
            for name in sorted(pages):
                done = subprocess.run(["mandoc", "-T", "lint", "-W", "error", self.path("man1") / name], capture_output=True, check=False)
                self.assertEqual(done.returncode, 0, done.stdout)

    def test_completions_are_accepted_by_their_shells(self):
        for shell in ("bash", "zsh", "fish"):
            script = self.file(f"completion.{shell}", self.run_tool("completion", shell).stdout.decode())
            with self.subTest(shell=shell):
                if not shutil.which(shell):
                    self.skipTest(f"there is no {shell}")
                subprocess.run([shell, "-n", script], check=True)

    def test_bash_completes_verbs_options_and_words(self):
        script = self.file("completion.bash", self.run_tool("completion", "bash").stdout.decode())
        for words, expected in ((["strata", "inters"], "intersection"), (["strata", "union", "--certi"], "--certify"),
                                (["strata", "union", "--input", "over"], "overlapping"), (["strata", "planar", "xo"], "xor"),
                                (["strata", "planar", "union", "--fill", "ev"], "even-odd"), (["strata", "info", "compl"], "completion.bash")):
            with self.subTest(words=words):
                line = (f"source {script}; COMP_WORDS=({' '.join(words)}); COMP_CWORD={len(words) - 1}; _strata; "
                        "printf '%s\\n' \"${COMPREPLY[@]}\"")
                done = subprocess.run(["bash", "-c", line], cwd=self.folder, capture_output=True, check=True)
                self.assertEqual(done.stdout.decode().split(), [expected], done.stderr)

    def test_formats_lists_what_is_read_and_written(self):
        table = self.run_tool("formats").stdout.decode()
        for row in ("stl ", "xoff ", "ply-big-endian ", "wkt ", "csg "):
            self.assertRegex(table, rf"(?m)^{row}")


if __name__ == "__main__":
    unittest.main()
