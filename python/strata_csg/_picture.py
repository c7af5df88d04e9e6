"""The geometry that the viewer of `_notebook` draws: parts in a common frame, and their edges."""

from __future__ import annotations

import base64
import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

from strata_csg._colors import Bytes, of_corners

Floats = NDArray[np.float64]
Indices = NDArray[np.int64]


@dataclass
class Part:
    """
    The triangles of a mesh that can be drawn.

    Attributes
    ----------
    mesh : object, or None
        Where they come from; it may have exact coordinates.
    omitted : int
        How many triangles cannot be drawn: numbers out of range, coordinates that are not finite.
    edges : pairs of vertices
        Those that are drawn.
    colors : bytes, or None
        What the mesh carries, at the corners of triangles, shape (n, 3, 3).
    vertex_colors : bytes, or None
        The same at the vertices of a placed part, shape (n, 3).
    """

    vertices: Floats
    triangles: Indices
    mesh: Any = None
    omitted: int = 0
    edges: Indices = field(default_factory=lambda: np.empty((0, 2), np.int64))
    colors: Bytes | None = None
    vertex_colors: Bytes | None = None

    def corners(self) -> Indices:
        """The numbers of the vertices that triangles have."""
        return np.unique(self.triangles)


def part_of(mesh: Any, *, colored: bool = True) -> Part:
    """Of a mesh: anything with `vertices` and `faces`; with its own colours, or without."""
    vertices = np.asarray(mesh.vertices, np.float64).reshape(-1, 3)
    triangles = np.asarray(mesh.faces).astype(np.int64).reshape(-1, 3)
    drawn = np.asarray(((triangles >= 0) & (triangles < len(vertices))).all(axis=1))
    finite = np.asarray(np.isfinite(vertices).all(axis=1))
    drawn[drawn] = finite[triangles[drawn]].all(axis=1)
    colors = of_corners(mesh, triangles[drawn], drawn) if colored else None
    return Part(vertices, triangles[drawn], mesh=mesh, omitted=len(drawn) - int(drawn.sum()), colors=colors)


class Frame:
    """
    The box of all parts. Places are relative to its middle, in halves of its diagonal, so that they fit floats.

    Coordinates are scaled by a power of two first, which rounds nothing and overflows nowhere. The middle is subtracted
    in doubles then. Where this leaves few digits, and vertices have more, it is subtracted from fractions.

    Parameters
    ----------
    lower, upper : arrays of three doubles
        Corners of the box.
    """

    def __init__(self, lower: Floats, upper: Floats) -> None:
        self.lower, self.upper = lower, upper
        self._exponent = int(np.frexp(max(np.abs(lower).max(), np.abs(upper).max()))[1])
        self._low = np.ldexp(lower, -self._exponent)
        self._half = (np.ldexp(upper, -self._exponent) - self._low) / 2
        self._unit = float(np.linalg.norm(self._half))
        self.is_narrow = self._unit < 2.0**-30

    @staticmethod
    def around(parts: Sequence[Part]) -> Frame | None:
        """None where there is no triangle."""
        corners = [part.vertices[part.corners()] for part in parts if len(part.triangles)]
        if not corners:
            return None
        drawn = np.concatenate(corners)
        return Frame(np.asarray(drawn.min(axis=0), np.float64), np.asarray(drawn.max(axis=0), np.float64))

    @property
    def noise(self) -> float:
        """How far places are from where they belong, at most; a billionth at least."""
        return 1e-9 + 2.0**-50 / (self._unit or 1.0)

    @property
    def digits(self) -> int:
        """So many digits of coordinates tell the corners of the box apart, and some places in it."""
        return min(17, 9 - min(0, round(math.log10(self._unit or 1e-17))))

    def placed(self, vertices: Floats) -> Floats:
        """The places of vertices."""
        scaled = np.ldexp(vertices, -self._exponent)
        return np.asarray(((scaled - self._low) - self._half) / (self._unit or 1.0))

    def box(self) -> Part:
        """The edges of the box."""
        signs = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], np.float64)
        edges = [[a, a | bit] for a in range(8) for bit in (1, 2, 4) if not a & bit]
        places = signs * self._half / (self._unit or 1.0)
        return Part(places, np.empty((0, 3), np.int64), edges=np.array(edges, np.int64))


def placed_parts(parts: Sequence[Part], frame: Frame) -> list[Part]:
    """The parts in the frame, with their edges. Vertices of a part at one place and of one colour are joined."""
    places = [frame.placed(part.vertices[part.corners()]) for part in parts]
    noise = frame.noise
    if frame.is_narrow:
        exact = _exactly_placed(parts)
        places, noise = (exact, 1e-9) if exact is not None else (places, noise)
    return [_joined(part, where + 0.0, noise) for part, where in zip(parts, places)]  # + 0.0: no -0.0


def _joined(part: Part, places: Floats, noise: float) -> Part:
    if not len(part.triangles):
        return Part(np.empty((0, 3)), part.triangles)
    _, triangles = np.unique(part.triangles, return_inverse=True)
    vertices, numbers = np.unique(places, axis=0, return_inverse=True)
    joined = numbers.reshape(-1)[triangles.reshape(-1)].reshape(-1, 3)
    edges = drawn_edges(vertices, joined, noise)
    return Part(vertices, joined, edges=edges) if part.colors is None else _colored(vertices, joined, edges, part.colors)


