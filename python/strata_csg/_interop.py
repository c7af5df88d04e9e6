"""What the conversions to other libraries have in common."""

from __future__ import annotations

import warnings
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from strata_csg import _native
from strata_csg._attributes import Image, Material
from strata_csg._types import Element

#: Names of the attributes that say which face of which operand a triangle is part of.
SOURCE_OPERAND = "strata_source_operand"
SOURCE_FACE = "strata_source_face"

#: What a channel on faces has at the end of its name where one on vertices has the same name.
CELL = "_cell"

Data = dict[str, Any]


@dataclass
class Arrays:
    """
    A mesh as other libraries have it: without values on corners. The arrays are copies.

    Attributes
    ----------
    vertices, triangles : arrays
    vertex, face : dict of arrays
        What the mesh carries, and the sources of its triangles.
    materials, images : tuple
        What ``face["material"]`` refers to.
    """

    vertices: NDArray[np.float64]
    triangles: NDArray[np.uint32]
    vertex: Data
    face: Data
    materials: tuple[Material, ...] = ()
    images: tuple[Image, ...] = ()


def arrays_of(mesh: Any, split: bool | None = None) -> Arrays:
    """
    Of a Mesh, Solid or Surface.

    Parameters
    ----------
    split : bool, optional
        Where the corners at a vertex have different values, as at the seams of textures: True gives each value a vertex
        of its own, False takes the values of the first corner. Without: True where there are texture coordinates.
    """
    arrays = Arrays(np.array(mesh.vertices), np.array(mesh.triangles), {}, {})
    attributes = getattr(mesh, "attributes", None)
    if attributes is not None:
        arrays.vertex, arrays.face = _copies(attributes.vertex), _copies(attributes.face)
        arrays.materials, arrays.images = attributes.materials, attributes.images
        _put_corners(arrays, attributes.corner, "texcoord" in attributes.corner if split is None else split)
        arrays.face = {_without_suffix(name, arrays.vertex): values for name, values in arrays.face.items()}
    arrays.face.update(sources_of(mesh))
    return arrays


def sources_of(mesh: Any) -> Data:
    """Source operand and source face per triangle, by the names above; nothing where a mesh is no result."""
    if mesh.source_faces is None:
        return {}
    return {SOURCE_OPERAND: np.array(mesh.source_operands), SOURCE_FACE: np.array(mesh.source_faces)}


def _copies(data: Mapping[str, NDArray[Any]]) -> Data:
    return {name: np.array(values) for name, values in data.items()}


def _without_suffix(name: str, vertex: Data) -> str:
    short = name.removesuffix(CELL)
    return short if short in vertex else name


def _put_corners(arrays: Arrays, corner: Data, split: bool) -> None:
    """Makes values on corners values on vertices. Vertices keep their numbers; copies come last."""
    if not corner or not len(arrays.triangles):
        return
    corners = np.asarray(arrays.triangles.reshape(-1), np.int64)
    first: NDArray[np.int64] = np.zeros(len(arrays.vertices), np.int64)
    first[corners[::-1]] = np.arange(len(corners))[::-1]
    if split:
        copies, numbers = _copies_of(corners, first, corner)
        arrays.triangles = numbers.reshape(-1, 3).astype(np.uint32)
        arrays.vertices = np.concatenate([arrays.vertices, arrays.vertices[corners[copies]]])
        for name, values in arrays.vertex.items():
            arrays.vertex[name] = np.concatenate([values, values[corners[copies]]])
        first = np.concatenate([first, copies])
    for name, values in corner.items():
        arrays.vertex[name] = values[first]


def _copies_of(
    corners: NDArray[np.int64], first: NDArray[np.int64], values: Data
) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """
    Where corners have other values than the first corner at their vertex, bit by bit.

    Returns
    -------
    copies : array
        A corner for each further vertex, with its values.
    numbers : array
        Per corner the number of its vertex now.
    """
    bits = np.hstack([np.ascontiguousarray(array).view(np.uint8).reshape(len(corners), -1) for array in values.values()])
    apart = np.flatnonzero((bits != bits[first[corners]]).any(axis=1))
    numbers = corners.copy()
    if not len(apart):
        return apart, numbers
    at = corners[apart].astype(">u4").reshape(-1, 1).view(np.uint8)
    _, chosen, copy = np.unique(np.hstack([at, bits[apart]]), axis=0, return_index=True, return_inverse=True)
    numbers[apart] = len(first) + copy.reshape(-1)
    return apart[chosen], numbers


def attributes_from(
    vertex: Mapping[str, Any],
    face: Mapping[str, Any],
    more: Iterable[_native.Channel] = (),
    materials: Iterable[Material] = (),
    images: Iterable[Image] = (),
) -> _native.Attributes:
    """
    Of arrays that other libraries have on vertices and faces.

    What no channel can hold, such as texts and tensors, is left out with a warning.
    """
    channels = [*more, *_channels(vertex, "vertex", set())]
    channels += _channels(face, "face", {channel.name for channel in channels})
    return _native.Attributes(channels, materials=materials, images=images)


def _channels(data: Mapping[str, Any], element: Element, taken: set[str]) -> Iterator[_native.Channel]:
    for name, values in data.items():
        if name in (SOURCE_OPERAND, SOURCE_FACE):
            continue
        try:
            yield _channel(name + CELL if name in taken else name, np.asarray(values), element)
        except (TypeError, ValueError) as error:
            warnings.warn(f"not carried: {error}", stacklevel=2)


def _channel(name: str, values: NDArray[Any], element: Element) -> _native.Channel:
    if values.dtype.kind == "b":
        return _native.Channel(name, values.astype(np.uint8), element, "nearest")
    is_direction = values.dtype.kind == "f" and values.shape[1:] == (3,) and name.lower() in ("normal", "normals")
    return _native.Channel(name, values, element, "spherical" if is_direction else None)
