"""strata chain: what is refused, with which words, and that nothing is written."""
import json
import unittest

from chain_case import ChainTest, matrix
from tool import FILE, INVALID, USAGE, cube, open_cube

STEP = {"operation": "union", "file": "unit.off"}


def with_coefficient(x):
    rows = matrix()
    rows[1][2] = x
    return {**STEP, "transform": rows}


class Errors(ChainTest):
    def refused(self, document, *messages, expect=FILE):
        text = document if isinstance(document, str) else json.dumps(document)
        self.file("steps.json", text)
        before = self.left_over()
        error = self.run_tool("chain", "steps.json", "-o", "out.off", expect=expect).stderr.decode()
        for message in messages:
            self.assertIn(message, error)
        self.assertEqual(self.left_over(), before)

    def test_text_that_is_no_json_has_line_and_column(self):
        for text, message in (("", "steps.json:1: column 1: "),
                              ('{"start": null,\n "steps": [}', "steps.json:2: column 12: "),
                              ('{"start": null, "steps": []} x', "steps.json:1: column 30: "),
                              ('{"start": null,\n\n  "steps": [{\'operation\'}]}', "steps.json:3: column 14: "),
                              ('{"start": null, "steps": [1e999]}', "number overflow")):
            with self.subTest(text=text):
                self.refused(text, message)

    def test_keys_that_stand_twice_are_refused(self):
        self.refused('{"start": null, "steps": [{}, {"file": "a", "transform": [[]], "file": "b"}]}',
                     "steps.json: steps[1].file: this key stands twice in one object")
        self.refused('{"start": null, "start": {"file": "unit.off"}, "steps": []}', "start: this key stands twice")

    def test_entries_are_named_by_their_place(self):
        for steps, message in (
                ([STEP, {**STEP, "operation": "cut"}],
                 "steps[1].operation: 'cut' is no operation; one of union, intersection, difference, symmetric-difference"),
                ([{"file": "unit.off"}], "steps[0]: 'operation' is missing"),
                ([{"operation": "union"}], "steps[0]: 'file' is missing"),
                ([STEP, STEP, "union"], 'steps[2]: expected an object, found "union"'),
                ([{**STEP, "file": 7}], "steps[0].file: expected a string, found 7"),
                ([{**STEP, "file": ""}], "steps[0].file: expected a string, not empty"),
                ([{**STEP, "colour": "red"}],
                 "steps[0].colour: no such key; known are operation, file, transform, input, label"),
                ([{**STEP, "input": "stew"}],
                 "steps[0].input: 'stew' is no input class; one of automatic, solid, overlapping, repair, soup"),
                ([{**STEP, "label": [1]}], "steps[0].label: expected a string, found [1]"),
                ({}, "steps: expected an array, found an object")):
            with self.subTest(message=message):
                self.refused({"start": None, "steps": steps}, "steps.json: " + message)

    def test_the_document_is_checked(self):
        for document, message in (([], "steps.json: expected an object, found []"),
                                  ({"steps": []}, "steps.json: 'start' is missing"),
                                  ({"start": None}, "steps.json: 'steps' is missing"),
                                  ({"start": "unit.off", "steps": []}, 'start: expected an object, found "unit.off"'),
                                  ({"start": STEP, "steps": []},
                                   "start.operation: no such key; known are file, transform, input, label"),
                                  ({"start": None, "steps": [], "transforms": "none"},
                                   "transforms: 'none' is no placement of transforms; one of exact, rounded"),
                                  ({"start": None, "steps": [], "step": []},
                                   "step: no such key; known are transforms, start, steps")):
            with self.subTest(message=message):
                self.refused(document, message)

    def test_documents_nested_too_deeply_are_refused(self):
        # Catches values that are copied or shown by recursion: the stack has room for some ten thousand.
        for depth, message in ((99, "start: expected an object"), (100, "nested more than 100 deep"),
                               (1_000_000, "nested more than 100 deep")):
            self.refused('{"start": ' + "[" * depth + "]" * depth + ', "steps": []}', message)

    def test_matrices_are_checked(self):
        wrong = "expected a number or a string with an integer or a quotient of integers"
        for step, message in (
                (with_coefficient("1/x"), f'steps[0].transform[1][2]: {wrong}, like "-1/3", found "1/x"'),
                (with_coefficient("0.5"), wrong), (with_coefficient("--1"), wrong), (with_coefficient("/2"), wrong),
                (with_coefficient("1/-2"), wrong), (with_coefficient(True), f"{wrong}, like \"-1/3\", found true"),
                (with_coefficient(None), wrong), (with_coefficient("-"), wrong),
                (with_coefficient("1/00"), "steps[0].transform[1][2]: the denominator is 0"),
                ({**STEP, "transform": matrix()[:3]}, "steps[0].transform: a matrix has 4 rows, this one has 3"),
                ({**STEP, "transform": [[1, 0, 0]] + matrix()[1:]},
                 "steps[0].transform[0]: a row of a matrix has 4 coefficients, this one has 3"),
                ({**STEP, "transform": [1] * 16}, "steps[0].transform: a matrix has 4 rows, this one has 16"),
                ({**STEP, "transform": matrix()[:3] + [[0, 0, 1, 1]]}, "steps[0].transform[3]: the last row of"),
                ({**STEP, "transform": matrix()[:3] + [[0, 0, 0, 0]]}, "steps[0].transform[3]: the last row of"),
                ({**STEP, "transform": matrix((1, 0, 1))}, "steps[0].transform: a transform of determinant 0"),
                ({**STEP, "transform": [["1/3", "2/3", 0, 0], [1, 2, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]},
                 "steps[0].transform: a transform of determinant 0")):
            with self.subTest(message=message):
                self.refused({"start": None, "steps": [step]}, message)

    def test_files_that_cannot_be_read_are_named_with_their_step(self):
        self.refused({"start": None, "steps": [STEP, {**STEP, "file": "missing.off"}]},
                     "steps.json: steps[1].file: ", "missing.off")
        self.file("bad.off", cube().replace("3 0 2 1", "3 0 2 9"))
        self.refused({"start": {"file": "bad.off"}, "steps": []}, "steps.json: start.file: ", "bad.off:11: ")
        self.path("steps.json").unlink()
        self.run_tool("chain", "steps.json", "-o", "out.off", expect=FILE)

    def test_what_is_no_solid_is_refused_with_its_step_and_defects(self):
        self.file("open.off", open_cube())
        document = {"start": None, "steps": [STEP, {**STEP, "file": "open.off", "label": "lid"}]}
        self.refused(document, "steps.json: steps[1] (lid): ", "open.off: error: open edge", expect=INVALID)
        report = self.report("chain", "steps.json", "-o", "out.off", expect=INVALID)
        self.assertIsNone(report["result"])
        self.assertEqual(report["steps"], [])
        self.assertEqual([operand["defects"] == [] for operand in report["operands"]], [True, False])
        self.assertEqual(report["operands"][1]["defects"][0]["kind"], "open edge")
        self.refused({"start": {"file": "open.off"}, "steps": []}, "steps.json: start: ", "open edge", expect=INVALID)

    def test_misuse(self):
        self.document("steps.json", self.block, [STEP])
        for arguments in ((), ("steps.json",), ("steps.json", "steps.json", "-o", "out.off"),
                          ("steps.json", "-o", "out.unknown"), ("steps.json", "-o", "out.off", "--input", "wrong"),
                          ("steps.json", "-o", "-", "--report", "-"),
                          ("steps.json", "-o", "out.off", "--timeout", "soon")):
            with self.subTest(arguments=arguments):
                self.run_tool("chain", *arguments, expect=USAGE)
        self.assertEqual(self.left_over(), ["block.off", "steps.json", "unit.off"])


if __name__ == "__main__":
    unittest.main()
