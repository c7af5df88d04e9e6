"""topology: cells, parts of the boundary, operators, complexes as files."""
import unittest

from tool import DATA, FILE, INVALID, USAGE, ToolTest, cube, open_cube


class Topology(ToolTest):
    def result(self, *arguments):
        return self.report("topology", *arguments, "--quiet")["result"]

    def test_a_closed_cube(self):
        result = self.result(self.file("a.off", cube()))
        self.assertEqual(result["cells"], [8, 12, 6, 2])
        self.assertEqual(result["parts"]["skin"], [8, 12, 6, 0])
        self.assertEqual(result["parts"]["interior"], [0, 0, 0, 1])
        self.assertEqual((result["components"], result["holes"], result["volume_exact"]), (1, 0, "1"))
        self.assertTrue(result["closed_regularized"])

    def test_a_closed_cube_minus_the_one_that_it_touches(self):
        """The difference lacks a face, which is a wound; minus the open one it lacks nothing."""
        a, b = self.file("a.off", cube()), self.file("b.off", cube(1))
        result = self.result(a, b, "--expression", "a - b")
        self.assertEqual(result["parts"]["wound"], [4, 4, 1, 0])
        self.assertEqual(result["parts"]["skin"], [4, 8, 5, 0])
        self.assertFalse(result["closed"] or result["open"])
        self.assertTrue(self.result(a, b, "--expression", "a - b", "--open", "b")["closed_regularized"])

    def test_what_closed_cubes_have_in_common_may_be_hair(self):
        a, b = self.file("a.off", cube()), self.file("b.off", cube(1))
        result = self.result(a, b, "--expression", "a & b")
        self.assertEqual(result["parts"]["hair"], [4, 4, 1, 0])
        self.assertEqual(result["cells"], [4, 4, 1, 1])
        self.assertEqual((result["volume_exact"], result["area"]), ("0", 1.0))
        self.assertEqual(self.result(a, b, "--expression", "a & b", "--operator", "regularized")["cells"], [0, 0, 0, 1])

    def test_open_cubes_that_touch_have_a_cut_between_them(self):
        a, b = self.file("a.off", cube()), self.file("b.off", cube(1))
        result = self.result(a, b, "--expression", "a | b", "--open", "a", "--open", "b")
        self.assertEqual(result["parts"]["cut"], [0, 0, 1, 0])
        self.assertEqual(result["components"], 2)
        healed = self.result(a, b, "--open", "a", "--open", "b", "--operator", "closure", "--operator", "interior")
        self.assertEqual((healed["cells"], healed["components"]), ([8, 12, 6, 2], 1))

    def test_where_the_boundary_is_no_manifold(self):
        self.file("a.off", cube())
        self.assertEqual(self.report("topology", "a.off")["result"]["non_manifold_cells"], [0, 0, 0, 0])
        self.file("b.off", cube(1, 1, 0))
        result = self.report("topology", "a.off", "b.off")["result"]
        self.assertFalse(result["manifold"])
        self.assertEqual(result["non_manifold_cells"][1], 1)

    def test_complexes_go_through_files(self):
        gear = DATA / "gear.off"
        self.run_tool("topology", gear, "--operator", "complement", "-o", "out.sgc")
        self.run_tool("topology", "x=out.sgc", "--expression", "~x", "-o", "back.sgc")
        self.run_tool("topology", gear, "-o", "gear.sgc")
        self.assertEqual(self.path("back.sgc").read_text(), self.path("gear.sgc").read_text())
        self.assertIsNone(self.result("out.sgc")["volume_exact"])
        mixed = self.result("g=gear.sgc", f"h={gear}", "--expression", "g ^ h")
        self.assertEqual(mixed["cells"], [0, 0, 0, 1])

    def test_what_makes_no_sense_is_refused(self):
        a = self.file("a.off", cube())
        self.run_tool("topology", a, "--expression", "a |", expect=USAGE)
        self.run_tool("topology", a, "--expression", "b", expect=USAGE)
        self.run_tool("topology", a, a, "--expression", "a", expect=USAGE)
        self.run_tool("topology", a, "--operator", "inside", expect=USAGE)
        self.run_tool("topology", a, "--open", "z", expect=USAGE)
        self.run_tool("topology", f"a={a}", f"a={a}", expect=USAGE)
        self.run_tool("topology", self.file("open.off", open_cube()), expect=INVALID)
        self.run_tool("topology", "missing.sgc", expect=FILE)
        self.run_tool("topology", self.file("bad.sgc", "SGC 1\ndimension 3\nvertices 1\n0 nan 0 1\n"), expect=FILE)


if __name__ == "__main__":
    unittest.main()
