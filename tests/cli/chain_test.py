"""strata chain: steps of a document, exact at every step."""
import json
import unittest
from fractions import Fraction

from chain_case import ChainTest, box, matrix
from tool import DATA, NEGATIVE, USAGE, cube, off


class Chain(ChainTest):
    def test_volumes_are_known_at_every_step(self):
        third, seventh = Fraction(1, 3), Fraction(1, 7)
        steps = [box("difference", (1, 1, 1), (-third, 1, 1), label="notch"),
                 box("union", (1, 1, 1), (4 - seventh, 2, 2)),
                 box("symmetric-difference", (1, 1, 1), (1, 2, 2), label="void"),
                 box("intersection", ("9/2", "9/2", "9/2"), (0, 0, 0)), box("difference", (9, 9, 9), (-1, -1, -1))]
        report = self.chain(self.block, steps)
        self.assertEqual((report["start"]["file"], report["start"]["volume_exact"]), ("block.off", "64"))
        volumes = [64 - 1 + third]
        volumes.append(volumes[-1] + 1 - seventh)
        volumes.append(volumes[-1] - 1)
        volumes.append(volumes[-1] - (5 - seventh - Fraction(9, 2)))
        volumes.append(Fraction(0))
        self.assertEqual([Fraction(step["volume_exact"]) for step in report["steps"]], volumes)
        for k, (step, volume) in enumerate(zip(report["steps"], volumes)):
            self.assertEqual((step["index"], step["operation"]), (k, steps[k]["operation"]))
            self.assertEqual((step["label"], step["file"]), (steps[k].get("label"), "unit.off"))
            self.assertAlmostEqual(step["volume"], float(volume), places=12)
            self.assertGreaterEqual(step["seconds"], 0)
        self.assertEqual([step["triangles"] > 0 for step in report["steps"]], [True] * 4 + [False])
        self.assertEqual((report["result"]["empty"], report["result"]["volume_exact"]), (True, "0"))

    def test_steps_are_what_verbs_do(self):
        steps = self.holes(6)
        self.chain(self.block, steps)
        before = "block.off"
        for k, step in enumerate(steps):
            self.document("tool.json", None, [{**step, "operation": "union"}])
            self.run_tool("chain", "tool.json", "-o", "tool.xoff")
            self.run_tool(step["operation"], before, "tool.xoff", "-o", f"{k}.xoff")
            before = f"{k}.xoff"
        self.run_tool("compare", before, "out.xoff")

    def test_the_report_has_what_went_in_and_came_out(self):
        report = self.chain(self.block, [box("difference", (1, 1, 1), (0, 0, 0)), box("union", (1, 1, 1), (5, 5, 5))])
        self.assertEqual((report["operation"], report["resumed"], report["checkpoints"]), ("chain", None, None))
        self.assertEqual([operand["path"] for operand in report["operands"]], [str(self.path(name)) for name in
                                                                              ("block.off", "unit.off")])
        self.assertEqual((report["result"]["volume_exact"], report["result"]["components"]), ("64", 2))
        self.assertLessEqual({"read", "evaluate", "volumes", "write"}, set(report["seconds"]))
        self.assertGreater(report["peak_bytes"], 0)
        plain = self.report("chain", "steps.json", "-o", "out.off")
        self.assertNotIn("volume_exact", plain["steps"][0])
        self.assertEqual(plain["steps"][0]["volume"], 63)

    def test_transforms_are_exact(self):
        big = 3 * 10**30 + 1
        for rows, volume in ((matrix(("1/3", "1/3", "1/3")), "1/27"), (matrix(("-4/6", 1, 1)), "2/3"),
                             ([[0, 2, 0, 0.5], [1, 0, 0, 0], [0, 0, "+7", "-1/3"], [0, 0, 0, 1]], "14"),
                             ([[2, 0, 0, 1], [0, 2, 0, 1], [0, 0, 2, 1], [0, 0, 0, "2/3"]], "27"),
                             (matrix((f"1/{big}", big, 1)), "1"), (matrix((2**53 + 1, 1, 1)), str(2**53 + 1))):
            with self.subTest(rows=rows):
                report = self.chain(None, [{"operation": "union", "file": "unit.off", "transform": rows}])
                self.assertEqual((report["start"]["file"], report["start"]["volume_exact"]), (None, "0"))
                self.assertEqual(report["result"]["volume_exact"], volume)
                self.assertEqual(self.volume("out.xoff"), Fraction(volume))
        start = {"file": "unit.off", "transform": matrix(("1/3", "1/3", "1/3"), ("1/3", 0, 0)), "label": "third"}
        report = self.chain(start, [])
        self.assertEqual((report["start"]["label"], report["start"]["volume_exact"]), ("third", "1/27"))

    def test_transforms_may_be_rounded_once(self):
        steps = [box("union", ("1/3", 1, 1), (0, 0, 0))]
        nearest = str(Fraction(1 / 3))
        for others, arguments in (({"transforms": "rounded"}, ()), ({}, ("--round-transforms",)),
                                  ({"transforms": "exact"}, ("--round-transforms",))):
            report = self.chain(None, steps, *arguments, **others)
            self.assertEqual(report["result"]["volume_exact"], nearest)
        self.assertEqual(self.chain(None, steps, transforms="exact")["result"]["volume_exact"], "1/3")

    def test_what_rounding_folds_over_is_resolved_where_asked_for(self):
        flat = {"operation": "union", "file": str(DATA / "bracket.off"), "transform": matrix((1, 1, 1e-20), (0, 0, 1))}
        flat["transform"][2][2] = 1e-20
        self.assertEqual(self.chain(None, [flat])["result"]["volume_exact"], str(14 * Fraction(1e-20)))
        for kind in ("overlapping", "repair"):
            report = self.chain(None, [{**flat, "input": kind}], "--round-transforms")
            self.assertEqual((report["result"]["volume_exact"], report["result"]["triangles"]), ("0", 0))

    def test_input_classes_are_those_of_the_options_or_of_the_step(self):
        lines = [cube(), cube(0.5)]
        vertices = [tuple(map(float, line.split())) for text in lines for line in text.splitlines()[2:10]]
        faces = [tuple(int(v) + 8 * k for v in line.split()[1:]) for k, text in enumerate(lines)
                 for line in text.splitlines()[10:]]
        self.file("overlapping.off", off(vertices, faces))
        self.file("twice.off", off(vertices[:8], faces[:12] + faces[:1]))
        step = {"operation": "union", "file": "overlapping.off"}
        self.assertEqual(self.chain(None, [step], "--input", "overlapping")["result"]["volume_exact"], "3/2")
        self.assertEqual(self.chain(None, [{**step, "input": "overlapping"}])["result"]["volume_exact"], "3/2")
        repaired = {"operation": "xor", "file": "twice.off", "input": "repair", "transform": matrix(at=(0, "1/3", 0))}
        report = self.chain(None, [{**step, "input": "overlapping"}, repaired])
        self.assertEqual(report["result"]["volume_exact"], str(Fraction(3, 2) + 1 - 2 * Fraction(2, 3)))
        self.assertTrue(report["operands"][1]["defects"])
        done = self.run_tool("chain", "steps.json", "-o", "out.off")
        self.assertIn(b"twice.off: ", done.stderr)
        self.assertEqual(self.run_tool("chain", "steps.json", "-o", "out.off", "-q").stderr, b"")

    def test_options_are_those_of_the_verbs(self):
        document = self.document("steps.json", self.block, self.holes(12))
        self.assertIs(self.report("chain", document, "-o", "out.off", "--certify")["result"]["rounded_valid"], True)
        for name in ("a.stl", "a.obj", "a.ply", "a.xoff"):
            self.run_tool("chain", document, "-o", name, "-j", "1", "--timeout", "100")
            self.run_tool("info", name)
        one = self.run_tool("chain", document, "-o", "-", "--format", "xoff", "-j", "1").stdout
        self.assertEqual(one, self.run_tool("chain", document, "-o", "-", "--format", "xoff", "-j", "2").stdout)
        self.assertIn(b"strata: 90 %", self.run_tool("chain", document, "-o", "a.stl", "--progress").stderr)
        self.file("block.dat", self.path("block.off").read_text())
        self.document("steps.json", {"file": "block.dat"}, [])
        self.run_tool("chain", document, "-o", "a.stl", "--input-format", "off")

    def test_paths_are_relative_to_the_document(self):
        self.path("parts").mkdir()
        self.document("parts/steps.json", {"file": "../block.off"},
                      [{"operation": "difference", "file": str(self.path("unit.off"))}])
        self.assertEqual(self.report("chain", "parts/steps.json", "-o", "out.off")["result"]["volume_exact"], "63")
        self.path("out.off").unlink()

    def test_standard_streams(self):
        steps = {"start": self.block, "steps": [{"operation": "difference", "file": "unit.off"}]}
        out = self.run_tool("chain", "-", "-o", "-", "--format", "xoff", stdin=json.dumps(steps).encode()).stdout
        self.assertTrue(out.startswith(b"XOFF\n"))
        # Read once, used three times.
        document = self.document("steps.json", {"file": "-"}, [
            {"operation": "xor", "file": "-", "input": kind, "transform": matrix(at=(Fraction(k, 3), 0, 0))}
            for k, kind in ((1, "solid"), (2, "overlapping"))])
        report = json.loads(self.run_tool("chain", document, "-o", "out.off", "--report", "-", "--input-format", "off",
                                          stdin=cube().encode()).stdout)
        self.assertEqual(report["result"]["volume_exact"], "1")
        self.run_tool("chain", document, "-o", "out.off", stdin=cube().encode(), expect=USAGE)
        self.run_tool("chain", "-", "-o", "out.off", "--input-format", "off", expect=USAGE,
                      stdin=json.dumps({"start": {"file": "-"}, "steps": []}).encode())
        self.run_tool("chain", document, "-o", "out.off", "--input-format", "off", "--checkpoint", "c",
                      stdin=cube().encode(), expect=USAGE)

    def test_ten_processes_through_files_are_one(self):
        steps = self.holes(40)
        one = self.chain(self.block, steps)["result"]["volume_exact"]
        before = self.block
        for k in range(10):
            self.document(f"{k}.json", before, steps[4 * k:4 * k + 4])
            self.run_tool("chain", f"{k}.json", "-o", f"{k}.xoff")
            before = {"file": f"{k}.xoff"}
        self.run_tool("compare", "9.xoff", "out.xoff")
        self.assertEqual(self.volume("9.xoff"), Fraction(one))
        self.run_tool("compare", "8.xoff", "out.xoff", expect=NEGATIVE)

    def test_the_example_has_known_volumes(self):
        drill = self.volume(DATA / "drill.off") / 3  # what lies in a leg, whose thickness is 1
        report = self.report("chain", DATA / "drilled_bracket.json", "-o", "out.xoff", "--exact-volumes")
        volumes = [Fraction(14), *(Fraction(step["volume_exact"]) for step in report["steps"])]
        self.assertEqual([after - before for before, after in zip(volumes, volumes[1:])],
                         [-drill] + 4 * [-drill / 9] + [-drill, 1])

    def test_help_shows_the_schema_and_examples(self):
        out = self.run_tool("chain", "--help").stdout.decode()
        for part in ('"steps": [{"operation": "difference"', "--resume part.save", "Exit codes:"):
            self.assertIn(part, out)


if __name__ == "__main__":
    unittest.main()
