"""What the conversions to other libraries have in common."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

#: Names of the attributes that say which face of which operand a triangle is part of.
SOURCE_OPERAND = "strata_source_operand"
SOURCE_FACE = "strata_source_face"


def arrays_of(mesh: Any) -> tuple[NDArray[np.float64], NDArray[np.uint32]]:
    """Copies of the vertices and triangles of a Mesh, Solid or Surface: the other library may write to them."""
    return np.array(mesh.vertices), np.array(mesh.triangles)


def sources_of(mesh: Any) -> dict[str, NDArray[np.uint32]]:
    """Source operand and source face per triangle, by the names above; nothing where a mesh is no result."""
    if mesh.source_faces is None:
        return {}
    return {SOURCE_OPERAND: np.array(mesh.source_operands), SOURCE_FACE: np.array(mesh.source_faces)}
