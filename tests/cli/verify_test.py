"""strata verify: how cases are read, certified and reported."""
import html
import json
import re
import sys
import unittest
import urllib.parse
import xml.etree.ElementTree

from tool import FILE, NEGATIVE, OK, USAGE
from verify_case import VerifyTest


class Cases(VerifyTest):
    def refused(self, change, message):
        """A case whose document is changed like this."""
        folder = self.path("cases") / "boxes"
        if not folder.exists():
            self.case("boxes")
        path = folder / "case.json"
        before = path.read_text()
        document = json.loads(before)
        change(document)
        path.write_text(json.dumps(document))
        error = self.run_tool("verify", "--cases", "cases", expect=FILE).stderr.decode()
        path.write_text(before)
        self.assertIn("case.json", error)
        self.assertIn(message, error)

    def test_errors_name_file_and_field(self):
        def put(key, value):
            return lambda d: d.update({key: value})

        def put_b(**line):
            return lambda d: d["operands"].update({"b": line})
        for change, message in (
                (put("expression", "a |"), "expression: column 4: a name or '(' is missing"),
                (put("expression", "~a"), "expression: the expression is not bounded"),
                (put("expression", "a | c"), "expression: there is no operand 'c'"),
                (put("expression", "a"), "operands: the expression has no 'b'"),
                (put("colour", "red"), "colour: no such key"), (put("why", 7), "why: expected a string"),
                (put("input", "stew"), "input: 'stew' is no input class"),
                (put("known", {"volume": "x"}), "known.volume: expected a number as a string"),
                (put("known", {"weight": "1"}), "known.weight: no such key"),
                (lambda d: d["operands"].update({"a": "missing.off"}), "operands.a: "),
                (lambda d: d["operands"].update({"a": "../other/a.off"}), "operands.a: operands are files in the folder"),
                (put_b(generate="cone"), "operands.b.generate: 'cone' is no family; one of box, boxes"),
                (put_b(generate="box", lower=[0, 0], upper=[1, 1, 1]), "operands.b.lower: expected 3 numbers, found 2"),
                (put_b(generate="box", lower=[0, 0, 0]), "operands.b: 'upper' is missing"),
                (put_b(generate="sphere", centre=[0, 0, 0], radius=1, level=99), "operands.b.level: expected an integer"),
                (put_b(generate="grid", count=[400, 400, 400], lower=[0, 0, 0], pitch=[2, 2, 2], size=[1, 1, 1]),
                 "operands.b.count: at most 80000 cells, these are 64000000"),
                (put("operands", {f"s{n}": {"generate": "sphere", "centre": [0, 0, 0], "radius": 1, "level": 7}
                                  for n in range(4)}), "operands.s3: more than 1000000 triangles are generated"),
                (put("known", {"euler": 2**64 - 1}), "known.euler: expected an integer"),
                (put("known", {"volume": ".+5"}), "known.volume: expected a number as a string"),
                (put("known", {"volume": "1.-5"}), "known.volume: expected a number as a string"),
                (lambda d: d.pop("tags"), "'tags' is missing")):
            with self.subTest(message=message):
                self.refused(change, message)

    def test_cases_are_chosen_by_name_and_tag(self):
        self.case("one")
        self.case("two", second=(5, 5, 5))
        self.assertEqual(len(self.findings()), 2)
        self.assertEqual([f["case"] for f in self.findings("--tag", "two")], ["two"])
        self.assertEqual([f["case"] for f in self.findings("--case", "one", "--jobs", "1")], ["one"])
        self.run_tool("verify", "--cases", "cases", "--tag", "three", expect=USAGE)
        self.run_tool("verify", "--cases", "cases", "--case", "three", expect=FILE)
        self.run_tool("verify", "--cases", "nowhere", expect=FILE)
        self.run_tool("verify", "--cases", "cases", "--report", "board.pdf", expect=USAGE)

    def test_certification_wants_the_authors_knowledge_to_hold(self):
        folder = self.case("known", known={"volume": "2", "area": "10", "components": 1, "euler": 2, "facets": 6})
        expected = json.loads((folder / "expected.json").read_text())
        self.assertEqual(expected["origin"], ["analytic", "strata"])
        self.assertEqual((expected["volume"], expected["vertices"], expected["edges"]), ("2", 8, 12))
        for key, value in (("volume", "2000000001/1000000000"), ("area", "11"), ("components", 2), ("euler", 0),
                           ("facets", 7)):
            with self.subTest(key=key):
                folder = self.case("false-" + key, known={key: value}, certified=False)
                self.assertIn(key if key != "euler" else "Euler",
                              self.verify("--certify", "--case", "false-" + key, expect=NEGATIVE))
                self.assertFalse((folder / "expected.json").exists())

    def test_certification_overwrites_nothing_that_differs(self):
        path = self.case("boxes") / "expected.json"
        changed = path.read_text().replace('"facets": 6', '"facets": 7')
        path.write_text(changed)
        self.assertIn("6 canonical facets instead of 7", self.verify("--certify", expect=NEGATIVE))
        self.assertEqual(path.read_text(), changed)

    def test_other_engines_that_say_the_same_are_noted(self):
        path = self.case("boxes") / "expected.json"
        self.verify("--certify", "--engine", self.engine("write(*read(a))", "liar"), expect=NEGATIVE)
        self.verify("--certify", "--engine", self.engine("right()", "friend"))
        self.assertEqual(json.loads(path.read_text())["origin"], ["friend", "strata"])

    def oracle(self, body):
        path = self.file("oracle", f"#!{sys.executable}\nimport sys\nexpression, out, *bindings = sys.argv[1:]\n{body}\n")
        path.chmod(0o755)
        return "--recertify", "--oracle", path

    def test_the_oracle_agrees_contradicts_or_fails(self):
        path = self.case("boxes") / "expected.json"
        expected = json.loads(path.read_text())
        facts = {key: expected[key] for key in ("volume", "vertices", "edges", "facets", "hash")}
        say = "assert [b[:2] for b in bindings] == ['a=', 'b=']\nopen(out, 'w').write({!r})"
        other = json.dumps({**facts, "hash": "0000000000000000"})
        self.assertIn("1 wrong", self.verify(*self.oracle(say.format(other)), expect=NEGATIVE))
        self.assertIn("1 oracle failed", self.verify(*self.oracle("sys.exit('no idea')"), expect=NEGATIVE))
        self.assertEqual(json.loads(path.read_text())["origin"], ["strata"])
        self.assertIn("1 exact", self.verify(*self.oracle(say.format(json.dumps(facts)))))
        self.assertEqual(json.loads(path.read_text())["origin"], ["nef", "strata"])

    def test_engines_evaluate_expressions_step_by_step(self):
        self.case("steps", "~(~a | b) & ~(b - a)", second=(.5, 0, 0))
        log = self.path("log")
        body = f"open({str(log)!r}, 'a').write(' '.join([operation, *map(os.path.basename, (a, b))]) + '\\n')\nright()"
        finding, = self.findings("--engine", self.engine(body))
        self.assertEqual(finding["outcome"], "exact")
        self.assertEqual(log.read_text().splitlines(), ["difference a.off b.off", "difference b.off a.off",
                                                        "difference step-1.off step-2.off"])

    def test_engines_that_are_not_installed_are_named(self):
        self.case("boxes")
        self.file("absent.py", "import sys\nsys.exit(print('no module; pip install absent', file=sys.stderr) or 4)")
        self.file("present.py", "import sys\nsys.exit(0)")
        for name, message in (("absent", "engine not installed: no module; pip install absent"),
                              ("unknown", "no engine is called 'unknown'")):
            error = self.run_tool("verify", "--cases", "cases", "--engine", name, "--scripts", ".", expect=USAGE)
            self.assertIn(message, error.stderr.decode())
        self.assertIn("1 crashed", self.verify("--engine", "present", "--scripts", ".", expect=NEGATIVE))

    def test_open_defects_are_run_and_told_when_they_are_mended(self):
        self.case("boxes", tags=["known-failure"])
        self.assertIn("boxes: exact now; remove its tag", self.verify(expect=NEGATIVE))

    def test_results_in_doubles_may_be_rounded_and_strata_may_not(self):
        folder = self.case("thirds", "a & b", second=(.5, .5, .5), certified=False)
        document = json.loads((folder / "case.json").read_text())
        document["operands"]["b"] = {"generate": "tetrahedron", "corners": [[0, 0, 0], [3, 1, 0], [0, 7, 1], [1, 0, 3]]}
        (folder / "case.json").write_text(json.dumps(document))
        self.verify("--certify")
        exact, rounded = self.findings("--engine", "strata", "--engine", "strata-doubles")
        self.assertEqual((exact["outcome"], rounded["outcome"]), ("exact", "rounded"))


