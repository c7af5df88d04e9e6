"""The verdicts of check, compare and --certify, and what Booleans of refused operands say."""
import unittest

from tool import DATA, INVALID, NEGATIVE, ToolTest, cube, off, open_cube, two_cubes


def turned(text):
    """The same mesh with all faces turned over."""
    lines = text.splitlines()
    faces = [" ".join(["3", *reversed(line.split()[1:])]) for line in lines[10:]]
    return "\n".join(lines[:10] + faces) + "\n"


class Answers(ToolTest):
    def test_solids_pass_the_check(self):
        for path in (self.file("a.off", cube()), self.file("apart.off", two_cubes(2)), DATA / "spot.obj"):
            with self.subTest(path=path):
                self.assertIn("a solid", self.run_tool("check", path).stdout.decode())

    def test_what_is_no_solid_is_told_with_its_defects(self):
        for name, text, defect in (("open.off", open_cube(), "open edge"), ("inside_out.off", turned(cube()), "inside"),
                                   ("crossing.off", two_cubes(0.5), "self-intersection")):
            with self.subTest(name=name):
                out = self.run_tool("check", self.file(name, text), expect=NEGATIVE).stdout.decode()
                self.assertIn("not a solid", out)
                self.assertIn(defect, out)

    def test_defects_are_listed_up_to_a_limit_and_all_in_the_report(self):
        vertices = [(3 * i + x, y, 0) for i in range(40) for x, y in ((0, 0), (1, 0), (0, 1))]
        loose = self.file("loose.off", off(vertices, [(3 * i, 3 * i + 1, 3 * i + 2) for i in range(40)]))
        out = self.run_tool("check", loose, expect=NEGATIVE).stdout.decode()
        self.assertEqual(out.count("open edge:"), 100)
        self.assertIn("... and 20 more of this kind", out)
        out = self.run_tool("check", loose, "--max-defects", 3, expect=NEGATIVE).stdout.decode()
        self.assertEqual(out.count("open edge:"), 3)
        self.assertIn("input class soup", out)
        defects = self.report("check", loose, expect=NEGATIVE)["operands"][0]["defects"]
        self.assertEqual([d["kind"] for d in defects], ["open edge"] * 120)
        self.assertEqual({d["count"] for d in defects}, {120})

    def test_check_writes_nothing(self):
        self.run_tool("check", self.file("a.off", cube()))
        self.assertEqual(self.left_over(), ["a.off"])

    def test_quiet_leaves_only_the_exit_code(self):
        a, bad = self.file("a.off", cube()), self.file("bad.off", open_cube())
        for arguments, code in ((("check", a), 0), (("check", bad), NEGATIVE), (("compare", a, a), 0)):
            done = self.run_tool(*arguments, "-q", expect=code)
            self.assertEqual((done.stdout, done.stderr), (b"", b""))

    def test_compare_sees_points_not_triangles(self):
        a, b, whole = self.file("a.off", cube()), self.file("b.off", cube(1)), self.path("whole.off")
        self.run_tool("union", a, b, "-o", whole)
        self.run_tool("union", b, a, "-o", "turned.off")
        self.run_tool("compare", whole, "turned.off")
        done = self.run_tool("compare", whole, a, expect=NEGATIVE)
        self.assertEqual(done.stdout, b"different\n")

    def test_compare_sees_the_last_bit(self):
        a, b = self.file("a.off", cube()), self.file("b.off", cube(2**-52))
        self.run_tool("compare", a, b, expect=NEGATIVE)

    def test_refused_operands_are_named_on_stderr(self):
        a, bad = self.file("a.off", cube()), self.file("bad.off", open_cube())
        for arguments in (("union", a, bad, "-o", "out.off"), ("compare", a, bad)):
            done = self.run_tool(*arguments, expect=INVALID)
            self.assertIn("bad.off: error: open edge", done.stderr.decode())
            self.assertEqual(done.stdout, b"")
        self.assertFalse(self.path("out.off").exists())

    def test_overlapping_input_is_resolved_when_declared(self):
        crossing, far = self.file("crossing.off", two_cubes(0.5)), self.file("far.off", cube(9))
        report = self.report("union", crossing, far, "-o", "out.off", "--input", "overlapping")
        self.assertEqual(report["result"]["volume_exact"], "23/8")

    def test_the_result_does_not_depend_on_threads(self):
        results = set()
        for threads in (1, 2, 8):
            done = self.run_tool("xor", DATA / "sphere.off", DATA / "torus.off", "-o", "-", "--format", "ply", "-j", threads)
            results.add(done.stdout)
        self.assertEqual(len(results), 1)


if __name__ == "__main__":
    unittest.main()
