"""bsp: sizes of trees, cells as glTF; and the engine that merges trees."""
import json
import struct
import unittest

from tool import DATA, FILE, INVALID, USAGE, ToolTest, cube, open_cube


def read_glb(data):
    """The document and its positions, in triples."""
    magic, version, length = struct.unpack_from("<4s2I", data)
    assert (magic, version, length) == (b"glTF", 2, len(data))
    size, kind = struct.unpack_from("<I4s", data, 12)
    assert kind == b"JSON"
    document = json.loads(data[20:20 + size])
    binary = 28 + size
    assert data[binary - 4:binary] == b"BIN\0"
    accessor = document["accessors"][0]
    floats = struct.unpack_from(f"<{3 * accessor['count']}f", data, binary)
    return document, list(zip(*[iter(floats)] * 3))


def volume(positions):
    triangles = zip(*[iter(positions)] * 3)
    return sum(a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
               a[2] * (b[0] * c[1] - b[1] * c[0]) for a, b, c in triangles) / 6


class Bsp(ToolTest):
    def test_a_cube_is_six_nodes_and_one_cell(self):
        a = self.file("a.off", cube())
        result = self.report("bsp", a, "-o", "cells.glb")["result"]
        self.assertEqual({k: result[k] for k in ("nodes", "leaves", "inside", "depth", "planes", "splits", "facets")},
                         {"nodes": 6, "leaves": 7, "inside": 1, "depth": 6, "planes": 6, "splits": 0, "facets": 6})
        document, positions = read_glb(self.path("cells.glb").read_bytes())
        self.assertEqual(len(positions), 36)
        self.assertAlmostEqual(volume(positions), 1)
        position = document["accessors"][0]
        for bound, chosen in (("min", min), ("max", max)):
            self.assertEqual(position[bound], [chosen(p[i] for p in positions) for i in range(3)])
        views = document["bufferViews"]
        self.assertEqual(document["buffers"][0]["byteLength"], sum(v["byteLength"] for v in views))

    def test_cells_of_a_gear_fill_it(self):
        gear = DATA / "gear.off"
        report = self.report("bsp", gear, "-o", "cells.glb")
        _, positions = read_glb(self.path("cells.glb").read_bytes())
        words = gear.read_text().split()
        vertices = list(zip(*[iter(map(float, words[4:4 + 3 * int(words[1])]))] * 3))
        size = max(max(axis) - min(axis) for axis in zip(*vertices))
        self.assertAlmostEqual(volume(positions) * size**3 / report["operands"][0]["volume"], 1, places=4)

    def test_what_is_no_solid_is_refused_and_cells_are_glb(self):
        self.run_tool("bsp", self.file("open.off", open_cube()), expect=INVALID)
        self.run_tool("bsp", self.file("a.off", cube()), "-o", "cells.what", expect=USAGE)


    def test_boundaries_go_to_any_format_of_meshes(self):
        gear = DATA / "gear.off"
        self.run_tool("bsp", gear, "-o", "again.xoff")
        self.run_tool("compare", gear, "again.xoff")

    def test_trees_of_hipparchus(self):
        # The corner x, y, z >= 0 of the half-space x + y + z <= 1, each plane with a point and its normal.
        def node(point, normal, minus, plus):
            return f"internal {point} {normal} 1e-8\nminus {minus}plus {plus}"
        inside, outside = "leaf true\n", "leaf false\n"
        tree = node("0 0 0", "-1 0 0", node("0 0 0", "0 -1 0", node("0 0 0", "0 0 -1", node(
            "1 0 0", "1 1 1", inside, outside), outside), outside), outside)
        path = self.file("tree.bsp", "PolyhedronsSet\ntolerance 1e-8\nplus " + tree)
        result = self.report("bsp", path, "-o", "corner.off")["result"]
        self.assertEqual((result["nodes"], result["inside"], result["facets"]), (4, 1, 4))
        self.assertEqual(self.report("info", "corner.off")["operands"][0]["volume_exact"], "1/6")
        error = self.run_tool("bsp", self.file("half.bsp", "PolyhedronsSet\ntolerance 1e-8\nplus " + node("0 0 0", "0 0 1", inside, outside)),
                              expect=FILE).stderr
        self.assertIn(b"no end", error)
        self.run_tool("bsp", self.file("wrong.bsp", "PolyhedronsSet\ntolerance 1e-8\nplus internal 0\n"), expect=FILE)


class Intervals(ToolTest):
    def test_operations(self):
        self.file("a.csv", "lower,upper\n0,2\n1,3\n5,inf\n")
        self.file("b.csv", "lower,upper\n-inf,1/3\n2.5,6\n")
        wanted = {"union": "-inf,inf\n", "intersection": "0,1/3\n2.5,3\n5,6\n",
                  "difference": "1/3,2.5\n6,inf\n", "xor": "-inf,0\n1/3,2.5\n3,5\n6,inf\n"}
        for operation, rows in wanted.items():
            out = self.run_tool("intervals", operation, "a.csv", "b.csv", "-o", "-").stdout.decode()
            self.assertEqual(out, "lower,upper\n" + rows, operation)
        report = self.report("intervals", "intersection", "a.csv", "b.csv", "-o", "out.csv")
        self.assertEqual(report["result"], {"intervals": 3, "length_exact": "11/6"})
        self.assertIsNone(self.report("intervals", "union", "a.csv", "-o", "out.csv")["result"]["length_exact"])

    def test_what_is_no_table_is_refused_with_its_line(self):
        for text, line in (("", ":"), ("0,1\n", ":1:"), ("lower,upper\n0,1\n1\n", ":3:"), ("lower,upper\n0,x\n", ":2:"),
                           ("lower,upper\ninf,inf\n", ":2:")):
            error = self.run_tool("intervals", "union", self.file("a.csv", text), "-o", "-", expect=FILE).stderr.decode()
            self.assertIn("a.csv" + line, error)


class BspEngine(ToolTest):
    def test_both_engines_have_the_same_solids(self):
        spot, gear = DATA / "spot.obj", DATA / "gear.off"
        for verb in ("difference", "intersection"):
            with self.subTest(verb=verb):
                self.run_tool(verb, spot, gear, "-o", "usual.xoff")
                report = self.report(verb, spot, gear, "--engine", "bsp", "-o", "merged.xoff")
                self.run_tool("compare", "usual.xoff", "merged.xoff")
                self.assertGreater(report["counts"]["nodes"], 1000)

    def test_usage(self):
        a = self.file("a.off", cube())
        self.run_tool("union", a, a, "--engine", "nef", "-o", "out.off", expect=USAGE)
        self.run_tool("union", a, self.file("open.off", open_cube()), "--engine", "bsp", "-o", "out.off",
                      expect=INVALID)


if __name__ == "__main__":
    unittest.main()
