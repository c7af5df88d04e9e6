"""strata draw: pictures of what is seen."""
import base64
import re
import shutil
import struct
import unittest
import xml.etree.ElementTree as xml
import zlib

from tool import DATA, FILE, OK, USAGE, ToolTest, cube

CUBE = DATA / "cube.off"

# 16 x 16, red above and blue below.
JPEG = base64.b64decode(
    "/9j/4AAQSkZJRgABAQAAAQABAAD/2wBDABALDA4MChAODQ4SERATGCgaGBYWGDEjJR0oOjM9PDkzODdASFxOQERXRTc4UG1RV19iZ2hnPk1xeX"
    "BkeFxlZ2P/2wBDARESEhgVGC8aGi9jQjhCY2NjY2NjY2NjY2NjY2NjY2NjY2NjY2NjY2NjY2NjY2NjY2NjY2NjY2NjY2NjY2NjY2P/wAARCAAQ"
    "ABADAREAAhEBAxEB/8QAFQABAQAAAAAAAAAAAAAAAAAAAAX/xAAUEAEAAAAAAAAAAAAAAAAAAAAA/8QAFwEBAQEBAAAAAAAAAAAAAAAAAAcFBv"
    "/EABQRAQAAAAAAAAAAAAAAAAAAAAD/2gAMAwEAAhEDEQA/AIrLd4AjqgnID//Z")


def png(rows, size=None):
    """A PNG of rows of colours as #rrggbb; `size` is what it says of itself."""
    def chunk(kind, content):
        return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))

    width, height = size or (len(rows[0]), len(rows))
    pixels = b"".join(b"\0" + b"".join(bytes.fromhex(c[1:]) for c in row) for row in rows)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0))
            + chunk(b"IDAT", zlib.compress(pixels)) + chunk(b"IEND", b""))


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

    def textured(self, image, content):
        """A cube with an image on its top, as it is seen from above, on a material that is half red."""
        self.path(image).write_bytes(content)
        self.file("top.mtl", f"newmtl top\nKd 0.5 1 1\nmap_Kd {image}\n")
        lines = cube().splitlines()
        faces = [[int(n) + 1 for n in line.split()[1:]] for line in lines[10:]]
        text = ["mtllib top.mtl", *("v " + v for v in lines[2:10]), "vt 0 0", "vt 1 0", "vt 1 1", "vt 0 1"]
        for face in faces:
            if min(face) > 4:
                text += ["usemtl top", "f " + " ".join(f"{v}/{v - 4}" for v in face), "usemtl"]
            else:
                text.append("f " + " ".join(map(str, face)))
        return self.file("textured.obj", "\n".join(text) + "\n")

    def middles(self, mesh, *arguments):
        """The area-weighted middles of what is filled in each colour, in the page; and what was told."""
        done = self.run_tool("draw", mesh, "--direction", "0,0,-1", "--up", "0,1,0", "--style", "fill", *arguments, "-o", "-")
        sums = {}
        for path in xml.fromstring(done.stdout).iter("{http://www.w3.org/2000/svg}path"):
            for run in paths(f'<svg xmlns="http://www.w3.org/2000/svg">{xml.tostring(path).decode()}</svg>'):
                (ax, ay), (bx, by), (cx, cy) = run
                area = abs((bx - ax) * (cy - ay) - (by - ay) * (cx - ax)) / 2
                total = sums.setdefault(path.get("fill"), [0, 0, 0])
                for i, x in enumerate((area, area * (ax + bx + cx) / 3, area * (ay + by + cy) / 3)):
                    total[i] += x
        return {fill: (area, x / area, y / area) for fill, (area, x, y) in sums.items()}, done.stderr.decode()

    def test_textures_are_drawn_where_they_are(self):
        quarters = png([["#ff0000", "#00ff00"], ["#0000ff", "#ffffff"]])
        found, told = self.middles(self.textured("quarters.png", quarters), "--width", "500")
        if "built without" in told:
            self.skipTest("built without libpng")
        # Each quarter is a fourth of the page but for its rim, in the colour times that of the material.
        whole = sum(area for area, _, _ in found.values())
        large = {fill: at for fill, at in found.items() if at[0] > .2 * whole}
        self.assertEqual(len(large), 4)
        self.assertGreater(sum(area for area, _, _ in large.values()), .9 * whole)
        channels = {fill: [int(fill[i:i + 2], 16) for i in (1, 3, 5)] for fill in large}
        for (left, top), (red, green, blue) in {(True, True): (1, 0, 0), (False, True): (0, 1, 0), (True, False): (0, 0, 1),
                                                (False, False): (1, 1, 1)}.items():
            fill, = (f for f, (_, x, y) in large.items() if (x < 250) == left and (y < 250) == top)
            r, g, b = channels[fill]
            self.assertEqual((r > 0, g > 0, b > 0), (bool(red), bool(green), bool(blue)), fill)
        white = max(channels.values(), key=sum)
        self.assertAlmostEqual(white[0] / white[1], 0.735, delta=.02)  # half the light, as screens show it
        self.assertEqual(white[1], white[2])
        # One colour all over needs no more polygons than faces.
        found, _ = self.middles(self.textured("one.png", png([["#ff0000"] * 7] * 5)))
        self.assertEqual(len(found), 1)
        done = self.run_tool("draw", "textured.obj", "--direction", "0,0,-1", "--style", "fill", "-o", "-")
        self.assertEqual(len(paths(done.stdout)), 2)

    def test_jpeg_textures(self):
        found, told = self.middles(self.textured("halves.jpg", JPEG), "--width", "500")
        if "built without" in told:
            self.skipTest("built without libjpeg")
        (first, second) = sorted(found.items(), key=lambda item: -item[1][0])[:2]
        red, blue = (first, second) if first[0].endswith(("0000", "0a00")) else (second, first)
        self.assertLess(red[1][2], 250)
        self.assertGreater(blue[1][2], 250)
        self.assertGreater(int(blue[0][5:], 16), int(blue[0][1:3], 16) + 50)

    def test_images_that_cannot_be_decoded_are_told_once_and_leave_the_material(self):
        whole = png([["#ff0000"] * 9] * 9)
        for content, why in ((whole[:-30], "cannot be decoded"), (whole.replace(b"IDAT", b"IDAX"), "cannot be decoded"),
                             (b"GIF89a" + whole, "is neither PNG nor JPEG"), (b"", "is neither PNG nor JPEG"),
                             (png([["#ff0000"]], (1 << 20, 1 << 20)), ""), (JPEG[:40], "cannot be decoded"),
                             (JPEG[:3], "cannot be decoded")):
            with self.subTest(why=why, size=len(content)):
                found, told = self.middles(self.textured("bad.png", content))
                self.assertEqual(told.count("note: the image bad.png"), 1, told)
                self.assertTrue(why in told or "built without" in told, told)
                self.assertEqual(len(found), 1)
                fill, = found
                self.assertLess(int(fill[1:3], 16), int(fill[3:5], 16))
                self.assertEqual(self.middles("textured.obj", "-q")[1], "")

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
