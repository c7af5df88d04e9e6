"""The pages of the site are gathered without a broken link, and the reference has every header, verb and schema.

Python's standard library is enough: MkDocs, which makes HTML of them, is for tools/site.
"""
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
TOOL = os.environ["STRATA_TOOL"]


class Site(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.scratch.cleanup)
        cls.pages = pathlib.Path(cls.scratch.name, "pages")
        done = subprocess.run([sys.executable, ROOT / "tools/pages/stage.py", "--tool", TOOL, "--out", cls.pages], capture_output=True,
                              text=True, check=False)
        assert done.returncode == 0, done.stdout + done.stderr

    def test_links_between_pages_lead_somewhere(self):
        for page in sorted(self.pages.rglob("*.md")):
            text = re.sub(r"^```.*?^```$|`[^`\n]*`", "", page.read_text(encoding="utf-8"), flags=re.DOTALL | re.MULTILINE)
            for place in re.findall(r"\]\(([^)\s#]+)[^)]*\)", text):
                if not re.match(r"[a-z]+:", place):
                    with self.subTest(page=page.relative_to(self.pages), place=place):
                        self.assertTrue((page.parent / place).exists())

    def test_every_header_has_a_page_with_its_names(self):
        for header in (ROOT / "include/strata").glob("*.h"):
            page = (self.pages / "reference/api" / f"{header.stem}.md").read_text(encoding="utf-8")
            for name in re.findall(r"^(?:class|struct|enum class) (\w+)\b.*\{$", header.read_text(encoding="utf-8"), re.MULTILINE):
                self.assertRegex(page, rf"(?m)^#+ {name}$", header)
            code = re.sub(r"private:.*?^\};", "", header.read_text(encoding="utf-8"), flags=re.DOTALL | re.MULTILINE)
            for line in code.splitlines():
                if "[[nodiscard]]" in line:
                    self.assertIn(line.strip(), page, header)

    def test_every_verb_has_a_page(self):
        program = json.loads(subprocess.run([TOOL, "describe"], check=True, capture_output=True).stdout)
        for verb in program["verbs"]:
            page = (self.pages / "reference/verbs" / f"{verb['name']}.md").read_text(encoding="utf-8")
            for option in verb["options"]:
                if "--help" not in option["names"]:
                    self.assertIn(f"`{option['names'][-1]}`", page)

    def test_figures_are_drawn(self):
        self.assertGreaterEqual(len(list((self.pages / "figures").glob("*.svg"))), 4)


if __name__ == "__main__":
    unittest.main()
