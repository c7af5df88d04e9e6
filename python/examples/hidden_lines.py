"""A line drawing with hidden lines removed, by the painter's order

Paint the faces of solids from the farthest to the nearest, each in the colour of the paper with its outline in ink, and
what remains is a drawing with hidden lines removed. For that an order must exist. Often it does not: three beams may
overlap in a cycle, each before the next. `layers` finds an order, and cuts faces where there is none: no face of a layer
is behind a face of the same layer or of one before, on any ray. All its decisions are exact, and so is the picture, at any
zoom.
"""

# %% Solids that overlap in a cycle
# Three beams, each over the next and under the last, and a block with a hole that one of them goes through.

from __future__ import annotations

import tempfile
from collections import defaultdict
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import strata_csg as st
from numpy.typing import NDArray

Floats = NDArray[np.float64]

beams = [st.box((-4, 0.5, -0.25), (3, 1.5, 0.25)).transformed([[1, 0, 0, 0], [0, 1, 0.1, 0], [0.15, 0, 1, 0]])]
for _ in range(2):
    beams.append(beams[-1].rotated((0, 0, 1), 120))
block = st.box((2, -0.5, -1), (3, 2.5, 2)) - st.box((1, 0.25, -0.75), (4, 1.75, 1))
solids = [*beams, block]

# %% Layers
# The picture is a parallel projection along `VIEW`. Layers count from the farthest.

VIEW = (1.0, 2.0, -3.0)
layers = st.layers(solids, direction=VIEW)
pieces = sum(len(layers.mesh(layer).triangles) for layer in range(1, len(layers) + 1))
print(f"{sum(len(solid.triangles) for solid in solids)} triangles, {pieces} pieces in {len(layers)} layers")
assert len(layers) >= 2


def unit(vector: Any) -> Floats:
    return np.asarray(vector, np.float64) / np.linalg.norm(vector)


RIGHT = unit(np.cross(VIEW, (0, 0, 1)))
UP = unit(np.cross(RIGHT, VIEW))


def projected(points: Floats) -> Floats:
    return points @ np.array([RIGHT, -UP]).T


# %% Outlines
# An edge of a piece is drawn where it lies on an edge of the solid between faces that are not coplanar. Both questions are
# decided with fractions: edges that come from cutting, and from triangulating, are not drawn.

Point = tuple[Fraction, Fraction, Fraction]


def cross(a: Any, b: Any) -> Point:
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def sharp_edges(solid: st.Solid) -> dict[int, list[tuple[Any, Any]]]:
    """Per triangle, its edges beyond which no coplanar triangle lies."""
    points = solid.exact_vertices
    over = defaultdict(list)
    for number, triangle in enumerate(solid.triangles.tolist()):
        for i in range(3):
            over[frozenset((triangle[i], triangle[i - 1]))].append((number, triangle[i - 2]))
    result = defaultdict(list)
    for edge, faces in over.items():
        p, q = (points[vertex] for vertex in edge)
        normals = [cross(q - p, points[apex] - p) for _, apex in faces]
        if any(cross(normals[0], normal) != (0, 0, 0) for normal in normals[1:]):
            for number, _ in faces:
                result[number].append((p, q))
    return result


def is_on(a: Any, b: Any, edge: tuple[Any, Any]) -> bool:
    """Whether a and b are on the line of the edge."""
    p, q = edge
    return all(cross(q - p, point - p) == (0, 0, 0) for point in (a, b))


outlines = [sharp_edges(solid) for solid in solids]

# %% The drawing
# Every layer is filled first, then its outlines are drawn.


def path(points: Floats) -> str:
    return "M" + "L".join(f"{x:.5f} {y:.5f}" for x, y in points)


def drawn(layer: st.Mesh) -> str:
    places, exact = projected(layer.vertices), layer.exact_vertices
    assert layer.source_operands is not None and layer.source_faces is not None
    sources = zip(layer.triangles.tolist(), layer.source_operands.tolist(), layer.source_faces.tolist())
    fills, lines = [], []
    for triangle, solid, face in sources:
        fills.append(path(places[triangle]) + "Z")
        for a, b in zip(triangle, triangle[1:] + triangle[:1]):
            if any(is_on(exact[a], exact[b], edge) for edge in outlines[solid][face]):
                lines.append(path(places[[a, b]]))
    return f'<path class="face" d="{"".join(fills)}"/>\n<path class="line" d="{"".join(lines)}"/>\n'


corners = projected(np.concatenate([solid.vertices for solid in solids]))
(left, top), (width, height) = corners.min(axis=0) - 0.2, np.ptp(corners, axis=0) + 0.4
svg = (
    f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{left:.3f} {top:.3f} {width:.3f} {height:.3f}" width="800">\n'
    "<style>path{stroke-linejoin:round;stroke-linecap:round}"
    ".face{fill:#fff;stroke:#fff;stroke-width:0.01}.line{fill:none;stroke:#000;stroke-width:0.03}</style>\n"
    + "".join(drawn(layers.mesh(layer)) for layer in range(1, len(layers) + 1))
    + "</svg>\n"
)
file = Path(tempfile.mkdtemp()) / "beams.svg"
file.write_text(svg, encoding="utf-8")
print(f"{file.name}: {len(svg):,} characters")

# %% Checked by rays
# What is painted last at a point of the picture is what a ray from the eye meets first. `RayCaster` decides that by other
# means.


def last_painted(point: Floats) -> tuple[int, int] | None:
    """The solid and the face of the nearest piece over a point of the picture."""
    for number in range(len(layers), 0, -1):
        layer = layers.mesh(number)
        a, b, c = (projected(layer.vertices)[layer.triangles[:, i]] - point for i in range(3))
        sides = [p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0] for p, q in ((a, b), (b, c), (c, a))]
        over = np.flatnonzero(np.all(np.array(sides) > 0, axis=0) | np.all(np.array(sides) < 0, axis=0))
        if len(over):
            assert layer.source_operands is not None and layer.source_faces is not None
            return int(layer.source_operands[over[0]]), int(layer.source_faces[over[0]])
    return None


generator = np.random.default_rng(7)
samples = corners.min(axis=0) + generator.random((300, 2)) * np.ptp(corners, axis=0)
origins = samples @ np.array([RIGHT, -UP]) - 100 * unit(VIEW)
first = st.RayCaster(solids).first(origins, np.tile(VIEW, (300, 1)))
hits = list(zip(first["solid"].tolist(), first["face"].tolist()))
assert [last_painted(point) or (-1, -1) for point in samples] == hits
print(f"{sum(solid >= 0 for solid, _ in hits)} of 300 rays meet a solid, and all agree with the picture")
