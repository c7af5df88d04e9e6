"""planar: Booleans of polygons in WKT, GeoJSON and SVG; the clean test; measures."""
import json
import re
import unittest

from tool import FILE, NEGATIVE, NOT_CERTIFIED, OK, USAGE, ToolTest

SQUARE = "POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))"
OTHER = '{"type": "Polygon", "coordinates": [[[1, 1], [3, 1], [3, 3], [1, 3], [1, 1]]]}'
TRIANGLE = "POLYGON ((0 0, 3 1, 0 1, 0 0))"


class Planar(ToolTest):
    def text(self, name):
        return self.path(name).read_text()

    def test_operations_on_files_of_different_formats(self):
        a, b = self.file("a.wkt", SQUARE), self.file("b.geojson", OTHER)
        areas = {"union": "7", "intersection": "1", "difference": "3", "xor": "6"}
        for operation, area in areas.items():
            report = self.report("planar", operation, a, b, "-o", "out.wkt")
            self.assertEqual(report["result"]["area_exact"], area)
        self.assertEqual(self.text("out.wkt"),
                         "MULTIPOLYGON (((0 0,2 0,2 1,1 1,1 2,0 2,0 0)),((1 2,2 2,2 1,3 1,3 3,1 3,1 2)))\n")
        self.run_tool("planar", "intersection", a, b, "-o", "out.geojson")
        self.assertEqual(json.loads(self.text("out.geojson")),
                         {"type": "Polygon", "coordinates": [[[1, 1], [2, 1], [2, 2], [1, 2], [1, 1]]]})
        self.run_tool("planar", "union", a, b, "-o", "out.svg")
        self.assertIn('d="M0 0L2 0L2 1L3 1L3 3L1 3L1 2L0 2Z', self.text("out.svg"))
        self.run_tool("planar", "xor", "out.svg", a, b, "-o", "again.wkt")
        self.assertEqual(self.report("planar", "info", "again.wkt")["result"]["area_exact"], "1")

    def test_many_operands_and_streams(self):
        files = [self.file(f"{i}.wkt", f"POLYGON (({i} 0, {i + 1} 0, {i + 1} 1, {i} 1))") for i in range(20)]
        done = self.run_tool("planar", "union", *files, "-o", "-", "--format", "wkt")
        self.assertEqual(done.stdout, b"POLYGON ((0 0,20 0,20 1,0 1,0 0))\n")
        done = self.run_tool("planar", "union", "-", "--input-format", "wkt", "-o", "-", "--format", "wkt", stdin=SQUARE.encode())
        self.assertEqual(done.stdout, b"POLYGON ((0 0,2 0,2 2,0 2,0 0))\n")

    def test_exact_coordinates_survive_files(self):
        a, b = self.file("a.wkt", TRIANGLE), self.file("b.wkt", "POLYGON ((0 1, 1 0, 5 0, 5 1))")
        self.run_tool("planar", "intersection", a, b, "-o", "common.wkt", "--exact")
        self.assertIn("3/4 1/4", self.text("common.wkt").replace("0.75 0.25", "3/4 1/4"))
        self.file("c.wkt", "POLYGON ((0 0, 7 1, 7 2, 0 1))")
        self.run_tool("planar", "intersection", a, "c.wkt", "-o", "thirds.wkt", "--exact")
        self.run_tool("planar", "difference", a, "c.wkt", "-o", "rest.wkt", "--exact")
        self.run_tool("planar", "union", "thirds.wkt", "rest.wkt", "-o", "whole.wkt", "--exact")
        self.assertEqual(self.text("whole.wkt"), "POLYGON ((0 0,3 1,0 1,0 0))\n")
        self.run_tool("planar", "union", a, "-o", "a.svg", "--exact", expect=USAGE)

    def test_loops_that_rounding_makes_meet_are_rearranged(self):
        # The corner (1 + 2^-54, 0) falls on the edge at x = 1, once it is rounded.
        self.file("a.wkt", "POLYGON ((18014398509481985/18014398509481984 0, 2 -1, 2 1))")
        self.file("b.wkt", "POLYGON ((0 -1, 1 -1, 1 1, 0 1))")
        done = self.run_tool("planar", "union", "a.wkt", "b.wkt", "-o", "near.wkt", "--rounding", "nearest", expect=NOT_CERTIFIED)
        self.assertIn(b"rounding", done.stderr)
        self.assertIn(b"rearranged", self.run_tool("planar", "union", "a.wkt", "b.wkt", "-o", "out.wkt").stderr)
        self.assertEqual(self.text("out.wkt"), "MULTIPOLYGON (((0 -1,1 -1,1 0,1 1,0 1,0 -1)),((1 0,2 -1,2 1,1 0)))\n")
        again = self.report("planar", "union", "out.wkt", "-o", "again.wkt")
        self.assertEqual((again["rounding_conflicts"], again["rounding"]),
                         ([], {"rounds": 0, "largest_movement": 0, "polygons": 2, "vertices": 8}))
        self.assertEqual(self.text("again.wkt"), self.text("out.wkt"))
        self.run_tool("planar", "union", "a.wkt", "b.wkt", "-o", "out.wkt", "--exact", "--grid", "0.1", expect=USAGE)
        report = self.report("planar", "union", "a.wkt", "b.wkt", "-o", "out.wkt", "--exact")
        self.assertEqual(report["result"]["polygons"], 2)

    def test_coordinates_are_multiples_of_a_step(self):
        self.file("a.wkt", "POLYGON ((0 0, 3 1, 1 3))")
        self.file("b.wkt", "POLYGON ((0 2, 3 0, 3 2))")
        for verb in ("union", "intersection", "symmetric-difference"):
            self.run_tool("planar", verb, "a.wkt", "b.wkt", "-o", "out.wkt", "--grid", "0.125")
            numbers = re.findall(r"-?\d[\d.e-]*", self.text("out.wkt"))
            self.assertTrue(numbers and all(float(x) * 8 % 1 == 0 for x in numbers), self.text("out.wkt"))
        self.run_tool("planar", "union", "a.wkt", "b.wkt", "-o", "out.wkt", "--grid", "-1", expect=USAGE)

    def test_fill_rules(self):
        self.file("star.svg", "M0 3 L2 -3 L-3 1 L3 1 L-2 -3 Z")
        nonzero = self.report("planar", "info", "star.svg")["result"]
        parity = self.report("planar", "info", "star.svg", "--fill", "even-odd")["result"]
        self.assertEqual((nonzero["polygons"], parity["polygons"]), (1, 5))
        self.run_tool("planar", "union", "star.svg", "--fill", "odd", "-o", "x.wkt", expect=USAGE)

    def test_clean_test_names_and_places(self):
        self.run_tool("planar", "check", self.file("a.wkt", SQUARE))
        self.file("bow.wkt", "POLYGON ((0 0, 2 2, 2 0, 0 2))")
        report = self.report("planar", "check", "bow.wkt", expect=NEGATIVE)
        self.assertEqual([(m["kind"], m["where"]) for m in report["listed"]], [("edges crossing", [1.0, 1.0])])

    def test_relative_paths_and_several_subpaths(self):
        self.file("a.svg", '<svg><path d="m1,1h2v2h-2z m.5.5 v1 h1 v-1 z"/></svg>')
        self.assertEqual(self.report("planar", "info", "a.svg", "--fill", "even-odd")["result"]["area_exact"], "3")

    def test_collections_and_features(self):
        self.file("a.wkt", "GEOMETRYCOLLECTION (POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 2 1, 2 2, 1 2, 1 1)), "
                           "MULTIPOLYGON (((9 9, 10 9, 10 10, 9 9)), EMPTY), POLYGON EMPTY)")
        result = self.report("planar", "info", "a.wkt")["result"]
        self.assertEqual((result["area_exact"], result["polygons"], result["holes"]), ("31/2", 2, 1))
        feature = '{"type": "FeatureCollection", "features": [{"type": "Feature", "properties": {"a": "\\"}"}, "geometry": %s}]}'
        self.file("b.json", feature % OTHER)
        self.assertEqual(self.report("planar", "info", "b.json")["result"]["area_exact"], "4")

    def test_what_cannot_be_read_is_told_with_its_line(self):
        for name, text, reason in (("c.svg", '<svg>\n<path d="M0 0 C1 1 2 2 3 3"/></svg>', b"c.svg:2: cubic Bezier curves"),
                                   ("l.wkt", "LINESTRING (0 0, 1 1)", b"found 'LINESTRING'"),
                                   ("n.wkt", "POLYGON ((0 0, 1 nan, 2 2))", b"expected a number"),
                                   ("i.wkt", "POLYGON ((0 0, 1 1e999, 2 2))", b"number"),
                                   ("z.wkt", "POLYGON ((0 0, 1 1/0, 2 2))", b"not zero"),
                                   ("o.wkt", "POLYGON ((0 0, 1 1", b"end of the file"),
                                   ("p.json", '{"type": "Point", "coordinates": [0, 0]}', b"found 'Point'"),
                                   ("d.json", "[" * 2000, b"nested")):
            done = self.run_tool("planar", "info", self.file(name, text), expect=FILE)
            self.assertIn(reason, done.stderr)
        self.run_tool("planar", "info", "missing.wkt", expect=FILE)
        self.run_tool("planar", "union", self.file("a.wkt", SQUARE), "-o", "a.doc", expect=USAGE)


