"""Exactness across processes: chains of Booleans through .xoff files, and every verb on rational vertices."""
import random
import unittest
from fractions import Fraction

from tool import INVALID, NEGATIVE, ToolTest, cube, off

TETRAHEDRON = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)]


def xoff(vertices, faces):
    return "X" + off(vertices, faces)


def corner(x, y, z, side):
    """A tetrahedron on three axis-parallel edges."""
    return [(x, y, z), (x + side, y, z), (x, y + side, z), (x, y, z + side)]


class Exact(ToolTest):
    def setUp(self):
        super().setUp()
        self.a = self.file("a.off", off([(0, 0, 0), (7, 1, 0), (1, 8, 2), (2, 1, 9)], TETRAHEDRON))
        self.b = self.file("b.off", off([(1, 1, 1), (9, 2, 2), (0, 6, 3), (3, 3, 5)], TETRAHEDRON))
        self.c = self.file("c.off", off([(-1, 2, 1), (6, 3, 2), (2, 7, -1), (1, 2, 6)], TETRAHEDRON))

    def volume(self, path):
        return Fraction(self.report("info", path)["operands"][0]["volume_exact"])

    def test_a_chain_through_files_is_the_chain_in_one_process(self):
        self.run_tool("union", self.a, self.b, "-o", "ab.xoff")
        self.run_tool("union", "ab.xoff", self.c, "-o", "chain.xoff")
        self.run_tool("union", self.a, self.b, self.c, "-o", "one.xoff")
        self.assertIn("/", self.path("one.xoff").read_text())
        self.run_tool("compare", "chain.xoff", "one.xoff")
        self.assertEqual(self.volume("chain.xoff"), self.volume("one.xoff"))

        self.run_tool("difference", self.a, self.b, "-o", "a-b.xoff")
        self.run_tool("difference", "a-b.xoff", self.c, "-o", "chain.xoff")
        self.run_tool("difference", self.a, self.b, self.c, "-o", "one.xoff")
        self.run_tool("compare", "chain.xoff", "one.xoff")
        self.assertEqual(self.volume("chain.xoff"), self.volume("one.xoff"))

    def test_inclusion_and_exclusion_hold_for_files(self):
        self.run_tool("intersection", self.a, self.b, "-o", "i.xoff")
        self.run_tool("union", self.a, self.b, "-o", "u.xoff")
        self.run_tool("xor", "u.xoff", "i.xoff", "-o", "x.xoff")
        self.assertEqual(self.volume(self.a) + self.volume(self.b), self.volume("u.xoff") + self.volume("i.xoff"))
        self.assertEqual(self.volume("x.xoff"), self.volume("u.xoff") - self.volume("i.xoff"))
        self.run_tool("xor", "x.xoff", self.b, "-o", "back.xoff")
        self.run_tool("compare", "back.xoff", self.a)

    def vertices(self, path):
        lines = self.path(path).read_text().splitlines()
        count = int(lines[1].split()[0])
        return [tuple(map(Fraction, line.split())) for line in lines[2:2 + count]]

    def test_results_of_random_expressions_are_read_and_written_as_they_are(self):
        """Solids on a grid of thirds or of a much finer one; results are the same when read again, digit by digit."""
        rational = 0
        for seed in range(12):
            with self.subTest(seed=seed):
                chance = random.Random(seed)
                fine = 1 if seed % 2 else 10**40
                bindings = []
                for name in "abcd":
                    place = [Fraction(chance.randint(-2 * fine, 2 * fine), 3 * fine) for _ in range(3)]
                    side = Fraction(chance.randint(2 * fine, 6 * fine), 3 * fine)
                    text = xoff(corner(*place, side), TETRAHEDRON)
                    bindings.append(f"{name}={self.file(name + '.xoff', text)}")
                one, two, three = (chance.choice("|&-^") for _ in range(3))
                self.run_tool("eval", f"((a {one} b) {two} c) {three} d", *bindings, "-o", "first.xoff")
                self.run_tool("eval", "x", "x=first.xoff", "-o", "again.xoff")
                self.run_tool("eval", "x | x", "x=again.xoff", "-o", "third.xoff")
                self.run_tool("compare", "first.xoff", "third.xoff")
                self.assertEqual(self.vertices("first.xoff"), self.vertices("again.xoff"))
                self.assertEqual(self.path("first.xoff").read_text(), self.path("again.xoff").read_text())
                rational += any(x.denominator % 3 == 0 for v in self.vertices("first.xoff") for x in v)
                for number, (step, other) in enumerate(((one, "b"), (two, "c"), (three, "d"))):
                    verb = {"|": "union", "&": "intersection", "-": "difference", "^": "xor"}[step]
                    before = f"step{number - 1}.xoff" if number else "a.xoff"
                    self.run_tool(verb, before, f"{other}.xoff", "-o", f"step{number}.xoff")
                self.run_tool("compare", "first.xoff", "step2.xoff")
        self.assertGreater(rational, 6)

    def test_doubles_lose_what_xoff_keeps(self):
        self.run_tool("union", self.a, self.b, "-o", "u.xoff")
        self.run_tool("union", self.a, self.b, "-o", "u.off")
        self.run_tool("compare", "u.xoff", "u.off", expect=NEGATIVE)
        self.assertNotEqual(self.volume("u.xoff"), self.volume("u.off"))

    def test_reports_volumes_as_fractions(self):
        report = self.report("union", self.a, self.b, "-o", "u.xoff", "--certify")
        self.assertEqual(Fraction(report["result"]["volume_exact"]), self.volume("u.xoff"))
        self.assertIs(report["result"]["rounded_valid"], True)
        facts = self.report("info", "u.xoff")["operands"][0]
        self.assertGreater(facts["rational_vertices"], 0)

    def test_standard_streams_carry_xoff(self):
        text = self.run_tool("union", self.a, self.b, "-o", "-", "--format", "xoff").stdout
        self.assertTrue(text.startswith(b"XOFF\n"))
        self.run_tool("xor", "-", self.b, "-o", "x.xoff", "--input-format", "off", stdin=self.a.read_bytes())
        self.run_tool("check", "-", "--input-format", "xoff", stdin=text)

    def test_rational_solids_are_checked(self):
        third = "1/3"
        cube_lines = cube().splitlines()
        thirds = [line.replace("1", third) for line in cube_lines[2:10]]
        whole = "\n".join(["XOFF", cube_lines[1], *thirds, *cube_lines[10:]]) + "\n"
        self.assertIn("a solid", self.run_tool("check", self.file("whole.xoff", whole)).stdout.decode())
        opened = "\n".join(["XOFF", "8 11 0", *thirds, *cube_lines[10:-1]]) + "\n"
        bad = self.file("open.xoff", opened)
        self.assertIn("open edge", self.run_tool("check", bad, expect=NEGATIVE).stdout.decode())
        for kind in ("solid", "overlapping", "repair"):
            done = self.run_tool("union", self.a, bad, "-o", "out.xoff", "--input", kind, expect=INVALID)
            self.assertIn("open.xoff: error: open edge", done.stderr.decode())
        self.assertEqual(self.volume("whole.xoff"), Fraction(1, 27))

    def test_crossings_of_rational_solids_are_found(self):
        tiny = f"1/{10**40}"
        vertices = corner(0, 0, 0, 1) + [(p if p else f"-{tiny}", q, r) for p, q, r in corner(0, 0, 0, 1)]
        faces = TETRAHEDRON + [tuple(4 + v for v in f) for f in TETRAHEDRON]
        crossing = self.file("crossing.xoff", xoff(vertices, faces))
        self.assertIn("self-intersection", self.run_tool("check", crossing, expect=NEGATIVE).stdout.decode())
        report = self.report("union", crossing, crossing, "-o", "out.xoff", "--input", "overlapping")
        self.assertGreater(Fraction(report["result"]["volume_exact"]), Fraction(1, 6))

    def test_rays_meet_rational_places(self):
        third = self.file("third.xoff", xoff([("1/3", 0, 0), (1, 0, 0), ("1/3", 1, 0), ("1/3", 0, 1)], TETRAHEDRON))
        self.file("rays.csv", "x,y,z,dx,dy,dz\n-1,0.25,0.25,1,0,0\n")
        out = self.run_tool("ray", third, "--rays", "rays.csv", "-o", "-", "--exact").stdout.decode().splitlines()
        self.assertIn("1/3", out[1].split(","))
        self.assertIn("4/3", out[1].split(","))

    def test_points_are_located_about_rational_faces(self):
        third = self.file("third.xoff", xoff([("1/3", 0, 0), (1, 0, 0), ("1/3", 1, 0), ("1/3", 0, 1)], TETRAHEDRON))
        nearest = 1 / 3  # below a third: outside; on the surface when vertices are rounded
        self.file("points.csv", f"x,y,z\n{nearest!r},0.25,0.25\n0.33333333333333337,0.25,0.25\n")
        out = self.run_tool("locate", third, "--points", "points.csv", "-o", "-").stdout.decode().splitlines()
        self.assertEqual([row.split(",")[3] for row in out[1:]], ["out", "in"])

    def test_layers_and_pictures_take_rationals(self):
        self.run_tool("difference", self.a, self.b, "-o", "a-b.xoff")
        self.run_tool("layers", "a-b.xoff", "-o", "layers.ply")
        self.run_tool("draw", "a-b.xoff", "--direction", "1,2,-1", "-o", "picture.svg")
        # Two parts that a gap below the last bit separates do not cross, so nothing is cut.
        gap = f"{10**30 + 1}/{3 * 10**30}"
        left = [("1/3", 0, 0), ("1/3", 1, 0), ("-1", 0, 0), ("1/3", 0, 1)]
        right = [(gap, 0, 0), (1, 0, 0), (gap, 1, 0), (gap, 0, 1)]
        a, b = self.file("left.xoff", xoff(left, TETRAHEDRON)), self.file("right.xoff", xoff(right, TETRAHEDRON))
        result = self.report("layers", a, b, "--origin", "direction:1,0,0")["result"]
        self.assertEqual(result["cuts_at_crossings"], 0)
        self.run_tool("intersection", a, b, "-o", "common.xoff")
        self.assertEqual(self.report("info", "common.xoff")["operands"][0]["triangles"], 0)

    def test_faces_with_holes_are_solids(self):
        z = ["0", "1/3"]
        outline = ["0 0", "3 0", "3 3", "0 3", "1 1", "2 1", "2 2", "1 2"]
        lines = ["XOFF", "16 10 0", *(f"{p} {h}" for h in z for p in outline),
                 "4 3 2 1 0 + 4 4 5 6 7", "4 8 9 10 11 + 4 15 14 13 12",
                 "4 0 1 9 8", "4 1 2 10 9", "4 2 3 11 10", "4 3 0 8 11",
                 "4 5 4 12 13", "4 6 5 13 14", "4 7 6 14 15", "4 4 7 15 12"]
        frame = self.file("frame.xoff", "\n".join(lines) + "\n")
        self.run_tool("check", frame)
        self.assertEqual(self.volume(frame), Fraction(8, 3))


if __name__ == "__main__":
    unittest.main()
