"""peer.py ENGINE CASE [options]: what an engine from PyPI takes for an operation, from arrays to arrays.

Prints JSON like strata-bench and measures in the same way (measure.cpp). Casting the input to the engine's own types
of numbers is not timed; every structure the engine builds on the arrays is, and its result as arrays of numpy.
"""

import argparse
import functools
import importlib.metadata
import json
import math
import operator
import os
import pathlib
import re
import statistics
import sys
import time

import numpy as np


def read_case(path):
    """A list of (vertices, triangles), as case_file.h describes it."""
    data = pathlib.Path(path).read_bytes()
    place = 0

    def take(dtype, count):
        nonlocal place
        items = np.frombuffer(data, dtype, count, place)
        place += items.nbytes
        return items

    meshes = []
    for _ in range(int(take(np.int64, 1)[0])):
        vertices, triangles = (int(n) for n in take(np.int64, 2))
        meshes.append((take(np.float64, 3 * vertices).reshape(-1, 3), take(np.int32, 3 * triangles).reshape(-1, 3)))
    return meshes


def write_result(path, vertices, triangles):
    vertices = np.ascontiguousarray(vertices, np.float64).reshape(-1, 3)
    triangles = np.ascontiguousarray(triangles, np.int32).reshape(-1, 3)
    with open(path, "wb") as file:
        for items in (np.array([1, len(vertices), len(triangles)], np.int64), vertices, triangles):
            items.tofile(file)


class Refused(Exception):
    """The engine says that it has no result."""


class Manifold:
    package = "manifold3d"

    def __init__(self, request):
        import manifold3d

        self.api = manifold3d
        self.operation = {
            "union": manifold3d.OpType.Add,
            "intersection": manifold3d.OpType.Intersect,
            "difference": manifold3d.OpType.Subtract,
        }[request.operation]
        self.one_by_one = request.one_by_one

    def cast(self, vertices, triangles):
        return np.array(vertices), triangles.astype(np.uint64)

    def solid(self, mesh):
        solid = self.api.Manifold(self.api.Mesh64(*mesh))
        self.ensure_valid(solid)
        return solid

    def ensure_valid(self, solid):
        if solid.status() != self.api.Error.NoError:
            raise Refused(str(solid.status()))

    def step(self, whole, mesh):
        whole = self.api.Manifold.batch_boolean([whole, self.solid(mesh)], self.operation)
        self.ensure_valid(whole)  # asking makes it evaluate
        return whole

    def run(self, meshes):
        if self.one_by_one:
            whole = functools.reduce(self.step, meshes[1:], self.solid(meshes[0]))
        else:
            whole = self.api.Manifold.batch_boolean([self.solid(m) for m in meshes], self.operation)
        self.ensure_valid(whole)
        mesh = whole.to_mesh64()
        vertices, triangles = np.asarray(mesh.vert_properties)[:, :3], np.asarray(mesh.tri_verts)
        if len(mesh.merge_from_vert):
            same = np.arange(len(vertices))
            same[np.asarray(mesh.merge_from_vert, np.int64)] = np.asarray(mesh.merge_to_vert, np.int64)
            triangles = same[triangles.astype(np.int64)]
        return vertices, triangles


def balanced(join, items):
    """All items joined, in a tree of little depth."""
    while len(items) > 1:
        last = items[len(items) & ~1 :]
        items = [join(a, b) for a, b in zip(items[::2], items[1::2])] + last
    return items[0]


class Trueform:
    package = "trueform"

    def __init__(self, request, real):
        import trueform

        self.api = trueform
        self.real = real
        self.pair = getattr(trueform, "boolean_" + request.operation)
        self.operation = request.operation
        self.one_by_one = request.one_by_one

    def cast(self, vertices, triangles):
        return np.array(vertices, self.real), np.array(triangles)

    def mesh(self, arrays):
        vertices, triangles = arrays
        return self.api.Mesh(triangles, vertices)

    def step(self, whole, mesh):
        (triangles, vertices), *_ = self.pair(self.mesh(whole), self.mesh(mesh))
        return vertices, triangles

    def expression(self, operands):
        if self.operation == "difference":
            return operands[0] - balanced(operator.or_, operands[1:])
        return balanced({"union": operator.or_, "intersection": operator.and_}[self.operation], operands)

    def run(self, meshes):
        if self.one_by_one or len(meshes) == 2:
            vertices, triangles = functools.reduce(self.step, meshes)
        else:
            graph = self.api.CsgGraph([self.mesh(m) for m in meshes])
            triangles, vertices = graph.mesh(self.expression([self.api.op(i) for i in range(len(meshes))]))
        return np.asarray(vertices), np.asarray(triangles)


