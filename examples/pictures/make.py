"""Makes the pictures of the examples in this folder, with strata-csg installed. Usage: make.py"""
import pathlib
import subprocess
import tempfile
from fractions import Fraction

import strata_csg as st

HERE = pathlib.Path(__file__).resolve().parent
DATA = HERE.parent.parent / "data"


def draw(name, solids, *view):
    """A picture of solids that do not touch, hidden lines removed."""
    with tempfile.TemporaryDirectory() as folder:
        paths = []
        for number, solid in enumerate(solids):
            paths.append(f"{folder}/{number}.xoff")
            st.write(paths[-1], solid)
        subprocess.run(["strata", "draw", *paths, "-o", HERE / f"{name}.svg", "--width", "400", *view], check=True)


corner = st.Solid(([[0, 0, 0], [4, 0, 0], [0, 4, 0], [0, 0, 4]], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]))
draw("corner", [corner - corner.translated((1, 0, 0))], "--direction=1,-3,-2", "--style", "both")

drill = st.cylinder(0.4, 3, 32)
plate = st.box((0, 0, 0), (9, 3, 1))
plate -= st.union([drill.translated((Fraction(9 * k + 4, 3), 1.5, -1)) for k in range(3)])
draw("plate", [plate], "--direction=-2,3,-3", "--style", "both")

cutter = st.cylinder(0.3, 3, 12)
piece = st.box((0, 0, 0), (20, 10, 1)) - st.union([cutter.translated((k + 1 / 3, 5, -1)) for k in range(20)])
draw("workpiece", [piece], "--direction=-1,3,-4", "--style", "both")

block = st.box((0, 0, 0), (4, 4, 2)) - st.cylinder(1, 2, 64).translated((2, 2, 0))
below, above = block.split(((0, 0, 1), 0.25))
draw("halves", [below, above.translated((0, 0, 1))], "--direction=-3,-2,-2", "--style", "both")

assembly = [st.box((0, 0, 0), (10, 4, 1)), st.box((1, 1, 1), (2, 3, 4)), st.box((5, 1, 0.875), (7, 3, 3)),
            st.sphere(1, 24).translated((13, 2, 3))]
draw("assembly", [st.union(assembly)], "--direction=-1,3,-1.5", "--style", "both")

draw("torus", [st.torus(2, 1, 48, 24)], "--direction=-1,-2,-2", "--style", "both")


def apart(solid, heights, gap):
    """The slabs of a solid between heights, with gaps between."""
    slabs = []
    for number, height in enumerate(heights):
        slab, solid = solid.split(((0, 0, 1), height))
        slabs.append(slab.translated((0, 0, number * gap)))
    return [*slabs, solid.translated((0, 0, len(heights) * gap))]


draw("slices", apart(st.sphere(1, 24), [k / 4 for k in range(-3, 4)], 0.2), "--direction=-2,-3,-1.2", "--style", "both")
draw("layers", apart(st.Solid(st.read(DATA / "bracket.off")), [k / 5 for k in range(-3, 5, 2)], 0.25), "--direction=-2,3,-2", "--style", "both")
