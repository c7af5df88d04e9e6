#!/usr/bin/env python3
"""The .csg files beneath a folder, evaluated by Strata and by manifold3d, both from Python: volumes, and times side by side.

    tools/bench/csg_by_manifold.py FOLDER [--repeat N]

Needs strata-csg, manifold3d and NumPy. Times are those of reading a file and evaluating it, until the mesh is there: the median of N. Models with nodes that
are not translated here, and those that manifold3d does not survive, are named, not compared.
"""
import argparse
import math
import multiprocessing
import pathlib
import re
import statistics
import time

import manifold3d as m3
import numpy as np
import strata_csg as st

TOKEN = re.compile(r'\s*(?:("(?:\\.|[^"\\])*")|([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)|([A-Za-z_$][\w$]*)|(.))', re.DOTALL)


class Unsupported(Exception):
    """A node that is not translated."""


class Node:
    def __init__(self, name, arguments, children):
        self.name, self.arguments, self.children = name, arguments, children

    def get(self, name, default):
        value = self.arguments.get(name, default)
        return default if value is None else value


class Parser:
    def __init__(self, path):
        self.folder = path.parent
        self.tokens = [m.groups() for m in TOKEN.finditer(path.read_text()) if m[0].strip()]
        self.at = 0

    def peek(self):
        return next((t for t in self.tokens[self.at] if t is not None), None) if self.at < len(self.tokens) else None

    def take(self):
        text, number, name, sign = self.tokens[self.at]
        self.at += 1
        return text or number or name or sign

    def nodes(self):
        found = []
        while self.peek() not in (None, "}"):
            found.append(self.node())
        return [n for n in found if n]

    def node(self):
        if self.peek() == ";":
            self.take()
            return None
        modifier = self.take() if self.peek() in "%#!*" else ""
        if modifier in ("!",):
            raise Unsupported("modifier !")
        name = self.take()
        arguments = self.arguments()
        if name == "import":
            arguments["file"] = self.folder / arguments["file"]
        children = []
        if self.take() == "{":
            children = self.nodes()
            self.take()
        return None if modifier in ("%", "*") and modifier else Node(name, arguments, children)

    def arguments(self):
        self.take()
        found = {}
        while self.peek() != ")":
            if self.peek() == ",":
                self.take()
                continue
            start = self.at
            name = self.take()
            if self.peek() == "=":
                self.take()
            else:
                self.at, name = start, len(found)
            found[name] = self.value()
        self.take()
        return found

    def value(self):
        token = self.take()
        if token == "[":
            items = []
            while self.peek() != "]":
                if self.peek() == ",":
                    self.take()
                else:
                    items.append(self.value())
            self.take()
            return items
        if token in ("true", "false"):
            return token == "true"
        if token == "undef":
            return None
        return token[1:-1] if token[0] == '"' else float(token)


def sides(node, radius):
    fn, fa, fs = node.get("$fn", 0), node.get("$fa", 12), node.get("$fs", 2)
    if radius < 1e-5:
        return 3
    return int(max(fn, 3)) if fn > 0 else math.ceil(max(min(360 / fa, 2 * math.pi * radius / fs), 5))


def manifold(points, faces):
    triangles = [(f[0], f[i], f[i + 1]) for f in faces for i in range(1, len(f) - 1)]
    mesh = m3.Mesh64(vert_properties=np.array(points, float), tri_verts=np.array(triangles, np.uint64))
    mesh.merge()
    made = m3.Manifold(mesh)
    if made.status() != m3.Error.NoError:
        raise Unsupported(f"polyhedron: {made.status()}")
    return made


def sphere(node):
    r = node.get("r", 1)
    n = sides(node, r)
    rings = (n + 1) // 2
    points = []
    for i in range(rings):
        phi = math.pi * (i + 0.5) / rings
        points += [(r * math.sin(phi) * math.cos(2 * math.pi * k / n), r * math.sin(phi) * math.sin(2 * math.pi * k / n), r * math.cos(phi))
                   for k in range(n)]
    faces = [list(range(n)), [(rings - 1) * n + k for k in reversed(range(n))]]
    for i in range(rings - 1):
        faces += [[i * n + k, (i + 1) * n + k, (i + 1) * n + (k + 1) % n, i * n + (k + 1) % n] for k in range(n)]
    return manifold(points, faces)


