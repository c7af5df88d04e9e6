"""What the tests of the command line share: a scratch folder, the tool, small meshes as text."""
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

OK, NEGATIVE, USAGE, FILE, INVALID, NOT_CERTIFIED, STOPPED = range(7)
INTERNAL = 70  # EX_SOFTWARE
DATA = pathlib.Path(os.environ["STRATA_DATA_DIR"])
TOOL = os.environ["STRATA_TOOL"]

CUBE_FACES = [(0, 2, 1), (0, 3, 2), (4, 5, 6), (4, 6, 7), (0, 1, 5), (0, 5, 4),
              (1, 2, 6), (1, 6, 5), (2, 3, 7), (2, 7, 6), (3, 0, 4), (3, 4, 7)]


def off(vertices, faces):
    lines = ["OFF", f"{len(vertices)} {len(faces)} 0"]
    lines += [" ".join(map(str, v)) for v in vertices]
    lines += [" ".join(map(str, (len(f), *f))) for f in faces]
    return "\n".join(lines) + "\n"


def cube(x=0, y=0, z=0, side=1):
    base = [(0, 0), (1, 0), (1, 1), (0, 1)]
    return off([(x + side * i, y + side * j, z + side * k) for k in (0, 1) for i, j in base], CUBE_FACES)


def open_cube():
    return off([tuple(map(float, line.split())) for line in cube().splitlines()[2:10]], CUBE_FACES[:-1])


def two_cubes(x):
    """Two cubes in one file, the second one moved by x."""
    first, second = cube().splitlines(), cube(x, x, x).splitlines()
    vertices = [tuple(map(float, line.split())) for line in first[2:10] + second[2:10]]
    faces = [tuple(map(int, line.split()[1:])) for line in first[10:]]
    return off(vertices, faces + [tuple(8 + v for v in face) for face in faces])


class ToolTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def file(self, name, text):
        path = self.folder / name
        path.write_text(text)
        return path

    def path(self, name):
        return self.folder / name

    def left_over(self):
        """Names in the scratch folder."""
        return sorted(entry.name for entry in self.folder.iterdir())

    def run_tool(self, *arguments, expect=OK, stdin=b"", **others):
        done = subprocess.run([TOOL, *map(str, arguments)], input=stdin, stdout=others.pop("stdout", subprocess.PIPE),
                              stderr=subprocess.PIPE, cwd=self.folder, timeout=120, **others)
        self.assertEqual(done.returncode, expect, done.stderr.decode(errors="replace"))
        return done

    def report(self, *arguments, expect=OK):
        """Runs with --report into a file and returns its content."""
        path = self.path("report.json")
        self.run_tool(*arguments, "--report", path, expect=expect)
        return json.loads(path.read_text())
