"""locate: where points are, how tables come in and go out, and what is wrong with them."""
import json
import os
import random
import struct
import subprocess
import unittest

from tool import DATA, FILE, INVALID, STOPPED, TOOL, USAGE, ToolTest, cube, open_cube

HEADER = "x,y,z,where,solid,face\n"


def table(points):
    return "x,y,z\n" + "".join(f"{x!r},{y!r},{z!r}\n" for x, y, z in points)


def ply_points(points, scalar="double"):
    code = {"double": "d", "float": "f"}[scalar]
    header = (f"ply\nformat binary_little_endian 1.0\nelement vertex {len(points)}\nproperty uchar kind\n" +
              "".join(f"property {scalar} {axis}\n" for axis in "zyx") + "end_header\n")
    return header.encode() + b"".join(struct.pack("<B3" + code, 7, z, y, x) for x, y, z in points)


def read_ply(data):
    """The rows (x, y, z, where, solid, face) of what locate writes."""
    header, body = data.split(b"end_header\n", 1)
    count = int(header.split(b"element vertex ")[1].split()[0])
    assert len(body) == 33 * count
    return [struct.unpack_from("<3dB2i", body, 33 * i) for i in range(count)]


class Locate(ToolTest):
    def locate(self, *meshes, points, options=()):
        """The rows of the answer to a table, as lists of fields."""
        self.file("points.csv", points)
        out = self.run_tool("locate", *meshes, "--points", "points.csv", "-o", "-", *options).stdout.decode()
        self.assertTrue(out.startswith(HEADER))
        return [line.split(",") for line in out.splitlines()[1:]]

    def test_points_of_a_cube(self):
        """Catches closed taken for open sides, corners that are missed, faces that are not the lowest."""
        a = self.file("a.off", cube())
        points = [(0.5, 0.5, 0.5), (2, 0, 0), (0.25, 0.5, 0), (0, 0, 0), (1, 1, 1), (0.5, 0.5, 1), (-0.0, 0.5, 0.25),
                  (1 + 2**-52, 0.5, 0.5), (1 - 2**-53, 0.5, 0.5)]
        rows = self.locate(a, points=table(points))
        self.assertEqual([row[3:] for row in rows],
                         [["in", "0", ""], ["out", "", ""], ["on", "0", "1"], ["on", "0", "0"], ["on", "0", "2"],
                          ["on", "0", "2"], ["on", "0", "10"], ["out", "", ""], ["in", "0", ""]])
        self.assertEqual([tuple(map(float, row[:3])) for row in rows], points)

    def test_both_engines_have_the_same_answers(self):
        a, b, gear = self.file("a.off", cube()), self.file("b.off", cube(0.5)), DATA / "gear.off"
        random.seed(7)
        steps = [k / 8 for k in range(-8, 17)]
        vertices = [tuple(map(float, line.split())) for line in gear.read_text().splitlines()[2:132]]
        points = table([tuple(random.choice(steps) for _ in range(3)) for _ in range(2000)] + vertices)
        usual = self.locate(a, b, gear, points=points, options=("--all",))
        self.assertEqual(self.locate(a, b, gear, points=points, options=("--all", "--engine", "bsp")), usual)
        self.assertGreater(sum(row[3] == "on" for row in usual), 200)

    def test_the_nearest_boundary(self):
        self.file("points.csv", table([(0.5, 0.5, 0.75), (0.5, 0.5, 3), (4, 1, 0.5), (1, 1, 1), (-3, -4, 0.5)]))
        a, b = self.file("a.off", cube()), self.file("b.off", cube(2, 0, 0, 2))
        rows = self.run_tool("locate", a, b, "--points", "points.csv", "-o", "-", "--nearest").stdout.decode().splitlines()
        self.assertEqual(rows[0], HEADER.strip() + ",distance,nearest_x,nearest_y,nearest_z")
        self.assertEqual([row.split(",", 6)[6] for row in rows[1:]],
                         ["-0.25,0.5,0.5,1", "1.8027756377319946,2,0.5,2", "0,4,1,0.5", "0,1,1,1", "5,0,0,0.5"])
        self.run_tool("locate", a, "--points", "points.csv", "-o", "out.ply", "--nearest", expect=USAGE)

    def test_the_lowest_solid_counts_unless_all_are_asked_for(self):
        a, b = self.file("a.off", cube()), self.file("b.off", cube(0.5))
        c = self.file("c.off", cube(0, 0, 0, 3))
        points = table([(0.75, 0.5, 0.5), (0.75, 0, 0.5), (2, 2, 2), (1, 0.25, 0.5), (9, 9, 9)])
        lowest = [row[3:] for row in self.locate(a, b, c, points=points)]
        self.assertEqual(lowest, [["in", "0", ""], ["on", "0", "4"], ["in", "2", ""], ["on", "0", "7"], ["out", "", ""]])
        every = [row[3:] for row in self.locate(a, b, c, points=points, options=("--all",))]
        self.assertEqual(every, [["in", "0;1;2", ";;"], ["on", "0;1;2", "4;5;4"], ["in", "2", ""],
                                 ["on", "0;1;2", "7;;"], ["out", "", ""]])

    def test_a_point_on_a_later_solid_is_on(self):
        a, b = self.file("a.off", cube(0, 0, 0, 3)), self.file("b.off", cube(1, 1, 1))
        self.assertEqual(self.locate(a, b, points=table([(1, 1.5, 1.25)]))[0][3:], ["on", "1", "10"])

    def test_faces_have_the_numbers_of_the_file(self):
        """Catches numbers of triangles where the file has quadrangles, and of what repair left over."""
        quads = self.file("quads.obj", "".join(f"v {x} {y} {z}\n" for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))) +
                          "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n")
        self.assertEqual(self.locate(quads, points=table([(0.5, 1, 0.25)]))[0][3:], ["on", "0", "4"])
        lines = cube().splitlines()
        lines[1] = "8 13 0"
        twice = self.file("twice.off", "\n".join(lines[:11] + [lines[10]] + lines[11:]) + "\n")
        self.assertEqual(self.locate(twice, points=table([(0.125, 0.5, 1)]), options=("--input", "repair"))[0][3:],
                         ["on", "0", "4"])

    def test_vertices_of_a_mesh_are_on_it(self):
        lines = (DATA / "bracket.off").read_text().splitlines()
        count = int(lines[1].split()[0])
        points = [tuple(map(float, line.split()[:3])) for line in lines[2:2 + count]]
        self.assertEqual({row[3] for row in self.locate(DATA / "bracket.off", points=table(points))}, {"on"})

    def test_coordinates_come_back_as_they_are(self):
        a = self.file("a.off", cube())
        values = [0.1, 1e-320, -1.7976931348623157e308, 5e-324, 1 / 3, 123456789012345.67, 1e22, -0.0, 2.0]
        rows = self.locate(a, points=table([(v, v, v) for v in values]))
        for value, row in zip(values, rows):
            self.assertEqual([struct.pack("<d", float(x)) for x in row[:3]], [struct.pack("<d", value)] * 3)
            self.assertLessEqual(len(row[0]), 24)

    def test_tables_may_have_other_columns_blank_lines_and_any_line_ends(self):
        a = self.file("a.off", cube())
        for text in ("z,name,y,x\n0.5,a,0.5,2\n0.25,b,0.5,0.75\n", "\ufeffx,y,z\r\n2,0.5,0.5\r\n\r\n0.75,0.5,0.25\r\n",
                     '\n "x" , y ,z\n +2 ,0.5,\t0.5\n  \n0.75,.5,25e-2', "x,y,z\n2,0.5,0.5\n\n\n0.75,0.5,0.25\n\n"):
            with self.subTest(text=text):
                self.assertEqual(self.locate(a, points=text),
                                 [["2", "0.5", "0.5", "out", "", ""], ["0.75", "0.5", "0.25", "in", "0", ""]])
        self.assertEqual(self.locate(a, points="x,y,z\n"), [])

    def test_what_is_wrong_with_a_table_is_told_with_its_line(self):
        a, out = self.file("a.off", cube()), self.file("out.csv", "yesterday's")
        for text, message in (("", "points.csv:1: expected a header with x,y,z"), ("1,2,3\n", "points.csv:1: expected a header"),
                              ("\n\nx,y\n1,2\n", "points.csv:3: expected a header with the column z"),
                              ("x,y,z,x\n", "points.csv:1: the column x is there 2 times"),
                              ("x,y,z\n1,2,3\n\n1,2\n", "points.csv:4: expected 3 fields, found 2"),
                              ("x,y,z\n1,2,3,4\n", "points.csv:2: expected 3 fields, found 4"),
                              ("x,y,z\n1,2,three\n", "points.csv:2: expected a number for z, found 'three'"),
                              ("x,y,z\n1,,3\n", "points.csv:2: expected a number for y, found ''"),
                              ("x,y,z\n1,2e,3\n", "points.csv:2: expected a number for y, found '2e'"),
                              ("x,y,z\r\n1,2,3\r\nnan,2,3\r\n", "points.csv:3: expected a finite number for x, found 'nan'"),
                              ("x,y,z\n1,-inf,3\n", "points.csv:2: expected a finite number for y"),
                              ("x,y,z\n1,1e999,3\n", "points.csv:2: expected a finite number for y")):
            with self.subTest(text=text):
                self.file("points.csv", text)
                done = self.run_tool("locate", a, "--points", "points.csv", "-o", out, expect=FILE)
                self.assertIn(message, done.stderr.decode())
        self.assertEqual(out.read_text(), "yesterday's")
        self.assertEqual(self.left_over(), ["a.off", "out.csv", "points.csv"])

    def test_the_first_error_is_told_for_any_number_of_threads(self):
        """Catches errors that are told as threads happen to meet them: the first one ends a block, the next starts one."""
        a = self.file("a.off", cube())
        rows = ["0.5,0.5,0.5"] * 200000
        rows[43600] = "first"
        rows[43800] = "second"
        self.file("points.csv", "x,y,z\n" + "\n".join(rows) + "\n")
        for threads in (1, 2, 8):
            done = self.run_tool("locate", a, "--points", "points.csv", "-o", "out.csv", "-j", threads, expect=FILE)
            self.assertIn("points.csv:43602: ", done.stderr.decode())

    def test_lines_are_counted_through_all_blocks(self):
        a = self.file("a.off", cube())
        self.file("points.csv", "x,y,z\n" + "0.5,0.5,0.5\n\n" * 100000 + "oops\n")
        done = self.run_tool("locate", a, "--points", "points.csv", "-o", "out.csv", expect=FILE)
        self.assertIn("points.csv:200002: ", done.stderr.decode())

    def test_the_answer_does_not_depend_on_threads(self):
        rng = random.Random(1)
        points = [[rng.uniform(-1.5, 1.5) for _ in range(3)] for _ in range(50000)]
        self.file("points.csv", table(points))
        for out in ("out.csv", "out.ply"):
            answers = set()
            for threads in (1, 2, 8):
                self.run_tool("locate", DATA / "sphere.off", DATA / "torus.off", "--points", "points.csv", "-o", out,
                              "-j", threads)
                answers.add(self.path(out).read_bytes())
            self.assertEqual(len(answers), 1)

    def test_ply_in_and_out(self):
        a, b = self.file("a.off", cube()), self.file("b.off", cube(1))
        points = [(0.5, 0.5, 0.5), (1.5, 0.5, 0.25), (1, 0.25, 0.5), (-1, 0, 0)]
        expected = [(*points[0], 2, 0, -1), (*points[1], 2, 1, -1), (*points[2], 1, 0, 7), (*points[3], 0, -1, -1)]
        self.file("points.csv", table(points))
        self.path("points.ply").write_bytes(ply_points(points))
        self.path("floats.ply").write_bytes(ply_points(points, "float"))
        self.file("text.ply", "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty int n\n"
                  "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n" +
                  "".join(f"{x} {y} 5 {z}\n\n" for x, y, z in points) + "3 0 1 2\n")
        for name in ("points.csv", "points.ply", "floats.ply", "text.ply"):
            with self.subTest(name=name):
                self.run_tool("locate", a, b, "--points", name, "-o", "out.ply")
                self.assertEqual(read_ply(self.path("out.ply").read_bytes()), expected)
        rows = self.run_tool("locate", a, b, "--points", "points.ply", "-o", "-").stdout.decode().splitlines()
        self.assertEqual(rows[3], "1,0.25,0.5,on,0,7")
        self.run_tool("locate", a, b, "--points", "out.ply", "-o", "again.ply")
        self.assertEqual(self.path("again.ply").read_bytes(), self.path("out.ply").read_bytes())

    def test_many_points_of_ply_come_in_blocks(self):
        a = self.file("a.off", cube())
        points = [(i / 30000, 0.5, 0.5) for i in range(40000)]
        self.path("points.ply").write_bytes(ply_points(points))
        self.run_tool("locate", a, "--points", "points.ply", "-o", "out.ply")
        rows = read_ply(self.path("out.ply").read_bytes())
        self.assertEqual([row[:3] for row in rows], points)
        self.assertEqual([row[3] for row in rows], [1] + [2] * 29999 + [1] + [0] * 9999)

    def test_what_is_wrong_with_ply_points_is_told(self):
        a = self.file("a.off", cube())
        good = ply_points([(0, 0, 0)] * 3)
        for data, message in ((good[:-1], "expected 3 vertices, found 2"), (b"ply\n", "points.ply"), (b"", "points.ply"),
                              (good.replace(b"double x", b"double w"), "expected the property x"),
                              (ply_points([(0, 0, 0), (float("nan"), 0, 0)]), "expected a finite x of vertex 1"),
                              (b"ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
                               b"property float z\nend_header\n1 2 3\n1 2 b\n", "points.ply:9: expected a number"),
                              (b"ply\nformat ascii 1.0\nelement face 2\nproperty float x\nend_header\n", "first element")):
            with self.subTest(message=message):
                self.path("points.ply").write_bytes(data)
                done = self.run_tool("locate", a, "--points", "points.ply", "-o", "out.csv", expect=FILE)
                self.assertIn(message, done.stderr.decode())
        self.assertEqual(self.left_over(), ["a.off", "points.ply"])

    def test_standard_streams(self):
        a = self.file("a.off", cube())
        done = self.run_tool("locate", a, "--points", "-", "-o", "-", stdin=b"x,y,z\n0.5,0.5,0.5\n")
        self.assertEqual(done.stdout.decode(), HEADER + "0.5,0.5,0.5,in,0,\n")
        self.assertEqual(done.stderr, b"")
        self.file("points.csv", "x,y,z\n0.5,0.5,0.5\n")
        done = self.run_tool("locate", "-", "--input-format", "off", "--points", "points.csv", "-o", "-",
                             stdin=cube(1).encode())
        self.assertEqual(done.stdout.decode(), HEADER + "0.5,0.5,0.5,out,,\n")

    def test_misuse(self):
        a = self.file("a.off", cube())
        self.file("points.csv", "x,y,z\n")
        good = ("--points", "points.csv", "-o", "out.csv")
        for arguments in ((a,), (a, "--points", "points.csv"), (a, "-o", "out.csv"), good,
                          (a, "--points", "points.csv", "-o", "out.ply", "--all"),
                          ("-", "--input-format", "off", "--points", "-", "-o", "out.csv"),
                          (a, "--points", "points.csv", "-o", "-", "--report", "-")):
            with self.subTest(arguments=arguments):
                self.run_tool("locate", *arguments, expect=USAGE)
        self.assertEqual(self.left_over(), ["a.off", "points.csv"])

    def test_refused_solids_and_missing_files(self):
        a, bad = self.file("a.off", cube()), self.file("bad.off", open_cube())
        self.file("points.csv", "x,y,z\n")
        done = self.run_tool("locate", a, bad, "--points", "points.csv", "-o", "out.csv", expect=INVALID)
        self.assertIn("bad.off: error: open edge", done.stderr.decode())
        self.run_tool("locate", a, "--points", "missing.csv", "-o", "out.csv", expect=FILE)
        self.run_tool("locate", a, "--points", "points.csv", "-o", "no/folder/out.csv", expect=FILE)
        self.assertEqual(self.left_over(), ["a.off", "bad.off", "points.csv"])

    def test_the_report_counts(self):
        a = self.file("a.off", cube())
        self.file("points.csv", table([(0.5, 0.5, 0.5), (0.25, 0.5, 0.5), (0, 0, 0), (7, 0, 0), (8, 0, 0), (9, 0, 0)]))
        report = self.report("locate", a, "--points", "points.csv", "-o", "out.csv")
        self.assertEqual(report["operation"], "locate")
        self.assertEqual(report["points"], {"count": 6, "in": 2, "on": 1, "out": 3})
        self.assertLessEqual({"read", "prepare", "build", "locate"}, set(report["seconds"]))
        self.assertEqual(report["operands"][0]["volume"], 1)
        done = self.run_tool("locate", a, "--points", "points.csv", "-o", "out.csv", "-q")
        self.assertEqual((done.stdout, done.stderr), (b"", b""))
        self.assertIn("%", self.run_tool("locate", a, "--points", "points.csv", "-o", "out.csv", "--progress").stderr.decode())

    def test_a_time_limit_ends_waiting_for_points_and_leaves_nothing(self):
        a = self.file("a.off", cube())
        process = subprocess.Popen([TOOL, "locate", a, "--points", "-", "-o", self.path("out.csv"), "--timeout", "0.5"],
                                   stdin=subprocess.PIPE, stderr=subprocess.PIPE)
        process.stdin.write(b"x,y,z\n0,0,0\n")
        process.stdin.flush()
        self.assertEqual(process.wait(timeout=10), STOPPED)
        self.assertIn(b"time limit", process.stderr.read())
        process.stdin.close()
        process.stderr.close()
        self.assertEqual(self.left_over(), ["a.off"])

    def test_memory_is_bounded(self):
        """Ten million points with STRATA_SLOW_TESTS set. Catches tables that are held whole."""
        million = 10 if os.environ.get("STRATA_SLOW_TESTS") else 1
        a, report = self.file("a.off", cube()), self.path("report.json")
        rows = "".join(f"0.{i},0.5,1.{i % 7}\n" for i in range(100000)).encode()
        few_freed_blocks = {**os.environ, "ASAN_OPTIONS": "quarantine_size_mb=1"}  # the address sanitizer keeps them for a while
        self.run_tool("locate", a, "--points", "-", "-o", "few.csv", "--report", report, stdin=b"x,y,z\n0,0,0\n")
        for_few = json.loads(report.read_text())["peak_bytes"]  # of the program itself
        for out in ("out.csv", "out.ply"):
            process = subprocess.Popen([TOOL, "locate", a, "--points", "-", "-o", self.path(out), "--report", report, "-q"],
                                       stdin=subprocess.PIPE, env=few_freed_blocks)
            process.stdin.write(b"x,y,z\n")
            for _ in range(10 * million):
                process.stdin.write(rows)
            process.stdin.close()
            self.assertEqual(process.wait(timeout=600), 0)
            facts = json.loads(report.read_text())
            self.assertEqual(facts["points"]["count"], million * 1000000)
            self.assertLess(facts["peak_bytes"], for_few + 60e6)


if __name__ == "__main__":
    unittest.main()
