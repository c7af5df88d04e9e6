"""strata chain: attributes and units of what the steps are made of."""
import unittest
from fractions import Fraction

from chain_case import ChainTest, box
from tool import cube


def painted(material, side, at=0):
    """A cube as OBJ, all of one material."""
    lines = cube(at, at, at, side=side).split("\n")
    counts = [int(n) for n in lines[1].split()]
    vertices, faces = lines[2:2 + counts[0]], lines[2 + counts[0]:2 + counts[0] + counts[1]]
    text = [f"v {v}" for v in vertices] + [f"usemtl {material}"]
    text += ["f " + " ".join(str(int(i) + 1) for i in f.split()[1:]) for f in faces]
    return "\n".join(text) + "\n"


class Attributes(ChainTest):
    def setUp(self):
        super().setUp()
        self.file("wood.obj", painted("wood", 4))
        self.file("brass.obj", painted("brass", 1))
        self.steps = [box("difference", (2, 2, 2), (3, 3, 3)), {**box("union", (1, 1, 2), (1, 1, 3)), "file": "brass.obj"}]

    def materials(self, path):
        """Names of materials in an OBJ file, and how many triangles have them."""
        count, now = {}, None
        for line in self.path(path).read_text().splitlines():
            if line.startswith("usemtl"):
                now = line[7:] or None
            if line.startswith("f "):
                count[now] = count.get(now, 0) + 1
        return count

    def run_chain(self, *arguments):
        return self.run_tool("chain", self.document("steps.json", {"file": "wood.obj"}, self.steps), "-o", "out.obj", *arguments)

    def test_faces_have_what_they_are_made_of(self):
        self.run_chain()
        self.assertEqual(set(self.materials("out.obj")), {"wood", "brass", None})
        self.run_chain("--cut-material", "steel")
        self.assertEqual(set(self.materials("out.obj")), {"wood", "brass", "steel"})
        self.run_chain("--attributes", "none")
        self.assertEqual(set(self.materials("out.obj")), {None})

    def test_a_checkpoint_keeps_none_and_says_so(self):
        done = self.run_chain("--checkpoint", "save", "--checkpoint-every", "1")
        self.assertEqual(done.stderr.decode().count("a checkpoint keeps no attributes"), 1)
        self.assertEqual(set(self.materials("out.obj")), {"wood", "brass", None})
        self.steps.append({**box("union", (1, 1, 1), (0, 0, 4)), "file": "brass.obj"})
        self.run_chain("--resume", "save")
        self.assertEqual(set(self.materials("out.obj")), {"brass", None})


class Units(ChainTest):
    def setUp(self):
        super().setUp()
        self.run_tool("convert", self.path("block.off"), "-o", "block.3mf", "--unit", "inch")
        self.run_tool("convert", self.path("unit.off"), "-o", "unit.3mf", "--unit", "millimeter")

    def run_chain(self, steps, *arguments):
        document = self.document("steps.json", {"file": "block.3mf"}, steps)
        return self.run_tool("chain", document, "-o", "out.xoff", *arguments)

    def test_all_are_in_the_unit_of_the_first_file(self):
        steps = [{**box("union", (1, 1, 1), (4, 0, 0)), "file": "unit.3mf"},
                 {**box("union", (1, 1, 1), (4, 2, 0)), "file": "unit.3mf"}]
        done = self.run_chain(steps[:1], "--checkpoint", "save")
        self.assertIn("converted from millimeter to inch, exactly", done.stderr.decode())
        small = Fraction(5, 127) ** 3
        self.assertEqual(self.volume("out.xoff"), 64 + small)
        self.assertEqual(self.mark("save")["unit"], "inch")
        # The start is not read again, and yet tells the unit.
        self.run_chain(steps, "--resume", "save")
        self.assertEqual(self.volume("out.xoff"), 64 + 2 * small)

    def test_the_result_says_the_unit(self):
        document = self.document("steps.json", {"file": "block.3mf"}, [box("difference", (1, 1, 1), (0, 0, 0))])
        self.run_tool("chain", document, "-o", "out.3mf")
        self.assertEqual(self.report("info", "out.3mf")["operands"][0]["unit"], "inch")


if __name__ == "__main__":
    unittest.main()
