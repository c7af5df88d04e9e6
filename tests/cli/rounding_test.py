"""Results in doubles, floats and on grids: --rounding, --grid and the verb round."""
import json
import math
import unittest

from tool import CUBE_FACES, DATA, FILE, INVALID, NOT_CERTIFIED, USAGE, ToolTest, cube, off


def thin_box(height):
    base = [(0, 0), (1, 0), (1, 1), (0, 1)]
    return off([(i, j, k) for k in (0, height) for i, j in base], CUBE_FACES)


def plate(k):
    """One of plates that are turned about the z axis, and tilted by a thousandth each: nearly in one plane."""
    tilt, points = k * 1e-3, []
    for z in (-0.003, 0.003):
        for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
            across, up = y * math.cos(tilt) - z * math.sin(tilt), y * math.sin(tilt) + z * math.cos(tilt)
            points.append((x * math.cos(k) - across * math.sin(k), x * math.sin(k) + across * math.cos(k), up))
    return off(points, [(0, 3, 2), (0, 2, 1), (4, 5, 6), (4, 6, 7), (0, 1, 5), (0, 5, 4), (1, 2, 6), (1, 6, 5), (2, 3, 7), (2, 7, 6),
                        (3, 0, 4), (3, 4, 7)])


def rough_sphere(rings, turn):
    """With radii from a fixed sequence, turned about the z axis by an angle."""
    points, faces, number, around = [(0, 0, 1), (0, 0, -1)], [], 12345, 2 * rings
    for i in range(1, rings):
        for j in range(around):
            number = (number * 1103515245 + 12345) % 2 ** 31
            radius, latitude, longitude = 1 + 5e-3 * (number / 2 ** 31 - 0.5), math.pi * i / rings, math.pi * j / rings
            x, y = radius * math.sin(latitude) * math.cos(longitude), radius * math.sin(latitude) * math.sin(longitude)
            points.append((x * math.cos(turn) - y * math.sin(turn), x * math.sin(turn) + y * math.cos(turn),
                           radius * math.cos(latitude)))
    for j in range(around):
        k = (j + 1) % around
        last = 2 + (rings - 2) * around
        faces += [(0, 2 + j, 2 + k), (1, last + k, last + j)]
        for ring in range(2, last, around):
            faces += [(ring + j, ring + around + j, ring + around + k), (ring + j, ring + around + k, ring + k)]
    return off(points, faces)


