"""section and slice: polygons in which planes meet solids, in all formats."""
import csv
import json
import unittest
import xml.etree.ElementTree as xml

from tool import DATA, FILE, INVALID, USAGE, ToolTest, cube, open_cube


class Sections(ToolTest):
    def text(self, *arguments):
        return self.run_tool(*arguments, "-q").stdout.decode()

    def test_a_plane_through_a_cube(self):
        a = self.file("a.off", cube())
        self.assertEqual(self.text("section", a, "--plane", "0,0,1,0.5", "-o", "-"),
                         "POLYGON ((0 0,1 0,1 1,0 1,0 0))\n")
        self.assertEqual(self.text("section", a, "--plane", "0,0,1,0", "-o", "-"), "POLYGON ((0 0,1 0,1 1,0 1,0 0))\n")
        self.assertEqual(self.text("section", a, "--plane", "0,0,1,1", "-o", "-"), "POLYGON EMPTY\n")
        self.assertEqual(self.text("section", a, "--plane", "1,1,1,1/3", "-o", "-", "--exact"),
                         "POLYGON ((0 0,1/3 0,0 1/3,0 0))\n")

    def test_areas_are_exact(self):
        report = self.report("section", DATA / "gear.off", self.file("a.off", cube()), "--plane", "1,1,0,1/3", "-o", "o.wkt")
        self.assertEqual(report["result"]["axes"], ["y", "z"])
        self.assertEqual([a["mesh"] for a in report["result"]["areas"]], [0, 1])
        self.assertEqual(report["result"]["areas"][1]["projected_area_exact"], "1/3")
        self.assertAlmostEqual(report["result"]["areas"][1]["area"], 2 ** 0.5 / 3, places=15)

    def test_all_formats_have_every_plane_of_every_mesh(self):
        a, b = self.file("a.off", cube()), self.file("b.off", cube(0, 0, 0.5))
        common = ("slice", a, b, "--step", "0.25", "-q", "-o")
        self.run_tool(*common, "o.wkt")
        self.assertEqual(len(self.path("o.wkt").read_text().splitlines()), 12)
        self.run_tool(*common, "o.csv")
        rows = list(csv.DictReader(self.path("o.csv").read_text().splitlines()))
        self.assertEqual([(r["plane"], r["mesh"]) for r in rows],
                         [(str(p), str(m)) for m in range(2) for p in range(6)])
        self.assertEqual([float(r["at"]) for r in rows[:6]], [0, 0.25, 0.5, 0.75, 1, 1.25])
        self.assertEqual([float(r["area"]) for r in rows], [1, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1, 1])
        self.run_tool(*common, "o.geojson")
        features = json.loads(self.path("o.geojson").read_text())["features"]
        self.assertEqual(len(features), 12)
        self.assertEqual(features[0]["geometry"]["type"], "Polygon")
        self.assertEqual(features[8]["properties"], {"plane": 2, "at": "0.5", "mesh": 1, "area": 1})
        self.run_tool(*common, "o.svg")
        groups = list(xml.fromstring(self.path("o.svg").read_text()))
        self.assertEqual(len(groups), 12)
        self.assertEqual(groups[7].attrib, {"data-plane": "1", "data-at": "0.25", "data-mesh": "1"})

    def test_planes_from_a_file_and_along_other_axes(self):
        a = self.file("a.off", cube())
        self.file("at.txt", "0.75\n0.25, 2\n")
        report = self.report("slice", a, "--along", "x", "--at", "at.txt", "-o", "o.csv")
        self.assertEqual({k: report["result"][k] for k in ("planes", "sections", "empty", "vertices")},
                         {"planes": 3, "sections": 3, "empty": 1, "vertices": 8})
        done = self.run_tool("slice", a, "--at", "-", "-o", "-", "-q", stdin=b"0.5")
        self.assertEqual(done.stdout, b"POLYGON ((0 0,1 0,1 1,0 1,0 0))\n")
        self.assertEqual(self.report("slice", a, "--step", "0.1", "--from", "0.5", "--to", "0.75", "-o", "o.csv")
                         ["result"]["planes"], 3)

    def test_the_same_for_any_number_of_threads(self):
        texts = {self.text("slice", DATA / "spot.obj", "--along", "y", "--step", "0.01", "-o", "-", "-j", j)
                 for j in (1, 2, 8)}
        self.assertEqual(len(texts), 1)

    def test_what_makes_no_sense_is_refused(self):
        a = self.file("a.off", cube())
        for arguments in (("slice", a, "-o", "o.wkt"), ("slice", a, "--step", "0", "-o", "o.wkt"),
                          ("slice", a, "--step", "1", "--at", "x", "-o", "o.wkt"), ("slice", a, "--step", "1e-12", "-o", "o.wkt"),
                          ("slice", a, "--at", "x", "--from", "1", "-o", "o.wkt"),
                          ("slice", "-", "--input-format", "off", "--at", "-", "-o", "o.wkt"),
                          ("slice", a, "--step", "1", "--to", "inf", "-o", "o.wkt"),
                          ("slice", a, "--along", "w", "--step", "1", "-o", "o.wkt"),
                          ("section", a, "--plane", "0,0,0,1", "-o", "o.wkt"), ("section", a, "-o", "o.wkt"),
                          ("section", a, "--plane", "0,0,1,0", "-o", "o.stl"),
                          ("section", a, "--plane", "0,0,1,0", "-o", "o.svg", "--exact")):
            with self.subTest(arguments=arguments):
                self.run_tool(*arguments, expect=USAGE)
        self.run_tool("slice", a, "--at", "missing.txt", "-o", "o.wkt", expect=FILE)
        self.run_tool("slice", a, "--at", self.file("bad.txt", "1\nx\n"), "-o", "o.wkt", expect=FILE)
        self.run_tool("section", self.file("open.off", open_cube()), "--plane", "0,0,1,0", "-o", "o.wkt", expect=INVALID)
        self.assertFalse(self.path("o.wkt").exists())


if __name__ == "__main__":
    unittest.main()
