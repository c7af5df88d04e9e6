"""What arguments may be, for annotations."""

from __future__ import annotations

import numbers
from collections.abc import Callable, Sequence
from decimal import Decimal
from fractions import Fraction
from typing import Any, Literal, Protocol, Union

#: A number, taken exactly.
Number = Union[int, float, Fraction, Decimal, numbers.Rational]

#: Three numbers: a sequence or an array.
PointLike = Union[Sequence[Number], Any]

#: A pair of a normal and an offset: the points p with normal . p = offset.
PlaneLike = tuple[PointLike, Number]

#: Three or four rows of four numbers.
MatrixLike = Union[Sequence[Sequence[Number]], Any]


class HasFaces(Protocol):
    """A mesh of another library, such as trimesh."""

    @property
    def vertices(self) -> Any: ...

    @property
    def faces(self) -> Any: ...


#: A Mesh, a Solid, a Surface, a pair (vertices, triangles) of arrays, or an object with `vertices` and `faces`.
MeshLike = Union[HasFaces, tuple[Any, Any]]

Element = Literal["vertex", "corner", "face"]
Interpolation = Literal["linear", "spherical", "nearest"]
InputClass = Literal["automatic", "solid", "overlapping", "repair", "soup"]
Operation = Literal["union", "intersection", "difference", "symmetric-difference", "xor"]

#: None, True for a bar of tqdm, or a callable that takes the fraction done.
Progress = Union[Callable[[float], object], bool, None]
