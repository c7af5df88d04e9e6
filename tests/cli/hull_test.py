"""hull: the convex hull of meshes and points."""
import unittest

from tool import DATA, FILE, INVALID, OK, USAGE, ToolTest, cube, off, open_cube


class Hull(ToolTest):
    def test_the_hull_of_two_cubes(self):
        a, b = self.file("a.off", cube()), self.file("b.off", cube(3))
        report = self.report("hull", a, b, "-o", "hull.off", "--certify")
        self.assertEqual(report["dimension"], 3)
        self.assertEqual(report["points"], 16)
        self.assertEqual([o["path"] for o in report["operands"]], [str(a), str(b)])
        self.assertEqual(report["result"]["volume_exact"], "4")
        self.assertEqual((report["result"]["vertices"], report["result"]["facets"]), (8, 6))
        self.run_tool("difference", a, "hull.off", "-o", "rest.off")
        self.assertEqual(self.report("info", "rest.off")["operands"][0]["triangles"], 0)

    def test_what_is_no_solid_has_a_hull(self):
        report = self.report("hull", self.file("open.off", open_cube()), "-o", "hull.off")
        self.assertEqual(report["result"]["volume_exact"], "1")

    def test_a_hull_is_its_own_hull(self):
        self.run_tool("hull", DATA / "spot.obj", "-o", "once.xoff")
        self.run_tool("hull", "once.xoff", "-o", "twice.xoff", "-j", "1")
        self.assertEqual(self.path("once.xoff").read_bytes(), self.path("twice.xoff").read_bytes())
        self.run_tool("compare", "once.xoff", "twice.xoff", expect=OK)

    def test_a_hull_has_no_attributes_and_its_union_with_the_solid_has_them(self):
        self.file("whole.off", cube(0, 0, 0, 4))
        self.run_tool("intersection", "whole.off", self.file("below.off", cube(-1, -1, -3, 6)), "-o", "low.3mf",
                      "--cut-material", "top")
        self.run_tool("difference", "low.3mf", self.file("corner.off", cube(2, 2, -1, 4)), "-o", "notched.3mf",
                      "--cut-material", "notch")
        hull = self.run_tool("hull", "notched.3mf", "-o", "hull.xoff")
        self.assertIn(b"note: material left out: the result carries no attributes", hull.stderr)
        self.run_tool("union", "notched.3mf", "hull.xoff", "-o", "painted.obj")
        self.run_tool("compare", "painted.obj", "hull.xoff")
        text = self.path("painted.obj").read_text()
        self.assertIn("usemtl top", text)  # what the hull has in common with the solid
        self.assertNotIn("usemtl notch", text)  # what it has not

    def test_points_count_like_vertices(self):
        points = self.file("points.csv", "x,y,z,name\n0,0,0,a\n1,0,0,b\n0,1,0,c\n0,0,1,d\n0.25,0.25,0.25,e\n")
        report = self.report("hull", "--points", points, "-o", "hull.off")
        self.assertEqual((report["points"], report["result"]["volume_exact"]), (5, "1/6"))
        both = self.report("hull", self.file("a.off", cube()), "--points", points, "-o", "hull.off")
        self.assertEqual((both["points"], both["result"]["volume_exact"]), (13, "1"))
        piped = self.run_tool("hull", "--points", "-", "-o", "-", "--format", "off", stdin=points.read_bytes())
        self.assertEqual(piped.stdout.decode().split()[:3], ["OFF", "4", "4"])

    def test_flat_points_are_refused_by_their_dimension(self):
        flat = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0)]
        for points, dimension in ((flat, 2), (flat[:2], 1), (flat[:1], 0), ([], -1)):
            with self.subTest(dimension=dimension):
                rows = "".join(f"{x},{y},{z}\n" for x, y, z in points)
                path = self.file("points.csv", "x,y,z\n" + rows)
                done = self.run_tool("hull", "--points", path, "-o", "hull.off", expect=INVALID)
                self.assertIn(f"dimension {dimension},", done.stderr.decode())
                self.assertFalse(self.path("hull.off").exists())
        report = self.report("hull", self.file("flat.off", off(flat, [(0, 1, 2)])), "-o", "hull.off", expect=INVALID)
        self.assertEqual((report["dimension"], report["result"]), (2, None))

    def test_usage_and_files(self):
        self.run_tool("hull", "-o", "hull.off", expect=USAGE)
        self.run_tool("hull", "missing.off", "-o", "hull.off", expect=FILE)


if __name__ == "__main__":
    unittest.main()