class Reports(VerifyTest):
    def test_json_junit_and_html_say_the_same(self):
        self.case("boxes")
        self.case("apart", "a & b", second=(5, 5, 5))
        liar = self.engine("write(*read(a))", "liar")
        absent = self.engine("sys.exit(5)", "absent")
        self.verify("--engine", "strata", "--engine", liar, "--engine", absent, "--report", "r.json", "--report", "r.xml",
                    "--report", "r.html", expect=NEGATIVE)
        report = json.loads(self.path("r.json").read_text())
        self.assertEqual([e["outcomes"] for e in report["engines"]],
                         [{"exact": 2}, {"wrong": 2}, {"not applicable": 2}])
        self.assertEqual(report["tags"], {"apart": 1, "test": 2, "boxes": 1})
        suites = xml.etree.ElementTree.parse(self.path("r.xml")).getroot()
        self.assertEqual([(s.get("name"), s.get("tests"), s.get("failures"), s.get("skipped")) for s in suites],
                         [("strata", "2", "0", "0"), ("liar", "2", "2", "0"), ("absent", "2", "0", "2")])
        self.assertIn("instead of 2", suites[1][1][0].get("message"))
        page = self.path("r.html").read_text()
        for text in ('id="boxes"', 'href="#list-1-test"', 'id="list-1-test"', "volume 1 instead of 2", "<svg"):
            self.assertIn(text, page)
        self.assertNotIn("<script", page)
        self.assertEqual(page.count("http"), page.count("http://www.w3.org/2000/svg"))
        self.assertNotIn("workbench", page)

    def test_cases_link_to_the_workbench(self):
        self.case("boxes")
        self.case("apart", "a & b", second=(5, 5, 5))
        self.verify("--report", "r.html", "--workbench", "strata.html?x=1&y=2")
        links = [html.unescape(link).split("#") for link in re.findall(r'<a href="(strata[^"]*)"', self.path("r.html").read_text())]
        self.assertEqual([address for address, _ in links], 2 * ["strata.html?x=1&y=2"])
        asked = urllib.parse.parse_qs(links[0][1])
        self.assertEqual((asked["expression"], sorted(asked)), (["a & b"], ["a.off", "b.off", "expression"]))
        self.path("again.off").write_text(asked["b.off"][0])
        self.run_tool("check", "again.off")

    def test_the_summary_goes_to_standard_output_and_can_be_left_out(self):
        self.case("boxes")
        self.assertIn("strata: 1 exact", self.verify())
        self.assertEqual(self.verify("-q"), "")


if __name__ == "__main__":
    unittest.main()
