"""The report: its members, and values that are known."""
import json
import unittest

from tool import DATA, INVALID, NEGATIVE, NOT_CERTIFIED, ToolTest, cube, off, open_cube

RESULT = {"vertices", "triangles", "facets", "volume", "volume_exact", "area", "components", "euler", "empty", "closed",
          "rounded_valid"}
OPERAND = {"path", "vertices", "triangles", "volume", "area", "components", "euler", "defects"}


class Report(ToolTest):
    def test_a_boolean_reports_what_went_in_and_came_out(self):
        a, b = self.file("a.off", cube()), self.file("b.off", cube(1))
        report = self.report("union", a, b, "-o", "out.stl", "--certify")
        self.assertEqual(report["operation"], "union")
        self.assertEqual([operand["path"] for operand in report["operands"]], [str(a), str(b)])
        for operand in report["operands"]:
            self.assertLessEqual(OPERAND, set(operand))
            self.assertEqual((operand["vertices"], operand["triangles"], operand["volume"]), (8, 12, 1))
            self.assertEqual((operand["area"], operand["components"], operand["euler"]), (6, 1, 2))
            self.assertEqual(operand["defects"], [])
        result = report["result"]
        self.assertLessEqual(RESULT, set(result))
        self.assertEqual((result["volume"], result["volume_exact"], result["area"]), (2, "2", 10))
        self.assertEqual((result["facets"], result["components"], result["euler"]), (6, 1, 2))
        self.assertEqual((result["empty"], result["closed"], result["rounded_valid"]), (False, True, True))
        self.assertLessEqual({"read", "evaluate", "write", "stages"}, set(report["seconds"]))
        self.assertGreater(report["peak_bytes"], 0)
        self.assertRegex(report["strata"], r"^\d+\.\d+\.\d+$")

    def test_exact_volumes_are_fractions(self):
        a, b = self.file("a.off", cube()), self.file("b.off", cube(0.5, 0.5, 0.5))
        for verb, volume in (("union", "15/8"), ("intersection", "1/8"), ("difference", "7/8"), ("symmetric-difference", "7/4")):
            with self.subTest(verb=verb):
                report = self.report(verb, a, b, "-o", "out.off")
                self.assertEqual(report["operation"], verb)
                self.assertEqual(report["result"]["volume_exact"], volume)
                self.assertIsNone(report["result"]["rounded_valid"])

    def test_nothing_left_is_an_empty_solid(self):
        a = self.file("a.off", cube())
        result = self.report("difference", a, a, "-o", "out.ply")["result"]
        self.assertEqual((result["empty"], result["volume_exact"], result["triangles"]), (True, "0", 0))
        self.assertTrue(self.path("out.ply").exists())

    def test_the_demo_obeys_inclusion_and_exclusion(self):
        spot, gear = DATA / "spot.obj", DATA / "gear.off"
        whole = self.report("difference", spot, gear, "-o", "difference.ply")
        common = self.report("intersection", spot, gear, "-o", "intersection.ply")["result"]["volume"]
        self.assertAlmostEqual(whole["result"]["volume"] + common, whole["operands"][0]["volume"], places=12)
        self.assertTrue(whole["result"]["closed"])

    def test_a_refused_operand_is_reported_with_its_defects(self):
        a, bad = self.file("a.off", cube()), self.file("bad.off", open_cube())
        report = self.report("union", a, bad, "-o", "out.off", expect=INVALID)
        self.assertIsNone(report["result"])
        self.assertEqual(report["operands"][0]["defects"], [])
        defect = report["operands"][1]["defects"][0]
        self.assertEqual((defect["kind"], defect["severity"]), ("open edge", "error"))
        self.assertLessEqual({"where", "faces", "count", "message", "remedy"}, set(defect))
        self.assertEqual(len(defect["where"]), 3)
        self.assertFalse(self.path("out.off").exists())

    def test_a_report_on_standard_output_stands_alone(self):
        a, b = self.file("a.off", cube()), self.file("b.off", cube(2))
        for arguments, code in ((("info", a), 0), (("check", a), 0), (("compare", a, b), NEGATIVE),
                                (("union", a, b, "-o", "out.off"), 0)):
            with self.subTest(arguments=arguments):
                done = self.run_tool(*arguments, "--report", "-", expect=code)
                self.assertEqual(json.loads(done.stdout)["operation"], arguments[0])

    def test_broken_meshes_have_no_measures(self):
        bad = self.file("bad.off", open_cube())
        operand = self.report("info", bad)["operands"][0]
        self.assertIsNone(operand["volume"])
        self.assertEqual(operand["closed"], False)
        self.assertEqual(operand["bounding_box"], {"lower": [0, 0, 0], "upper": [1, 1, 1]})
        self.assertTrue(operand["defects"])

    def test_touching_is_counted_and_a_choice(self):
        a, b = self.file("a.off", cube()), self.file("b.off", cube(1, 1, 0))
        for how, vertices in (("shared", 14), ("separate", 16)):
            with self.subTest(how=how):
                report = self.report("union", a, b, "-o", "out.off", "--touching", how)
                self.assertEqual(report["result"]["touching_edges"], 1)
                self.assertEqual(report["result"]["touching_vertices"], 2)
                self.assertEqual(int(self.path("out.off").read_text().split()[1]), vertices)
        self.path("out.off").unlink()
        done = self.run_tool("union", a, b, "-o", "out.off", "--touching", "refuse", expect=NOT_CERTIFIED)
        self.assertIn("in 1 edges and 2 vertices", done.stderr.decode())
        self.assertFalse(self.path("out.off").exists())
        self.run_tool("union", a, "-o", "out.off", "--touching", "refuse")

    def test_repair_says_what_it_did(self):
        vertices = [tuple(map(float, line.split())) for line in cube().splitlines()[2:10]]
        faces = [tuple(map(int, line.split()[1:])) for line in cube().splitlines()[10:]]
        twice = self.file("twice.off", off(vertices, faces + [faces[0]]))
        a = self.file("a.off", cube(3))
        self.report("union", a, twice, "-o", "out.off", expect=INVALID)
        report = self.report("union", a, twice, "-o", "out.off", "--input", "repair")
        self.assertEqual(report["result"]["volume_exact"], "2")
        self.assertEqual({defect["severity"] for defect in report["operands"][1]["defects"]}, {"note"})


if __name__ == "__main__":
    unittest.main()
