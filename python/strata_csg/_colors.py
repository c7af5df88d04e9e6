"""Colours that meshes carry, as bytes of a screen."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from strata_csg import _native
from strata_csg._attributes import Material

Bytes = NDArray[np.uint8]


def of_materials(materials: Sequence[Material], numbers: NDArray[Any]) -> Bytes:
    """
    Colours and opacity of faces, shape (n, 4), from the numbers of their materials; white where there is none.

    Materials have the colours of light, screens those of IEC 61966-2-1.
    """
    colors = np.clip([*(material.color for material in materials), (1.0, 1.0, 1.0, 1.0)], 0, 1)
    light = colors[:, :3]
    colors[:, :3] = np.where(light <= 0.0031308, 12.92 * light, 1.055 * light ** (1 / 2.4) - 0.055)
    known = (numbers >= 0) & (numbers < len(materials))
    return np.asarray(_bytes_of(colors)[np.where(known, numbers, len(materials))])


def of_corners(mesh: Any, triangles: NDArray[np.int64], drawn: NDArray[np.bool_]) -> Bytes | None:
    """
    Colours at the corners of those triangles of a mesh that are drawn, shape (n, 3, 3).

    They are those of the channel "color", or else of materials, without their images; None where there is neither.
    """
    attributes = getattr(mesh, "attributes", None)
    if not isinstance(attributes, _native.Attributes):
        return None
    for channel in attributes.channels:
        if channel.name == "color" and channel.values.ndim == 2 and channel.values.shape[1] >= 3:
            return _at_corners(channel, triangles, drawn)
    numbers = attributes.face.get("material")
    if numbers is None or numbers.ndim != 1 or not attributes.materials:
        return None
    return _on_all_corners(of_materials(attributes.materials, numbers[drawn]))


def _at_corners(channel: _native.Channel, triangles: NDArray[np.int64], drawn: NDArray[np.bool_]) -> Bytes:
    values = _bytes_of(channel.values[:, :3])
    if channel.element == "vertex":
        return np.asarray(values[triangles])
    if channel.element == "corner":
        return np.asarray(values.reshape(-1, 3, 3)[drawn])
    return _on_all_corners(values[drawn])


def _on_all_corners(colors: Bytes) -> Bytes:
    return np.repeat(colors[:, None, :3], 3, axis=1)


def _bytes_of(colors: NDArray[Any]) -> Bytes:
    """Of bytes, or of floats from 0 to 1."""
    if colors.dtype == np.uint8:
        return colors
    return np.asarray(np.rint(255 * np.clip(np.nan_to_num(colors), 0, 1)), np.uint8)
