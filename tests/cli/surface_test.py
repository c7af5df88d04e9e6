"""clip, split, imprint and cells: surfaces that need not be closed."""
import csv
import json
import unittest
from fractions import Fraction

from tool import DATA, FILE, INVALID, USAGE, ToolTest, cube, off, open_cube


def sheet(height, low=-1, high=2):
    return off([(low, low, height), (high, low, height), (high, high, height), (low, high, height)], [(0, 1, 2, 3)])


class Surfaces(ToolTest):
    def listed(self, folder, verb):
        return json.loads((self.path(folder) / f"{verb}.json").read_text())["files"]

    def test_pieces_make_the_solid_again(self):
        gear = DATA / "gear.off"
        whole = self.report("union", gear, "-o", "whole.xoff")["result"]["volume_exact"]
        report = self.report("split", gear, "--plane", "1,2,3,1/3", "--plane", "0,0,1,0.125", "-o", "pieces")
        self.assertEqual(report["result"]["volume_exact"], whole)
        pieces = self.listed("pieces", "split")
        self.assertEqual(len(pieces), report["result"]["pieces"])
        self.assertGreater(len(pieces), 3)
        self.assertEqual(sum(Fraction(p["volume_exact"]) for p in pieces), Fraction(whole))
        self.run_tool("union", *(self.path("pieces") / p["file"] for p in pieces), "-o", "again.xoff")
        self.run_tool("compare", "again.xoff", gear)

    def test_a_surface_that_ends_inside_divides_nothing(self):
        solid = self.file("a.off", cube())
        self.assertEqual(self.report("split", solid, self.file("s.off", sheet(0.5)))["result"]["pieces"], 2)
        self.assertEqual(self.report("split", solid, self.file("t.off", sheet(0.5, -1, 0.5)))["result"]["pieces"], 1)

    def test_parts_of_a_surface(self):
        solid, surface = self.file("a.off", cube()), self.file("s.off", sheet(0.5))
        for part, area in (("inside", 1), ("outside", 8), ("on", 0)):
            with self.subTest(part=part):
                report = self.report("clip", surface, solid, "--keep", part, "-o", "out.off")
                self.assertEqual(report["result"]["area"], area)
                self.assertEqual(report["result"]["keep"], part)
        self.run_tool("clip", self.file("top.off", sheet(1)), solid, "--keep", "on", "-o", "-", "--format", "off")
        self.run_tool("clip", surface, solid, "--keep", "some", "-o", "out.off", expect=USAGE)

    def test_what_surfaces_carry_goes_into_the_files(self):
        self.file("photo.png", "no picture")
        self.file("terrain.mtl", "newmtl photo\nmap_Kd photo.png\n")
        terrain = self.file("terrain.obj", "mtllib terrain.mtl\nusemtl photo\n"
                            "v -1 -1 .5\nv 3 -1 .5\nv 3 3 .5\nv -1 3 .5\n"
                            "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3\nf 1/1 3/3 4/4\n")
        solid = self.file("a.off", cube())
        self.run_tool("clip", terrain, solid, "-o", "part.obj")
        text = self.path("part.obj").read_text()
        self.assertIn("usemtl photo\n", text)
        self.assertIn("vt 0.25 0.25\n", text)
        self.assertTrue(self.path("part-photo.png").exists())
        self.run_tool("clip", terrain, solid, "-o", "bare.obj", "--attributes", "none")
        self.assertNotIn("vt", self.path("bare.obj").read_text())
        run = self.run_tool("clip", terrain, solid, "-o", "part.off")
        self.assertIn(b"note: materials left out: OFF cannot keep them", run.stderr)
        self.run_tool("clip", terrain, solid, "-o", "part.off", "--strict", expect=FILE)
        self.run_tool("imprint", terrain, solid, "-o", "all.obj")
        text = self.path("all.obj").read_text()
        self.assertIn("g surface 0", text)
        self.assertIn("vt 0.25 0.25\n", text)
        # Several files: what the format cannot keep is told once.
        run = self.run_tool("split", solid, terrain, "-o", "halves", "--format", "off", "--cut-material", "photo")
        self.assertEqual(run.stderr.count(b"materials left out"), 1)
        self.run_tool("split", solid, "--plane", "0,0,1,1/3", "-o", "cut", "--format", "3mf", "--cut-material", "#ff0000")
        self.assertEqual(self.report("info", self.path("cut/piece-0.3mf"))["operands"][0]["materials"], ["#ff0000"])

    def test_imprinted_surfaces_have_common_edges(self):
        a, b = self.file("a.off", cube()), self.file("b.off", cube(1, 0.5, 0.5))
        self.run_tool("imprint", a, b, "-o", "out", "--format", "off")
        first, second = self.listed("out", "imprint")
        self.assertEqual([f["area"] for f in (first, second)], [6, 6])
        self.assertEqual(first["of"], str(a))
        self.assertGreater(first["triangles"], 12)
        self.run_tool("compare", self.path("out") / first["file"], a)

    def test_cells_and_their_walls(self):
        a, b = self.file("a.off", cube()), self.file("b.off", cube(1))
        report = self.report("cells", a, b, self.file("s.off", sheet(0.5, -1, 3)), "-o", "out", "--walls")
        self.assertEqual(report["result"]["cells"], 4)
        cells = self.listed("out", "cells")
        self.assertEqual([c["cell"] for c in cells], [1, 2, 3, 4])
        self.assertEqual({c["volume_exact"] for c in cells}, {"1/2"})
        rows = list(csv.DictReader((self.path("out") / "walls.csv").read_text().splitlines()))
        between = {tuple(sorted((int(r["in_front"]), int(r["behind"])))) for r in rows}
        self.assertEqual(len({pair for pair in between if 0 not in pair}), 4)  # through the sheet, and from cube to cube
        shared = {r["wall"] for r in rows if r["operand"] == "1"} & {r["wall"] for r in rows if r["operand"] == "0"}
        self.assertTrue(shared)  # the common side of the cubes
        self.run_tool("info", self.path("out") / "walls.xoff")

    def test_faces_are_numbered_as_in_the_file_and_options_come_anywhere(self):
        vertices, faces = cube().splitlines()[2:10], cube().splitlines()[10:]
        flat = "\n".join(["OFF", "9 13 0", *vertices, "0.5 0 0", "3 0 8 1", *faces]) + "\n"
        self.run_tool("cells", self.file("flat.off", flat), "-o", "out", "--walls", "-q")
        rows = list(csv.DictReader((self.path("out") / "walls.csv").read_text().splitlines()))
        self.assertEqual(sorted(int(r["face"]) for r in rows), list(range(1, 13)))
        self.run_tool("split", "--plane", "0,0,1,0.5", self.file("a.off", cube()), "-o", "pieces", "-q")
        self.run_tool("split", "a.off", "-o", "-", "--plane", "0,0,1,0.5", expect=USAGE)
        self.run_tool("split", "a.off", "-o", "x", "--format", "foo", "--plane", "0,0,1,0.5", expect=USAGE)
        self.assertFalse(self.path("x").exists())

    def test_open_faces_enclose_a_cell_together(self):
        lid = off([(0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)], [(0, 1, 2, 3)])
        vertices = [(i, j, k) for k in (0, 1) for i, j in ((0, 0), (1, 0), (1, 1), (0, 1))]
        bucket = off(vertices, [(0, 3, 2, 1), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)])
        report = self.report("cells", self.file("bucket.off", bucket), self.file("lid.off", lid))
        self.assertEqual(report["result"]["volume_exact"], "1")
        self.assertEqual(self.report("cells", self.path("bucket.off"))["result"]["cells"], 0)

    def test_what_makes_no_sense_is_refused(self):
        a, surface = self.file("a.off", cube()), self.file("s.off", sheet(0.5))
        self.run_tool("split", a, expect=USAGE)
        for plane in ("1,2,3", "1,2,3,4,5", "0,0,0,1", "1,x,0,0", "1/0,1,1,1", "nan,1,1,1", ""):
            with self.subTest(plane=plane):
                self.run_tool("split", a, f"--plane={plane}", expect=USAGE)
        self.run_tool("split", self.file("open.off", open_cube()), surface, expect=INVALID)
        self.run_tool("clip", surface, self.path("open.off"), "-o", "o.off", expect=INVALID)
        self.run_tool("split", a, surface, "-o", a, expect=USAGE)
        self.run_tool("cells", a, "--walls", expect=USAGE)
        self.run_tool("cells", "missing.off", expect=FILE)
        self.file("wrong.off", off([(0, 0, 0), (1, 0, 0), ("nan", 1, 0)], [(0, 1, 2)]))
        self.run_tool("cells", "wrong.off", expect=FILE)
        self.path("full").mkdir()
        self.file("full/x", "")
        self.run_tool("cells", a, "-o", "full", expect=USAGE)


if __name__ == "__main__":
    unittest.main()
