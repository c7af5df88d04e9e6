"""A Boolean of trimesh that comes out empty, and one that joins what is apart

Plants and buildings have coordinates that count from far away: a pump in a map has a position of 5,600,000 metres,
and its drawing is in millimetres. trimesh has doubles, which hold such numbers. Its default engine, manifold3d, is
called with 32-bit floats, which do not: they have 24 binary digits. Vertices of a small part far from the origin fall
together, and the result is empty, without an error. Near the origin, the same loss closes gaps that are narrower than
a float resolves.

Strata takes the doubles as they are. Nothing is moved, nothing is joined because it is near.
"""

# %% A block with a pocket, near and far
# The block is a cube, and the pocket a hole of half its width. The volume that remains is 13/16 wherever they are.

from __future__ import annotations

from fractions import Fraction
from importlib import import_module
from importlib.util import find_spec
from typing import Any

import numpy as np
import strata_csg as st

trimesh: Any = None
if find_spec("trimesh") and find_spec("manifold3d"):
    trimesh = import_module("trimesh")
else:
    print("SKIPPED: the comparison needs trimesh and manifold3d")

BLOCK = st.box((0, 0, 0), (1, 1, 1))
POCKET = st.box((0.25, 0.25, 0.25), (0.75, 0.75, 2))


def moved(solid: st.Solid, by: float) -> tuple[Any, Any]:
    """Arrays of vertices and triangles, as a program has them."""
    return solid.vertices + by, np.array(solid.triangles)


def by_trimesh(operation: str, *meshes: tuple[Any, Any]) -> Any:
    """The result of trimesh with its engine manifold; None without trimesh."""
    if trimesh is None:
        return None
    operands = [trimesh.Trimesh(*mesh, process=False) for mesh in meshes]
    return getattr(trimesh.boolean, operation)(operands, engine="manifold")


# %% The difference
# The volumes of the results, relative to their own middle, so that the measure itself loses nothing.


def volume_of(mesh: Any) -> str:
    if mesh is None:
        return "-"
    if len(mesh.faces) == 0:
        return "empty"
    return f"{float(st.Solid((mesh.vertices, mesh.faces)).volume):.6f}"


print(f"{'moved by':>16}  {'Strata':>8}  {'manifold3d':>10}")
for by in (0.0, 1e6, 1e7, 5.6e9, 2.0**45):
    block, pocket = moved(BLOCK, by), moved(POCKET, by)
    rest = st.Solid(block) - st.Solid(pocket)
    assert rest.volume == Fraction(13, 16)
    print(f"{by:16,.0f}  {float(rest.volume):8.6f}  {volume_of(by_trimesh('difference', block, pocket)):>10}")

# %% A gap
# Two boxes that are apart by less and less. They are two bodies as long as they do not touch.

print(f"\n{'gap':>10}  {'Strata':>8}  {'manifold3d':>10}")
for gap in (1e-3, 1e-6, 1e-9, 2.0**-52, 0.0):
    left, right = st.box((0, 0, 0), (1, 1, 1)), st.box((1 + gap, 0, 0), (2, 1, 1))
    bodies = len((left | right).components())
    assert bodies == (2 if gap > 0 else 1)
    union = by_trimesh("union", moved(left, 0), moved(right, 0))
    others = "-" if union is None else str(union.body_count)
    print(f"{gap:10.1e}  {bodies:8}  {others:>10}")

# %% The same by the interface of trimesh
# `strata_csg.trimesh` makes Strata an engine of `trimesh.boolean`, so that a program changes in one word.

if trimesh is not None:
    from strata_csg.trimesh import register

    register()
    operands = [trimesh.Trimesh(*moved(solid, 5.6e9), process=False) for solid in (BLOCK, POCKET)]
    result = trimesh.boolean.difference(operands, engine="strata")
    assert st.Solid((result.vertices, result.faces)).volume == Fraction(13, 16)
    print("\nengine='strata':", len(result.faces), "triangles, a volume:", result.is_volume)