class Rounding(ToolTest):
    def test_files_of_every_format_hold_solids(self):
        for out in ("out.stl", "out.off", "out.ply", "out.obj"):
            with self.subTest(out=out):
                report = self.report("difference", DATA / "spot.obj", DATA / "gear.off", "-o", out, "--certify")
                rounding = report["result"]["rounding"]
                self.assertTrue(report["result"]["rounded_valid"])
                self.assertLess(rounding["largest_movement"], 4 * rounding["unit"])
                self.run_tool("check", out)

    def test_nearest_and_xoff_round_nothing(self):
        a, b = self.file("a.off", cube()), self.file("b.off", cube(0.5))
        for options in (("-o", "out.off", "--rounding", "nearest"), ("-o", "out.xoff")):
            self.assertIsNone(self.report("union", a, b, *options)["result"]["rounding"])

    def test_a_grid_of_decimals(self):
        self.run_tool("union", DATA / "gear.off", DATA / "torus.off", "-o", "out.off", "--grid", "0.001")
        numbers = [word for line in self.path("out.off").read_text().splitlines() for word in line.split()
                   if "." in word]
        self.assertTrue(all(len(word.split(".")[1]) <= 3 for word in numbers))
        self.run_tool("check", "out.off")
        for bad in ("0", "-1", "x", "1e-999", "1/0", "1/1152921504606846977"):
            said = self.run_tool("union", DATA / "gear.off", "-o", "o.off", "--grid", bad, expect=USAGE).stderr
            self.assertIn(b"--grid", said)

    def test_a_broken_promise_is_told_and_no_error_of_the_program(self):
        """Where the operand crosses itself, the exact boundary is open; rounding must not be the first to meet that."""
        points, faces = [], []
        for low, high in ((0, 4), (2, 6)):
            faces += [[v + len(points) for v in face] for face in CUBE_FACES]
            points += [(i, j, k) for k in (low, high) for i, j in ((low, low), (high, low), (high, high), (low, high))]
        tetrahedron = [(5.3, 5, 2.4), (5.3, 1.8, -0.8), (2.1, 5, -0.8), (2.1, 1.8, 2.4)]
        a = self.file("a.off", off(points, faces))
        b = self.file("b.off", off(tetrahedron, [(0, 1, 2), (0, 3, 1), (0, 2, 3), (1, 3, 2)]))
        said = self.run_tool("union", a, b, "-o", "o.off", "--input", "solid", "--grid", "1", expect=INVALID).stderr
        self.assertIn(b"a.off is not what was declared", said)
        self.assertIn(b"self-intersection", said)

    def test_a_broken_promise_that_a_stage_meets_is_told(self):
        """Blocks of two parts, of which one leans into the other."""
        sides = ((0, 2, 1), (1, 2, 3), (4, 5, 6), (5, 7, 6), (0, 1, 4), (1, 5, 4), (2, 6, 3), (3, 6, 7), (0, 4, 2), (2, 4, 6), (1, 3, 5), (3, 7, 5))

        def block(tilt):
            upright, leaning = ((0, 0), (1, 0), (0, 1), (1, 1)), ((1, 0), (2, tilt), (1 - tilt, 1), (2 - tilt, 1 + tilt))
            points = [(x, y, z) for part in (upright, leaning) for z in (0, 1) for x, y in part]
            return off(points, [[v + first for v in side] for first in (0, 8) for side in sides])
        a, b = self.file("a.off", block(1e-15)), self.file("b.off", block(1e-9))
        said = self.run_tool("intersection", a, b, "-o", "o.off", "--input", "solid", expect=INVALID).stderr
        self.assertIn(b"a.off is not what was declared", said)

    def test_round_to_floats_and_back(self):
        self.run_tool("round", DATA / "sphere.off", "--to", "float32", "-o", "a.off")
        self.run_tool("round", DATA / "sphere.off", "--to", "float64", "-o", "b.stl")
        again = self.report("round", "a.off", "--to", "float32", "-o", "c.off")["result"]["rounding"]
        self.assertEqual((again["rounds"], again["moved_vertices"]), (0, 0))
        self.assertEqual(self.path("a.off").read_bytes(), self.path("c.off").read_bytes())
        self.run_tool("compare", "a.off", "b.stl")

    def test_what_is_too_thin_vanishes_and_is_told(self):
        plate = self.file("plate.off", thin_box(1e-3))
        ran = self.run_tool("round", plate, "--to", "0.01", "-o", "none.off", "--report", "r.json")
        self.assertIn(b"rearranged", ran.stderr)
        self.assertIn(b"nothing is left of 12 faces, nor of 1 connected parts", ran.stderr)
        rounding = json.loads(self.path("r.json").read_text())["result"]["rounding"]
        self.assertEqual((rounding["triangles"], rounding["vanished_faces"]), (0, 12))
        self.assertEqual(rounding["vanished_components"], 1)
        self.assertEqual((rounding["exact"]["components"], rounding["rounded"]["components"]), (1, 0))

    def test_parts_that_meet_in_floats_touch(self):
        a, b = self.file("a.off", cube()), self.file("b.off", cube(1.0000000001, 1))
        self.run_tool("union", a, b, "-o", "out.stl", "--touching", "refuse", "--rounding", "nearest")
        said = self.run_tool("union", a, b, "-o", "n.stl", "--touching", "refuse", expect=NOT_CERTIFIED)
        self.assertIn(b"touches itself in 1 edges", said.stderr)
        self.assertFalse(self.path("n.stl").exists())

    def test_sheets_that_meet_by_rounding_are_separated(self):
        a, b = self.file("a.off", cube()), self.file("b.off", cube(1.0001, 1))
        for how, vertices in (("shared", 14), ("separate", 16)):
            self.run_tool("union", a, b, "-o", "out.off", "--touching", how, "--grid", "0.001")
            self.assertEqual(int(self.path("out.off").read_text().split()[1]), vertices)

    def test_plates_nearly_in_one_plane_keep_their_volume(self):
        files = [self.file(f"{k}.off", plate(k)) for k in range(6)]
        for options in (("--grid", "0.001"), ()):
            rounding = self.report("xor", *files, "-o", "out.ply", *options)["result"]["rounding"]
            self.assertLess(rounding["largest_movement"], 100 * rounding["unit"])
            self.assertLess(abs(self.volume("out.ply") / 0.0295427477 - 1), 0.1)
            self.run_tool("check", "out.ply")

    def test_bundles_of_needles_end_soon(self):
        """A step of a chain through floats; it took 76 rounds, and ended 1,037 units away, as long as flips in bundles went to and fro."""
        worst = DATA.parent / "tools/bench/worst"
        report = self.report("xor", worst / "chain_b.stl", worst / "chain_b_tool.off", "-o", "out.stl")
        rounding = report["result"]["rounding"]
        self.assertLess(rounding["rounds"], 60)
        self.assertLess(rounding["largest_movement"], 20 * rounding["unit"])
        self.run_tool("check", "out.stl")

    def test_slivers_of_which_most_collapse(self):
        """A solid without itself, turned by 1e-12: floats hold nearly nothing of the difference."""
        a, b = self.file("a.off", rough_sphere(16, 0)), self.file("b.off", rough_sphere(16, 1e-12))
        for threads in ("1", "2"):
            self.run_tool("difference", a, b, "-o", f"out{threads}.stl", "--threads", threads)
            self.run_tool("check", f"out{threads}.stl")
        self.assertEqual(self.path("out1.stl").read_bytes(), self.path("out2.stl").read_bytes())

    def volume(self, name):
        return self.report("info", name)["operands"][0]["volume"]

    def test_beyond_floats(self):
        huge = self.file("huge.off", thin_box(1e39))
        said = self.run_tool("round", huge, "--to", "float32", "-o", "out.off", expect=FILE).stderr
        self.assertIn(b"beyond the largest number", said)
        self.assertFalse(self.path("out.off").exists())
        self.run_tool("union", huge, "-o", "out.stl", expect=FILE)


if __name__ == "__main__":
    unittest.main()
