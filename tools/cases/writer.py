"""Writes cases as directories: case.json and the files of its operands."""
import json
import pathlib

from measure import TooLong, expression_volume

OPERATIONS = {"union": "a | b", "intersection": "a & b", "difference": "a - b", "xor": "a ^ b"}
MOST_PARTS = 40  # beyond it volumes are not measured here


class Cases:
    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.slugs = set()

    def add(self, slug, solids, expression, tags, why, known=None, measured=True, input="solid"):
        """One case. Its volume is found in fractions where all solids are made of convex parts."""
        if slug in self.slugs:
            raise ValueError(f"two cases are called {slug}")
        self.slugs.add(slug)
        known = dict(known or {})
        parts = [s.parts for s in solids.values()]
        if measured and "volume" not in known and None not in parts and sum(map(len, parts)) <= MOST_PARTS:
            try:
                known["volume"] = expression_volume(expression, {n: s.parts for n, s in solids.items()})
            except TooLong:
                pass
        folder = self.folder / slug
        folder.mkdir(parents=True, exist_ok=True)
        for old in folder.iterdir():
            if old.name != "expected.json":
                old.unlink()
        document = {"why": why, "expression": expression, "tags": list(tags),
                    "operands": {name: self.operand(folder, name, solid) for name, solid in solids.items()}}
        if input != "solid":
            document["input"] = input
        if known:
            document["known"] = {k: str(v) if k in ("volume", "area") else v for k, v in known.items()}
        (folder / "case.json").write_text(text_of(document))

    @staticmethod
    def operand(folder, name, solid):
        if solid.line is not None:
            return solid.line
        text, extension = solid.text()
        (folder / f"{name}.{extension}").write_text(text)
        return f"{name}.{extension}"

    def operations(self, slug, a, b, tags, why, known=None):
        """A case for each of the four operations. `known` has facts by operation."""
        for operation, expression in OPERATIONS.items():
            self.add(f"{slug}-{operation}", {"a": a, "b": b}, expression, [*tags, operation], f"{why} ({operation})",
                     (known or {}).get(operation))

    def stale(self):
        """Directories that no family makes any more."""
        return sorted(p.name for p in self.folder.iterdir() if (p / "case.json").exists() and p.name not in self.slugs)


def text_of(document):
    """JSON with an operand on each line."""
    operands = ",\n".join(f"  {json.dumps(n)}: {json.dumps(o)}" for n, o in document["operands"].items())
    lines = []
    for key, value in document.items():
        text = "{\n" + operands + "\n }" if key == "operands" else json.dumps(value, ensure_ascii=False)
        lines.append(f" {json.dumps(key)}: {text}")
    return "{\n" + ",\n".join(lines) + "\n}\n"
