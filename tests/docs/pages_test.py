"""Every command in the tutorials and the how-to pages runs, ends with the exit code that the page says, and prints what it shows.

A block of `sh` is run in a scratch folder, one after the other of a page. `<!-- exit N -->` above it is the exit code; without, every
command must end with 0. A block of `text` behind it has lines that its output must contain; their spaces do not matter.
"""
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
TOOL = pathlib.Path(os.environ["STRATA_TOOL"]).resolve()
BLOCK = re.compile(r"(?:<!-- exit (\d+) -->\n)?```(\w*)[^\n]*\n(.*?)^```$", re.DOTALL | re.MULTILINE)
SLOW = {"own-engine.md"}  # tells `strata-verify` to ask hundreds of questions: in the slow tests


def plain(text):
    return re.sub(r"[ \t]+", " ", text)


class Pages(unittest.TestCase):
    def run_page(self, path):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            shutil.copytree(ROOT / "data", folder / "data", ignore=shutil.ignore_patterns("cases"))
            programs = folder / ".programs"
            programs.mkdir()
            (programs / "strata").symlink_to(TOOL)
            environment = os.environ | {"PATH": f"{programs}:{os.environ['PATH']}", "NO_COLOR": "1"}
            output = ""
            for code, language, text in BLOCK.findall(path.read_text(encoding="utf-8")):
                if language == "sh":
                    done = subprocess.run(["bash", "-euo", "pipefail", "-c", text], cwd=folder, env=environment, capture_output=True,
                                          text=True, timeout=120, check=False)
                    output = done.stdout + done.stderr
                    self.assertEqual(done.returncode, int(code or 0), f"{path.name}:\n{text}\n{output}")
                elif language == "text":
                    for line in text.splitlines():
                        self.assertIn(plain(line), plain(output), f"{path.name}: the block says what is not printed")

    def test_the_index_of_how_tos_is_whole(self):
        index = (ROOT / "docs/how-to/index.md").read_text(encoding="utf-8")
        for path in sorted((ROOT / "docs/how-to").glob("*.md")):
            if path.name != "index.md":
                heading = path.read_text(encoding="utf-8").splitlines()[0].removeprefix("# ")
                self.assertIn(f"[{heading}]({path.name})", index)

    def test_programs_that_pages_show_are_there(self):
        for path in sorted((ROOT / "docs").rglob("*.md")):
            for name in re.findall(r'^```\w+ title="(examples/[^"]+)"', path.read_text(encoding="utf-8"), re.MULTILINE):
                self.assertTrue((ROOT / name).is_file(), f"{path}: {name}")


def add(path):
    def test(self):
        if path.name in SLOW and not os.environ.get("STRATA_SLOW"):
            self.skipTest("slow: set STRATA_SLOW")
        self.run_page(path)
    setattr(Pages, "test_" + path.parent.name.replace("-", "_") + "_" + path.stem.replace("-", "_"), test)


for page in sorted([*(ROOT / "docs/tutorials").glob("*.md"), *(ROOT / "docs/how-to").glob("*.md")]):
    if page.name != "index.md":
        add(page)

if __name__ == "__main__":
    unittest.main()
