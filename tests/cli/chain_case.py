"""What the tests of `strata chain` share: documents, and boxes as steps."""
import json
from fractions import Fraction

from tool import ToolTest, cube


def matrix(size=(1, 1, 1), at=(0, 0, 0)):
    """Scales, then moves; fractions become strings."""
    def number(x):
        x = Fraction(x)
        return x.numerator if x.denominator == 1 and abs(x) < 2**63 else str(x)
    rows = [[number(size[i]) if i == j else 0 for j in range(3)] + [number(at[i])] for i in range(3)]
    return rows + [[0, 0, 0, 1]]


def box(operation, size, at, **others):
    """A step with a box; its corner with the least coordinates is at `at`."""
    return {"operation": operation, "file": "unit.off", "transform": matrix(size, at), **others}


class ChainTest(ToolTest):
    def setUp(self):
        super().setUp()
        self.file("unit.off", cube())
        self.file("block.off", cube(side=4))
        self.block = {"file": "block.off"}

    def document(self, name, start, steps, **others):
        return self.file(name, json.dumps({"start": start, "steps": steps, **others}, indent=1))

    def chain(self, start, steps, *arguments, **others):
        """Runs the document and returns the report."""
        return self.report("chain", self.document("steps.json", start, steps, **others), "-o", "out.xoff",
                           "--exact-volumes", *arguments)

    def volume(self, path):
        return Fraction(self.report("info", path)["operands"][0]["volume_exact"])

    def holes(self, count):
        """Boxes cut out of the block or put on it, in places with denominators of 3, 5 and 7; many touch or overlap."""
        return [box("difference" if k % 3 else "xor", ("1/3", "2/5", 5),
                    (Fraction(k * 5 % 13, 3), Fraction(k * 7 % 11, 3) - Fraction(1, 7), Fraction(k, 9) - 1),
                    label=f"no {k}")
                for k in range(count)]

    def mark(self, path):
        """What the first line of a checkpoint says."""
        return json.loads(self.path(path).read_text().splitlines()[0].removeprefix("# strata chain checkpoint "))
