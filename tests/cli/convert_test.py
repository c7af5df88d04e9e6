"""Other formats, objects, units and what is lost."""
import subprocess
import sys
import unittest
from pathlib import Path

from tool import FILE, TOOL, USAGE, ToolTest, cube

HOSTILE = Path(__file__).resolve().parents[1] / "hostile/run"

OBJ = """mtllib part.mtl
o left
v 0 0 0
v 1 0 0
v 0 1 0
v 0 0 1
vt 0 0
vt 1 0
usemtl red
f 1/1 3/2 2/1
f 1/1 2/1 4/2
f 2/1 3/1 4/2
f 3/2 1/1 4/1
o right
v 5 0 0
v 6 0 0
v 5 1 0
v 5 0 1
f 5 7 6
f 5 6 8
f 6 7 8
f 7 5 8
"""
AMF = """<amf unit='inch'><object id='0'><mesh><vertices>
<vertex><coordinates><x>0</x><y>0</y><z>0</z></coordinates></vertex><vertex><coordinates><x>1</x><y>0</y><z>0</z></coordinates></vertex>
<vertex><coordinates><x>0</x><y>1</y><z>0</z></coordinates></vertex><vertex><coordinates><x>0</x><y>0</y><z>1</z></coordinates></vertex>
</vertices><volume><triangle><v1>0</v1><v2>2</v2><v3>1</v3></triangle><triangle><v1>0</v1><v2>1</v2><v3>3</v3></triangle>
<triangle><v1>1</v1><v2>2</v2><v3>3</v3></triangle><triangle><v1>2</v1><v2>0</v2><v3>3</v3></triangle></volume></mesh></object></amf>"""


class Convert(ToolTest):
    def textured(self):
        self.file("part.mtl", "newmtl red\nKd 1 0 0\n")
        return self.file("part.obj", OBJ)

    def facts(self, path):
        return self.report("info", path, "-q")["operands"][0]

    def test_every_format_keeps_the_solid(self):
        a = self.file("a.off", cube())
        for extension in ("3mf", "glb", "gltf", "obj", "ply", "xoff", "stl"):
            with self.subTest(format=extension):
                self.run_tool("convert", a, "-o", f"b.{extension}")
                self.run_tool("compare", a, f"b.{extension}")
        for extension in ("vtk", "msh"):
            self.run_tool("convert", a, "-o", f"b.{extension}")
            self.run_tool("check", f"b.{extension}", expect=FILE)

    def test_objects_materials_and_texture_coordinates_come_along(self):
        part = self.textured()
        for extension in ("3mf", "glb", "gltf", "obj"):
            with self.subTest(format=extension):
                self.run_tool("convert", part, "-o", f"copy.{extension}")
                facts = self.facts(f"copy.{extension}")
                self.assertEqual(facts["objects"], ["left", "right"])
                self.assertEqual(facts["materials"], ["red"])
                self.assertIn("material (face, 1 x integer)", facts["channels"])

    def test_ply_and_off_keep_channels(self):
        colors = self.file("a.off", "COFF\n3 1 0\n0 0 0 1 2 3\n1 0 0 4 5 6\n0 1 0 7 8 9\n3 0 1 2\n")
        self.run_tool("convert", colors, "-o", "b.ply", "--strict")
        self.run_tool("convert", "b.ply", "-o", "c.off", "--strict")
        self.assertEqual(self.path("c.off").read_text(), colors.read_text())
        self.assertEqual(self.facts("b.ply")["channels"], ["color (vertex, 3 x byte)"])
        part = self.textured()
        self.run_tool("convert", part, "-o", "part.ply")
        self.assertIn("material (face, 1 x integer)", self.facts("part.ply")["channels"])

    def test_what_is_lost_is_told_once_and_an_error_if_strict(self):
        part = self.textured()
        said = self.run_tool("convert", part, "-o", "a.stl").stderr.decode()
        self.assertIn("materials left out: STL cannot keep them", said)
        self.assertIn("names of objects left out", said)
        self.run_tool("convert", part, "-o", "strict.stl", "--strict", expect=FILE)
        self.assertFalse(self.path("strict.stl").exists())
        a = self.file("a.off", cube())
        self.run_tool("convert", a, "-o", "strict.glb", "--strict")

    def test_each_object_is_an_operand_if_asked(self):
        part = self.textured()
        self.assertEqual(len(self.report("union", part, "-o", "u.off", "--objects")["operands"]), 2)
        self.run_tool("intersection", part, "-o", "i.off", "--objects")
        self.assertEqual(self.path("i.off").read_text().split()[2], "0")

    def test_operands_of_different_units_are_converted_exactly(self):
        inch = self.file("inch.amf", AMF)
        mesh = self.file("mm.off", cube(0, 0, 0, 2))
        self.run_tool("convert", mesh, "-o", "mm.3mf", "--unit", "mm")
        self.assertEqual(self.facts("mm.3mf")["unit"], "millimeter")
        self.assertEqual(self.facts(inch)["unit"], "inch")
        self.run_tool("convert", inch, "-o", "inch.3mf")
        self.assertEqual(self.facts("inch.3mf")["unit"], "inch")
        report = self.report("union", "mm.3mf", inch, "-o", "both.xoff")
        # 25.4^3 / 6 and 8, minus what they have in common: the cube is inside the tetrahedron.
        self.assertAlmostEqual(report["operands"][1]["volume"], 25.4**3 / 6, 9)
        self.assertEqual(self.facts("both.xoff")["volume_exact"], "2048383/750")
        said = self.run_tool("union", "mm.3mf", mesh, "-o", "same.3mf").stderr.decode()
        self.assertIn("says no unit: taken for millimeter", said)
        self.assertEqual(self.facts("same.3mf")["unit"], "millimeter")
        self.run_tool("convert", mesh, "-o", "x.3mf", "--unit", "parsec", expect=USAGE)

    def test_results_in_floats_are_solids(self):
        a, b = self.file("a.off", cube(0.1, 0.1, 0.1)), self.file("b.off", cube(0.4, 0.3, 0.7))
        self.run_tool("union", a, b, "-o", "u.glb", "--certify")
        self.run_tool("check", "u.glb")

    def test_damaged_files_end_in_a_result_or_an_error(self):
        seeds = self.path("seeds")
        seeds.mkdir()
        part = self.textured()
        for extension in ("3mf", "glb", "gltf", "obj", "ply", "off"):
            self.run_tool("convert", part, "-o", seeds / f"part.{extension}")
        (seeds / "part.amf").write_text(AMF)
        done = subprocess.run([sys.executable, HOSTILE, "--tool", TOOL, "--seeds", seeds, "--count", "15"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)


if __name__ == "__main__":
    unittest.main()
