"""Solids from and to PyVista, and the accessor ``mesh.strata`` of its surfaces.

>>> import pyvista
>>> import strata_csg.pyvista
>>> a, b = pyvista.Cube(x_length=2, y_length=2, z_length=2), pyvista.Cube(z_length=4)
>>> round(a.strata.difference(b).volume, 9)
6.0

PyVista finds the accessor by the entry point ``pyvista.accessors`` of the installed package, without the import; an
accessor needs PyVista 0.48. Coordinates stay doubles where PyVista has doubles. Many of its sources, such as
``pyvista.Sphere``, have floats, which are taken as they are.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable
from typing import Any

import numpy as np
import pyvista  # type: ignore[import-not-found,import-untyped,unused-ignore]
from numpy.typing import NDArray

from strata_csg import _native
from strata_csg._errors import Defect
from strata_csg._interop import SOURCE_FACE, SOURCE_OPERAND, arrays_of, attributes_from
from strata_csg._types import MeshLike, Operation

__all__ = ["StrataAccessor", "from_pyvista", "to_pyvista"]


def from_pyvista(mesh: pyvista.PolyData, **options: Any) -> _native.Solid:
    """
    The solid that a pyvista.PolyData bounds.

    Points are taken exactly. Triangles are taken as they are; VTK divides other polygons and strips into triangles.
    Vertex and line cells are left out. Data of points and cells becomes attributes, up to four numbers each; other data
    is left out with a warning. Where both have a name, that of cells gets the suffix ``_cell``.

    Parameters
    ----------
    mesh : pyvista.PolyData
        Of other data sets, take ``dataset.extract_surface()``.
    **options
        Those of `Solid`: ``input``, ``threads`` and so on.

    Raises
    ------
    InputError
        The mesh bounds no solid; its `defects` say why and where, with triangles counted as in
        ``mesh.triangulate()``.

    Examples
    --------
    >>> import pyvista
    >>> from_pyvista(pyvista.Cube(x_length=3)).volume
    Fraction(3, 1)
    """
    return _native.Solid(_mesh_of(mesh)[0], **options)


def to_pyvista(mesh: MeshLike, *, split: bool | None = None) -> pyvista.PolyData:
    """
    The boundary of a solid, or a result of `boolean`, as a pyvista.PolyData.

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
    pyvista.PolyData
        With attributes as point data and cell data. With the cell data ``strata_source_operand`` and
        ``strata_source_face``, where the mesh is a result: every triangle is part of that face of that operand.

    Examples
    --------
    >>> import strata_csg as st
    >>> mesh = to_pyvista(st.box((0, 0, 0), (1, 1, 1)))
    >>> mesh.n_cells, mesh.points.dtype.name
    (12, 'float64')
    """
    arrays = arrays_of(mesh, split)
    faces: Any = arrays.triangles.astype(np.int64)
    result: pyvista.PolyData = pyvista.PolyData.from_regular_faces(arrays.vertices, faces)
    for data, given in ((result.point_data, arrays.vertex), (result.cell_data, arrays.face)):
        for name, values in given.items():
            if values.size or values.ndim == 1:  # PyVista refuses other empty arrays
                data[name] = values
    return result


class StrataAccessor:
    """
    What ``mesh.strata`` offers, for every pyvista.PolyData.

    Operands are PolyData, or other meshes that `strata_csg.boolean` takes. Results are PolyData with the data of points
    and cells of the operands, as `from_pyvista` and `to_pyvista` carry it; data that an operand does not have is 0
    there, or -1 for integers. The cell data ``strata_source_operand`` is 0 for this mesh, and ``strata_source_face``
    the number of the cell of that operand. Options are those of `strata_csg.boolean`.

    Examples
    --------
    >>> import pyvista
    >>> a, b = pyvista.Cube(), pyvista.Cube(center=(0.5, 0, 0))
    >>> result = a.strata.union(b)
    >>> round(result.volume, 9)
    1.5
    >>> int(result.cell_data["strata_source_face"].max())  # cubes have six faces
    5
    >>> a.cell_data["side"], b.cell_data["side"] = range(6), range(6, 12)
    >>> sorted(set(a.strata.union(b).cell_data["side"].tolist()))
    [0, 2, 3, 4, 5, 7, 8, 9, 10, 11]
    """

    def __init__(self, mesh: pyvista.PolyData) -> None:
        self._mesh = mesh

    def union(self, *others: Any, **options: Any) -> pyvista.PolyData:
        """
        The points in this mesh or any other.

        Examples
        --------
        >>> import pyvista
        >>> round(pyvista.Cube().strata.union(pyvista.Cube(center=(1, 0, 0))).volume, 9)
        2.0
        """
        return self._combined("union", others, options)

    def intersection(self, *others: Any, **options: Any) -> pyvista.PolyData:
        """
        The points in this mesh and all others.

        Examples
        --------
        >>> import pyvista
        >>> pyvista.Cube().strata.intersection(pyvista.Cube(center=(1, 0, 0))).n_cells
        0
        """
        return self._combined("intersection", others, options)

    def difference(self, *others: Any, **options: Any) -> pyvista.PolyData:
        """
        The points in this mesh and in no other.

        Examples
        --------
        >>> import pyvista
        >>> round(pyvista.Cube().strata.difference(pyvista.Cube(center=(0.5, 0, 0))).volume, 9)
        0.5
        """
        return self._combined("difference", others, options)

    def symmetric_difference(self, *others: Any, **options: Any) -> pyvista.PolyData:
        """
        The points in an odd number of the meshes.

        Examples
        --------
        >>> import pyvista
        >>> round(pyvista.Cube().strata.symmetric_difference(pyvista.Cube(center=(0.5, 0, 0))).volume, 9)
        1.0
        """
        return self._combined("symmetric-difference", others, options)

    def solid(self, **options: Any) -> _native.Solid:
        """
        The solid that this mesh bounds, as by `from_pyvista`: for exact chains, transforms, splits and measures.

        Examples
        --------
        >>> import pyvista
        >>> below, above = pyvista.Cube().strata.solid().split(((0, 0, 1), 0.25))
        >>> above.volume
        Fraction(1, 4)
        """
        return from_pyvista(self._mesh, **options)

    def check(self, **options: Any) -> tuple[Defect, ...]:
        """
        All defects for which this mesh bounds no solid, as by `strata_csg.check`.

        Faces are those of ``mesh.triangulate()``.

        Examples
        --------
        >>> import pyvista
        >>> {defect.kind for defect in pyvista.Plane(i_resolution=1, j_resolution=1).strata.check()}
        {'open edge'}
        """
        points, triangles, _ = _triangles_of(self._mesh)
        return _native.check((points, triangles), **options)

    def _combined(self, operation: Operation, others: tuple[Any, ...], options: dict[str, Any]) -> pyvista.PolyData:
        operands: list[Any] = []
        cells: list[NDArray[np.int64] | None] = []
        for mesh in (self._mesh, *others):
            operand, numbers = _operand(mesh)
            operands.append(operand)
            cells.append(numbers)
        options.setdefault("rounding", "float64")  # the result is to be an operand again
        result = to_pyvista(_native.boolean(operation, operands, **options))
        result.cell_data[SOURCE_FACE] = _cells_of(result, cells)
        return result


def _operand(mesh: Any) -> tuple[Any, NDArray[np.int64] | None]:
    """A mesh for `boolean`, and the cells that its triangles are part of, where they are not the same."""
    if not isinstance(mesh, pyvista.PolyData):
        return mesh, None
    return _mesh_of(mesh)


def _mesh_of(mesh: Any) -> tuple[_native.Mesh, NDArray[np.int64]]:
    """The triangles of a PolyData with its data, and the number of the cell that each is part of."""
    points, triangles, cells = _triangles_of(mesh)
    cell_data: dict[str, Any] = {}
    for name, values in mesh.cell_data.items():
        if len(values) == mesh.n_cells:
            cell_data[name] = np.asarray(values)[cells]
        else:
            warnings.warn(f"not carried: {name!r} has {len(values)} values for {mesh.n_cells} cells", stacklevel=2)
    return _native.Mesh(points, triangles, attributes=attributes_from(mesh.point_data, cell_data)), cells


def _triangles_of(mesh: Any) -> tuple[NDArray[Any], NDArray[Any], NDArray[np.int64]]:
    """Points, triangles, and the number of the cell that each triangle is part of."""
    if not isinstance(mesh, pyvista.PolyData):
        raise TypeError(f"expected a pyvista.PolyData, found {type(mesh).__name__}")
    surface = pyvista.PolyData()  # without vertices and lines
    surface.points = mesh.points
    surface.SetPolys(mesh.GetPolys())
    surface.SetStrips(mesh.GetStrips())
    cells = np.arange(mesh.n_verts + mesh.n_lines, mesh.n_cells)
    if mesh.n_strips == 0 and surface.is_all_triangles:
        return surface.points, surface.regular_faces, cells
    surface.cell_data["cell"] = cells
    surface = surface.triangulate()
    return surface.points, surface.regular_faces, np.asarray(surface.cell_data["cell"])


def _cells_of(result: pyvista.PolyData, cells: list[NDArray[np.int64] | None]) -> NDArray[np.uint32]:
    """The source faces of a result, numbered as cells of the operands."""
    faces = np.array(result.cell_data[SOURCE_FACE])
    for operand, numbers in enumerate(cells):
        if numbers is not None:
            chosen = result.cell_data[SOURCE_OPERAND] == operand
            faces[chosen] = numbers[faces[chosen]]
    return faces


def _register() -> None:
    """Attaches the accessor, where PyVista is recent enough for accessors."""
    register: Callable[..., Any] | None = getattr(pyvista, "register_dataset_accessor", None)
    if register is not None:
        register("strata", pyvista.PolyData)(StrataAccessor)


_register()
