"""What the tests of `strata verify` share: cases in a scratch folder, engines that are small scripts."""
import json
import sys

from tool import OK, ToolTest, cube

# Reads and writes OFF; `vertices` and `faces` of the right result, by the tool itself.
PRELUDE = """
import math, os, signal, subprocess, sys, time
operation, a, b, out = sys.argv[1:]
def read(path):
    words = open(path).read().split()[1:]
    v, f = int(words[0]), int(words[1])
    numbers = [float(w) for w in words[3:3 + 3 * v]]
    indices = [int(w) for w in words[3 + 3 * v:]]
    return ([numbers[3 * i:3 * i + 3] for i in range(v)], [indices[4 * i + 1:4 * i + 4] for i in range(f)])
def write(vertices, faces):
    with open(out, "w") as file:
        file.write(f"OFF\\n{len(vertices)} {len(faces)} 0\\n")
        file.writelines(" ".join(map(repr, v)) + "\\n" for v in vertices)
        file.writelines("3 " + " ".join(map(str, f)) + "\\n" for f in faces)
def right():
    subprocess.run([os.environ["STRATA_TOOL"], operation, a, b, "-o", out, "-q"], check=True)
    return read(out)
def together():
    (v, f), (w, g) = read(a), read(b)
    return v + w, f + [[i + len(v) for i in t] for t in g]
"""


class VerifyTest(ToolTest):
    def case(self, slug, expression="a | b", second=(1, 0, 0), known=None, certified=True, **others):
        """A unit cube and another one at `second`."""
        folder = self.path("cases") / slug
        folder.mkdir(parents=True)
        (folder / "a.off").write_text(cube())
        x, y, z = second
        document = {"why": "a test", "expression": expression, "tags": ["test", slug],
                    "operands": {"a": "a.off",
                                 "b": {"generate": "box", "lower": [x, y, z], "upper": [x + 1, y + 1, z + 1]}}, **others}
        if known:
            document["known"] = known
        (folder / "case.json").write_text(json.dumps(document))
        if certified:
            self.verify("--certify", "--case", slug)
        return folder

    def engine(self, body, name="fake"):
        """NAME=COMMAND for a script with this end."""
        return f"{name}={sys.executable} {self.file(name + '.py', PRELUDE + body)}"

    def verify(self, *arguments, expect=OK):
        return self.run_tool("verify", "--cases", "cases", *arguments, expect=expect).stdout.decode()

    def findings(self, *arguments, expect=OK):
        self.verify(*arguments, "--report", "report.json", expect=expect)
        return json.loads(self.path("report.json").read_text())["findings"]

    def outcome(self, body, *arguments, slug="boxes", expect=OK):
        """What becomes of the case if the engine does this: outcome and reason."""
        finding, = self.findings("--case", slug, "--engine", self.engine(body), *arguments, expect=expect)
        return finding["outcome"], finding["reason"]
