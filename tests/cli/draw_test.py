"""strata draw: pictures of what is seen."""
import re
import shutil
import unittest
import xml.etree.ElementTree as xml

from tool import DATA, FILE, OK, USAGE, ToolTest

CUBE = DATA / "cube.off"


def paths(svg):
    """The lines of a picture: lists of points, one per run."""
    root = xml.fromstring(svg)
    runs = []
    for path in root.iter("{http://www.w3.org/2000/svg}path"):
        for run_text in re.findall(r"M[^MZ]*Z?", path.get("d")):
            numbers = [float(x) for x in re.findall(r"-?[\d.]+(?:e-?\d+)?", run_text)]
            runs.append(list(zip(numbers[::2], numbers[1::2])))
    return runs


class Draw(ToolTest):
    def draw(self, *arguments):
        return self.run_tool("draw", *arguments, "-o", "-", expect=OK).stdout.decode()

    def test_a_cube_along_an_axis_is_a_square(self):
        runs = paths(self.draw(CUBE, "--direction", "0,0,-1"))
        points = {p for r in runs for p in r}
        self.assertEqual(len(points), 4)

    def test_a_cube_from_a_corner_shows_nine_edges(self):
        runs = paths(self.draw(CUBE, "--direction=-1,-1,-1"))
        self.assertEqual(len({p for r in runs for p in r}), 7)
        self.assertEqual(sum(len(r) - 1 for r in runs), 9)

    def test_a_perspective_looks_at_the_middle(self):
        runs = paths(self.draw(CUBE, "--from", "5,6,7"))
        self.assertEqual(sum(len(r) - 1 for r in runs), 9)

    def test_shaded_faces_are_painted_back_to_front(self):
        text = self.draw(CUBE, "--direction=-1,-2,-3", "--style", "fill")
        self.assertEqual(len(paths(text)), 6)
        self.assertNotIn('fill="none"', text)

    def test_faces_have_the_colours_of_their_materials_and_vertices(self):
        def fills(*arguments):
            return set(re.findall(r'fill="(#[0-9a-f]{6})" stroke=', self.draw(*arguments, "--style", "fill")))

        lines = CUBE.read_text().split("\n")
        vertices, faces = lines[2:10], lines[10:22]
        self.file("red.mtl", "newmtl red\nKd 1 0 0\n")
        corners = [[str(int(n) + 1) for n in face.split()[1:]] for face in faces]
        self.file("red.obj", "\n".join(["mtllib red.mtl", *(f"v {v}" for v in vertices), "usemtl red",
                                         *("f " + " ".join(c) for c in corners)]) + "\n")
        self.file("green.obj", "\n".join([*(f"v {v} 0 1 0" for v in vertices), *("f " + " ".join(c) for c in corners)]) + "\n")
        view = ["--direction=-1,-2,-3"]
        grey = fills(CUBE, *view)
        self.assertEqual(len(grey), 3)
        for name, pattern in (("red", "#..0000"), ("green", "#00..00")):
            found = fills(f"{name}.obj", *view)
            self.assertEqual(len(found), 3)
            self.assertTrue(all(re.fullmatch(pattern, fill) for fill in found), found)
            self.assertEqual(fills(f"{name}.obj", *view, "--attributes", "none"), grey)
        # Solids that cross are drawn as their union, which has the colours of both.
        both = fills("red.obj", DATA / "cube_beside.off", *view, "--input", "overlapping")
        self.assertTrue({fill[3:] for fill in both} > {"0000"}, both)

    def test_the_same_picture_for_any_number_of_threads(self):
        pictures = {self.draw(DATA / "gear.off", "--direction=-2,3,-2", "-j", j) for j in ("1", "2", "8")}
        self.assertEqual(len(pictures), 1)

    def test_a_point_of_view_is_needed_once(self):
        for arguments in ([], ["--from", "1,2,3", "--direction", "1,2,3"], ["--direction", "0,0,0"], ["--from", "1,2"]):
            done = self.run_tool("draw", CUBE, *arguments, "-o", "-", expect=USAGE)
            self.assertEqual(done.stdout, b"")

    def test_a_png_by_rsvg_convert_or_a_clear_error(self):
        has_converter = shutil.which("rsvg-convert") is not None
        done = self.run_tool("draw", CUBE, "--from", "5,6,7", "-o", "cube.png", expect=OK if has_converter else FILE)
        if has_converter:
            self.assertEqual(self.path("cube.png").read_bytes()[:4], b"\x89PNG")
        else:
            self.assertIn(b"rsvg-convert", done.stderr)
            self.assertFalse(self.path("cube.png").exists())


if __name__ == "__main__":
    unittest.main()