class Queries(ToolTest):
    # A square with a square hole, and a square that touches it in an edge and one in a corner.
    FRAME = "POLYGON ((0 0, 4 0, 4 4, 0 4), (1 1, 1 3, 3 3, 3 1))"

    def test_both_engines_have_the_same_polygons(self):
        a, b = self.file("a.wkt", self.FRAME), self.file("b.wkt", "POLYGON ((2 -1, 7 2, 2 5, 3 2), (5 2, 4 1.5, 4 2.5))")
        for operation in ("union", "intersection", "difference", "xor"):
            for engine in ("arrangement", "bsp"):
                self.run_tool("planar", operation, a, b, "-o", f"{engine}.wkt", "--exact", "--engine", engine)
            texts = [self.path(f"{engine}.wkt").read_text() for engine in ("arrangement", "bsp")]
            self.assertIn("/", texts[0])
            self.assertEqual(*texts, operation)

    def test_bridges(self):
        a = self.file("a.wkt", self.FRAME)
        report = self.report("planar", "bridge", a, "-o", "one.wkt")
        self.assertEqual(report["result"], {"polygons": 1, "bridges": 1})
        ring = self.path("one.wkt").read_text()
        self.assertEqual(ring.count("("), 2)
        self.assertEqual(ring.count(",") + 1, 4 + 4 + 2 + 1)  # a bridge there and back, and the end of the ring
        self.assertEqual(self.report("planar", "info", "one.wkt", "--fill", "even-odd")["result"]["area_exact"], "12")

    def test_points(self):
        a = self.file("a.wkt", self.FRAME)
        self.file("points.csv", "y,x\n0.5,0.5\n2,2\n1,1\n4,0\n9,9\n")
        done = self.run_tool("planar", "locate", a, "--points", "points.csv", "-o", "-", "--report", "r.json")
        self.assertEqual(done.stdout.decode(), "x,y,where\n0.5,0.5,in\n2,2,out\n1,1,on\n0,4,on\n9,9,out\n")
        self.assertEqual(json.loads(self.path("r.json").read_text())["points"], {"count": 5, "in": 1, "on": 2, "out": 2})
        self.file("points.csv", "x\n1\n")
        self.run_tool("planar", "locate", a, "--points", "points.csv", "-o", "-", expect=FILE)

    def test_contacts(self):
        files = [self.file("frame.wkt", self.FRAME), self.file("edge.wkt", "POLYGON ((1 2, 2 2, 2 3, 1 3))"),
                 self.file("corner.wkt", "POLYGON ((4 4, 5 4, 5 5, 4 5))"), self.file("over.wkt", "POLYGON ((0 0, 1 0, 1 1, 0 1))")]
        report = self.report("planar", "contacts", *files)
        pairs = {(p["a"], p["b"]): p for p in report["pairs"]}
        self.assertEqual({k: p["relation"] for k, p in pairs.items()},
                         {(0, 1): "contact", (0, 2): "contact", (0, 3): "interfering", (1, 2): "apart", (1, 3): "apart",
                          (2, 3): "apart"})
        self.assertEqual(pairs[0, 1]["edges"], [[[1, 2], [1, 3]], [[1, 3], [2, 3]]])
        self.assertEqual((pairs[0, 2]["edges"], pairs[0, 2]["points"]), ([], [[4, 4]]))
        self.assertEqual(report["result"], {"apart": 3, "contact": 2, "interfering": 1})

    def test_canonical_decompositions(self):
        # Two squares that touch in a corner are two polygons; a triangle in a hole touches it in one.
        a = self.file("a.wkt", "POLYGON ((0 0, 4 0, 4 4, 0 4), (0 0, 1 3, 3 1))")
        report = self.report("planar", "decompose", a)
        self.assertEqual(report["result"], {"polygons": 1, "vertices": 6, "edges": 7, "exterior_faces": 2})
        polygon = report["polygons"][0]
        self.assertFalse(polygon["manifold"])
        self.assertEqual(polygon["degree"][polygon["vertices"].index([0, 0])], 4)


if __name__ == "__main__":
    unittest.main()
