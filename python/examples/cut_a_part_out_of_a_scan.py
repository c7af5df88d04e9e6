"""A head cut out of a scan that is open and damaged

Scans are rarely closed. The scanner does not see under the feet, misses spots, and programs that merge its pictures
list triangles twice or turn them over. Such a mesh bounds no solid, and a Boolean of it has no meaning.

Strata says so, with every defect, its place and its faces. With `input="soup"` it mends the mesh: equal triangles
become one, triangles are turned to agree with their neighbours, and holes are filled with triangles between the
vertices on their rims. No vertex moves. The notes of the solid tell what was done.
"""

# %% A scan
# The mesh of a cow is closed and clean. Without the soles of the hooves, with a hole in the flank, with triangles
# that are doubled and turned over, it is what a scanner would make of it.

from __future__ import annotations

import tempfile
from collections import Counter
from pathlib import Path

import numpy as np
import strata_csg as st

HERE = Path(__file__).parent if "__file__" in globals() else Path.cwd()
cow = st.read(HERE.parents[1] / "data" / "spot.obj")
vertices, triangles = cow.vertices, cow.triangles.copy()

middles = vertices[triangles].mean(axis=1)
missed = np.linalg.norm(middles - middles[1234], axis=1) < 0.06
seen = triangles[(middles[:, 1] > -0.68) & ~missed]
seen[100:150] = seen[100:150, ::-1]
scan = st.Mesh(vertices, np.vstack([seen, seen[:20]]))
print(scan)

# %% What is wrong with it
# `check` finds all defects. `Solid` refuses a mesh that has some.

found = {defect.kind: defect.count for defect in st.check(scan)}
for kind, count in found.items():
    print(f"{kind}: {count}")
assert set(found) == {"duplicate face", "open edge", "inconsistent orientation"}

try:
    st.Solid(scan)
except st.InputError as error:
    print("refused:", error.defects[0])
else:
    raise AssertionError("an open mesh was accepted")

# %% Mended
# Holes may be limited: a rim of many edges is more likely a piece that is missing than a spot that was not seen.

try:
    st.Solid(scan, input="soup", most_hole_edges=8)
except st.InputError as error:
    print("refused:", error.defects[0].message)

mended = st.Solid(scan, input="soup", most_hole_edges=16)
for note in mended.notes:
    if note.kind == "open edge":
        place = ", ".join(f"{x:.3f}" for x in note.where or ())
        print(f"filled at ({place}): {note.message}")
holes = next(note.count for note in mended.notes if note.kind == "open edge")
print(Counter(note.kind for note in mended.notes))
print(f"{holes} holes filled; volume {mended.nearest_volume:.6f}, of the whole cow {st.Solid(cow).nearest_volume:.6f}")
assert holes == 5
assert abs(mended.nearest_volume / st.Solid(cow).nearest_volume - 1) < 0.01

# %% Cut
# The head is what is in a box. The two parts have exactly the volume of the whole.

box = st.box((-1, 0.2, -1), (1, 2, 0))
head, body = mended & box, mended - box
print(head)
assert head.volume + body.volume == mended.volume
assert len(head.components()) == 1

# %% Written
# Binary STL has floats. `rounded` moves vertices to floats such that the mesh bounds a solid still, and tells how
# far.

folder = Path(tempfile.mkdtemp())
rounded = head.rounded("float32")
moved = rounded.rounding or {}
print(f"{moved['moved_vertices']} vertices moved, by {moved['largest_movement']:.1e} at most")
st.write(folder / "head.stl", rounded)
assert st.Solid(st.read(folder / "head.stl")) == st.Solid(rounded)
print("written:", (folder / "head.stl").stat().st_size, "bytes")
