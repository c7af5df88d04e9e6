"""Every public header stands alone, includes the standard library only, and costs its includer little.

headers_test.py COMPILER: CXX and, where it is installed, clang++-14 compile each header by itself.
"""
import re
import resource
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

INCLUDE = Path(__file__).resolve().parents[2] / "include"
HEADERS = sorted((INCLUDE / "strata").glob("*.h"))
COMPILERS = [sys.argv.pop(1) if len(sys.argv) > 1 else "c++"] + [c for c in ("clang++-14",) if shutil.which(c)]
# <string>, <vector> and <stdexcept> are 33,000 lines of this; <memory>, <functional>, <atomic> and <filesystem>, 70,000
# lines together, are not included. Lines are the check: seconds depend on what else the machine does.
MOST_LINES, MOST_SECONDS = 50_000, 10.0


def compile_header(compiler, header, *options):
    text = f'#include "strata/{header.name}"\n'
    return subprocess.run([compiler, "-std=c++20", "-Wall", "-Wextra", "-Werror", f"-I{INCLUDE}", *options, "-x", "c++", "-"],
                          input=text, capture_output=True, text=True)


class PublicHeaders(unittest.TestCase):
    def test_each_compiles_alone(self):
        for compiler in COMPILERS:
            for header in HEADERS:
                with self.subTest(compiler=compiler, header=header.name):
                    done = compile_header(compiler, header, "-fsyntax-only")
                    self.assertEqual(done.returncode, 0, done.stderr)

    def test_each_includes_the_standard_library_and_public_headers_only(self):
        for header in HEADERS:
            for name in re.findall(r"^#include\s+(\S+)", header.read_text(), re.M):
                with self.subTest(header=header.name, include=name):
                    if name.startswith('"'):
                        self.assertIn(INCLUDE / name.strip('"'), HEADERS)
                    else:
                        self.assertRegex(name, r"^<[a-z_]+>$")

    def test_each_is_documented_in_its_first_lines(self):
        for header in HEADERS:
            with self.subTest(header=header.name):
                self.assertTrue(header.read_text().splitlines()[1].startswith("/// "))

    def test_the_cost_of_all_of_the_core(self):
        umbrella = INCLUDE / "strata/strata.h"
        for compiler in COMPILERS:
            lines = compile_header(compiler, umbrella, "-E").stdout.count("\n")
            before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
            compile_header(compiler, umbrella, "-fsyntax-only")
            seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
            print(f"strata.h: {lines} preprocessed lines, {seconds:.2f} s of {compiler}", file=sys.stderr)
            with self.subTest(compiler=compiler):
                self.assertGreater(lines, 0)
                self.assertLessEqual(lines, MOST_LINES)
                self.assertLessEqual(seconds, MOST_SECONDS)

    def test_none_includes_the_costly_headers(self):
        for header in HEADERS:
            for name in re.findall(r"^#include\s+<(\S+)>", header.read_text(), re.M):
                with self.subTest(header=header.name, include=name):
                    self.assertNotIn(name, ["algorithm", "atomic", "filesystem", "functional", "iostream", "memory"])


if __name__ == "__main__":
    unittest.main()
