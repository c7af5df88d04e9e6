#!/usr/bin/env python3
"""Times what attributes cost, and files that hold them, from Python, beside peers in the same run.

Usage: attributes.py [--repeat N] [--level L] [--json FILE]; the interpreter must find strata_csg, and the peers that are to
be compared (manifold3d, trimesh). Operands are spheres of 20 * 4^L triangles with texture coordinates of floats. A time is
the median of N. `assimp` is the program of that name, its own start included.
"""

import argparse
import json
import pathlib
import shutil
import subprocess
import tempfile

import numpy
import strata_csg

import python


def texcoords(vertices):
    """Longitude and latitude from 0 to 1, for every vertex."""
    x, y, z = (vertices - vertices.mean(axis=0)).T
    return numpy.stack([numpy.arctan2(y, x) / (2 * numpy.pi) + 0.5, numpy.arccos(numpy.clip(z, -1, 1)) / numpy.pi],
                       axis=1).astype(numpy.float32)


def textured(vertices, triangles):
    """A mesh with a material that has an image, and texture coordinates of corners."""
    material = strata_csg.Material("wood", image=0)
    image = strata_csg.Image("wood.png", "image/png", b"\x89PNG\r\n\x1a\n" + bytes(1000))
    attributes = strata_csg.Attributes(corner={"texcoord": texcoords(vertices)[triangles].reshape(-1, 2)},
                                       face={"material": numpy.zeros(len(triangles), numpy.int32)},
                                       materials=[material], images=[image])
    return strata_csg.Mesh(vertices, triangles, attributes=attributes)


def booleans(operands, repeat):
    plain = [strata_csg.Mesh(*m) for m in operands]
    painted = [textured(*m) for m in operands]
    times = {}
    for kind in ("solid", "automatic"):
        times[kind] = python.median(lambda: strata_csg.boolean("union", plain, input=kind), repeat)
        times[kind + " with texture"] = python.median(lambda: strata_csg.boolean("union", painted, input=kind), repeat)
    try:
        import manifold3d

        def manifold(mesh):
            properties = numpy.hstack([mesh[0], texcoords(mesh[0])])
            return manifold3d.Manifold(manifold3d.Mesh64(properties, mesh[1].astype(numpy.uint64)))
        times["manifold3d with properties"] = python.median(
            lambda: (manifold(operands[0]) + manifold(operands[1])).to_mesh64(), min(repeat, 3))
    except ImportError:
        pass
    return times


def closed(scene):
    """What trimesh needs for a Boolean: one mesh, without copies of vertices along seams."""
    mesh = scene.to_geometry()
    mesh.merge_vertices(merge_tex=True, merge_norm=True)
    return mesh


def files(mesh, repeat, folder):
    table = {}
    for suffix in ("glb", "3mf"):
        path = folder / f"painted.{suffix}"
        row = table[suffix] = {"write": python.median(lambda: strata_csg.write(path, mesh), repeat)}
        row["read"] = python.median(lambda: strata_csg.read(path), repeat)
        row["size"] = path.stat().st_size
        try:
            import trimesh
            again = folder / f"again.{suffix}"
            few = repeat if suffix == "glb" else 1
            row["trimesh read"] = python.median(lambda: trimesh.load(path), few)
            row["trimesh read, seams closed"] = python.median(lambda: closed(trimesh.load(path)), few)
            scene = trimesh.load(path)
            row["trimesh write"] = python.median(lambda: scene.export(again), few)
        except ImportError:
            pass
        if shutil.which("assimp"):
            row["assimp read"] = python.median(
                lambda: subprocess.run(["assimp", "info", path, "-r"], check=False, stdout=subprocess.DEVNULL), repeat)
    return table


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--repeat", type=int, default=5)
    parser.add_argument("--level", type=int, default=8)
    parser.add_argument("--json")
    options = parser.parse_args()
    operands = [python.sphere(options.level, shift) for shift in (0, numpy.array([0.31, 0.23, 0.17]))]
    table = {"union": booleans(operands, options.repeat)}
    with tempfile.TemporaryDirectory() as folder:
        table.update(files(textured(*operands[0]), options.repeat, pathlib.Path(folder)))
    for name, row in table.items():
        print(name + ": " + ", ".join(f"{what} {value:.3f}" if what != "size" else f"{value / 1e6:.1f} MB"
                                      for what, value in row.items()))
    if options.json:
        with open(options.json, "w") as file:
            json.dump(table, file, indent=1)


if __name__ == "__main__":
    main()
