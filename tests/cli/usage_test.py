"""The command line itself: help, version, misuse (exit code 2)."""
import unittest

from tool import USAGE, ToolTest, cube


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
                          ("union", a, a, "-o", "out.stl", "--format", "glb"),
                          ("info", a, "--input-format", "nonsense")):
            with self.subTest(arguments=arguments):
                done = self.run_tool(*arguments, expect=USAGE)
                self.assertEqual(done.stdout, b"")
                self.assertNotEqual(done.stderr, b"")
        self.assertEqual(self.left_over(), ["a.off"])

    def test_streams_serve_once(self):
        a = self.file("a.off", cube())
        self.run_tool("union", "-", "-", "-o", "x.off", "--input-format", "off", expect=USAGE)
        self.run_tool("union", "-", a, "-o", "x.off", expect=USAGE)
        self.run_tool("union", a, a, "-o", "-", "--report", "-", expect=USAGE)


if __name__ == "__main__":
    unittest.main()