def _colored(vertices: Floats, triangles: Indices, edges: Indices, colors: Bytes) -> Part:
    """A part with a vertex for each colour at a place."""
    corners = np.hstack([triangles.reshape(-1, 1), colors.reshape(-1, 3)])
    rows, numbers = np.unique(corners, axis=0, return_inverse=True)
    first = np.searchsorted(rows[:, 0], np.arange(len(vertices)))
    tints = rows[:, 1:].astype(np.uint8)
    return Part(vertices[rows[:, 0]], numbers.reshape(-1, 3), edges=first[edges], vertex_colors=tints)


def _exactly_placed(parts: Sequence[Part]) -> list[Floats] | None:
    """Places of corners by differences of fractions; None where all are at one place."""
    corners = [_exact_corners(part) for part in parts]
    points = np.concatenate(corners)
    lower, upper = points.min(axis=0), points.max(axis=0)
    middle, width = (lower + upper) / 2, max(upper - lower)
    if width == 0:
        return None
    # Halves of the diagonal are at most sqrt(3) halves of the greatest width.
    return [((corner - middle) / width).astype(np.float64) * (2 / math.sqrt(3)) for corner in corners]


def _exact_corners(part: Part) -> NDArray[Any]:
    """Coordinates of the corners of triangles, as fractions."""
    used = part.corners()
    exact = getattr(part.mesh, "exact_vertices", None) if np.isfinite(part.vertices).all() else None
    if exact is not None:
        return np.asarray(exact)[used]
    fractions = [Fraction(x) for x in part.vertices[used].reshape(-1).tolist()]
    return np.array(fractions, dtype=object).reshape(-1, 3)


def drawn_edges(vertices: Floats, triangles: Indices, noise: float) -> Indices:
    """
    The edges that are not between two coplanar triangles, as pairs of vertices.

    For a picture doubles suffice: two triangles are coplanar where the apex of the smaller one is in the plane of the
    larger one, up to `noise`, and beyond their common edge.
    """
    ends = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    apexes = np.concatenate([triangles[:, 2], triangles[:, 0], triangles[:, 1]])
    ends.sort(axis=1)
    order = np.argsort(ends[:, 0] * len(vertices) + ends[:, 1], kind="stable")
    ends, apexes = ends[order], apexes[order]
    starts = np.flatnonzero(np.r_[True, np.any(ends[1:] != ends[:-1], axis=1)])
    sizes = np.diff(np.r_[starts, len(ends)])
    edges = ends[starts]
    drawn = edges[:, 0] != edges[:, 1]
    pairs = np.flatnonzero((sizes == 2) & drawn)
    first = starts[pairs]
    drawn[pairs] = ~_coplanar(vertices, edges[pairs], apexes[first], apexes[first + 1], noise)
    return np.asarray(edges[drawn])


def _coplanar(vertices: Floats, edges: Indices, first: Indices, second: Indices, noise: float) -> NDArray[np.bool_]:
    """Per edge, whether the triangles over it with these apexes are in one plane, on different sides of it."""
    origin = vertices[edges[:, 0]]
    along = vertices[edges[:, 1]] - origin
    a, b = vertices[first] - origin, vertices[second] - origin
    normal_a, normal_b = np.cross(along, a), np.cross(b, along)
    length_a, length_b = np.linalg.norm(normal_a, axis=1), np.linalg.norm(normal_b, axis=1)
    larger = (length_a >= length_b)[:, None]
    normal, apex = np.where(larger, normal_a, normal_b), np.where(larger, b, a)
    height = np.abs(np.einsum("ij,ij->i", normal, apex))
    beyond = np.einsum("ij,ij->i", normal_a, normal_b) >= 0
    return np.asarray((height <= noise * np.maximum(length_a, length_b)) & beyond)


def packed(parts: Sequence[Part], colors: Sequence[Any]) -> dict[str, Any]:
    """
    The arrays of placed parts one after the other, as base64 of little-endian numbers, and where each part ends.

    Colours of vertices are listed where a part has some; others have that of their part.
    """
    first = np.cumsum([0] + [len(part.vertices) for part in parts])
    vertices = np.concatenate([part.vertices for part in parts])
    triangles = np.concatenate([part.triangles + start for part, start in zip(parts, first)])
    edges = np.concatenate([part.edges + start for part, start in zip(parts, first)])
    counts = [(len(part.vertices), len(part.triangles), len(part.edges)) for part in parts]
    arrays: dict[str, Any] = {
        "positions": _base64(vertices.astype("<f4")),
        "triangles": _base64(triangles.astype("<u4")),
        "edges": _base64(edges.astype("<u4")),
        "ends": np.cumsum(counts, axis=0).tolist(),
    }
    if any(part.vertex_colors is not None for part in parts):
        arrays["colors"] = _base64(np.concatenate([_tints(part, color) for part, color in zip(parts, colors)]))
    return arrays


def _tints(part: Part, color: Any) -> Bytes:
    """A colour per vertex."""
    if part.vertex_colors is not None:
        return part.vertex_colors
    return np.tile(np.array(color, np.uint8), (len(part.vertices), 1))


def _base64(array: NDArray[Any]) -> str:
    return base64.b64encode(array.tobytes()).decode("ascii")
