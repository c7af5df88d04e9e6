"""verify and fuzz are verbs of the program strata-verify, which the command line becomes."""
import os
import shutil
import signal
import subprocess
import unittest

from tool import FILE, TOOL, ToolTest

# Says how it was called; its exit code is its second argument.
FAKE = """#!/bin/sh
echo "$@"
cat
[ "$2" = wait ] && { kill -TERM $$; sleep 60; }
exit "$2"
"""


class Suite(ToolTest):
    def setUp(self):
        super().setUp()
        self.path("bin").mkdir()
        shutil.copy(TOOL, self.path("bin/strata"))

    def install(self, where):
        path = self.path(where)
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(FAKE)
        path.chmod(0o755)

    def call(self, *arguments, path="", stdin=b""):
        return subprocess.run([self.path("bin/strata"), *arguments], input=stdin, capture_output=True, timeout=60,
                              env={**os.environ, "PATH": f"{path}:/usr/bin:/bin"})

    def test_arguments_streams_and_exit_code_go_through(self):
        for where, path in (("bin/strata-verify", ""), ("libexec/strata/strata-verify", ""),
                            ("elsewhere/strata-verify", str(self.path("elsewhere")))):
            with self.subTest(where=where):
                self.install(where)
                done = self.call("fuzz", "7", "--seed", "a b", "--help", path=path, stdin=b"in\n")
                self.assertEqual((done.returncode, done.stdout), (7, b"fuzz 7 --seed a b --help\nin\n"))
                self.path(where).unlink()

    def test_a_signal_that_ends_it_ends_the_verb(self):
        self.install("bin/strata-verify")
        self.assertEqual(self.call("verify", "wait").returncode, -signal.SIGTERM)

    def test_without_it_the_verbs_say_what_is_missing(self):
        for verb in ("verify", "fuzz"):
            done = self.call(verb, "--seed", "1")
            self.assertEqual(done.returncode, FILE)
            self.assertIn(f"strata: {verb} is a verb of the program strata-verify, which is neither beside this one",
                          done.stderr.decode())
        self.assertIn(b"  verify  ", self.call("--help").stdout)


if __name__ == "__main__":
    unittest.main()
