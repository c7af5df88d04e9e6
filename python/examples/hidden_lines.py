"""A line drawing with hidden lines removed, by the painter's order

Paint the faces of solids from the farthest to the nearest, and what remains is what one sees. For that an order must
exist. Often it does not: three beams may overlap in a cycle, each before the next. `layers` finds an order, and cuts
faces where there is none: no piece of a layer is behind a piece of the same layer or of one before, on any ray.

So an edge of a piece is hidden where a piece of a later layer covers it. This is decided with fractions, too, and the
drawing is right at any zoom.
"""

# %% Solids that overlap in a cycle
# Three beams, each over the next and under the last, and a block with a hole that one of them goes through.

from __future__ import annotations

import tempfile
from collections import defaultdict
from collections.abc import Iterator
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import strata_csg as st
from numpy.typing import NDArray

Floats = NDArray[np.float64]

beams = [st.box((-4, 1, -0.25), (4.5, 2, 0.25)).transformed([[1, 0, 0, 0], [0, 1, 0, 0], [0.25, 0, 1, 0]])]
for _ in range(2):
    beams.append(beams[-1].rotated((0, 0, 1), 120, exact=True))
block = st.box((3.5, 0.5, -0.5), (4, 2.5, 2)) - st.box((3, 0.75, 0), (5, 2.25, 1.5))
solids = [*beams, block]
assert not st.contacts(solids)

# %% Layers
# The picture is a parallel projection along `VIEW`. Layers count from the farthest.

VIEW = (1, 2, -3)
layers = st.layers(solids, direction=VIEW)
meshes = [layers.mesh(layer) for layer in range(1, len(layers) + 1)]
pieces = sum(len(mesh.triangles) for mesh in meshes)
print(f"{sum(len(solid.triangles) for solid in solids)} triangles, {pieces} pieces in {len(layers)} layers")
assert len(layers) >= 2

# %% Projection
# The axes of the picture are integer vectors at right angles to the view, so that projected points are fractions.
# Only the numbers that are written are divided by the lengths of these vectors.

RIGHT = (VIEW[1], -VIEW[0], 0)
DOWN = (VIEW[0] * VIEW[2], VIEW[1] * VIEW[2], -(VIEW[0] ** 2 + VIEW[1] ** 2))
LENGTHS = np.linalg.norm([RIGHT, DOWN], axis=1)

Point = tuple[Fraction, Fraction]


def projected(points: Any) -> list[Point]:
    return [(Fraction(np.dot(point, RIGHT)), Fraction(np.dot(point, DOWN))) for point in points]


def side(p: Point, q: Point, r: Point) -> Fraction:
    """Positive, zero, negative: r is on the left, on, on the right of the line from p to q."""
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])


# %% Outlines
# An edge of a piece is drawn where it lies on an edge of the solid between faces that are not coplanar. Edges that
# come from cutting, and from triangulating, are not drawn.


def cross(a: Any, b: Any) -> tuple[Fraction, ...]:
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
        if any(any(cross(normals[0], normal)) for normal in normals[1:]):
            for number, _ in faces:
                result[number].append((p, q))
    return result


def outlines_of(mesh: st.Mesh, sharp: list[dict[int, list[tuple[Any, Any]]]]) -> Iterator[tuple[int, int, int]]:
    """Edges of pieces that lie on sharp edges of solids, with the third vertex of the piece: numbers of vertices."""
    exact = mesh.exact_vertices
    assert mesh.source_operands is not None and mesh.source_faces is not None
    sources = zip(mesh.source_operands.tolist(), mesh.source_faces.tolist())
    for triangle, (solid, face) in zip(mesh.triangles.tolist(), sources):
        for i in range(3):
            a, b, c = triangle[i], triangle[i - 2], triangle[i - 1]
            for p, q in sharp[solid][face]:
                if not any(cross(q - p, exact[a] - p)) and not any(cross(q - p, exact[b] - p)):
                    yield a, b, c


# %% What hides what
# The part of a segment inside a triangle is an interval of its parameter. What none of the nearer pieces covers is
# visible. Faces are cut where others hide them, so a segment may run along the common side of two pieces. Therefore
# an edge counts as a line just beside it, on the side of its own piece.

Triangle = tuple[Point, Point, Point]


def covered(a: Point, b: Point, inner: Point, triangle: Triangle) -> tuple[Fraction, Fraction]:
    """
    Between which parameters the segment from a to b is inside a triangle: the first is greater where it is outside.

    A segment along a side is inside where the point `inner` is on the same side of it as the triangle.
    """
    p, q, r = triangle
    lower, upper = Fraction(0), Fraction(1)
    turn = 1 if side(p, q, r) > 0 else -1
    for begin, end in ((p, q), (q, r), (r, p)):
        at_a, at_b = turn * side(begin, end, a), turn * side(begin, end, b)
        if at_a == at_b == 0:
            at_a = at_b = turn * side(begin, end, inner)
        if at_a <= 0 and at_b <= 0:
            return Fraction(1), Fraction(0)
        if at_a < 0:
            lower = max(lower, at_a / (at_a - at_b))
        elif at_b < 0:
            upper = min(upper, at_a / (at_a - at_b))
    return lower, upper


