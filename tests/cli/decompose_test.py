"""decompose: convex pieces as files, as a picture, as numbers."""
import json
import unittest
from fractions import Fraction

from bsp_test import read_glb, volume
from tool import DATA, FILE, INVALID, USAGE, ToolTest, cube, open_cube


class Decompose(ToolTest):
    def test_pieces_of_a_bracket_make_it_again(self):
        bracket = DATA / "bracket.off"
        report = self.report("decompose", bracket, "-o", "pieces")
        self.assertEqual({k: report["result"][k] for k in ("reflex_edges", "pieces", "walls")},
                         {"reflex_edges": 1, "pieces": 2, "walls": 1})
        listed = json.loads(self.path("pieces/decomposition.json").read_text())
        files = [self.path("pieces") / p["file"] for p in listed["pieces"]]
        self.assertTrue(all(f.suffix == ".xoff" for f in files))
        self.run_tool("union", *files, "-o", "again.xoff")
        self.run_tool("compare", "again.xoff", bracket)
        self.assertEqual(sum(Fraction(p["volume_exact"]) for p in listed["pieces"]), Fraction(report["operands"][0]["volume"]))
        self.assertEqual([w["pieces"] for w in listed["walls"]], [[0, 1]])
        self.assertEqual(len(listed["walls"][0]["polygon"]), 4)

    def test_pieces_of_a_gear_in_place_and_pulled_apart(self):
        gear = DATA / "gear.off"
        self.run_tool("decompose", gear, "-o", "in_place.glb")
        self.run_tool("decompose", gear, "-o", "apart.glb", "--exploded")
        sizes = []
        for name in ("in_place.glb", "apart.glb"):
            document, positions = read_glb(self.path(name).read_bytes())
            sizes.append((volume(positions), document["accessors"][0]["max"][1]))
        self.assertAlmostEqual(sizes[0][0], sizes[1][0], places=4)
        self.assertLess(sizes[0][1] * 1.2, sizes[1][1])

    def test_other_formats(self):
        self.run_tool("decompose", self.file("a.off", cube()), "-o", "pieces", "--format", "stl")
        self.assertEqual(len(self.path("pieces/piece-0.stl").read_bytes()), 84 + 12 * 50)

    def test_volumes_have_shells_and_neighbours(self):
        self.file("outer.off", cube(0, 0, 0, 4))
        self.file("inner.off", cube(1, 1, 1, 2))
        self.run_tool("difference", "outer.off", "inner.off", "-o", "hollow.off")
        report = self.report("decompose", "hollow.off", "--volumes")
        volumes = report["volumes"]["volumes"]
        self.assertEqual([v["mark"] for v in volumes[:2]], ["outer", "cavity"])
        self.assertEqual(len(volumes), 2 + report["result"]["pieces"])
        self.assertTrue(all(v["selected"] == (v["mark"] == "piece") and len(v["shells"]) == 1 for v in volumes))
        for n, interface in enumerate(report["volumes"]["interfaces"]):
            for volume in interface["volumes"]:
                self.assertIn(n, sum(volumes[volume]["shells"], []))
        self.assertNotIn(0, volumes[1]["neighbours"])
        self.run_tool("decompose", "hollow.off", "--volumes", expect=USAGE)

    def test_pieces_carry_what_the_solid_carries(self):
        self.file("a.off", cube(0, 0, 0, 2))
        self.file("b.off", cube(1, 1, -1, 4))
        self.run_tool("difference", "a.off", "b.off", "-o", "notched.3mf", "--cut-material", "red", "--unit", "inch")
        # In one file: the notch is red, the wall between the pieces is cut anew, the outside has nothing.
        self.run_tool("decompose", "notched.3mf", "-o", "pieces.obj", "--cut-material", "steel")
        text = self.path("pieces.obj").read_text()
        used = [line for line in text.splitlines() if line.startswith(("g ", "usemtl"))]
        self.assertEqual([line for line in used if line.startswith("g")], ["g piece 0", "g piece 1"])
        self.assertEqual(used.count("usemtl steel"), 2)
        self.assertEqual(used.count("usemtl red"), 2)
        self.run_tool("resolve", "pieces.obj", "-o", "all.off", "--input", "overlapping")
        self.run_tool("compare", "all.off", "notched.3mf")
        # In a folder, with unit; without what is not asked for.
        self.run_tool("decompose", "notched.3mf", "-o", "pieces", "--format", "3mf")
        piece = self.report("info", "pieces/piece-1.3mf")["operands"][0]
        self.assertEqual((piece["materials"], piece["unit"]), (["red"], "inch"))
        self.run_tool("decompose", "notched.3mf", "-o", "bare.obj", "--attributes", "none")
        self.assertNotIn("usemtl", self.path("bare.obj").read_text())
        # A picture has the materials, with each piece an object; without them, colours of the pieces.
        self.run_tool("decompose", "notched.3mf", "-o", "painted.glb", "--exploded", "--cut-material", "#0000ff", "--strict")
        info = self.report("info", "painted.glb")["operands"][0]
        self.assertEqual((info["materials"], info["objects"]), (["red", "#0000ff"], ["piece 0", "piece 1"]))
        _, positions = read_glb(self.path("painted.glb").read_bytes())
        self.run_tool("decompose", "notched.3mf", "-o", "bare.glb", "--exploded", "--attributes", "none")
        self.assertEqual(self.report("info", "bare.glb")["operands"][0].get("materials", []), [])
        self.assertLess(max(x for p in positions for x in p), 0.75)
        # What a format cannot keep is told once, and an error with --strict.
        done = self.run_tool("decompose", "notched.3mf", "-o", "off", "--format", "off")
        self.assertEqual(done.stderr.count(b"materials left out"), 1)
        self.run_tool("decompose", "notched.3mf", "-o", "strict", "--format", "off", "--strict", expect=FILE)

    def test_what_makes_no_sense_is_refused(self):
        a = self.file("a.off", cube())
        self.run_tool("decompose", self.file("open.off", open_cube()), expect=INVALID)
        self.run_tool("decompose", a, "-o", "pieces", "--exploded", expect=USAGE)
        self.run_tool("decompose", a, "-o", "pieces.glb", "--format", "off", expect=USAGE)
        self.run_tool("decompose", a, "-o", a, expect=USAGE)
        self.run_tool("decompose", a, "-o", "twice")
        self.run_tool("decompose", a, "-o", "twice", expect=USAGE)
        self.run_tool("decompose", a, "-o", "pieces", "--format", "doc", expect=USAGE)


if __name__ == "__main__":
    unittest.main()
