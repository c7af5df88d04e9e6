"""strata verify: every outcome, by engines that misbehave on purpose."""
import os
import unittest

from tool import NEGATIVE, OK, USAGE, cube
from verify_case import VerifyTest


class Outcomes(VerifyTest):
    def setUp(self):
        super().setUp()
        self.case("boxes")

    def expect_outcome(self, outcome, reason, body, *arguments, slug="boxes"):
        passed = outcome in ("exact", "rounded", "not applicable")
        found, why = self.outcome(body, *arguments, slug=slug, expect=0 if passed else NEGATIVE)
        self.assertEqual(found, outcome, why)
        self.assertIn(reason, why)

    def test_exact(self):
        self.expect_outcome("exact", "", "right()")

    def test_other_triangles_of_the_same_solid_are_exact(self):
        self.expect_outcome("exact", "", """
v, f = right()
write(v[::-1], [[len(v) - 1 - i for i in t[1:] + t[:1]] for t in f])""")

    def test_rounded(self):
        self.expect_outcome("rounded", "within rounding", """
v, f = right()
write([[math.nextafter(x, 9) if x == 2 else x for x in p] if p == [2, 1, 1] else p for p in v], f)""")

    def test_more_than_rounding_is_wrong(self):
        self.expect_outcome("wrong", "volume", """
v, f = right()
write([[x + 1e-9 if x == 2 else x for x in p] for p in v], f)""")

    def test_wrong_volume(self):
        self.expect_outcome("wrong", "volume 1 instead of 2", "write(*read(a))")

    def test_wrong_topology(self):
        self.case("hollow", "a - b", second=(3, 0, 0))
        self.expect_outcome("wrong", "components 2 instead of 1", """
v, f = read(a)
w = [[5 + x * 1e-9 for x in p] for p in v]
write(v + w, f + [[i + len(v) for i in t] for t in f])""", slug="hollow")

    def test_nothing_instead_of_something_and_something_instead_of_nothing(self):
        self.expect_outcome("wrong", "empty", "write([], [])")
        self.case("apart", "a & b", second=(5, 5, 5))
        self.expect_outcome("exact", "", "write([], [])", slug="apart")
        self.expect_outcome("wrong", "should be empty", "write(*read(a))", slug="apart")

    def test_open_mesh(self):
        self.expect_outcome("invalid mesh", "open: 3 edges", "v, f = right()\nwrite(v, f[:-1])")

    def test_inverted_mesh(self):
        self.expect_outcome("invalid mesh", "inverted: volume -2", "v, f = right()\nwrite(v, [t[::-1] for t in f])")

    def test_a_wall_that_is_left_is_no_valid_mesh(self):
        self.expect_outcome("invalid mesh", "overlap in one plane", "write(*together())")

    def test_faces_that_cross(self):
        self.case("apart", second=(5, 0, 0))
        self.expect_outcome("invalid mesh", "self-intersection", """
v, f = together()
write([[x - 4.5 if i >= 8 and k == 0 else x for k, x in enumerate(p)] for i, p in enumerate(v)], f)""", slug="apart")

    def test_no_mesh_in_the_file(self):
        self.expect_outcome("invalid mesh", "cannot be read", "open(out, 'w').write('OFF 1 1 0 0 0')")

    def test_refused(self):
        self.expect_outcome("refused", "not my kind of box", "print('not my kind of box', file=sys.stderr)\nsys.exit(3)")

    def test_crashed(self):
        self.expect_outcome("crashed", "signal 11", "os.kill(os.getpid(), signal.SIGSEGV)")
        self.expect_outcome("crashed", "exit status 1: ValueError: oh", "raise ValueError('oh')")
        self.expect_outcome("crashed", "no file", "")
        found, = self.findings("--case", "boxes", "--engine", "missing=/no/such/program", expect=NEGATIVE)
        self.assertEqual((found["outcome"], found["reason"][:15]), ("crashed", "exit status 127"))

    def test_out_of_memory(self):
        self.expect_outcome("crashed", "out of memory", "x = bytearray(4 << 30)", "--memory", "1000")

    def test_timed_out_with_all_its_children(self):
        self.expect_outcome("timed out", "stopped after", f"""
child = subprocess.Popen([sys.executable, "-c", "import time; time.sleep(60)"])
open({str(self.path('pid'))!r}, "w").write(str(child.pid))
while True: pass""", "--seconds", "1.5")
        self.assertFalse(alive(int(self.path("pid").read_text())))

    def test_no_such_operation(self):
        self.expect_outcome("not applicable", "no union", "print('no union', file=sys.stderr)\nsys.exit(5)")

    def test_rational_operands_are_for_exact_files_only(self):
        folder = self.case("rational", certified=False)
        text = (folder / "a.off").read_text().replace("OFF", "XOFF")
        (folder / "a.xoff").write_text(text.replace("\n0 0 0\n", "\n0 0 -1/3\n").replace("\n1 0 0\n", "\n1 0 -1/3\n")
                                       .replace("\n1 1 0\n", "\n1 1 -1/3\n").replace("\n0 1 0\n", "\n0 1 -1/3\n"))
        (folder / "case.json").write_text((folder / "case.json").read_text().replace("a.off", "a.xoff"))
        self.verify("--certify", "--case", "rational")
        self.assertEqual(self.findings("--case", "rational")[0]["outcome"], "exact")
        self.expect_outcome("not applicable", "rational", "right()", slug="rational")

    @unittest.skipIf(os.environ.get("STRATA_SANITIZED"), "the address sanitizer ends a program that is out of memory")
    def test_a_result_that_brings_the_judge_down_ends_its_case_alone(self):
        self.expect_outcome("oracle failed", "the judge failed: out of memory", "os.symlink('/dev/zero', out)",
                            "--memory", 400)

    def test_results_that_are_there_already(self):
        self.run_tool("union", self.file("wrong.off", cube()), self.file("b.off", cube(1)), "-o", "right.off")
        (found,), (wrong,) = (self.findings("--case", "boxes", "--result", self.path(name), expect=expect)
                              for name, expect in (("right.off", OK), ("wrong.off", NEGATIVE)))
        self.assertEqual((found["engine"], found["outcome"], wrong["outcome"]), ("result", "exact", "wrong"))
        self.verify("--result", self.path("right.off"), expect=USAGE)
        self.verify("--case", "boxes", "--result", self.path("right.off"), "--engine", "strata", expect=USAGE)

    def test_a_case_without_expectation(self):
        self.case("new", certified=False)
        self.expect_outcome("oracle failed", "no expected.json", "right()", slug="new")

    def test_touching_sheets_may_be_listed_once_or_apart(self):
        self.case("edge", second=(1, 1, 0))
        self.expect_outcome("exact", "", "right()", slug="edge")
        self.expect_outcome("exact", "", "write(*together())", slug="edge")
        self.expect_outcome("rounded", "", """
v, f = together()
write([[math.nextafter(x, 9) for x in p] if i >= 8 else p for i, p in enumerate(v)], f)""", slug="edge")


def alive(pid):
    import pathlib
    stat = pathlib.Path(f"/proc/{pid}/stat")
    return stat.exists() and stat.read_text().rsplit(")", 1)[1].split()[0] != "Z"


if __name__ == "__main__":
    unittest.main()
