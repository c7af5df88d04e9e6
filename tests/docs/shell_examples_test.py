"""Every script in examples/shell runs, on the meshes of the repository; every example has less than fifty lines and is listed."""
import os
import pathlib
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
TOOL = pathlib.Path(os.environ["STRATA_TOOL"]).resolve()
PRINTS = {"subtract.sh": "a solid", "layers.sh": "", "check_folder.sh": "are solids"}


class ShellExamples(unittest.TestCase):
    def test_scripts(self):
        scripts = sorted((ROOT / "examples/shell").glob("*.sh"))
        self.assertEqual({script.name for script in scripts}, set(PRINTS))
        for script in scripts:
            with self.subTest(script=script.name), tempfile.TemporaryDirectory() as out:
                programs = pathlib.Path(out, "programs")
                programs.mkdir()
                (programs / "strata").symlink_to(TOOL)
                done = subprocess.run([script, ROOT / "data", out], env=os.environ | {"PATH": f"{programs}:{os.environ['PATH']}"},
                                      capture_output=True, text=True, timeout=120, check=False)
                self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
                self.assertIn(PRINTS[script.name], done.stdout)

    def test_examples_are_short_and_listed(self):
        listed = (ROOT / "examples/README.md").read_text(encoding="utf-8")
        programs = [path for pattern in ("cpp/*.cpp", "python/*.py", "shell/*.sh") for path in (ROOT / "examples").glob(pattern)]
        self.assertGreaterEqual(len(programs), 10)
        for path in programs:
            self.assertLess(len(path.read_text(encoding="utf-8").splitlines()), 50, path)
            self.assertIn(f"({path.relative_to(ROOT / 'examples')})", listed)


if __name__ == "__main__":
    unittest.main()
