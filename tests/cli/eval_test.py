"""strata eval: expressions over files."""
import os
import subprocess
import unittest

from tool import DATA, FILE, INVALID, OK, TOOL, USAGE, ToolTest, cube, open_cube


class Eval(ToolTest):
    def volume(self, expression, *bindings):
        return self.report("eval", expression, *bindings, "-o", "out.off")["result"]["volume_exact"]

    def setUp(self):
        super().setUp()
        self.a = f"a={self.file('a.off', cube())}"
        self.b = f"b={self.file('b.off', cube(0.5))}"
        self.c = f"c={self.file('c.off', cube(0, 0.5))}"

    def test_operators_and_parentheses(self):
        for expression, volume in (("a & b", "1/2"), ("a - b", "1/2"), ("a + b", "3/2"), ("a|b", "3/2"), ("a ^ b", "1"),
                                   ("a & ~b", "1/2"), ("!(~a | b)", "1/2"), ("b - a ^ a", "3/2"), ("((a))&b", "1/2")):
            with self.subTest(expression=expression):
                self.assertEqual(self.volume(expression, self.a, self.b), volume)

    def test_what_is_equal_as_steps_is_equal_at_once(self):
        self.run_tool("eval", "(a | b) - c", self.a, self.b, self.c, "-o", "once.ply")
        self.run_tool("union", "a.off", "b.off", "-o", "ab.ply")
        self.run_tool("difference", "ab.ply", "c.off", "-o", "steps.ply")
        self.run_tool("compare", "once.ply", "steps.ply")

    def test_errors_point_at_the_place(self):
        for expression, place, what in (("a - d", 4, "no solid is called 'd'"), ("(a - b", 0, "never closed"),
                                        ("a b", 2, "operator"), ("a -", 3, "a name or '('"), ("", 0, "a name or '('")):
            with self.subTest(expression=expression):
                error = self.run_tool("eval", expression, self.a, self.b, "-o", "out.off",
                                      expect=USAGE).stderr.decode().splitlines()
                self.assertIn(what, error[0])
                self.assertEqual(error[2], "  " + " " * place + "^")
        self.assertEqual(self.left_over(), ["a.off", "b.off", "c.off"])

    def test_misuse(self):
        for arguments in (("a", "-o", "o.off"), ("a", self.a, self.b, "-o", "o.off"), ("a", self.a, self.a, "-o", "o.off"),
                          ("a", "a.off", "-o", "o.off"), ("a", "=a.off", "-o", "o.off"), ("a", "a=", "-o", "o.off"),
                          ("~a", self.a, "-o", "o.off"), ("a", self.a), ("a", "a=-", "-o", "o.off"),
                          ("a | b", "a=-", "b=-", "--input-format", "off", "-o", "o.off")):
            with self.subTest(arguments=arguments):
                self.run_tool("eval", *arguments, expect=USAGE)
        self.assertIn("not bounded", self.run_tool("eval", "a | ~b", self.a, self.b, "-o", "o.off",
                                                   expect=USAGE).stderr.decode())

    def test_files_are_checked(self):
        bad = f"bad={self.file('bad.off', open_cube())}"
        done = self.run_tool("eval", "a - bad", self.a, bad, "-o", "out.off", expect=INVALID)
        self.assertIn("bad.off: error: open edge", done.stderr.decode())
        self.run_tool("eval", "a - m", self.a, "m=missing.off", "-o", "out.off", expect=FILE)

    def test_the_report_tells_the_forms(self):
        report = self.report("eval", "a - (b ^ c) | a & b", self.a, self.b, self.c, "-o", "out.off")
        self.assertEqual(report["operation"], "eval")
        expression = report["expression"]
        self.assertEqual(expression["solids"], 5)
        self.assertEqual(expression["positive_form"]["solids"], 7)
        self.assertEqual(expression["disjunctive_form"]["text"], "a & b | a - b - c")
        self.assertEqual([(p["name"], p["positive"], p["negative"], p["matters"]) for p in expression["primitives"]],
                         [("a", True, False, True), ("b", True, True, True), ("c", True, True, True)])
        self.assertEqual(len(report["operands"]), 3)
        self.assertLessEqual({"read", "evaluate", "write"}, set(report["seconds"]))

    def test_models_of_openscad(self):
        model = self.file("part.csg", """difference() {
  color([1, 0, 0]) { cube(size = [2, 2, 2], center = false); }
  multmatrix([[0.1, 0, 0, 0.1], [0, 1, 0, 0], [0, 0, 1, -0.5], [0, 0, 0, 1]]) { cube(size = 1); }
}
""")
        done = self.run_tool("eval", model, "-o", "part.xoff")
        self.assertIn(b"note: ", done.stderr)
        self.assertEqual(self.report("info", "part.xoff")["operands"][0]["volume"], 7.95)
        self.assertEqual(self.report("eval", model, "-o", "part.off", "--round-transforms")["result"]["volume"], 7.95)
        refused = self.file("bad.csg", "group() {\n  roof() { square(1); }\n}\n")
        error = self.run_tool("eval", refused, "-o", "bad.off", expect=FILE).stderr.decode()
        self.assertIn("bad.csg:2", error)
        self.assertIn("roof", error)
        self.run_tool("eval", "missing.csg", "-o", "bad.off", expect=FILE)

    def test_colors_of_models_are_materials(self):
        model = self.file("colors.csg", "difference() { color([1, 0, 0, 1]) cube(2); color([0, 0, 1, 1]) cube(1); }")
        self.run_tool("eval", model, "-o", "colors.3mf", "--strict")
        self.assertEqual(len(self.report("info", "colors.3mf")["operands"][0]["materials"]), 2)
        self.assertIn(b"materials left out", self.run_tool("eval", model, "-o", "colors.off").stderr)
        self.run_tool("eval", model, "-o", "colors.off", "--strict", expect=FILE)
        self.run_tool("eval", model, "-o", "colors.off", "--strict", "--attributes", "none")

    def test_models_tell_which_nodes_took_long(self):
        model = self.file("part.csg", "hull() { cube(1); sphere(2); }\nminkowski() { cube(1); cube(2); }\nhull() { cube(1); sphere(2); }")
        nodes = self.report("eval", model, "-o", "part.off")["nodes"]
        self.assertEqual(sorted((n["name"], n["line"]) for n in nodes), [("hull", 1), ("minkowski", 2)])
        self.assertEqual([n["seconds"] for n in nodes], sorted((n["seconds"] for n in nodes), reverse=True))

    def test_models_in_the_plane(self):
        model = self.file("flat.csg", "difference() { square(4); polygon(points = [[1, 1], [3, 1], [1, 2]]); "
                                      "polygon(points = [[0, 3], [3, 2.5], [3, 4], [0, 4]]); }")
        report = self.report("eval", model, "-o", "flat.wkt", "--exact")
        self.assertEqual((report["result"], report["shape"]["area_exact"]), (None, "45/4"))
        self.assertIn("POLYGON ((", self.path("flat.wkt").read_text())
        self.assertEqual(self.report("planar", "info", "flat.wkt")["result"]["area_exact"], "45/4")
        self.run_tool("eval", model, "-o", "flat.svg")
        self.assertIn("L4 -", self.path("flat.svg").read_text())  # y downwards
        self.run_tool("eval", model, "-o", "flat.dxf")
        self.assertIn("POLYLINE", self.path("flat.dxf").read_text())
        again = self.file("again.csg", 'linear_extrude(height = 2) { import(file = "flat.dxf"); }')
        self.assertEqual(self.report("eval", again, "-o", "again.off")["result"]["volume_exact"], "45/2")
        back = self.file("back.csg", 'import(file = "flat.svg", dpi = 25.4);')
        self.assertEqual(self.report("eval", back, "-o", "back.wkt")["shape"]["area_exact"], "45/4")
        self.assertIn("is a shape in the plane", self.run_tool("eval", model, "-o", "flat.stl", expect=USAGE).stderr.decode())
        self.assertIn("--exact is for WKT", self.run_tool("eval", model, "-o", "x.svg", "--exact", expect=USAGE).stderr.decode())
        solid = self.file("solid.csg", "cube(1);")
        self.assertIn("is a solid", self.run_tool("eval", solid, "-o", "solid.svg", expect=USAGE).stderr.decode())

    def test_models_read_files_beneath_their_folder(self):
        self.file("outside.off", cube())
        (self.folder / "model").mkdir()
        model = self.file("model/part.csg", 'import(file = "../outside.off");')
        self.assertIn("--allow-path", self.run_tool("eval", model, "-o", "o.off", expect=FILE).stderr.decode())
        self.assertEqual(self.report("eval", model, "--allow-path", "-o", "o.off")["result"]["volume"], 1)

    def test_models_name_fonts_of_files(self):
        font = DATA / "fonts" / "blocks.ttf"
        model = self.file("sign.csg", 'linear_extrude(height = 2) { text(text = "OI", size = 10, font = "Strata Blocks"); }')
        done = subprocess.run([TOOL, "eval", model, "--font", font, "-o", "sign.off"], cwd=self.folder, capture_output=True, check=False)
        if b"this build reads no fonts" in done.stderr:
            self.assertEqual(done.returncode, FILE)
            return
        self.assertEqual((done.returncode, done.stderr), (OK, b""))
        self.assertAlmostEqual(self.report("info", "sign.off")["operands"][0]["volume"], 2 * (84 + 10 * (100 / 10.24 + 2 - 10)))
        no_font = self.run_tool("eval", model, "--font", model, "-o", "none.off", expect=FILE)
        self.assertIn("there is no font in", no_font.stderr.decode())

    def test_programs_of_openscad_are_given_to_openscad(self):
        scad = self.file("part.scad", "cube(size);")
        program = self.file("fake", """#!/bin/sh
[ "$1" = -o ] && [ "$3" = -D ] || exit 1
[ "$4" = size=crash ] && kill -SEGV $$
[ "$4" = size=bad ] && { echo "WARNING: no"; echo "ERROR: bad size" >&2; exit 1; }
echo "cube(size = ${4#size=}, center = false);" > "$2"
""")
        os.chmod(self.folder / "fake", 0o755)
        program = str(self.folder / "fake")
        arguments = ("eval", scad, "--openscad", program, "-o", "part.off")
        self.assertEqual(self.report(*arguments, "-D", "size=3")["result"]["volume"], 27)
        self.assertIn("says: ERROR: bad size", self.run_tool(*arguments, "-D", "size=bad", expect=FILE).stderr.decode())
        self.assertIn("was ended by signal 11", self.run_tool(*arguments, "-D", "size=crash", expect=FILE).stderr.decode())
        error = self.run_tool("eval", scad, "--openscad", "./no-such-program", "-o", "p.off", expect=FILE).stderr.decode()
        self.assertIn("cannot be started: install OpenSCAD", error)
        self.run_tool("eval", "missing.scad", "--openscad", program, "-o", "p.off", expect=FILE)

    def test_standard_streams(self):
        done = self.run_tool("eval", "a - b", "a=-", self.b, "--input-format", "off", "-o", "-", "--format", "off",
                             stdin=cube().encode())
        self.assertTrue(done.stdout.startswith(b"OFF"))


if __name__ == "__main__":
    unittest.main()
