"""What pickle calls: functions of the extension module have no place of their own that pickle could name."""

from __future__ import annotations

from typing import Any

from strata_csg import _native


def attributes(channels: Any, materials: Any, images: Any, objects: Any, groups: Any) -> _native.Attributes:
    return _native.Attributes(channels, materials=materials, images=images, objects=objects, groups=groups)


def mesh(*parts: Any) -> _native.Mesh:
    return _native._mesh_of(*parts)


def solid(*parts: Any) -> Any:
    return _native._solid_of(*parts)


def polygons(text: str) -> _native.Polygons:
    return _native.Polygons.parse(text)
