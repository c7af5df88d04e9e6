"""Meshes from and to meshio, for the file formats that it knows: VTK, VTU, Gmsh, Abaqus, XDMF and others.

>>> import meshio
>>> import strata_csg as st
>>> from strata_csg.meshio import from_meshio, to_meshio
>>> st.Solid(from_meshio(to_meshio(st.box((0, 0, 0), (1, 2, 3))))).volume
Fraction(6, 1)
"""

from __future__ import annotations

from typing import Any

import meshio  # type: ignore[import-not-found,import-untyped,unused-ignore]
import numpy as np

from strata_csg import _native
from strata_csg._interop import arrays_of, attributes_from
from strata_csg._types import MeshLike

__all__ = ["from_meshio", "to_meshio"]


def from_meshio(mesh: meshio.Mesh) -> _native.Mesh:
    """
    The triangles of a meshio.Mesh, in the order of its blocks.

    Points are taken exactly. Blocks of vertices and lines are left out; sets of points and cells are lost. Data of
    points and of triangles becomes attributes, up to four numbers each; other data is left out with a warning. Where
    both have a name, that of triangles gets the suffix ``_cell``.

    Parameters
    ----------
    mesh : meshio.Mesh
        With points of three coordinates. Where a file has tetrahedra beside the triangles of their surface, as Gmsh
        writes, take ``meshio.Mesh(mesh.points, {"triangle": mesh.cells_dict["triangle"]})``.

    Raises
    ------
    ValueError
        For cells that are not triangles, and points in the plane.

    Examples
    --------
    >>> import meshio
    >>> from_meshio(meshio.Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0.]], [("triangle", [[0, 1, 2]])]))
    Mesh(3 vertices, 1 triangles)
    >>> points, cells = [[0, 0, 0], [1, 0, 0], [0, 1, 0.]], [("triangle", [[0, 1, 2]])]
    >>> from_meshio(meshio.Mesh(points, cells, point_data={"heat": [20.0, 25.0, 30.0]})).attributes["heat"].tolist()
    [20.0, 25.0, 30.0]
    """
    blocks = [block for block in mesh.cells if block.dim >= 2]
    others = sorted({block.type for block in blocks} - {"triangle"})
    if others:
        raise ValueError(f"expected cells of type triangle, found {', '.join(others)}")
    triangles = [np.asarray(block.data) for block in blocks]
    return _native.Mesh(
        mesh.points,
        np.concatenate(triangles) if triangles else np.empty((0, 3), np.uint32),
        attributes=attributes_from(mesh.point_data, _cell_data(mesh)),
    )


def _cell_data(mesh: meshio.Mesh) -> dict[str, Any]:
    """Data of the triangles of all blocks."""
    kept = [number for number, block in enumerate(mesh.cells) if block.dim >= 2]
    if not kept:
        return {}
    return {name: np.concatenate([data[number] for number in kept]) for name, data in mesh.cell_data.items()}


def to_meshio(mesh: MeshLike, *, split: bool | None = None) -> meshio.Mesh:
    """
    A solid, or a result of `boolean`, as a meshio.Mesh with one block of triangles.

    Coordinates are the nearest doubles; exact positions that are not doubles are lost, and so are materials, images and
    names. The arrays are copies.

    Parameters
    ----------
    mesh : Solid, Mesh or Surface
    split : bool, optional
        Where the corners at a vertex have different values: True gives each value a point of its own, False takes the
        values of the first triangle. Without: True where there are texture coordinates.

    Returns
    -------
    meshio.Mesh
        With attributes as point data and cell data. With the cell data ``strata_source_operand`` and
        ``strata_source_face``, where the mesh is a result: every triangle is part of that face of that operand. VTK, VTU and Gmsh files (``file_format="gmsh"``) keep them; STL,
        OBJ, OFF and PLY files that meshio writes do not.

    Examples
    --------
    >>> import strata_csg as st
    >>> mesh = to_meshio(st.box((0, 0, 0), (1, 1, 1)) | st.box((1, 0, 0), (2, 1, 1)))
    >>> [(block.type, len(block)) for block in mesh.cells]
    [('triangle', 20)]
    >>> sorted(set(mesh.cell_data["strata_source_operand"][0].tolist()))
    [0, 1]
    """
    arrays = arrays_of(mesh, split)
    cell_data: dict[str, Any] = {name: [values] for name, values in arrays.face.items()}
    cells: Any = [("triangle", arrays.triangles.astype(np.int64))]
    return meshio.Mesh(arrays.vertices, cells, point_data=arrays.vertex, cell_data=cell_data)
