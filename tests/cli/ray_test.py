"""ray: where rays meet solids, how tables come in and go out, and what is wrong with them."""
import json
import random
import unittest
from fractions import Fraction

from tool import FILE, INVALID, USAGE, ToolTest, cube, open_cube

HEADER = "ray,hit,x,y,z,t,solid,face,passage\n"


def table(rays):
    return "x,y,z,dx,dy,dz\n" + "".join(",".join(map(repr, map(float, ray))) + "\n" for ray in rays)


class Ray(ToolTest):
    def ray(self, *meshes, rays, options=(), header=HEADER):
        """The rows of the answer to a table, as lists of fields."""
        self.file("rays.csv", rays)
        out = self.run_tool("ray", *meshes, "--rays", "rays.csv", "-o", "-", *options).stdout.decode()
        self.assertTrue(out.startswith(header))
        return [line.split(",") for line in out.splitlines()[1:]]

    def test_rays_and_a_cube(self):
        """Catches rays that miss edges and corners, wrong passages, hits behind the beginning."""
        a = self.file("a.off", cube())
        rays = table([(-1, 0.25, 0.5, 1, 0, 0), (0.5, 0.5, 0.5, 0, 0, 2), (0.5, 0.5, 1.5, 0, 0, 1),
                      (-1, -1, -1, 1, 1, 1), (-1, 1, 0, 1, -1, 0), (-1, 0, 0.5, 1, 0, 0)])
        rows = self.ray(a, rays=rays)
        self.assertEqual(rows[0], ["0", "0", "0", "0.25", "0.5", "1", "0", "10", "entering"])
        self.assertEqual(rows[1], ["1", "0", "0.5", "0.5", "1", "0.25", "0", "2", "leaving"])
        self.assertEqual(rows[2], ["2"] + 8 * [""])
        self.assertEqual(rows[3], ["3", "0", "0", "0", "0", "1", "0", "0", "entering"])
        self.assertEqual(rows[4][2:6] + rows[4][8:], ["0", "0", "0", "1", "touching"])
        self.assertEqual(rows[5][2:6] + rows[5][8:], ["0", "0", "0.5", "1", "along"])

    def test_all_hits_of_two_solids_in_order(self):
        a, b = self.file("a.off", cube()), self.file("b.off", cube(1))
        rows = self.ray(a, b, rays=table([(-1, 0.25, 0.5, 1, 0, 0), (5, 5, 5, 1, 0, 0)]), options=("--all",))
        self.assertEqual([(r[0], r[1], r[5], r[6], r[8]) for r in rows],
                         [("0", "0", "1", "0", "entering"), ("0", "1", "2", "0", "leaving"),
                          ("0", "2", "2", "1", "entering"), ("0", "3", "3", "1", "leaving"), ("1", "", "", "", "")])

    def test_exact_columns_are_rationals(self):
        a = self.file("a.off", cube())
        rows = self.ray(a, rays=table([(-1, 0.5, 0.5, 3, 0.25, 0)]), options=("--exact",),
                        header="ray,hit,x,y,z,t,solid,face,passage,exact_x,exact_y,exact_z,exact_t\n")
        exact = [Fraction(x) for x in rows[0][9:]]
        self.assertEqual(exact, [0, Fraction(7, 12), Fraction(1, 2), Fraction(1, 3)])
        self.assertEqual([float(x) for x in exact], [float(x) for x in rows[0][2:6]])

    def test_answers_do_not_depend_on_threads_or_blocks(self):
        """Catches rays numbered by block: the table is longer than one."""
        a = self.file("a.off", cube())
        numbers = random.Random(1)
        rays = [[numbers.uniform(-2, 2) for _ in range(6)] for _ in range(20000)]
        text = table(rays).replace("\n", "\n\n")
        one, two = (self.ray(a, rays=text, options=("-j", j, "--all")) for j in ("1", "2"))
        self.assertEqual(one, two)
        self.assertEqual([int(r[0]) for r in one if r[1] in ("", "0")], list(range(20000)))

    def test_bad_tables_are_refused_with_the_line(self):
        a = self.file("a.off", cube())
        for text, reason in (("x,y,z\n1,2,3\n", "dx"), ("", "header"), (table([(0, 0, 0, 1, 0, 0)]) + "1,2,3,4,5\n", "3"),
                             (table([(0, 0, 0, 1, 0, 0)]) + "\n1,2,3,0,0,0\n", "4"),
                             (table([]) + "1,2,3,4,five,6\n", "five"), (table([]) + "1,2,3,4,inf,6\n", "inf")):
            with self.subTest(text=text):
                self.file("rays.csv", text)
                done = self.run_tool("ray", a, "--rays", "rays.csv", "-o", "out.csv", expect=FILE)
                self.assertIn(reason, done.stderr.decode())
                self.assertIn("rays.csv", done.stderr.decode())
                self.assertNotIn("out.csv", self.left_over())

    def test_misuse_and_meshes_that_are_no_solids(self):
        a, bad, rays = self.file("a.off", cube()), self.file("bad.off", open_cube()), self.file("r.csv", table([]))
        self.run_tool("ray", a, "-o", "out.csv", expect=USAGE)
        self.run_tool("ray", a, "--rays", rays, expect=USAGE)
        self.run_tool("ray", a, "--rays", rays, "-o", "out.csv", "--first", "--all", expect=USAGE)
        self.run_tool("ray", "-", "--input-format", "off", "--rays", "-", "-o", "out.csv", expect=USAGE)
        self.run_tool("ray", a, bad, "--rays", rays, "-o", "out.csv", expect=INVALID)
        self.run_tool("ray", a, "--rays", "nothing.csv", "-o", "out.csv", expect=FILE)

    def test_streams_and_report(self):
        a = self.file("a.off", cube())
        rays = table([(-1, 0.25, 0.5, 1, 0, 0), (9, 9, 9, 1, 0, 0)]).encode()
        out = self.run_tool("ray", a, "--rays", "-", "-o", "-", "--report", "report.json", stdin=rays).stdout
        self.assertEqual(len(out.splitlines()), 3)
        report = json.loads(self.path("report.json").read_text())
        self.assertEqual(report["rays"], {"count": 2, "meeting": 1, "hits": 1})


if __name__ == "__main__":
    unittest.main()
