"""contacts: pairs of parts as a table, as a report, as pictures; overlaps as files."""
import struct
import unittest
from fractions import Fraction

from bsp_test import read_glb
from tool import FILE, INVALID, USAGE, ToolTest, cube, off, open_cube, CUBE_FACES


def read_ply(data):
    """Vertices, (corners, colour, part, pair) per face, (ends, colour, pair) per edge."""
    header, body = data.split(b"end_header\n", 1)
    count = {name: int(header.split(f"element {name} ".encode())[1].split()[0]) for name in ("vertex", "face", "edge")}
    assert len(body) == 24 * count["vertex"] + 24 * count["face"] + 15 * count["edge"]
    points = [struct.unpack_from("<3d", body, 24 * i) for i in range(count["vertex"])]
    at = 24 * count["vertex"]
    faces = [struct.unpack_from("<B3i3B2i", body, at + 24 * i) for i in range(count["face"])]
    at += 24 * count["face"]
    edges = [struct.unpack_from("<2i3Bi", body, at + 15 * i) for i in range(count["edge"])]
    return (points, [(f[1:4], f[4:7], f[7], f[8]) for f in faces], [(e[0:2], e[2:5], e[5]) for e in edges])


def area(points, corners):
    a, b, c = (points[v] for v in corners)
    u, v = ([q[i] - a[i] for i in range(3)] for q in (b, c))
    n = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
    return sum(x * x for x in n) ** 0.5 / 2


