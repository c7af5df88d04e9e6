"""Solids from and to trimesh, and Strata as an engine of ``trimesh.boolean``.

>>> import trimesh
>>> from strata_csg.trimesh import register
>>> register()
>>> a, b = trimesh.creation.box((2, 2, 2)), trimesh.creation.box((1, 1, 4))
>>> float(trimesh.boolean.difference([a, b], engine="strata").volume)
6.0

Coordinates stay doubles in both directions. The module needs trimesh; ``import strata_csg`` does not.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
import trimesh  # type: ignore[import-not-found,import-untyped,unused-ignore]

from strata_csg import _native
from strata_csg._errors import Defect, InputError
from strata_csg._interop import arrays_of
from strata_csg._trimesh_visuals import attributes_of, visual_of
from strata_csg._types import MeshLike, Operation

__all__ = ["boolean", "from_trimesh", "register", "to_trimesh", "unregister"]

_NAME = "strata"
_TESTED = "4.9.0, 5.0.0 and 5.2.0"

#: The default engine that ``register(default=True)`` replaced.
_replaced: list[Any] = []


def from_trimesh(mesh: Any, **options: Any) -> _native.Solid:
    """
    The solid that a trimesh.Trimesh bounds.

    Vertices are taken exactly. Colours of vertices or faces, texture coordinates with their materials, and attributes
    of vertices and faces become attributes, of up to four numbers each; others are left out with a warning. Normals, which trimesh computes itself, and metadata are not taken.

    Parameters
    ----------
    mesh : trimesh.Trimesh
        Also one of ``trimesh.primitives``. Of a scene, take ``scene.to_mesh()``.
    **options
        Those of `Solid`: ``input``, ``threads`` and so on.

    Raises
    ------
    InputError
        The mesh bounds no solid; its `defects` say why and where.

    Examples
    --------
    >>> import trimesh
    >>> from_trimesh(trimesh.creation.box((1, 2, 3))).volume
    Fraction(6, 1)
    """
    return _native.Solid(_mesh_of(mesh), **options)


def to_trimesh(mesh: MeshLike, *, split: bool | None = None) -> trimesh.Trimesh:
    """
    The boundary of a solid, or a result of `boolean`, as a trimesh.Trimesh.

    Coordinates are the nearest doubles; exact positions that are not doubles are lost. Nothing is merged or removed.
    The arrays are copies.

    Parameters
    ----------
    mesh : Solid, Mesh or Surface
    split : bool, optional
        Where the corners at a vertex have different values, as at the seams of textures: True gives each value a vertex
        of its own, so that ``is_watertight`` is no longer True; False takes the values of the first triangle. Without:
        True where there are texture coordinates.

    Returns
    -------
    trimesh.Trimesh
        Texture coordinates with materials, or else colours, or else the colours of materials are its ``visual``; images
        need Pillow. Other attributes are vertex attributes and face attributes. With the face attributes
        ``strata_source_operand`` and ``strata_source_face``, where the mesh is a result: every triangle is part of that
        face of that operand. ``metadata["strata_notes"]`` is a list of sentences that tell what was resolved in
        operands, where something was.

    Examples
    --------
    >>> import strata_csg as st
    >>> mesh = to_trimesh(st.box((0, 0, 0), (1, 1, 1)) - st.box((0, 0, 0), (1, 1, 0.5)))
    >>> float(mesh.volume), mesh.is_volume
    (0.5, True)
    >>> sorted(set(mesh.face_attributes["strata_source_operand"].tolist()))
    [0, 1]
    """
    arrays = arrays_of(mesh, split)
    visual = visual_of(arrays)
    notes: tuple[Defect, ...] = getattr(mesh, "notes", ())
    return trimesh.Trimesh(
        vertices=arrays.vertices,
        faces=arrays.triangles,
        visual=visual,
        vertex_attributes=arrays.vertex,
        face_attributes=arrays.face,
        metadata={"strata_notes": [str(note) for note in notes]} if notes else None,
        process=False,
        validate=False,
    )


def boolean(
    meshes: Iterable[Any],
    operation: Operation = "difference",
    check_volume: bool = True,
    **kwargs: Any,
) -> trimesh.Trimesh:
    """
    The Boolean of any number of trimesh meshes, with the signature of the engines of ``trimesh.boolean``.

    All operands are computed in one arrangement, on the doubles of the meshes. Colours, textures and attributes are
    carried, as `from_trimesh` and `to_trimesh` say. An operand without colours is white where others have some.

    Parameters
    ----------
    meshes : iterable of trimesh.Trimesh
    operation : {"difference", "union", "intersection", "symmetric-difference"}
        Difference: the first mesh without all others.
    check_volume : bool
        Refuse meshes for which ``Trimesh.is_volume`` is False, as the engines of trimesh do, even if vertices at one
        place, as at the seams of textures, are joined. Without, Strata's own rule remains: what is not closed, or
        inside out, is refused; empty meshes, and edges with more than two faces, are not. ``input="repair"`` and
        ``input="soup"`` accept the others, too.
    **kwargs
        Those of `strata_csg.boolean`: ``input``, ``rounding``, ``threads``, ``progress``, ``timeout`` and so on.
        Unless told, ``rounding`` is "float64": the result bounds a solid, so that it can be the next operand.

    Returns
    -------
    trimesh.Trimesh
        As by `to_trimesh`; without vertices and faces where the result is empty.

    Raises
    ------
    InputError
        A mesh bounds no solid. A ValueError, as trimesh raises.
    ValueError
        For an unknown operation, and the difference of fewer than two meshes.

    Examples
    --------
    Faces of a result have the colours of the faces that they are part of:

    >>> import trimesh
    >>> meshes = [trimesh.creation.box((2, 2, 2)), trimesh.creation.box((1, 1, 4))]
    >>> meshes[1].visual.face_colors = [255, 0, 0, 255]
    >>> result = boolean(meshes, "difference")
    >>> drilled = result.face_attributes["strata_source_operand"] == 1
    >>> set(map(tuple, result.visual.face_colors[drilled].tolist()))
    {(255, 0, 0, 255)}
    """
    operands = list(meshes)
    if operation == "difference" and len(operands) < 2:
        raise ValueError("Difference only defined over two meshes.")
    if check_volume:
        _refuse_non_volumes(operands)
    if not kwargs.get("exact"):
        kwargs.setdefault("rounding", "float64")
    return to_trimesh(_native.boolean(operation, [_mesh_of(mesh) for mesh in operands], **kwargs))


def register(*, default: bool = False) -> None:
    """
    Makes ``engine="strata"`` known to trimesh, in this process; `unregister` undoes it.

    trimesh has no interface for engines of others. This adds one entry to the dictionary ``trimesh.boolean._engines``,
    in which trimesh looks engines up, and to the set ``trimesh.boolean.engines_available`` where there is one. Tested
    with trimesh 4.9.0, 5.0.0 and 5.2.0. Calling it again changes nothing.

    Parameters
    ----------
    default : bool
        Also use it where no engine is named.

    Raises
    ------
    NotImplementedError
        This trimesh has no such dictionary. `boolean` of this module works nevertheless.

    Examples
    --------
    >>> import trimesh
    >>> register()
    >>> a = trimesh.creation.box((1, 1, 1))
    >>> float(a.union(a, engine="strata").volume)
    1.0
    """
    engines = _engines()
    engines[_NAME] = boolean
    _available().add(_NAME)
    if default and engines.get(None) is not boolean:
        _replaced.append(engines.get(None))
        engines[None] = boolean


def unregister() -> None:
    """
    Undoes `register`: trimesh has the engines that it had before.

    Examples
    --------
    >>> import trimesh
    >>> register()
    >>> unregister()
    >>> "strata" in trimesh.boolean.engines_available
    False
    """
    engines = _engines()
    engines.pop(_NAME, None)
    _available().discard(_NAME)
    if engines.get(None) is boolean:
        engines[None] = _replaced.pop()


def _pair(mesh: Any) -> tuple[Any, Any]:
    """Vertices and faces; ``Trimesh.triangles`` are coordinates."""
    try:
        return mesh.vertices, mesh.faces
    except AttributeError:
        raise TypeError(f"expected a trimesh.Trimesh, found {type(mesh).__name__}") from None


def _mesh_of(mesh: Any) -> _native.Mesh:
    vertices, faces = _pair(mesh)
    return _native.Mesh(vertices, faces, attributes=attributes_of(mesh))


def _is_volume(mesh: Any) -> bool:
    """Also of a mesh that is one once vertices at one place are joined."""
    if mesh.is_volume or mesh.is_empty:
        return bool(mesh.is_volume)
    places, numbers = np.unique(mesh.vertices, axis=0, return_inverse=True)
    return bool(trimesh.Trimesh(places, numbers.reshape(-1)[mesh.faces], process=False).is_volume)


def _refuse_non_volumes(meshes: list[Any]) -> None:
    for number, mesh in enumerate(meshes):
        if not _is_volume(mesh):
            defects = tuple(defect for defect in _native.check(_pair(mesh)) if defect.severity == "error")
            reasons = [_reason(mesh), *map(str, defects[:1])]
            raise InputError(f"Not all meshes are volumes! Mesh {number} {'; '.join(reasons)}", defects, number)


def _reason(mesh: Any) -> str:
    """Why ``is_volume`` is False."""
    if mesh.is_empty:
        return "is empty"
    if not mesh.is_watertight:
        return "is not watertight"
    if not mesh.is_winding_consistent:
        return "has no consistent winding"
    return "has no positive volume"


def _engines() -> dict[Any, Any]:
    engines = getattr(trimesh.boolean, "_engines", None)
    if not isinstance(engines, dict) or "manifold" not in engines:
        raise NotImplementedError(
            f"trimesh {trimesh.__version__} does not look Boolean engines up in trimesh.boolean._engines; "
            f"register() was tested with trimesh {_TESTED}. Call strata_csg.trimesh.boolean instead."
        )
    return engines


def _available() -> set[Any]:
    """The set that trimesh keeps of engines that work; older versions have none."""
    available = getattr(trimesh.boolean, "engines_available", None)
    return available if isinstance(available, set) else set()