def circle(radius, n):
    return [(radius * math.cos(2 * math.pi * k / n), radius * math.sin(2 * math.pi * k / n)) for k in range(n)]


def polygon(node):
    points, paths = node.get("points", []), node.get("paths", None)
    loops = [[points[int(i)] for i in path] for path in paths] if paths else [points]
    return m3.CrossSection([np.array(loop, float) for loop in loops], m3.FillRule.EvenOdd)


def linear_extrude(node, shape):
    height, twist = node.get("height", 100), node.get("twist", 0)
    scale = node.get("scale", 1)
    scale = scale if isinstance(scale, list) else [scale, scale]
    slices = int(node.get("slices", 1)) if twist else 1
    made = m3.Manifold.extrude(shape, height, max(slices, 1) - 1, -twist, tuple(scale))
    return made.translate((0, 0, -height / 2)) if node.get("center", False) else made


def square(node):
    size = node.get("size", 1)
    size = size if isinstance(size, list) else [size, size]
    return m3.CrossSection.square(tuple(size), node.get("center", False))


def cube(node):
    size = node.get("size", 1)
    size = size if isinstance(size, list) else [size] * 3
    return m3.Manifold.cube(tuple(size), node.get("center", False))


def cylinder(node):
    h, r1, r2 = node.get("h", 1), node.get("r1", 1), node.get("r2", 1)
    n = sides(node, max(r1, r2))
    if r1 == 0:
        return m3.Manifold.cylinder(h, r2, 0, n, node.get("center", False)).mirror((0, 0, 1)).translate(
            (0, 0, 0 if node.get("center", False) else h))
    return m3.Manifold.cylinder(h, r1, r2, n, node.get("center", False))


def imported(node):
    path = node.get("file", None)
    if path.suffix.lower() != ".off":
        raise Unsupported(f"import of {path.suffix}")
    rows = [line.split() for line in path.read_text().splitlines()]
    if rows[0] != ["OFF"]:
        raise Unsupported("import of OFF with more than points and faces")
    rows = [row for row in rows[1:] if row and not row[0].startswith("#")]
    vertices, faces = int(rows[0][0]), int(rows[0][1])
    points = [[float(x) for x in row[:3]] for row in rows[1:1 + vertices]]
    return manifold(points, [[int(v) for v in row[1:1 + int(row[0])]] for row in rows[1 + vertices:1 + vertices + faces]])


LEAVES = {"cube": cube, "import": imported, "sphere": sphere, "cylinder": cylinder, "square": square, "polygon": polygon,
          "circle": lambda n: m3.CrossSection([np.array(circle(n.get("r", 1), sides(n, n.get("r", 1))))]),
          "polyhedron": lambda n: manifold(n.get("points", []), [[int(i) for i in reversed(f)] for f in n.get("faces", [])])}


def transformed(part, matrix):
    matrix = np.array(matrix, float)[:3]
    if isinstance(part, m3.CrossSection):
        return part.transform(matrix[:2][:, [0, 1, 3]])
    return part.transform(matrix)


def united(parts):
    if not parts:
        return None
    return type(parts[0]).batch_boolean(parts, m3.OpType.Add)


def hull(parts):
    return type(parts[0]).batch_hull(parts)


def minkowski(parts):
    made = parts[0]
    for part in parts[1:]:
        made = made.minkowski_sum(part)
    return made


def offset(node, shape):
    if "delta" in node.arguments:
        join = m3.JoinType.Bevel if node.get("chamfer", False) else m3.JoinType.Miter
        return shape.offset(node.get("delta", 1), join, 1e6)
    r = node.get("r", 1)
    return shape.offset(r, m3.JoinType.Round, 2, sides(node, abs(r)))