def visible(a: Point, b: Point, inner: Point, nearer: list[Triangle]) -> Iterator[tuple[Fraction, Fraction]]:
    """The intervals of a segment that no triangle covers."""
    end = Fraction(0)
    for lower, upper in sorted(covered(a, b, inner, triangle) for triangle in nearer):
        if lower >= upper:
            continue
        if lower > end:
            yield end, lower
        end = max(end, upper)
    if end < 1:
        yield end, Fraction(1)


def boxes_of(shapes: list[Any]) -> Floats:
    """Boxes of the projected shapes, in doubles and a little larger: least and greatest coordinates."""
    points = np.array([[[float(x) for x in point] for point in shape] for shape in shapes])
    return np.hstack([points.min(axis=1) - 1e-9, points.max(axis=1) + 1e-9])


Segment = tuple[Point, Point]


def drawing() -> tuple[list[list[Triangle]], set[Segment]]:
    """The pieces of every layer, projected, and the visible parts of outlines."""
    sharp = [sharp_edges(solid) for solid in solids]
    painted: list[list[Triangle]] = []
    lines: set[Segment] = set()
    nearer: list[Triangle] = []
    for mesh in reversed(meshes):
        places = projected(mesh.exact_vertices)
        boxes = boxes_of(nearer) if nearer else np.empty((0, 4))
        for numbers in outlines_of(mesh, sharp):
            a, b, inner = (places[number] for number in numbers)
            box = boxes_of([(a, b)])[0]
            over = np.flatnonzero((boxes[:, :2] <= box[2:]).all(axis=1) & (boxes[:, 2:] >= box[:2]).all(axis=1))
            for begin, end in visible(a, b, inner, [nearer[i] for i in over]):
                p, q = ((a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])) for t in (begin, end))
                lines.add((min(p, q), max(p, q)))
        painted.insert(0, [(places[i], places[j], places[k]) for i, j, k in mesh.triangles.tolist()])
        nearer += painted[0]
    return painted, lines


painted, lines = drawing()
print(f"{len(lines)} visible lines")

# %% The file
# Faces are painted from the farthest layer to the nearest, in a grey that tells their layer, and lines are drawn over
# them.


def path(points: Any) -> str:
    return "M" + "L".join(f"{float(x) / LENGTHS[0]:.6g} {float(y) / LENGTHS[1]:.6g}" for x, y in points)


def picture() -> str:
    corners = boxes_of([triangle for layer in painted for triangle in layer]) / np.tile(LENGTHS, 2)
    (left, top), (right, bottom) = corners[:, :2].min(axis=0) - 0.2, corners[:, 2:].max(axis=0) + 0.2
    parts = [
        '<svg xmlns="http://www.w3.org/2000/svg" width="800" '
        f'viewBox="{left:.4f} {top:.4f} {right - left:.4f} {bottom - top:.4f}">'
    ]
    for number, layer in enumerate(painted):
        grey = f"hsl(40,30%,{80 + 16 * number // len(painted)}%)"
        faces = "".join(path(triangle) + "Z" for triangle in layer)
        parts.append(f'<path fill="{grey}" stroke="{grey}" stroke-width="0.005" d="{faces}"/>')
    outlines = "".join(path(segment) for segment in sorted(lines))
    parts.append(f'<path fill="none" stroke="#000" stroke-width="0.03" stroke-linecap="round" d="{outlines}"/>')
    return "\n".join([*parts, "</svg>\n"])


file = Path(tempfile.mkdtemp()) / "beams.svg"
file.write_text(picture(), encoding="utf-8")
print(f"{file.name}: {file.stat().st_size:,} bytes")

# %% Checked by rays
# What is painted last at a point of the picture is what a ray from the eye meets first. `RayCaster` decides that by
# other means.


def last_painted(point: Point) -> tuple[int, int]:
    """The solid and the face of the nearest piece over a point of the picture; -1 where there is none."""
    for mesh, layer in zip(reversed(meshes), reversed(painted)):
        assert mesh.source_operands is not None and mesh.source_faces is not None
        for number, (p, q, r) in enumerate(layer):
            sides = {side(p, q, point) > 0, side(q, r, point) > 0, side(r, p, point) > 0}
            if len(sides) == 1:
                return int(mesh.source_operands[number]), int(mesh.source_faces[number])
    return -1, -1


generator = np.random.default_rng(7)
origins = generator.uniform(-4, 4, (300, 3)).round(3) - 100 * np.array(VIEW)
first = st.RayCaster(solids).first(origins, np.tile(np.array(VIEW, np.float64), (300, 1)))
hits = list(zip(first["solid"].tolist(), first["face"].tolist()))
exact_origins = [[Fraction(x) for x in origin] for origin in origins.tolist()]
assert [last_painted(point) for point in projected(exact_origins)] == hits
print(f"{sum(solid >= 0 for solid, _ in hits)} of 300 rays meet a solid, and all agree with the picture")
