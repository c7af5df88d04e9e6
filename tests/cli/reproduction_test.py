"""What a verb leaves when the library finds an error of its own. The error is asked for by an environment variable."""
import json
import os
import unittest

from tool import INTERNAL, NOT_CERTIFIED, ToolTest, cube, two_cubes


class Reproduction(ToolTest):
    def setUp(self):
        super().setUp()
        self.file("a.off", cube())
        self.file("b.off", cube(0.1, 1e-300, 1 / 3))

    def fails(self, *arguments, **variables):
        environment = {**os.environ, "STRATA_TEST_LOGIC_ERROR": "1", **variables}
        done = self.run_tool(*arguments, "-o", "out.off", expect=INTERNAL, env=environment)
        self.assertFalse(self.path("out.off").exists())
        return done.stderr.decode()

    def case(self, folder):
        return json.loads((self.path(folder) / "case.json").read_text())

    def test_a_boolean_leaves_a_case_with_its_operands(self):
        said = self.fails("difference", "a.off", "b.off", "a.off", "--input", "overlapping", "-j", "3")
        self.assertIn("please report it: an error that a test asked for", said)
        self.assertIn("strata-reproduction-1", said)
        case = self.case("strata-reproduction-1")
        self.assertEqual(case["expression"], "s0 - s1 - s2")
        self.assertEqual(case["input"], "overlapping")
        self.assertEqual(case["operands"], {"s0": "s0.off", "s1": "s1.off", "s2": "s2.off"})
        self.assertIn("strata difference --input overlapping -j 3", case["why"])

    def test_operands_keep_all_bits(self):
        self.fails("union", "a.off", "b.off")
        def numbers(path):
            return [float(word) for word in path.read_text().split()[1:]]
        for kept, given in (("s0.off", "a.off"), ("s1.off", "b.off")):
            self.assertEqual(numbers(self.path("strata-reproduction-1") / kept), numbers(self.path(given)))
        self.run_tool("difference", "a.off", "b.off", "-o", "third.xoff")
        self.fails("union", "third.xoff", "a.off")
        self.run_tool("compare", "third.xoff", self.path("strata-reproduction-2") / "s0.xoff")

    def test_the_case_can_be_asked_again(self):
        self.fails("eval", "left - (right & left)", "left=a.off", "right=b.off")
        self.assertEqual(self.case("strata-reproduction-1")["expression"], "left - (right & left)")
        self.run_tool("fuzz", "--case", "strata-reproduction-1")

    def test_a_chain_leaves_the_step_that_failed(self):
        self.file("steps.json", json.dumps({"start": {"file": "a.off"},
                                            "steps": [{"operation": "difference", "file": "b.off"}]}))
        self.fails("chain", "steps.json")
        self.assertEqual(self.case("strata-reproduction-1")["expression"], "s0 - s1")
        self.run_tool("fuzz", "--case", "strata-reproduction-1")

    def test_nothing_is_overwritten(self):
        self.path("strata-reproduction-1").mkdir()
        self.file("strata-reproduction-2", "a file")
        self.assertIn("strata-reproduction-3", self.fails("union", "a.off", "b.off"))
        self.assertEqual(list(self.path("strata-reproduction-1").iterdir()), [])
        self.assertEqual(self.path("strata-reproduction-2").read_text(), "a file")

    def test_the_folder_may_be_named(self):
        said = self.fails("xor", "a.off", "b.off", STRATA_REPRODUCTIONS=str(self.path("elsewhere")))
        self.assertIn("elsewhere/strata-reproduction-1", said)
        self.assertEqual(self.case("elsewhere/strata-reproduction-1")["expression"], "s0 ^ s1")

    def test_that_nothing_could_be_kept_is_said(self):
        said = self.fails("union", "a.off", "b.off", STRATA_REPRODUCTIONS=str(self.path("a.off")))
        self.assertIn("please report it: an error that a test asked for", said)
        self.assertIn("could not be kept", said)

    def test_an_exact_result_that_crosses_itself_is_kept(self):
        self.file("crossing.off", two_cubes(0.5))
        said = self.run_tool("union", "crossing.off", self.file("far.off", cube(9)), "-o", "out.xoff", "--input", "solid", "--certify",
                             expect=NOT_CERTIFIED).stderr.decode()
        self.assertIn("an operand crosses itself (`strata check` tells)", said)
        self.assertIn("strata-reproduction-1", said)
        self.assertEqual(self.case("strata-reproduction-1")["expression"], "s0 | s1")
        self.assertTrue(self.path("out.xoff").exists())

    def test_without_an_error_nothing_is_kept(self):
        self.run_tool("union", "a.off", "b.off", "-o", "out.off")
        self.assertEqual(self.left_over(), ["a.off", "b.off", "out.off"])


if __name__ == "__main__":
    unittest.main()
