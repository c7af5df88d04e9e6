"""minkowski, erosion, offset: sums of meshes, and balls with a proven excess."""
import unittest

from tool import INVALID, USAGE, ToolTest, cube, open_cube


class Minkowski(ToolTest):
    def test_cubes_add_up(self):
        a, b, sum_of_both = self.file("a.off", cube()), self.file("b.off", cube(1, 2, 3, 2)), self.path("sum.off")
        report = self.report("minkowski", a, b, "-o", sum_of_both)
        self.assertEqual(report["operation"], "minkowski")
        self.assertEqual(report["result"]["volume_exact"], "27")
        self.run_tool("compare", sum_of_both, self.file("c.off", cube(1, 2, 3, 3)))

    def test_erosion_undoes_a_sum_of_convex_solids(self):
        a, b = self.file("a.off", cube(0, 0, 0, 3)), self.file("b.off", cube(1, 2, 3, 2))
        self.run_tool("minkowski", a, b, "-o", "sum.off")
        self.run_tool("erosion", "sum.off", b, "-o", "back.off")
        self.run_tool("compare", a, "back.off")

    def test_nothing_left_is_an_empty_mesh(self):
        a, b = self.file("a.off", cube()), self.file("b.off", cube(side=2))
        report = self.report("erosion", a, b, "-o", "out.off")
        self.assertEqual(report["result"]["triangles"], 0)
        self.run_tool("offset", a, "--by", "-1", "-o", "gone.off")
        self.run_tool("compare", "out.off", "gone.off")

    def test_usage(self):
        a, bad = self.file("a.off", cube()), self.file("bad.off", open_cube())
        self.run_tool("minkowski", a, "-o", "out.off", expect=USAGE)
        self.run_tool("minkowski", a, bad, "-o", "out.off", expect=INVALID)
        self.run_tool("offset", a, "-o", "out.off", expect=USAGE)
        self.run_tool("offset", a, "--by", "1", "--facets", "3", "-o", "out.off", expect=USAGE)
        self.run_tool("offset", a, "--by", "nan", "-o", "out.off", expect=USAGE)
        self.assertIn("at least 2^-900", self.run_tool("offset", a, "--by", "1e-320", "-o", "out.off", expect=USAGE).stderr.decode())

    def test_a_sum_beyond_all_doubles_is_no_result(self):
        far = self.file("far.off", cube(1.5e308, 0, 0, 1e300))
        done = self.run_tool("minkowski", far, far, "-o", "out.off", expect=INVALID)
        self.assertIn("beyond all doubles; no result was written", done.stderr.decode())


class Offset(ToolTest):
    def test_the_excess_is_reported_and_bounds_the_volume(self):
        a = self.file("a.off", cube())
        report = self.report("offset", a, "--by", "0.5", "--facets", "80", "-o", "out.off", "--progress")
        exact = 1 + 6 * 0.5 + 3 * 3.14159265 * 0.25 + 4 / 3 * 3.14159265 * 0.125
        self.assertLess(report["excess"], 0.1)
        self.assertGreater(report["result"]["volume"], exact)
        self.assertLess(report["result"]["volume"], exact * (1 + report["excess"]) ** 3)

    def test_no_distance_changes_nothing(self):
        a = self.file("a.off", cube())
        self.run_tool("offset", a, "--by", "0", "-o", "out.off")
        self.run_tool("compare", a, "out.off")


if __name__ == "__main__":
    unittest.main()