class MeshLib:
    package = "meshlib"

    def __init__(self, request):
        from meshlib import mrmeshnumpy, mrmeshpy

        self.api, self.arrays = mrmeshpy, mrmeshnumpy
        self.operation = request.operation
        self.one_by_one = request.one_by_one

    def cast(self, vertices, triangles):
        return np.array(vertices), np.array(triangles)

    def mesh(self, arrays):
        vertices, triangles = arrays
        return self.arrays.meshFromFacesVerts(triangles, vertices)

    def pair(self, a, b):
        operation = {
            "union": self.api.BooleanOperation.Union,
            "intersection": self.api.BooleanOperation.Intersection,
            "difference": self.api.BooleanOperation.DifferenceAB,
        }[self.operation]
        result = self.api.boolean(a, b, operation)
        if not result.valid():
            raise Refused(result.errorString)
        return result.mesh

    def united(self, meshes):
        pointers = self.api.std_vector_Mesh_const_ptr()
        for mesh in meshes:
            pointers.append(mesh)
        return self.api.uniteManyMeshes(pointers)

    def run(self, meshes):
        solids = [self.mesh(m) for m in meshes]
        if self.one_by_one or len(solids) == 2:
            whole = functools.reduce(self.pair, solids)
        elif self.operation == "union":
            whole = self.united(solids)
        elif self.operation == "difference":
            whole = self.pair(solids[0], self.united(solids[1:]))
        else:
            whole = functools.reduce(self.pair, solids)
        whole.pack()
        return self.arrays.getNumpyVerts(whole), self.arrays.getNumpyFaces(whole.topology)


ENGINES = {
    "manifold": Manifold,
    "trueform_f64": functools.partial(Trueform, real=np.float64),
    "trueform_f32": functools.partial(Trueform, real=np.float32),
    "meshlib": MeshLib,
}


def status_bytes(field):
    """Of the system's account of this process, as in memory.cpp."""
    text = pathlib.Path("/proc/self/status").read_text()
    return 1024 * int(re.search(rf"^{field}:\s+(\d+) kB", text, re.MULTILINE)[1])


def watch_memory():
    """Forgets earlier peaks if the system can; the bytes in use now."""
    try:
        pathlib.Path("/proc/self/clear_refs").write_text("5")
        return status_bytes("VmRSS")
    except OSError:
        return status_bytes("VmHWM")


class Subject:
    """An engine on its input, which can be run again and again."""

    def __init__(self, engine, meshes):
        self.engine = engine
        self.meshes = meshes
        self.result = None

    def timed(self, batch):
        self.result = None
        start = time.perf_counter()
        for _ in range(batch):
            self.result = self.engine.run(self.meshes)
        return (time.perf_counter() - start) / batch


def choose_batch(subject, first):
    """As in measure.cpp."""
    if first > 50e-3:
        return 1
    fastest = first
    start = time.perf_counter()
    while time.perf_counter() - start < 50e-3:
        fastest = min(fastest, subject.timed(1))
    return 1 if fastest >= 1e-3 else math.ceil(5e-3 / max(fastest, 1e-6))


def measure(subject, repetitions, budget):
    before = watch_memory()
    start = time.perf_counter()
    warm_up = subject.timed(1)
    peak = max(before, status_bytes("VmHWM"))
    batch = choose_batch(subject, warm_up)
    seconds = []
    while len(seconds) < repetitions and time.perf_counter() - start < budget:
        seconds.append(subject.timed(batch))
    return {
        "seconds": seconds or [warm_up],
        "median": statistics.median(seconds or [warm_up]),
        "warm_up": warm_up,
        "warm_up_only": not seconds,
        "batch": batch,
        "memory_before": before,
        "memory_peak": peak,
        "memory_above_input": peak - before,
    }


def parse(arguments):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("engine", choices=ENGINES)
    parser.add_argument("case")
    parser.add_argument("--operation", default="union", choices=["union", "intersection", "difference"])
    parser.add_argument("--one-by-one", action="store_true")
    parser.add_argument("--threads", type=int, default=1, help="for the record: the driver pins the process")
    parser.add_argument("--repetitions", type=int, default=5)
    parser.add_argument("--budget", type=float, default=10)
    parser.add_argument("--result")
    return parser.parse_args(arguments)


def main():
    request = parse(sys.argv[1:])
    engine = ENGINES[request.engine](request)
    subject = Subject(engine, [engine.cast(*mesh) for mesh in read_case(request.case)])
    try:
        answer = measure(subject, request.repetitions, request.budget)
    except (Refused, RuntimeError, ValueError) as error:
        sys.exit(str(error))
    vertices, triangles = subject.result
    answer |= {
        "threads": request.threads,
        "version": importlib.metadata.version(engine.package),
        "vertices": len(vertices),
        "triangles": len(triangles),
    }
    if request.result:
        write_result(request.result, vertices, triangles)
    print(json.dumps(answer), flush=True)
    os._exit(0)  # some engines crash when the interpreter takes them down


if __name__ == "__main__":
    main()
