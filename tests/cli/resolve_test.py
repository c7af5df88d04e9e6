"""One mesh that crosses itself: verified by default, resolved by rules, and what is refused."""
import json
import unittest

from tool import INVALID, USAGE, ToolTest, cube, off, open_cube, two_cubes


class Resolve(ToolTest):
    def volume_of(self, *arguments):
        report = self.report(*arguments)
        return report["result"]["volume_exact"], report

    def test_what_crosses_itself_is_resolved_with_a_note(self):
        crossing = self.file("crossing.off", two_cubes(0.5))
        done = self.run_tool("union", crossing, "-o", "out.off", "--report", "report.json")
        self.assertIn("self-intersection", done.stderr.decode())
        report = json.loads(self.path("report.json").read_text())
        self.assertEqual(report["result"]["volume_exact"], "15/8")
        kinds = {defect["kind"] for defect in report["operands"][0]["defects"]}
        self.assertEqual(kinds, {"self-intersection"})
        self.run_tool("check", "out.off")

    def test_a_solid_is_taken_as_it_is(self):
        done = self.run_tool("union", self.file("a.off", cube()), "-o", "out.off")
        self.assertEqual(done.stderr, b"")

    def test_no_search_where_the_caller_promises(self):
        crossing = self.file("crossing.off", two_cubes(0.5))
        volume, report = self.volume_of("union", crossing, "-o", "out.off", "--input", "solid")
        self.assertEqual(volume, "2")
        self.assertEqual(report["operands"][0]["defects"], [])

    def test_all_rules(self):
        crossing = self.file("crossing.off", two_cubes(0.5))
        for rule, volume in (("winding", "15/8"), ("even-odd", "7/4"), ("outer", "15/8")):
            with self.subTest(rule=rule):
                found, report = self.volume_of("resolve", crossing, "-o", "out.off", "--keep", rule)
                self.assertEqual(found, volume)
                self.assertEqual(report["inside"], rule)
                self.run_tool("check", "out.off")
        self.run_tool("resolve", crossing, "-o", "out.off", "--keep", "some", expect=USAGE)

    def test_all_engines_resolve(self):
        crossing, far = self.file("crossing.off", two_cubes(0.5)), self.file("far.off", cube(9))
        for engine in ("arrangement", "bsp", "layers"):
            with self.subTest(engine=engine):
                self.assertEqual(self.volume_of("union", crossing, far, "-o", "out.off", "--engine", engine)[0], "23/8")

    def test_every_verb_says_what_it_resolves(self):
        """Catches verbs that make a solid in silence."""
        crossing = self.file("crossing.off", two_cubes(0.5))
        self.file("points.csv", "x,y,z\n0.75,0.75,0.75\n")
        self.file("steps.json", json.dumps({"start": {"file": "crossing.off"}, "steps": []}))
        for arguments in (("eval", "a", f"a={crossing}", "-o", "o.off"), ("compare", crossing, crossing),
                          ("decompose", crossing), ("locate", crossing, "--points", "points.csv", "-o", "o.csv"),
                          ("contacts", crossing, self.file("far.off", cube(9))), ("bsp", crossing),
                          ("chain", "steps.json", "-o", "o.off")):
            with self.subTest(arguments=arguments):
                self.assertIn("self-intersection", self.run_tool(*arguments).stderr.decode())
                self.assertEqual(self.run_tool(*arguments, "-q").stderr, b"")

    def test_what_is_open_is_refused(self):
        self.run_tool("resolve", self.file("open.off", open_cube()), "-o", "out.off", expect=INVALID)
        self.assertFalse(self.path("out.off").exists())

    def test_a_soup_becomes_a_solid(self):
        soup = self.file("open.off", open_cube())
        for verb in ("union", "resolve"):
            with self.subTest(verb=verb):
                volume, report = self.volume_of(verb, soup, "-o", "out.off", "--input", "soup")
                self.assertEqual(volume, "1")
                note = report["operands"][0]["defects"][0]
                self.assertEqual((note["kind"], note["severity"]), ("open edge", "note"))
                self.assertIn("3 open edges", note["message"])
                self.run_tool("check", "out.off")
        self.assertIn("was filled", self.run_tool("union", soup, "-o", "out.off", "--input", "soup").stderr.decode())
        self.run_tool("union", soup, "-o", "out.off", "--input", "repair", expect=INVALID)

    def test_holes_are_filled_up_to_a_size(self):
        soup = self.file("open.off", open_cube())
        for word in ("all", "3"):
            volume, _ = self.volume_of("union", soup, "-o", "out.off", "--fill-holes", word)
            self.assertEqual(volume, "1")
        done = self.run_tool("resolve", soup, "-o", "out.off", "--fill-holes", "2", expect=INVALID)
        self.assertIn("a hole is bounded by 3 open edges", done.stderr.decode())
        for word in ("few", "-1", "+4", " 4", "4.5", "99999999999999999999"):
            self.run_tool("union", soup, "-o", "out.off", "--fill-holes", word, expect=USAGE)
        self.run_tool("union", soup, "-o", "out.off", "--fill-holes", "3", "--input", "soup", expect=USAGE)

    def test_a_soup_that_encloses_nothing_is_refused(self):
        flat = self.file("flat.off", off([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2)]))
        done = self.run_tool("union", flat, "-o", "out.off", "--input", "soup", expect=INVALID)
        self.assertIn("enclose no volume", done.stderr.decode())


if __name__ == "__main__":
    unittest.main()
