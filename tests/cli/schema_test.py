"""Reports of all verbs are what their JSON Schemas say, and say nothing else.

Needs the Python package jsonschema, of this interpreter or of build/python-environment; without, a visible skip.
"""
import copy
import json
import os
import pathlib
import shlex
import sys
import unittest

from report_runs import FILES, RUNS
from tool import ToolTest

ROOT = pathlib.Path(__file__).resolve().parents[2]
ENVIRONMENT = ROOT / "build/python-environment/bin/python"
try:
    import jsonschema
except ImportError:
    jsonschema = None
    if ENVIRONMENT.exists() and pathlib.Path(sys.executable) != ENVIRONMENT and not os.environ.get("STRATA_NO_SECOND_PYTHON"):
        os.environ["STRATA_NO_SECOND_PYTHON"] = "1"
        os.execv(ENVIRONMENT, [str(ENVIRONMENT), *sys.argv])


def strict(schema):
    """The same schema, by which objects have no other members than those it names."""
    if isinstance(schema, dict):
        for part in schema.values():
            strict(part)
        if "properties" in schema and "additionalProperties" not in schema and schema.get("type") == "object":
            schema["additionalProperties"] = False
    if isinstance(schema, list):
        for part in schema:
            strict(part)
    return schema


class Schemas(ToolTest):
    def schema(self, verb):
        return json.loads(self.run_tool("schema", *verb.split()).stdout)

    def verbs(self):
        return self.run_tool("schema").stdout.decode().split("\n")[:-1]

    def test_every_verb_that_reports_has_a_schema_and_a_run(self):
        program = json.loads(self.run_tool("describe").stdout)
        reporting = set()
        for verb in program["verbs"]:
            for name, each in [(verb["name"], verb), *((f"{verb['name']} {inner['name']}", inner) for inner in verb["verbs"])]:
                if any("--report" in option["names"] for option in each["options"]):
                    reporting.add(name)
        self.assertEqual(reporting, set(self.verbs()))
        self.assertEqual(reporting, {verb for verb, _, _ in RUNS})

    def test_an_unknown_verb_is_answered_with_the_nearest(self):
        done = self.run_tool("schema", "unoin", expect=2)
        self.assertIn("did you mean 'union'?", done.stderr.decode())

    @unittest.skipUnless(jsonschema, "SKIPPED: the Python package jsonschema is not there")
    def test_schemas_are_schemas(self):
        for verb in self.verbs():
            with self.subTest(verb=verb):
                schema = self.schema(verb)
                self.assertEqual(schema["$schema"], "https://json-schema.org/draft/2020-12/schema")
                jsonschema.Draft202012Validator.check_schema(schema)
                self.assertNotIn("verbs", schema)

    @unittest.skipUnless(jsonschema, "SKIPPED: the Python package jsonschema is not there")
    def test_reports_are_what_schemas_say(self):
        for name, text in FILES.items():
            self.file(name, text)
        validators = {verb: jsonschema.Draft202012Validator(strict(self.schema(verb))) for verb in self.verbs()}
        for verb, line, code in RUNS:
            with self.subTest(line=line):
                report = self.report(*shlex.split(line), expect=code)
                faults = [f"{error.json_path}: {error.message[:300]}" for error in validators[verb].iter_errors(report)]
                self.assertEqual(faults, [])
                self.path("report.json").unlink()

    @unittest.skipUnless(jsonschema, "SKIPPED: the Python package jsonschema is not there")
    def test_what_is_no_report_is_refused(self):
        """Else the test above would pass for a schema that allows everything."""
        for name, text in FILES.items():
            self.file(name, text)
        report = self.report("union", "a.off", "b.off", "-o", "out.off")
        validator = jsonschema.Draft202012Validator(self.schema("union"))
        self.assertTrue(validator.is_valid(report))
        for change in (lambda r: r.pop("operation"), lambda r: r.update(strata="next"), lambda r: r["result"].update(volume="1"),
                       lambda r: r["operands"][0].pop("path"), lambda r: r["operands"][0].update(defects=[{}]),
                       lambda r: r["result"].update(volume_exact="1.5")):
            wrong = copy.deepcopy(report)
            change(wrong)
            self.assertFalse(validator.is_valid(wrong))


if __name__ == "__main__":
    unittest.main()
