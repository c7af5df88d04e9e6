"""strata view: pages that show meshes."""
import base64
import json
import re
import struct
import unittest

from tool import DATA, INVALID, OK, USAGE, ToolTest

CUBE = DATA / "cube.off"


class View(ToolTest):
    def page(self, *arguments):
        text = self.run_tool("view", *arguments, "-o", "-", expect=OK).stdout.decode()
        return text, json.loads(re.search(r'<script type="application/json" id="data">(.*?)</script>', text, re.S).group(1))

    def test_a_cube_has_its_twelve_edges_and_exact_facts(self):
        text, data = self.page(CUBE)
        [part] = data["parts"]
        self.assertEqual(part["ends"], [16, 12, 12])  # the corners again for edges
        self.assertTrue(part["shown"])
        self.assertEqual(part["name"], CUBE.name)
        self.assertIn(["triangles", "12"], part["facts"])
        points = struct.unpack(f"<{3 * 16}f", base64.b64decode(data["positions"]))
        self.assertTrue(all(abs(abs(x) - 3 ** -0.5) < 1e-6 for x in points))
        self.assertEqual(len(base64.b64decode(data["triangles"])), 4 * 3 * 12)
        self.assertEqual(max(struct.unpack("<24I", base64.b64decode(data["edges"]))), 15)
        self.assertNotRegex(text, r"(src|href)=|https?://|@import|fetch\(")  # nothing is loaded

    def test_an_expression_is_shown_before_its_operands(self):
        other = self.path("other.off")
        self.run_tool("convert", CUBE, "-o", other, expect=OK)
        _, data = self.page(CUBE, f"b={other}", "--expression", "a - b | b")
        self.assertEqual([p["name"] for p in data["parts"]], ["a - b | b", f"a = {CUBE.name}", "b = other.off"])
        self.assertEqual([p["shown"] for p in data["parts"]], [True, False, False])
        _, nothing = self.page(CUBE, f"b={other}", "--expression", "a - b")
        self.assertEqual(nothing["parts"][0]["ends"], [0, 0, 0])
        self.assertIn(["volume", "0"], nothing["parts"][0]["facts"])

    def test_volumes_are_exact_where_they_are_short(self):
        corner = self.path("corner.off")
        with open(corner, "w") as file:
            file.write("OFF\n4 4 0\n0 0 0\n4 0 0\n0 4 0\n0 0 4\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n")
        _, data = self.page(corner)
        self.assertIn(["exactly", "32/3"], data["parts"][0]["facts"])

    def test_names_of_files_cannot_become_elements(self):
        evil = self.path("<script>alert(1)<!--.off")
        self.run_tool("convert", CUBE, "-o", evil, expect=OK)
        text, data = self.page(evil)
        self.assertNotIn("<script>alert", text)
        self.assertEqual(data["title"], "<script>alert(1)<!--.off")

    def test_misuse_and_meshes_that_are_no_solids_are_refused(self):
        self.run_tool("view", CUBE, "-o", self.path("x.html"), "--expression", "a - c", expect=USAGE)
        self.run_tool("view", CUBE, "-o", self.path("x.html"), "--expression", "a -", expect=USAGE)
        self.run_tool("view", f"n={CUBE}", f"n={CUBE}", "-o", self.path("x.html"), expect=USAGE)
        self.run_tool("view", CUBE, expect=USAGE)
        self.run_tool("view", CUBE, "-o", self.path("x.html"), "--expression", "~a", expect=USAGE)
        open_mesh = self.path("open.off")
        with open(open_mesh, "w") as file:
            file.write("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
        self.run_tool("view", open_mesh, "-o", self.path("x.html"), expect=INVALID)


if __name__ == "__main__":
    unittest.main()