def evaluate(node):
    """A Manifold, a CrossSection, or None for nothing."""
    if node.name in LEAVES:
        return LEAVES[node.name](node)
    parts = [evaluate(child) for child in node.children]
    if node.name in ("difference",) and parts and parts[0] is None:
        return None
    if node.name in ("intersection", "intersection_for") and any(p is None for p in parts):
        return None
    parts = [p for p in parts if p is not None]
    kinds = {type(p) for p in parts}
    if len(kinds) > 1:
        raise Unsupported("shapes and solids mixed")
    if not parts:
        return None
    if node.name in ("group", "union", "color", "render"):
        return united(parts)
    if node.name == "multmatrix":
        return transformed(united(parts), node.arguments[0])
    if node.name == "difference":
        return type(parts[0]).batch_boolean(parts, m3.OpType.Subtract)
    if node.name in ("intersection", "intersection_for"):
        return type(parts[0]).batch_boolean(parts, m3.OpType.Intersect)
    if node.name == "hull":
        return hull(parts)
    if node.name == "minkowski" and kinds == {m3.Manifold}:
        return minkowski(parts)
    if node.name == "linear_extrude":
        return linear_extrude(node, united(parts))
    if node.name == "rotate_extrude":
        bounds = united(parts).bounds()
        return m3.Manifold.revolve(united(parts), sides(node, max(abs(bounds[0]), abs(bounds[2]))), node.get("angle", 360))
    if node.name == "offset":
        return offset(node, united(parts))
    if node.name == "projection":
        solid = united(parts)
        return solid.slice(0) if node.get("cut", False) else solid.project()
    raise Unsupported(node.name)


def by_manifold(path):
    made = united([p for p in map(evaluate, Parser(path).nodes()) if p is not None])
    if not isinstance(made, m3.Manifold):
        raise Unsupported("no solid")
    made.to_mesh64()
    return made


def by_strata(path):
    solid = st.read_openscad(path).evaluate()
    _ = solid.vertices, solid.triangles
    return solid


def timed(function, path):
    """What the function makes, and how long it takes."""
    start = time.perf_counter()
    made = function(path)
    return made, time.perf_counter() - start


def compare(path, repeat, connection):
    """In a process of its own: manifold3d may end it. Sends (volume, median seconds) of manifold3d and of Strata, or why there are none."""
    _ = m3.Manifold.cube() - m3.Manifold.cube(), st.box((0, 0, 0), (1, 1, 1)) - st.box((0, 0, 0), (1, 1, 1))  # loads what is loaded once
    try:
        runs = [(*timed(by_manifold, path), *timed(by_strata, path)) for _ in range(repeat)]
        theirs, their_seconds, ours, our_seconds = zip(*runs)
        connection.send(((theirs[0].volume(), statistics.median(their_seconds)), (float(ours[0].volume), statistics.median(our_seconds))))
    except Exception as error:  # pylint: disable=broad-except
        connection.send(str(error).partition("\n")[0] or repr(error))


def outcome_of(path, repeat):
    context = multiprocessing.get_context("spawn")
    receiver, sender = context.Pipe(duplex=False)
    process = context.Process(target=compare, args=(path, repeat, sender))
    process.start()
    sender.close()
    try:
        return receiver.recv() if receiver.poll(600) else "out of time"
    except EOFError:
        return "the process ended by itself"
    finally:
        process.kill()
        process.join()


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--repeat", type=int, default=1)
    arguments = parser.parse_args()
    equal, different = [], []  # pairs of seconds
    for model in sorted(arguments.folder.rglob("*.csg")):
        outcome = outcome_of(model, arguments.repeat)
        if isinstance(outcome, str):
            print(f"{model.name}: not compared: {outcome}", flush=True)
            continue
        (theirs, their_seconds), (ours, our_seconds) = outcome
        is_different = abs(ours - theirs) > 1e-5 * abs(ours)
        (different if is_different else equal).append((our_seconds, their_seconds))
        sizes = f", volume {ours:.9g}, theirs {theirs:.9g}" if is_different else ""
        print(f"{model.name}: {our_seconds:.4f} s, manifold3d {their_seconds:.4f} s{sizes}", flush=True)
    for pairs, what in (equal, "of the same volume"), (different, "of other volumes, of which one side does not make all"):
        ours, theirs = (sum(column) for column in zip(*pairs)) if pairs else (0, 0)
        print(f"{len(pairs)} {what}: {ours:.2f} s, manifold3d {theirs:.2f} s, ratio {theirs / max(ours, 1e-9):.2f}")


if __name__ == "__main__":
    main()
