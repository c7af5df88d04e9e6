"""layers: decompositions as coloured files and as reports."""
import json
import struct
import unittest

from tool import DATA, FILE, INVALID, USAGE, ToolTest, cube, open_cube

RESULT = {"origin", "solids", "faces", "layers", "faces_per_layer", "cuts_at_crossings", "cuts_of_cycles", "flat_faces",
          "dominations", "pairs_tested", "bytes"}


def read_layers(data):
    """Vertices and (corners, colour, layer, solid) per face of what layers writes."""
    header, body = data.split(b"end_header\n", 1)
    vertices = int(header.split(b"element vertex ")[1].split()[0])
    faces = int(header.split(b"element face ")[1].split()[0])
    assert len(body) == 24 * vertices + 24 * faces
    points = [struct.unpack_from("<3d", body, 24 * i) for i in range(vertices)]
    rows = [struct.unpack_from("<B3i3B2i", body, 24 * (vertices + i)) for i in range(faces)]
    assert all(row[0] == 3 for row in rows)
    return points, [(row[1:4], row[4:7], row[7], row[8]) for row in rows]


class Layers(ToolTest):
    def layers(self, *arguments):
        """The result in the report, and what is in the file."""
        result = self.report("layers", *arguments, "-o", "out.ply")["result"]
        return result, *read_layers(self.path("out.ply").read_bytes())

    def test_a_cube_has_one_layer_from_inside_and_two_from_outside(self):
        a = self.file("a.off", cube())
        for origin, layers, flat in (("auto", [12], 0), ("0.5,0.5,0.25", [12], 0), ("3,4,5", [6, 6], 0),
                                     ("direction:1,2,3", [6, 6], 0), ("direction:0,0,1", [2, 2], 8), ("0,0,0", [6], 6)):
            with self.subTest(origin=origin):
                result, points, faces = self.layers(a, "--origin", origin)
                self.assertEqual(result["faces_per_layer"], layers)
                self.assertEqual((result["layers"], result["flat_faces"]), (len(layers), flat))
                self.assertEqual((len(points), len(faces)), (8, 12))
                for number in range(len(layers) + 1):
                    expected = layers[number - 1] if number > 0 else flat
                    self.assertEqual(sum(layer == number for _, _, layer, _ in faces), expected)

    def test_the_first_layer_is_the_farthest(self):
        """Catches layers that are numbered front to back."""
        a = self.file("a.off", cube())
        _, points, faces = self.layers(a, "--origin", "0.25,0.5,9")
        for corners, _, layer, _ in faces:
            heights = {points[v][2] for v in corners}
            if heights == {0}:
                self.assertEqual(layer, 1)
            if heights == {1}:
                self.assertEqual(layer, 2)

    def test_pictures_have_the_colours_of_layers(self):
        a = self.file("a.off", cube())
        self.run_tool("layers", a, "--origin", "3,4,5", "-o", "out.glb")
        data = self.path("out.glb").read_bytes()
        length = struct.unpack_from("<I", data, 12)[0]
        document = json.loads(data[20:20 + length])
        primitive = document["meshes"][0]["primitives"][0]
        views, accessors = document["bufferViews"], document["accessors"]
        colors = accessors[primitive["attributes"]["COLOR_0"]]
        view = views[colors["bufferView"]]
        start = 28 + length + view.get("byteOffset", 0) + colors.get("byteOffset", 0)
        step = view.get("byteStride", {5121: 4, 5126: 16}[colors["componentType"]])
        self.assertEqual(accessors[primitive["attributes"]["POSITION"]]["count"], 36)
        self.assertEqual(len({data[start + step * i:start + step * i + 3] for i in range(colors["count"])}), 2)
        self.run_tool("layers", a, "-o", "out.stl", expect=USAGE)

    def test_colours_tell_layers_apart(self):
        a, b = self.file("a.off", cube()), self.file("b.off", cube(5))
        _, _, faces = self.layers(a, b, "--origin", "-3,0.5,0.25")
        colours = {}
        for _, colour, layer, _ in faces:
            colours.setdefault(layer, set()).add(colour)
        self.assertTrue(all(len(of_layer) == 1 for of_layer in colours.values()))
        self.assertEqual(len(set.union(*colours.values())), len(colours))
        self.assertEqual([sum(solid == s for _, _, _, solid in faces) for s in (0, 1)], [12, 12])

    def test_faces_that_cross_are_cut_and_stay_what_they_are_together(self):
        """Catches replaced faces that are written, parts that are not, corners that are lost in rounding."""
        a, b = self.file("a.off", cube()), self.file("b.off", cube(0.5, 0.25, 0.125))
        result, points, faces = self.layers(a, b, "--origin", "3,4,5")
        self.assertGreater(result["cuts_at_crossings"], 0)
        self.assertGreater(len(faces), 24)
        self.assertEqual(sum(result["faces_per_layer"]) + result["flat_faces"], len(faces))
        for solid in (0, 1):
            volume = 0
            for corners, _, _, s in faces:
                if s == solid:
                    (a, b, c), (d, e, f), (g, h, i) = (points[v] for v in corners)
                    volume += a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
            self.assertAlmostEqual(volume / 6, 1, places=12)

    def test_the_report_says_everything(self):
        report = self.report("layers", DATA / "torus.off", DATA / "sphere.off", "--origin", "1,2,3")
        self.assertEqual(report["operation"], "layers")
        self.assertLessEqual(RESULT, set(report["result"]))
        self.assertEqual(report["result"]["origin"], {"kind": "point", "at": [1, 2, 3]})
        self.assertEqual(len(report["result"]["faces_per_layer"]), report["result"]["layers"])
        self.assertLessEqual({"read", "prepare", "origin", "build", "write"}, set(report["seconds"]))
        self.assertEqual(len(report["operands"]), 2)

    def test_the_result_does_not_depend_on_threads(self):
        answers = {self.run_tool("layers", DATA / "torus.off", DATA / "gear.off", "-o", "-", "-j", threads).stdout
                   for threads in (1, 2, 8)}
        self.assertEqual(len(answers), 1)

    def test_what_goes_where(self):
        a = self.file("a.off", cube())
        self.assertIn("faces_per_layer   [12]", self.run_tool("layers", a).stdout.decode())
        self.assertEqual(self.run_tool("layers", a, "-q").stdout, b"")
        done = self.run_tool("layers", a, "-o", "-")
        self.assertTrue(done.stdout.startswith(b"ply\n"))
        self.assertIn("layers ", done.stderr.decode())
        self.assertEqual(json.loads(self.run_tool("layers", a, "--report", "-").stdout)["operation"], "layers")
        self.run_tool("layers", a, "-o", "out.ply")
        self.run_tool("compare", a, "out.ply")

    def test_misuse_and_refusal(self):
        a, bad = self.file("a.off", cube()), self.file("bad.off", open_cube())
        for arguments in ((), (a, "-o", "out.stl"), (a, "-o", "-", "--report", "-"), (a, "--origin", "somewhere"),
                          (a, "--origin", "direction:0,0"), (a, "--origin", "nan,0,0")):
            with self.subTest(arguments=arguments):
                self.run_tool("layers", *arguments, expect=USAGE)
        done = self.run_tool("layers", a, bad, "-o", "out.ply", expect=INVALID)
        self.assertIn("bad.off: error: open edge", done.stderr.decode())
        self.run_tool("layers", a, "missing.off", expect=FILE)
        self.run_tool("layers", a, "-o", "no/folder/out.ply", expect=FILE)
        self.assertEqual(self.left_over(), ["a.off", "bad.off"])


if __name__ == "__main__":
    unittest.main()