class Contacts(ToolTest):
    def parts(self):
        return [self.file("a.off", cube()), self.file("b.off", cube(1, 0.5, 0)), self.file("c.off", cube(0.5, 0.5, 0.5)),
                self.file("d.off", cube(5, 5, 5)), self.file("e.off", cube(0, 0, -1))]

    def test_pairs_of_cubes(self):
        result = self.report("contacts", *self.parts())["result"]
        self.assertEqual([result[k] for k in ("parts", "apart", "contact", "interfering")], [5, 5, 3, 2])
        pairs = {(p["a"], p["b"]): p for p in result["pairs"]}
        self.assertEqual(sorted(pairs), [(0, 1), (0, 2), (0, 4), (1, 2), (1, 4)])
        touching = pairs[0, 1]
        self.assertEqual((touching["relation"], touching["area"], touching["length"]), ("contact", 0.5, 0))
        self.assertEqual(touching["facets"][0]["squared_area_exact"], "1/4")
        self.assertEqual(touching["facets"][0]["loops"], [[[1, 0.5, 0], [1, 1, 0], [1, 1, 1], [1, 0.5, 1]]])
        self.assertEqual((pairs[1, 4]["length"], pairs[1, 4]["edges"][0]["ends"]), (0.5, [[1, 0.5, 0], [1, 1, 0]]))
        self.assertEqual((pairs[0, 2]["relation"], Fraction(pairs[0, 2]["volume_exact"])), ("interfering", Fraction(1, 8)))

    def test_distances_of_all_pairs(self):
        result = self.report("contacts", *self.parts(), "--distance")["result"]
        self.assertEqual(len(result["pairs"]), 10)
        apart = next(p for p in result["pairs"] if (p["a"], p["b"]) == (0, 3))
        self.assertEqual(apart["squared_distance_exact"], "48")
        self.assertEqual(apart["witnesses"][0], {"at": [1, 1, 1], "on": "vertex", "vertices": [6]})
        self.assertEqual(apart["witnesses"][1], {"at": [5, 5, 5], "on": "vertex", "vertices": [0]})

    def test_distances_within_a_bound(self):
        parts = [self.file("a.off", cube()), self.file("b.off", cube(4, 5, 0)), self.file("c.off", cube(1, 0, 0))]
        listed = lambda *options: {(p["a"], p["b"]): p.get("distance") for p in
                                   self.report("contacts", *parts, *options)["result"]["pairs"]}
        self.assertEqual(listed("--within", "5"), {(0, 1): 5, (0, 2): None, (1, 2): 20 ** 0.5})
        self.assertEqual(listed("--within", "4.999999999999999"), {(0, 2): None, (1, 2): 20 ** 0.5})
        self.assertEqual(listed("--within", "0"), {(0, 2): None})
        self.assertEqual(listed("--within", "inf"), listed("--distance"))
        for wrong in ("-1", "nan", "near"):
            self.run_tool("contacts", *parts, "--within", wrong, expect=USAGE)

    def test_a_gap_of_an_ulp_is_a_gap(self):
        after = 1 + 2.0 ** -52
        far = [(after if x == "1" else 2, float(y), float(z)) for x, y, z in
               (line.split() for line in cube(1).splitlines()[2:10])]
        result = self.report("contacts", self.file("a.off", cube()), self.file("b.off", off(far, CUBE_FACES)),
                             "--distance")["result"]
        self.assertEqual((result["apart"], result["pairs"][0]["distance"]), (1, 2.0 ** -52))
        self.assertEqual(Fraction(result["pairs"][0]["squared_distance_exact"]), Fraction(1, 2 ** 104))

    def test_overlaps_are_solids(self):
        a, *_, = parts = self.parts()
        self.report("contacts", *parts, "--overlap", "overlaps")
        self.assertEqual(sorted(f.name for f in self.path("overlaps").iterdir()), ["overlap-0-2.xoff", "overlap-1-2.xoff"])
        self.run_tool("intersection", a, parts[2], "-o", "expected.xoff")
        self.run_tool("compare", "overlaps/overlap-0-2.xoff", "expected.xoff")
        self.run_tool("contacts", *parts, "--overlap", "overlaps", expect=USAGE)  # not empty

    def test_a_picture_has_the_parts_and_their_contacts(self):
        self.run_tool("contacts", *self.parts(), "-o", "out.ply")
        points, faces, edges = read_ply(self.path("out.ply").read_bytes())
        self.assertEqual(sum(part >= 0 for _, _, part, _ in faces), 5 * 12)
        contacts = [(corners, pair) for corners, _, part, pair in faces if part < 0]
        self.assertAlmostEqual(sum(area(points, corners) for corners, _ in contacts), 0.5 + 1)
        self.assertEqual(len(edges), 1)
        self.assertEqual({tuple(points[v]) for v in edges[0][0]}, {(1, 0.5, 0), (1, 1, 0)})
        self.run_tool("contacts", *self.parts(), "-o", "out.glb")
        document, positions = read_glb(self.path("out.glb").read_bytes())
        self.assertEqual(len(positions), 3 * (5 * 12 + 2 * len(contacts)))

    def test_the_table_goes_to_standard_output(self):
        lines = self.run_tool("contacts", *self.parts()).stdout.decode().splitlines()
        self.assertEqual(lines[0], "5 parts: 5 pairs apart, 3 in contact, 2 interfering")
        self.assertEqual(len(lines), 6)
        self.assertIn("facets 1, area 0.5; edges 0, length 0.0; vertices 0", lines[1])
        self.assertEqual(self.run_tool("contacts", *self.parts(), "-q").stdout, b"")

    def test_one_part_or_none_is_an_answer(self):
        empty = self.file("none.off", off([], []))
        result = self.report("contacts", self.file("a.off", cube()), empty, "--distance")["result"]
        self.assertEqual((result["apart"], result["pairs"]), (1, []))
        self.assertEqual(self.report("contacts", empty)["result"]["apart"], 0)

    def test_threads_do_not_matter(self):
        one = self.report("contacts", *self.parts(), "--distance", "-j", "1")["result"]
        self.assertEqual(one, self.report("contacts", *self.parts(), "--distance", "-j", "2")["result"])

    def test_parts_may_touch_themselves_in_faces(self):
        around = self.file("around.off", """OFF
8 8 0
0.0 0.0 8.0
16.0 0.0 8.0
0.0 16.0 8.0
2.0 2.0 -16.0
2.0 3.0 8.0
4.0 3.0 8.0
3.0 2.0 5.0
3.0 4.0 5.0
3 0 1 2
3 0 2 3
3 0 3 1
3 3 2 1
3 4 5 6
3 4 6 7
3 4 7 5
3 7 6 5
""")
        within = self.file("within.off", """OFF
4 4 0
2.0 3.0 8.0
4.0 3.0 8.0
3.0 2.0 5.0
3.0 4.0 5.0
3 0 2 1
3 0 3 2
3 0 1 3
3 3 1 2
""")  # fills a cavity that has an edge in a face
        result = self.report("contacts", around, within)["result"]
        self.assertEqual((result["contact"], result["interfering"]), (1, 0))
        self.assertEqual(result["pairs"], self.report("contacts", around, within, "--input", "overlapping")["result"]["pairs"])

        deeper = self.file("deeper.off", within.read_text().replace("5.0\n", f"{5 - 2.0 ** -40}\n"))
        pair, = self.report("contacts", around, deeper)["result"]["pairs"]
        self.assertEqual(pair, self.report("contacts", around, deeper, "--input", "overlapping")["result"]["pairs"][0])
        self.assertEqual(pair["relation"], "interfering")

    def test_parts_that_cross_themselves_are_resolved_when_asked(self):
        points = [tuple(map(float, line.split())) for at in (0, 0.5) for line in cube(at).splitlines()[2:10]]
        crossing = self.file("crossing.off", off(points, CUBE_FACES + [tuple(v + 8 for v in f) for f in CUBE_FACES]))
        pair, = self.report("contacts", crossing, self.file("b.off", cube(1.5)), "--input", "overlapping")["result"]["pairs"]
        self.assertEqual((pair["relation"], pair["area"]), ("contact", 1))

    def test_what_makes_no_sense_is_refused(self):
        a = self.file("a.off", cube())
        self.run_tool("contacts", a, self.file("open.off", open_cube()), expect=INVALID)
        self.run_tool("contacts", a, a, "-o", "out.stl", expect=USAGE)
        self.run_tool("contacts", a, a, "--format", "stl", expect=USAGE)
        self.run_tool("contacts", a, a, "--overlap", a, expect=USAGE)
        self.run_tool("contacts", a, a, "--overlap", "overlaps", "--format", "doc", expect=USAGE)
        self.run_tool("contacts", a, "missing.off", expect=FILE)
        self.run_tool("contacts", expect=USAGE)


if __name__ == "__main__":
    unittest.main()
