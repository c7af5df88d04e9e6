"""Exact Booleans of solids: the functions beneath strata_csg."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
import fractions
import os
from typing import Any, Literal, overload

import numpy
import numpy.typing

from strata_csg._attributes import Image, Material
from strata_csg._errors import Defect
from strata_csg._types import (
    Element,
    InputClass,
    Interpolation,
    MatrixLike,
    MeshLike,
    Number,
    Operation,
    PlaneLike,
    PointLike,
    Progress
)



version: str = '0.1.0'

class Channel:
    """
    Named values on all vertices, corners or faces of a mesh. Immutable.

    A corner is a vertex of one triangle: corner 3 t + k is the k-th of triangle t, so that neighbours may differ, as at the
    seams of a texture.

    Parameters
    ----------
    name : str
        "normal", "texcoord", "color", "material", "object" and "group" are names that files know; others are free.
    values : array_like, shape (n,) or (n, k), k from 1 to 4
        Copied: float32, float64, uint8, or integers that fit int32, which is what they become. float16 becomes float32.
    element : {"vertex", "corner", "face"}
        What the values belong to, in the order of vertices or triangles.
    interpolation : {"linear", "spherical", "nearest"}, optional
        How a value within a face follows from those at its corners: by barycentric coordinates; the same, scaled to length
        1, for directions; that of the nearest corner, for identifiers. Without: "nearest" for integers, "spherical" for
        three floats with the name "normal", else "linear".

    Raises
    ------
    TypeError, ValueError
        With the name of the channel: for other types and shapes, numbers beyond 32 bits, another element or interpolation
        than those above, integers that are not "nearest", bytes that are "spherical".

    Examples
    --------
    >>> channel = Channel("temperature", [20.0, 25.0, 22.5])
    >>> channel
    Channel('temperature', (3,) float64 per vertex, linear)
    >>> channel.values.tolist()
    [20.0, 25.0, 22.5]
    """

    def __init__(self, name: str, values: numpy.typing.ArrayLike, element: Element = 'vertex', interpolation: Interpolation | None = None) -> None: ...

    @property
    def name(self) -> str:
        """The name by which attributes find it."""

    @property
    def values(self) -> numpy.typing.NDArray[Any]:
        """Shape (n,) for one component, else (n, k). Read-only."""

    @property
    def element(self) -> Element:
        """What the values belong to."""

    @property
    def interpolation(self) -> Interpolation:
        """How values between corners follow from theirs."""

    def __eq__(self, other: object, /) -> bool: ...

    def __hash__(self) -> int: ...

    def __repr__(self) -> str: ...

    def __reduce__(self) -> tuple[Any, ...]: ...

    def __copy__(self) -> object: ...

    def __deepcopy__(self, memo: object) -> object: ...

class Attributes:
    """
    What a mesh carries beside its shape: channels of numbers, materials, images and names.

    Like a mapping of names of channels to arrays: ``attributes["color"]``. Immutable: arrays are read-only, and own their
    memory. Equal where everything is, in the same order.

    Parameters
    ----------
    channels : iterable of Channel
    vertex, corner, face : mapping of str to array_like, optional
        More channels, on these elements, with the usual interpolation; see Channel.
    materials : iterable of Material
        What the integers of a channel "material" on faces refer to; -1 is none.
    images : iterable of Image
        What materials refer to.
    objects, groups : iterable of str
        Names that the channels "object" and "group" on faces refer to, in the same way.

    Raises
    ------
    TypeError, ValueError
        With the name of the channel: where two have one name, where numbers of elements disagree, for an index beyond its
        list, and for what Channel refuses.

    Examples
    --------
    >>> attributes = Attributes(
    ...     vertex={"temperature": [20.0, 25.0, 22.5, 21.0]},
    ...     face={"material": [0, 0, 1, -1]},
    ...     materials=[Material("steel", metallic=1), Material("paint", color=(0.8, 0, 0))],
    ... )
    >>> attributes
    Attributes(temperature: (4,) float64 per vertex, material: (4,) int32 per face, 2 materials)
    >>> attributes["material"].tolist(), attributes.materials[1].name
    ([0, 0, 1, -1], 'paint')
    >>> tetrahedron_of = Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]],
    ...                       attributes=attributes)
    >>> part = Solid(tetrahedron_of) - box((0, 0, 0), (1, 1, 0.5))
    >>> sorted(set(part.attributes["material"].tolist()))
    [-1, 0, 1]
    """

    def __init__(self, channels: Iterable[Channel] = (), *, vertex: Mapping[str, numpy.typing.ArrayLike] | None = None, corner: Mapping[str, numpy.typing.ArrayLike] | None = None, face: Mapping[str, numpy.typing.ArrayLike] | None = None, materials: Iterable[Material] = (), images: Iterable[Image] = (), objects: Iterable[str] = (), groups: Iterable[str] = ()) -> None: ...

    def with_channels(self, *channels: Channel) -> Attributes:
        """
        The same with more channels; one of a name that there is already takes its place.

        Examples
        --------
        >>> Attributes(face={"id": [0, 1]}).with_channels(Channel("id", [5, 6], "face"), Channel("heat", [0.5, 1.5], "face"))
        Attributes(id: (2,) int32 per face, heat: (2,) float64 per face)
        """

    def only(self, names: Iterable[str]) -> Attributes:
        """
        The channels with these names, and the lists that they refer to.

        Examples
        --------
        >>> Attributes(face={"id": [0, 1], "heat": [0.5, 1.5]}).only(["heat"])
        Attributes(heat: (2,) float64 per face)
        """

    def __eq__(self, other: object, /) -> bool: ...

    def __hash__(self) -> int: ...

    def __repr__(self) -> str: ...

    def __reduce__(self) -> tuple[Any, ...]: ...

    @property
    def channels(self) -> tuple[Channel, ...]:
        """All channels in their order, with element and interpolation."""

    @property
    def vertex(self) -> dict[str, numpy.typing.NDArray[Any]]:
        """The arrays of the channels on vertices, by name."""

    @property
    def corner(self) -> dict[str, numpy.typing.NDArray[Any]]:
        """
        The arrays of the channels on corners, by name: three values per triangle.
        """

    @property
    def face(self) -> dict[str, numpy.typing.NDArray[Any]]:
        """The arrays of the channels on faces, by name."""

    @property
    def materials(self) -> tuple[Material, ...]:
        """What the channel "material" refers to."""

    @property
    def images(self) -> tuple[Image, ...]:
        """What materials refer to. O(bytes)."""

    @property
    def objects(self) -> tuple[str, ...]:
        """Names, which the channel "object" refers to."""

    @property
    def groups(self) -> tuple[str, ...]:
        """Names, which the channel "group" refers to."""

    def __getitem__(self, name: str, /) -> numpy.typing.NDArray[Any]: ...

    def __contains__(self, name: object, /) -> bool: ...

    def __iter__(self) -> Iterator[str]: ...

    def __len__(self) -> int: ...

    def __bool__(self) -> bool: ...

    def keys(self) -> list[str]:
        """The names of the channels in their order."""

    def get(self, name: str, default: Any = None) -> Any:
        """
        The values of a channel, or the default where there is none of that name.
        """

    def __copy__(self) -> object: ...

    def __deepcopy__(self, memo: object) -> object: ...

class Mesh:
    """
    A triangle mesh: arrays of vertices and of triangles. No invariant, nothing checked.

    Parameters
    ----------
    vertices : array_like, shape (n, 3)
        Coordinates in model units, taken exactly. C-contiguous float64 is looked at, not copied. An array of objects
        (int, Fraction, Decimal) is taken exactly, too.
    triangles : array_like of integers, shape (m, 3)
        Numbers of vertices, counter-clockwise seen from outside. C-contiguous uint32 is looked at, not copied.
    attributes : Attributes, optional
        What the mesh carries: colours, texture coordinates, materials and so on.
    unit : str, optional
        Of coordinates: "micron", "millimeter", "centimeter", "inch", "foot", "meter", or the short "um", "mm", "cm", "in",
        "ft", "m". Nothing is converted.

    Raises
    ------
    TypeError, ValueError
        For arrays of other types and shapes, for negative indices, and where attributes have another number of values.

    Notes
    -----
    Meshes are equal where vertices, triangles, attributes and units are. Results of `boolean` are meshes, too, with the source of every triangle. Meshes are immutable, but arrays that are
    looked at are the caller's: nothing may write to them while a computation uses them.

    Examples
    --------
    >>> mesh = Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
    >>> mesh
    Mesh(4 vertices, 4 triangles)
    >>> Solid(mesh).volume
    Fraction(1, 6)
    """

    def __init__(self, vertices: numpy.typing.ArrayLike, triangles: numpy.typing.ArrayLike, *, attributes: Attributes | None = None, unit: str | None = None) -> None: ...

    @property
    def vertices(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        Coordinates, shape (n, 3), rounded to the nearest doubles where they are not doubles.
        """

    @property
    def triangles(self) -> numpy.typing.NDArray[numpy.uint32]:
        """Numbers of vertices, shape (m, 3)."""

    @property
    def faces(self) -> numpy.typing.NDArray[numpy.uint32]:
        """The triangles, by the name that trimesh gives them."""

    @property
    def exact_vertices(self) -> numpy.typing.NDArray[numpy.object_]:
        """
        Exact coordinates as an array of objects, shape (n, 3), of fractions.Fraction. O(n).
        """

    @property
    def exact_parts(self) -> tuple[numpy.typing.NDArray[numpy.uint32], numpy.typing.NDArray[numpy.object_], numpy.typing.NDArray[numpy.object_]]:
        """
        Of the vertices that are not three doubles: their numbers (k,), numerators and denominators (k, 3), ints.
        """

    @property
    def attributes(self) -> Attributes | None:
        """What the mesh carries; None where it is nothing."""

    @property
    def unit(self) -> str | None:
        """Of coordinates, where somebody said one."""

    @property
    def source_operands(self) -> numpy.typing.NDArray[numpy.uint32] | None:
        """
        Per triangle of a result, the operand that it is part of, from 0. None for other meshes.
        """

    @property
    def source_faces(self) -> numpy.typing.NDArray[numpy.uint32] | None:
        """
        Per triangle of a result, the triangle of that operand that it is part of. None for other meshes.
        """

    @property
    def notes(self) -> tuple[Defect, ...]:
        """Of a result: what was resolved in operands on the way in."""

    @property
    def file_notes(self) -> tuple[str, ...]:
        """
        Of a mesh that was read: what was left out or decided, a sentence each.
        """

    @property
    def rounding(self) -> dict[str, int | float] | None:
        """
        Of a rounded result: rounds, moved_vertices, largest_movement, unit, far_vertices, vanished_faces, vanished_components.
        """

    @property
    def seconds(self) -> dict[str, float]:
        """Of a result: the time that each stage took."""

    def __repr__(self) -> str: ...

    def _repr_html_(self) -> str:
        """A viewer, for notebooks."""

    def __eq__(self, other: object, /) -> bool: ...

    def __hash__(self) -> int: ...

    def __reduce__(self) -> tuple[Any, ...]: ...

    def __copy__(self) -> object: ...

    def __deepcopy__(self, memo: object) -> object: ...

def _mesh_of(vertices: object, triangles: object, rest: dict[str, Any]) -> Mesh:
    """What pickle calls for a Mesh."""

class Solid:
    """
    A bounded solid, given by its boundary: a closed triangle mesh. An immutable value.

    Operations are exact: vertices are doubles or, where operations made them, fractions. `|` is union, `&` intersection,
    `-` difference, `^` symmetric difference; `~` is the complement, an Expression. Solids are equal when they are the same
    set of points, however they are triangulated and whatever they carry, and may be keys of dictionaries.

    What meshes carry, such as colours and materials, goes through all operations: `attributes`. Of coincident faces the
    first operand speaks; faces that a cut makes belong to the operand that cut, or are of a material of their own.

    Parameters
    ----------
    mesh : Mesh, pair of arrays, or an object with `vertices` and `faces`, as of trimesh; without: the empty solid
        Attributes of a Mesh are carried; its unit is not.
    input : {"automatic", "solid", "overlapping", "repair", "soup"}
        What is expected of the mesh. "automatic": closed; what crosses itself is resolved, which `notes` say. "solid": the
        caller's promise that nothing crosses itself. "overlapping": inside is where the winding number is positive.
        "repair": any triangles; doubled faces and orientation are mended. "soup": any triangles; holes are filled.
    most_hole_edges : int, optional
        For "soup": holes of more edges are refused.
    threads : int
        0: all cores. Results do not depend on it.
    progress : callable, True or None
        Called with the fraction done; True shows a bar where tqdm is installed.
    timeout : float, optional
        Seconds, after which TimeoutError is raised.

    Raises
    ------
    InputError
        The mesh is not what was expected; its `defects` say what and where.

    Examples
    --------
    >>> corner = Solid(([[0, 0, 0], [4, 0, 0], [0, 4, 0], [0, 0, 4]], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]))
    >>> (corner - corner.translated((1, 0, 0))).volume
    Fraction(37, 6)
    """

    @overload
    def __init__(self) -> None: ...

    @overload
    def __init__(self, mesh: MeshLike, *, input: InputClass = 'automatic', most_hole_edges: int | None = None, threads: int = 0, progress: Progress | None = None, timeout: float | None = None) -> None: ...

    @staticmethod
    def trusted(mesh: MeshLike) -> Solid:
        """
        Of a mesh that is known to bound a solid, such as a result: nothing is checked.

        Results are unspecified where it does not bound one.

        Examples
        --------
        >>> a, b = box((0, 0, 0), (2, 2, 2)), box((1, 1, 1), (3, 3, 3))
        >>> Solid.trusted(boolean("union", [a, b], exact=True)) == a | b
        True
        """

    def __or__(self, arg: Solid, /) -> Solid: ...

    def __and__(self, arg: Solid, /) -> Solid: ...

    def __sub__(self, arg: Solid, /) -> Solid: ...

    def __xor__(self, arg: Solid, /) -> Solid: ...

    def __eq__(self, other: object, /) -> bool: ...

    def __hash__(self) -> int: ...

    def __bool__(self) -> bool: ...

    def __repr__(self) -> str: ...

    @staticmethod
    def from_trimesh(mesh: object, **options: object) -> Solid:
        """The solid that a trimesh.Trimesh bounds; options are those of Solid."""

    def to_trimesh(self) -> Any:
        """The boundary as a trimesh.Trimesh, in nearest doubles."""

    def _repr_html_(self) -> str:
        """The solid in a viewer, for notebooks."""

    def with_attributes(self, attributes: Attributes | None) -> Solid:
        """
        The same solid with these attributes in place of its own; None for nothing.

        Raises
        ------
        ValueError
            Where they do not fit the boundary, with the name of the channel.

        Examples
        --------
        >>> block = box((0, 0, 0), (2, 2, 2)).with_attributes(Attributes(face={"side": range(12)}))
        >>> part = block - box((1, 1, 1), (3, 3, 3))
        >>> int(part.attributes["side"].max())
        11
        """

    @property
    def vertices(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        Coordinates, shape (n, 3), rounded to the nearest doubles. Read-only; `exact_vertices` are the solid's own.
        """

    @property
    def triangles(self) -> numpy.typing.NDArray[numpy.uint32]:
        """
        Numbers of vertices, shape (m, 3), counter-clockwise seen from outside. Read-only.
        """

    @property
    def faces(self) -> numpy.typing.NDArray[numpy.uint32]:
        """The triangles, by the name that trimesh gives them."""

    @property
    def exact_vertices(self) -> numpy.typing.NDArray[numpy.object_]:
        """
        Exact coordinates as an array of objects, shape (n, 3), of fractions.Fraction. O(n).
        """

    @property
    def exact_parts(self) -> tuple[numpy.typing.NDArray[numpy.uint32], numpy.typing.NDArray[numpy.object_], numpy.typing.NDArray[numpy.object_]]:
        """
        Of the vertices that are not three doubles: their numbers (k,), numerators and denominators (k, 3), ints.
        """

    @property
    def attributes(self) -> Attributes | None:
        """
        What the boundary carries, per vertex, corner and triangle; None where it is nothing.
        """

    @property
    def source_operands(self) -> numpy.typing.NDArray[numpy.uint32]:
        """
        Per triangle the operand that it is part of, in the operation that made the solid.
        """

    @property
    def source_faces(self) -> numpy.typing.NDArray[numpy.uint32]:
        """Per triangle the triangle of that operand that it is part of."""

    @property
    def notes(self) -> tuple[Defect, ...]:
        """
        What was resolved when the solid was made; nothing, if it comes from a pickle.
        """

    @property
    def volume(self) -> fractions.Fraction:
        """The exact volume. O(n)."""

    @property
    def nearest_volume(self) -> float:
        """
        The double nearest to the volume: much faster where the solid has many rational vertices. O(n).
        """

    @property
    def area(self) -> float:
        """The area of the boundary, to a few units in the last place. O(n)."""

    @property
    def bounds(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        Least and greatest coordinates, shape (2, 3); infinite for the empty solid. O(n).
        """

    @property
    def is_empty(self) -> bool:
        """Whether it has no points."""

    def canonical_text(self) -> str:
        """
        Facets, edges and exact vertices as a text that does not depend on how the boundary is triangulated.

        Equal for equal point sets. O(n log n).

        Examples
        --------
        >>> box((0, 0, 0), (1, 1, 1)).canonical_text() == (box((0, 0, 0), (1, 1, .5)) | box((0, 0, .5), (1, 1, 1))).canonical_text()
        True
        """

    def transformed(self, matrix: MatrixLike, *, rounded: bool = False) -> Solid:
        """
        The image under an affine map.

        Parameters
        ----------
        matrix : array_like, shape (3, 4) or (4, 4)
            Numbers of any kind, taken exactly; the last of four rows is a multiple of (0, 0, 0, 1).
        rounded : bool
            Round vertices to doubles. A thin part may come to cross itself then, which `check` finds.

        Raises
        ------
        ValueError
            For a matrix of another shape, or of determinant 0.
        OverflowError
            Where a coordinate is beyond all doubles.

        Examples
        --------
        >>> from fractions import Fraction
        >>> third = Fraction(1, 3)
        >>> box((0, 0, 0), (1, 1, 1)).transformed([[third, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]).volume
        Fraction(1, 3)
        """

    def translated(self, by: PointLike) -> Solid:
        """
        Moved by a vector, exactly.

        Examples
        --------
        >>> box((0, 0, 0), (1, 1, 1)).translated((10, 0, 0)).bounds[1].tolist()
        [11.0, 1.0, 1.0]
        """

    def scaled(self, factors: Number | PointLike) -> Solid:
        """
        Scaled about the origin, by one factor or a factor per axis, exactly. Negative ones mirror.

        Examples
        --------
        >>> box((0, 0, 0), (1, 1, 1)).scaled(2).volume
        Fraction(8, 1)
        """

    def mirrored(self, normal: PointLike) -> Solid:
        """
        Mirrored in the plane through the origin with this normal, exactly.

        Examples
        --------
        >>> box((0, 0, 0), (1, 1, 1)).mirrored((1, 0, 0)).bounds[0].tolist()
        [-1.0, 0.0, 0.0]
        """

    def rotated(self, axis: PointLike, degrees: float, *, exact: bool = False) -> Solid:
        """
        Rotated about an axis through the origin, counter-clockwise as seen from the axis's end.

        Quarter and half turns about coordinate axes are exact. Otherwise vertices are rounded to doubles, unless `exact`:
        then the solid stays congruent, with rationals of some 200 bits.

        Examples
        --------
        >>> box((0, 0, 0), (1, 2, 3)).rotated((0, 0, 1), 90).bounds[0].tolist()
        [-2.0, 0.0, 0.0]
        >>> box((0, 0, 0), (1, 1, 1)).rotated((1, 1, 1), 20, exact=True).volume
        Fraction(1, 1)
        """

    def split(self, plane: PlaneLike, *, cut_material: Material | None = None, threads: int = 0, progress: Progress | None = None, timeout: float | None = None) -> tuple[Solid, Solid]:
        """
        What is behind a plane, and what is in front of it. Exact: volumes add up.

        Parameters
        ----------
        plane : (normal, offset)
            The points p with normal . p = offset; three numbers and one.
        cut_material : Material, optional
            What the faces in the plane are made of; see `union`.
        threads, progress, timeout
            As for Solid.

        Returns
        -------
        behind, in_front : Solid

        Examples
        --------
        >>> below, above = box((0, 0, 0), (1, 1, 1)).split(((0, 0, 1), 0.25))
        >>> below.volume, above.volume
        (Fraction(1, 4), Fraction(3, 4))
        """

    def components(self) -> list[Solid]:
        """
        The connected components of the interior, each with its cavities. Volumes add up.

        Examples
        --------
        >>> two = box((0, 0, 0), (1, 1, 1)) | box((2, 0, 0), (3, 1, 1))
        >>> [part.volume for part in two.components()]
        [Fraction(1, 1), Fraction(1, 1)]
        """

    def without_cavities(self, *, threads: int = 0, progress: Progress | None = None, timeout: float | None = None) -> Solid:
        """
        The solid and its cavities: all that it closes off from infinity.

        Examples
        --------
        >>> shell = box((0, 0, 0), (3, 3, 3)) - box((1, 1, 1), (2, 2, 2))
        >>> shell.without_cavities().volume
        Fraction(27, 1)
        """

    def separated(self) -> Solid:
        """
        The same point set with edges and vertices of its own for every sheet: a 2-manifold mesh.

        Examples
        --------
        >>> touching = box((0, 0, 0), (1, 1, 1)) | box((1, 1, 0), (2, 2, 1))
        >>> len(touching.vertices), len(touching.separated().vertices)
        (14, 16)
        """

    def rounded(self, to: Number | str | None = 'float64', *, threads: int = 0, progress: Progress | None = None, timeout: float | None = None) -> Mesh:
        """
        The boundary with coordinates of few digits, a solid still: closed, and nothing crosses.

        Parameters
        ----------
        to : "float64", "float32" or a number
            A number is a step: coordinates are the doubles nearest to its multiples.

        Returns
        -------
        Mesh
            Its `rounding` tells what moved, and how far.

        Examples
        --------
        >>> from fractions import Fraction
        >>> mesh = box((0, 0, 0), (1, 1, 1)).scaled(Fraction(1, 3)).rounded("float32")
        >>> float(mesh.vertices.max())
        0.3333333432674408
        """

    def __copy__(self) -> Solid: ...

    def __deepcopy__(self, memo: object) -> Solid: ...

    def __reduce__(self) -> tuple[Any, ...]: ...

    def __invert__(self) -> Expression: ...

def _solid_of(type: type, vertices: object, triangles: object, exact: str, operands: object, faces: object, attributes: Attributes | None) -> object:
    """What pickle calls for a Solid."""

def carry_attributes(operands: Iterable[MeshLike], result: MeshLike, sources: tuple[numpy.typing.ArrayLike, numpy.typing.ArrayLike] | None = None, *, cut_material: Material | None = None, cut_faces: Literal['turned', 'of-later-operands'] = 'turned', threads: int = 0, progress: Progress = None, timeout: float | None = None) -> Attributes:
    """
    What a mesh carries on from those whose faces its triangles are parts of.

    `boolean`, `resolve`, and all functions from solids to solids do it themselves, but for `minkowski_sum`,
    `erosion`, `offset` and `convex_hull`. The meshes of Layers carry nothing; this gives what they would.

    Parameters
    ----------
    operands : iterable of meshes
        As for `boolean`, with attributes.
    result : mesh
        Every triangle of it lies in one triangle of an operand; where it does not, the nearest points speak.
    sources : pair of arrays of integers, optional
        Per triangle of the result, the operand and its triangle. Without: the `source_operands` and `source_faces` of the
        result.
    cut_material : Material, optional
        What cut faces are made of that have no material.
    cut_faces : {"turned", "of-later-operands"}
        Which those are: faces that are turned over, or those of all operands but the first.
    threads, progress, timeout
        As for Solid.

    Returns
    -------
    Attributes
        For ``Solid.with_attributes``, or for ``Mesh(..., attributes=...)``. Values are rounded once; those at corners of
        the operands are theirs, bit by bit.

    Raises
    ------
    InputError
        For indices out of range and coordinates that are not finite.
    ValueError
        For sources of no triangle, and another number of them than of triangles.

    Examples
    --------
    >>> sheet = Mesh([[-8, -8, .5], [8, -8, .5], [0, 8, .5]], [[0, 1, 2]], attributes=Attributes(vertex={"x": [-8., 8., 0.]}))
    >>> inside = clip(sheet, box((0, 0, 0), (1, 1, 1)))
    >>> attributes = carry_attributes([sheet], inside)
    >>> bool((attributes["x"] == inside.vertices[:, 0]).all())
    True
    """

def boolean(operation: Operation, meshes: Iterable[MeshLike], *, input: InputClass = 'automatic', exact: bool = False, rounding: Number | str | None = None, engine: Literal['bsp', 'layers'] | None = None, most_hole_edges: int | None = None, cut_material: Material | None = None, threads: int = 0, progress: Progress = None, timeout: float | None = None) -> Mesh:
    """
    The regularized Boolean of any number of meshes, from arrays to arrays.

    The combinatorics are those of the exact result; coordinates of new vertices are the nearest doubles. Faces that meet
    no other operand come out untouched. Arrays that are C-contiguous are not copied: no other thread, and no callback, may
    write to them meanwhile.

    Parameters
    ----------
    operation : {"union", "intersection", "difference", "symmetric-difference"}
        Difference: the first mesh without all others. Also "xor".
    meshes : iterable of meshes
        A Mesh, a Solid, a pair of arrays (vertices, triangles), or an object with `vertices` and `faces`.
    input : {"automatic", "solid", "overlapping", "repair", "soup"}
        What is expected of the meshes; see Solid.
    exact : bool
        Keep exact positions of vertices that are not doubles: `Mesh.exact_vertices`.
    rounding : "float64", "float32" or a number, optional
        Round such that the mesh bounds a solid again, where nearest doubles would cross; see `Solid.rounded`.
    engine : {"bsp", "layers"}, optional
        Compute it by another method, as a check. "bsp" carries no attributes.
    cut_material : Material, optional
        What cut faces are made of; see `union`.
    most_hole_edges, threads, progress, timeout
        As for Solid.

    Returns
    -------
    Mesh
        With `source_operands`, `source_faces`, `notes`, `rounding` and `seconds`; with the `attributes` of the operands, and
        with the `unit` of those that have one.

    Raises
    ------
    InputError
        A mesh is not what was expected; `operand` says which.
    ValueError
        Operands have different units, or attributes cannot be carried.

    Examples
    --------
    >>> a, b = box((0, 0, 0), (2, 2, 2)), box((1, 1, 1), (3, 3, 3))
    >>> result = boolean("union", [a, (b.vertices, b.triangles)])
    >>> sorted(set(result.source_operands.tolist()))
    [0, 1]
    >>> Solid(result).volume
    Fraction(15, 1)
    """

def union(solids: Iterable[Solid], *, cut_material: Material | None = None, threads: int = 0, progress: Progress | None = None, timeout: float | None = None) -> Solid:
    """
    The points in any of the solids, in one arrangement of all. Exact.

    Parameters
    ----------
    solids : iterable of Solid
    cut_material : Material, optional
        What cut faces are made of where what cuts has no material. Of an intersection cut faces are those of all solids but
        the first, else those that are turned over: what is taken away.
    threads, progress, timeout
        As for Solid.

    Examples
    --------
    >>> union([box((i, 0, 0), (i + 2, 1, 1)) for i in range(10)]).volume
    Fraction(11, 1)
    """

def intersection(solids: Iterable[Solid], *, cut_material: Material | None = None, threads: int = 0, progress: Progress | None = None, timeout: float | None = None) -> Solid:
    """
    The points in all of the solids. Exact.

    Examples
    --------
    >>> intersection([box((0, 0, 0), (2, 1, 1)), box((1, 0, 0), (3, 1, 1))]).volume
    Fraction(1, 1)
    """

def difference(solids: Iterable[Solid], *, cut_material: Material | None = None, threads: int = 0, progress: Progress | None = None, timeout: float | None = None) -> Solid:
    """
    The points in the first solid and in no other. Exact.

    Examples
    --------
    >>> paint = Material("paint", color=(0.8, 0, 0))
    >>> cut = difference([box((0, 0, 0), (2, 2, 2)), box((1, 1, 1), (3, 3, 3))], cut_material=paint)
    >>> sorted(set(cut.attributes["material"].tolist())), cut.attributes.materials[0].name
    ([-1, 0], 'paint')
    >>> difference([box((0, 0, 0), (3, 1, 1)), box((0, 0, 0), (1, 1, 1)), box((2, 0, 0), (3, 1, 1))]).volume
    Fraction(1, 1)
    """

def symmetric_difference(solids: Iterable[Solid], *, cut_material: Material | None = None, threads: int = 0, progress: Progress | None = None, timeout: float | None = None) -> Solid:
    """
    The points in an odd number of the solids. Exact.

    Examples
    --------
    >>> symmetric_difference([box((0, 0, 0), (2, 1, 1)), box((1, 0, 0), (3, 1, 1))]).volume
    Fraction(2, 1)
    """

def resolve(mesh: MeshLike, *, inside: Literal['winding', 'even-odd', 'outer'] = 'winding', input: InputClass = 'automatic', threads: int = 0, progress: Progress | None = None, timeout: float | None = None) -> Solid:
    """
    A closed mesh that crosses and overlaps itself, made a solid. Exact.

    Parameters
    ----------
    mesh : mesh, as for `boolean`
    inside : {"winding", "even-odd", "outer"}
        Inside is where the winding number is positive; where it is odd; all that the mesh closes off from infinity.
    input : {"automatic", "solid", "overlapping", "repair", "soup"}
        What is accepted; "repair" and "soup": any triangles.
    threads, progress, timeout
        As for Solid.

    Examples
    --------
    >>> import numpy as np
    >>> a, b = box((0, 0, 0), (2, 1, 1)), box((1, 0, 0), (3, 1, 1))
    >>> both = Mesh(np.vstack([a.vertices, b.vertices]), np.vstack([a.triangles, b.triangles + 8]))
    >>> resolve(both).volume
    Fraction(3, 1)
    >>> resolve(both, inside="even-odd").volume
    Fraction(2, 1)
    """

def check(mesh: MeshLike, *, listed: int = 5, threads: int = 0, progress: Progress = None, timeout: float | None = None) -> tuple[Defect, ...]:
    """
    Is a mesh the boundary of a solid? The complete, exact answer: all its defects.

    Parameters
    ----------
    mesh : mesh, as for `boolean`
    listed : int
        So many defects of each kind are listed with place and faces; the others are counted.
    threads, progress, timeout
        As for Solid.

    Returns
    -------
    tuple of Defect
        Without one of severity "error" the mesh bounds a solid.

    Examples
    --------
    >>> check(box((0, 0, 0), (1, 1, 1)))
    ()
    >>> {defect.kind for defect in check(Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]))}
    {'open edge'}
    """

def measure(mesh: MeshLike, *, threads: int = 0) -> dict[str, int | float | None]:
    """
    Volume, area and topology of a mesh, which need not be closed.

    Returns
    -------
    dict
        ``volume``: the nearest double, None if the mesh is not closed; ``area``; ``facets``: sets of coplanar triangles
        that are connected; ``components``, ``euler``, ``non_manifold_edges``, ``non_manifold_vertices``, ``open_edges``.

    Examples
    --------
    >>> facts = measure(box((0, 0, 0), (1, 1, 1)))
    >>> facts["volume"], facts["facets"], facts["euler"]
    (1.0, 6, 2)
    """

def box(lower: PointLike, upper: PointLike) -> Solid:
    """
    The box with opposite corners `lower` and `upper`, numbers of any kind, taken exactly.

    Raises
    ------
    ValueError
        Unless lower < upper in every coordinate.

    Examples
    --------
    >>> box((0, 0, 0), (1, 2, 3)).volume
    Fraction(6, 1)
    """

def tetrahedron(a: PointLike, b: PointLike, c: PointLike, d: PointLike) -> Solid:
    """
    The tetrahedron with these corners, in any order.

    Examples
    --------
    >>> tetrahedron((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)).volume
    Fraction(1, 6)
    """

def cylinder(radius: Number, height: Number, sides: int = 64) -> Solid:
    """
    A cylinder about the z axis from z = 0: a prism over a regular polygon inscribed in the circle.

    Examples
    --------
    >>> cylinder(1, 2, 4).volume
    Fraction(4, 1)
    """

def cone(lower_radius: Number, upper_radius: Number, height: Number, sides: int = 64) -> Solid:
    """
    A cone about the z axis, with `lower_radius` at z = 0 and `upper_radius` at z = height; one of them may be 0.

    Examples
    --------
    >>> cone(1, 0, 3, 4).volume
    Fraction(2, 1)
    """

def sphere(radius: Number, sides: int = 64) -> Solid:
    """
    A polyhedron inscribed in the sphere about the origin: circles of latitude of `sides` corners each.

    Examples
    --------
    >>> sphere(1, 4).volume
    Fraction(4, 3)
    """

def torus(radius: Number, tube_radius: Number, sides: int = 64, tube_sides: int = 32) -> Solid:
    """
    A torus about the z axis. `sides` corners on the great circle, `tube_sides` on the small one.

    Examples
    --------
    >>> float(torus(2, 1, 4, 4).volume)
    16.0
    """

def prism(polygon: numpy.typing.ArrayLike, lower: Number, upper: Number) -> Solid:
    """
    A simple polygon in the plane, extruded from z = lower to z = upper.

    Parameters
    ----------
    polygon : sequence of pairs of float
        Corners in either direction.

    Raises
    ------
    InputError
        Where the polygon crosses or touches itself.

    Examples
    --------
    >>> prism([(0, 0), (2, 0), (0, 2)], 0, 1).volume
    Fraction(2, 1)
    """

def read(path: str | os.PathLike[str], format: str | None = None) -> Mesh:
    """
    Reads a mesh, with what the format has beside the shape; `formats` lists the formats.

    Coordinates are the numbers in the file. What is read need not bound a solid: `check` and Solid tell.

    Parameters
    ----------
    path : str or path
    format : str, optional
        "stl", "stl-ascii", "obj", "off", "xoff", "ply", "ply-ascii", "ply-big-endian", "3mf", "glb", "gltf", "amf", or
        another extension where the build has assimp; without: by the extension of the path.

    Returns
    -------
    Mesh
        Its `attributes` are the colours, texture coordinates, normals, materials, images and names of the file, `unit` is
        that of the file, and `file_notes` tell what was left out or decided.

    Raises
    ------
    FileError
        A file that is missing, or not what its format demands; an OSError.

    Examples
    --------
    >>> import os, tempfile
    >>> path = os.path.join(tempfile.mkdtemp(), "part.3mf")
    >>> red = Attributes(face={"material": [0] * 12}, materials=[Material("paint", color=(1, 0, 0))])
    >>> write(path, box((0, 0, 0), (1, 1, 1)).with_attributes(red), unit="mm")
    []
    >>> mesh = read(path)
    >>> mesh.unit, mesh.attributes.materials[0].name
    ('millimeter', 'paint')
    """

def write(path: str | os.PathLike[str], mesh: MeshLike, format: str | None = None, *, attributes: Attributes | Literal['all'] | None = 'all', unit: str | None = None, strict: bool = False) -> list[str]:
    """
    Writes a mesh, the format by the extension. The file is complete, or not there.

    Text and PLY keep every double, XOFF fractions; binary STL and glTF round to floats. The material library and the images
    of OBJ are files beside it.

    Parameters
    ----------
    path : str or path
    mesh : mesh, as for `boolean`
    format : str, optional
        As `formats` lists them; without: by the extension of the path.
    attributes : "all", Attributes or None
        Those of the mesh, others, or nothing.
    unit : str, optional
        Of coordinates, as for Mesh; without: that of the mesh. Nothing is converted.
    strict : bool
        What would not survive is a FileError, and nothing is written.

    Returns
    -------
    list of str
        What did not survive, a sentence each.

    Raises
    ------
    FileError
        A file that cannot be written; an OSError.
    ValueError
        Attributes that do not fit the mesh, with the name of the channel; an unknown format or unit.

    Examples
    --------
    >>> import os, tempfile
    >>> hot = box((0, 0, 0), (1, 1, 1)).with_attributes(Attributes(face={"heat": range(12)}))
    >>> folder = tempfile.mkdtemp()
    >>> write(os.path.join(folder, "part.vtk"), hot)
    []
    >>> len(write(os.path.join(folder, "part.stl"), hot))
    1
    """

def read_bytes(data: bytes, format: str) -> Mesh:
    """
    Reads a mesh from bytes in memory, as `read` does.

    Examples
    --------
    >>> read_bytes(write_bytes(box((0, 0, 0), (1, 1, 1)), "ply"), "ply")
    Mesh(8 vertices, 12 triangles)
    """

def write_bytes(mesh: MeshLike, format: str, *, attributes: Attributes | Literal['all'] | None = 'all', unit: str | None = None, strict: bool = False) -> bytes:
    """
    The bytes that `write` would write; of OBJ, without the files beside it.

    Examples
    --------
    >>> write_bytes(tetrahedron((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)), "off").split(b"\\n")[1]
    b'4 4 0'
    """

def formats() -> list[dict[str, Any]]:
    """
    The formats of meshes, by name.

    Returns
    -------
    list of dict
        ``name``; ``reads`` and ``writes``, whether that can be done; ``floats``, whether writing rounds to floats.

    Examples
    --------
    >>> [format["name"] for format in formats() if format["writes"] and format["floats"]]
    ['stl', 'glb', 'gltf']
    """

class Expression:
    """
    A Boolean expression of solids: nothing is computed before it is evaluated.

    All of it is then evaluated in one arrangement, so that a chain of thousands of operations is exact without growing
    fractions. `|`, `&`, `-`, `^` combine expressions and solids; `~` is the complement, which is allowed everywhere but in
    what is evaluated. Immutable.

    Parameters
    ----------
    solid : Solid
    name : str
        For texts and messages.

    Examples
    --------
    >>> part = Expression(box((0, 0, 0), (4, 4, 4)), "block") - Expression(box((1, 1, 1), (2, 2, 5)), "hole")
    >>> part
    Expression(block - hole)
    >>> part.evaluate().volume
    Fraction(61, 1)
    """

    def __init__(self, solid: Solid, name: str = '') -> None: ...

    @staticmethod
    def parse(text: str, solids: dict[str, Solid]) -> Expression:
        """
        Reads an expression such as ``(a - b) & (c | ~d)``.

        Parameters
        ----------
        text : str
            Names, and | & - ^ ~ and parentheses; ~ binds strongest, then - and +, then &, then ^, then |.
        solids : dict
            The solids of the names.

        Raises
        ------
        ParseError
            The text does not follow the grammar, or has a name that is not in `solids`.

        Examples
        --------
        >>> solids = {"a": box((0, 0, 0), (2, 2, 2)), "b": box((1, 1, 1), (3, 3, 3))}
        >>> Expression.parse("a - b", solids).evaluate().volume
        Fraction(7, 1)
        """

    @staticmethod
    def any(terms: Sequence[Expression | Solid]) -> Expression:
        """The union of any number of expressions."""

    @staticmethod
    def all(terms: Sequence[Expression | Solid]) -> Expression:
        """The intersection of one or more expressions."""

    @staticmethod
    def odd(terms: Sequence[Expression | Solid]) -> Expression:
        """What is in an odd number of expressions."""

    def __or__(self, other: Expression | Solid, /) -> Expression: ...

    def __and__(self, other: Expression | Solid, /) -> Expression: ...

    def __sub__(self, other: Expression | Solid, /) -> Expression: ...

    def __xor__(self, other: Expression | Solid, /) -> Expression: ...

    def __ror__(self, arg: Solid, /) -> Expression: ...

    def __rand__(self, arg: Solid, /) -> Expression: ...

    def __rsub__(self, arg: Solid, /) -> Expression: ...

    def __rxor__(self, arg: Solid, /) -> Expression: ...

    def __invert__(self) -> Expression: ...

    def __len__(self) -> int: ...

    def __repr__(self) -> str: ...

    def __str__(self) -> str: ...

    def transformed(self, matrix: MatrixLike, *, rounded: bool = False) -> Expression:
        """
        The image under an affine map, as `Solid.transformed`. Maps of maps are multiplied before a vertex moves.
        """

    def evaluate(self, *, cut_material: Material | None = None, threads: int = 0, progress: Progress | None = None, timeout: float | None = None) -> Solid:
        """
        The solid, in one arrangement.

        Attributes of the solids are carried; `cut_material` is for faces that come out turned over.

        Raises
        ------
        ValueError
            The expression is not bounded, as a complement is.
        """

    @property
    def primitives(self) -> list[tuple[str, Solid, bool, bool, bool]]:
        """
        The different solids in order: name, solid, whether it occurs as it is, whether it occurs complemented, whether the result depends on it.
        """

    def __copy__(self) -> object: ...

    def __deepcopy__(self, memo: object) -> object: ...

def read_openscad(path: str | os.PathLike[str]) -> Expression:
    """
    Reads a model in the .csg format that OpenSCAD writes (``openscad -o part.csg part.scad``).

    Raises
    ------
    FileError
        The file cannot be read, or uses what is not supported; `line` says where.
    """

class Workpiece:
    """
    A solid that is combined with one tool after the other, in thousands of steps.

    A step costs about what the surfaces cost where tool and workpiece meet; all versions may be kept, and coordinates do
    not grow. Immutable: every step gives a new version.

    Parameters
    ----------
    solid : Solid

    Examples
    --------
    >>> work = Workpiece(box((0, 0, 0), (10, 10, 2)))
    >>> for i in range(1, 10):
    ...     work = work.cut(box((i, 1, 1), (i + .5, 9, 3)))
    >>> work.solid.volume
    Fraction(164, 1)
    """

    @overload
    def __init__(self) -> None: ...

    @overload
    def __init__(self, solid: Solid) -> None: ...

    def combined(self, operation: Operation, tools: Iterable[Solid], *, threads: int = 0, progress: Progress | None = None, timeout: float | None = None) -> Workpiece:
        """
        Combined with tools, those near each other in one step.

        Union: with all; difference: all are taken away; intersection: what is in all; symmetric difference: what is in an odd
        number of them and this solid together.
        """

    def cut(self, tool: Solid) -> Workpiece:
        """Without a tool: one step of machining."""

    @property
    def solid(self) -> Solid:
        """
        The solid, with exact vertices and the attributes of what it was made of. O(n).
        """

    def finished(self, *, cut_material: Material | None = None, threads: int = 0, progress: Progress | None = None, timeout: float | None = None) -> Solid:
        """
        `solid`, with cut faces made of a material.

        Parameters
        ----------
        cut_material : Material, optional
            What the faces that tools left are made of, where the tool has no material.
        threads, progress, timeout
            As for Solid.

        Examples
        --------
        >>> work = Workpiece(box((0, 0, 0), (2, 2, 2))).cut(box((1, 1, 1), (3, 3, 3)))
        >>> sorted(set(work.finished(cut_material=Material("steel")).attributes["material"].tolist()))
        [-1, 0]
        """

    @property
    def nearest_volume(self) -> float:
        """
        The volume to a few units in the last place, unless nearly all of the solid cancels. O(1).
        """

    @property
    def triangle_count(self) -> int:
        """How many triangles the boundary has."""

    def __bool__(self) -> bool: ...

    def __repr__(self) -> str: ...

    def __copy__(self) -> object: ...

    def __deepcopy__(self, memo: object) -> object: ...

class Surface:
    """
    A set of triangles in space: open or closed, oriented or not, crossing itself or not.

    Vertices at one position become one; triangles without area are left out, which `notes` say. Immutable.

    Parameters
    ----------
    mesh : mesh, as for `boolean`

    Raises
    ------
    InputError
        For indices out of range and coordinates that are not finite.

    Examples
    --------
    >>> sheet = Surface(([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]))
    >>> sheet.area
    0.5
    """

    def __init__(self, mesh: MeshLike) -> None: ...

    @staticmethod
    def of_plane(plane: PlaneLike, lower: PointLike, upper: PointLike) -> Surface:
        """
        A rectangle of a plane (normal, offset) that reaches beyond a box on all sides.

        Examples
        --------
        >>> cut = Surface.of_plane(((0, 0, 1), 0.5), (0, 0, 0), (1, 1, 1))
        >>> [piece.volume for piece in split(box((0, 0, 0), (1, 1, 1)), [cut])]
        [Fraction(1, 2), Fraction(1, 2)]
        """

    @property
    def vertices(self) -> numpy.typing.NDArray[numpy.float64]:
        """Coordinates, shape (n, 3), rounded to the nearest doubles. Read-only."""

    @property
    def triangles(self) -> numpy.typing.NDArray[numpy.uint32]:
        """Numbers of vertices, shape (m, 3)."""

    @property
    def faces(self) -> numpy.typing.NDArray[numpy.uint32]:
        """The triangles, by the name that trimesh gives them."""

    @property
    def exact_vertices(self) -> numpy.typing.NDArray[numpy.object_]:
        """
        Exact coordinates as an array of objects, shape (n, 3), of fractions.Fraction.
        """

    @property
    def source_operands(self) -> numpy.typing.NDArray[numpy.uint32]:
        """Per triangle the operand that it is part of."""

    @property
    def source_faces(self) -> numpy.typing.NDArray[numpy.uint32]:
        """Per triangle the triangle of that operand that it is part of."""

    @property
    def notes(self) -> tuple[Defect, ...]:
        """What was left out when the surface was made."""

    @property
    def attributes(self) -> Attributes | None:
        """
        What the surface carries, per vertex, corner and triangle; None where it is nothing.
        """

    def with_attributes(self, attributes: Attributes | None) -> Surface:
        """
        The same surface with these attributes in place of its own; None for nothing.

        Clips, imprints, cells and splits carry on what surfaces carry; a mesh with attributes makes a surface with them.

        Raises
        ------
        ValueError
            Where they do not fit the surface, with the name of the channel.

        Examples
        --------
        >>> sheet = Surface(([[0, 0, 0.5], [4, 0, 0.5], [0, 4, 0.5]], [[0, 1, 2]]))
        >>> map_of_it = sheet.with_attributes(Attributes(vertex={"texcoord": [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]}))
        >>> float(clip(map_of_it, box((0, 0, 0), (1, 1, 1))).attributes["texcoord"].max())
        0.25
        """

    @property
    def area(self) -> float:
        """Of all triangles, to a few units in the last place."""

    def __bool__(self) -> bool: ...

    def _repr_html_(self) -> str:
        """A viewer, for notebooks."""

    def __repr__(self) -> str: ...

    def __copy__(self) -> object: ...

    def __deepcopy__(self, memo: object) -> object: ...

def clip(surface: MeshLike, solid: Solid, *, keep: Literal['inside', 'outside', 'on'] = 'inside', threads: int = 0, progress: Progress | None = None, timeout: float | None = None) -> Surface:
    """
    The part of a surface inside, outside or on a solid. Exact.

    Parameters
    ----------
    surface : Surface or mesh
    solid : Solid
    keep : {"inside", "outside", "on"}
    threads, progress, timeout
        As for Solid.

    Examples
    --------
    >>> sheet = Surface(([[-9, -9, .5], [9, -9, .5], [0, 9, .5]], [[0, 1, 2]]))
    >>> clip(sheet, box((0, 0, 0), (1, 1, 1))).area
    1.0
    """

def split(solid: Solid, surfaces: Iterable[MeshLike], *, cut_material: Material | None = None, threads: int = 0, progress: Progress | None = None, timeout: float | None = None) -> list[Solid]:
    """
    The pieces into which surfaces divide a solid. Exact: they unite to the solid, and volumes add up.

    Parameters
    ----------
    solid : Solid
    surfaces : iterable of Surface or mesh
        Those that end inside the solid do not divide it there.
    cut_material : Material, optional
        What the faces are made of that the surfaces cut.
    threads, progress, timeout
        As for Solid.

    Examples
    --------
    >>> cut = Surface.of_plane(((1, 1, 0), 1), (0, 0, 0), (1, 1, 1))
    >>> sum(piece.volume for piece in split(box((0, 0, 0), (1, 1, 1)), [cut]))
    Fraction(1, 1)
    """

def imprint(surfaces: Iterable[MeshLike], *, threads: int = 0, progress: Progress | None = None, timeout: float | None = None) -> list[Surface]:
    """
    Each surface with the traces of the others as edges: nothing is added or removed. Exact.

    Examples
    --------
    >>> a, b = imprint([box((0, 0, 0), (1, 1, 1)), box((1, .25, .25), (2, .75, .75))])
    >>> a.area
    6.0
    """

def cells_of(surfaces: Iterable[MeshLike], *, threads: int = 0, progress: Progress | None = None, timeout: float | None = None) -> list[Solid]:
    """
    Every volume that surfaces enclose together, closed or not, as a solid. Exact.

    Examples
    --------
    >>> parts = cells_of([box((0, 0, 0), (2, 1, 1)), box((1, 0, 0), (3, 1, 1))])
    >>> [part.volume for part in parts]
    [Fraction(1, 1), Fraction(1, 1), Fraction(1, 1)]
    """

class Polygons:
    """
    A bounded set of the plane: simple polygons with holes. An immutable value, exact.

    `|`, `&`, `-`, `^` as for solids. Geometries of shapely and of others with ``__geo_interface__`` go in by `from_geo`, and
    ``shapely.geometry.shape(polygons)`` takes them out.

    Parameters
    ----------
    loops : iterable of loops, each an iterable of pairs of numbers
        Closed polygons, which may cross themselves and each other; numbers of any kind, taken exactly.
    fill : {"nonzero", "even-odd", "positive", "negative"}
        Which points loops fill, by how often they wind around them.

    Examples
    --------
    >>> square = Polygons([[(0, 0), (2, 0), (2, 2), (0, 2)]])
    >>> (square - Polygons([[(1, 1), (3, 1), (3, 3), (1, 3)]])).area
    Fraction(3, 1)
    """

    def __init__(self, loops: Iterable[Iterable[Any]] = (), *, fill: Literal['nonzero', 'even-odd', 'positive', 'negative'] = 'nonzero') -> None: ...

    @staticmethod
    def from_geo(geometry: Any) -> Polygons:
        """
        Of polygons as GeoJSON describes them, or of an object with ``__geo_interface__``.

        Examples
        --------
        >>> Polygons.from_geo({"type": "Polygon", "coordinates": [[(0, 0), (1, 0), (1, 1), (0, 0)]]}).area
        Fraction(1, 2)
        """

    @staticmethod
    def parse(text: str, format: str = 'wkt') -> Polygons:
        """
        Reads WKT, GeoJSON, or the paths of SVG.

        Examples
        --------
        >>> Polygons.parse("POLYGON ((0 0, 1/3 0, 0 1))").area
        Fraction(1, 6)
        """

    def text(self, format: str = 'wkt', *, exact: bool = False) -> str:
        """
        As WKT, GeoJSON or SVG; in WKT also with exact coordinates, as quotients.
        """

    def __or__(self, arg: Polygons, /) -> Polygons: ...

    def __and__(self, arg: Polygons, /) -> Polygons: ...

    def __sub__(self, arg: Polygons, /) -> Polygons: ...

    def __xor__(self, arg: Polygons, /) -> Polygons: ...

    def __eq__(self, other: object, /) -> bool: ...

    def __hash__(self) -> int: ...

    def __bool__(self) -> bool: ...

    def __len__(self) -> int: ...

    @property
    def area(self) -> fractions.Fraction:
        """The exact area."""

    @property
    def loops(self) -> list[list[list[tuple[fractions.Fraction, fractions.Fraction]]]]:
        """Per polygon its outer loop and its holes, as points of Fractions."""

    @property
    def __geo_interface__(self) -> dict[str, Any]:
        """As a MultiPolygon of GeoJSON, in nearest doubles."""

    def membership(self, point: Sequence[Number]) -> int:
        """1 for a point in the interior, 0 on the boundary, -1 outside. Exact."""

    def rounded(self, to: Number | str | None = 'float64') -> Polygons:
        """
        Coordinates on a grid, and simple polygons still: crossings that rounding makes are resolved.

        Examples
        --------
        >>> from fractions import Fraction
        >>> Polygons([[(0, 0), (Fraction(1, 3), 0), (0, 1)]]).rounded(Fraction(1, 8)).area
        Fraction(3, 16)
        """

    def __reduce__(self) -> tuple[Any, ...]: ...

    def __repr__(self) -> str: ...

    def __copy__(self) -> object: ...

    def __deepcopy__(self, memo: object) -> object: ...

def section(solid: Solid, plane: PlaneLike) -> Polygons:
    """
    The section of a solid by a plane (normal, offset), as polygons. Exact.

    Coordinates are those of space without the axis along which the normal is longest; they turn counter-clockwise as seen
    from in front of the plane: for the normal (0, 0, 1) they are x, y; for (0, 0, -1) y, x; for (0, 1, 0) z, x. Faces in
    the plane belong to the section where the solid is in front of them.

    Examples
    --------
    >>> section(box((0, 0, 0), (1, 2, 3)), ((0, 0, 1), 1)).area
    Fraction(2, 1)
    """

def slice(solid: Solid, axis: int, at: numpy.typing.ArrayLike, *, threads: int = 0, progress: Progress | None = None, timeout: float | None = None) -> list[Polygons]:
    """
    The sections by planes perpendicular to an axis (0, 1, 2), at doubles that do not decrease. Exact.

    Coordinates of the polygons are y, z for axis 0; z, x for axis 1; x, y for axis 2. See `section`. A solid that was taken
    at its word (``input='solid'``) and crosses or touches itself has loops that do.

    Examples
    --------
    >>> [layer.area for layer in slice(box((0, 0, 0), (1, 2, 3)), 2, [0, 1, 2, 3])]
    [Fraction(2, 1), Fraction(2, 1), Fraction(2, 1), Fraction(0, 1)]
    """

def convex_hull(points: numpy.typing.ArrayLike | MeshLike, *, threads: int = 0) -> Solid:
    """
    The convex hull of points, or of the vertices of a mesh, as a solid. Exact.

    Points may be equal, collinear and coplanar. Of points in one plane the hull is empty: it has no volume.

    Examples
    --------
    >>> convex_hull([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [.1, .1, .1]])
    Solid(4 vertices, 4 triangles)
    """

def decompose(solid: Solid, *, cut_material: Material | None = None, progress: Progress | None = None, timeout: float | None = None) -> list[Solid]:
    """
    Convex solids with disjoint interiors whose union is the solid. Exact: volumes add up.

    Pieces carry what the solid carries. Walls between them are made of `cut_material`, if it is given.

    Examples
    --------
    >>> notched = box((0, 0, 0), (2, 2, 1)) - box((1, 1, 0), (2, 2, 1))
    >>> pieces = decompose(notched)
    >>> len(pieces), sum(piece.volume for piece in pieces)
    (2, Fraction(3, 1))
    """

def minkowski_sum(a: Solid, b: Solid, *, threads: int = 0, progress: Progress | None = None, timeout: float | None = None) -> Solid:
    """
    All sums of a point of one solid and a point of the other. Exact.

    Examples
    --------
    >>> minkowski_sum(box((0, 0, 0), (1, 1, 1)), box((0, 0, 0), (2, 3, 4))).volume
    Fraction(60, 1)
    """

def erosion(a: Solid, b: Solid, *, threads: int = 0, progress: Progress | None = None, timeout: float | None = None) -> Solid:
    """
    All positions x such that b moved by x is within a. Exact.

    Examples
    --------
    >>> erosion(box((0, 0, 0), (3, 3, 3)), box((0, 0, 0), (1, 1, 1))).volume
    Fraction(8, 1)
    """

def offset(solid: Solid, radius: Number, *, facets: int = 320, threads: int = 0, progress: Progress | None = None, timeout: float | None = None) -> tuple[Solid, float]:
    """
    A solid grown, or shrunk by a negative radius, by a ball of facets.

    Returns
    -------
    solid : Solid
    excess : float
        The distance is between |radius| and (1 + excess) |radius| everywhere; proven.

    Examples
    --------
    >>> grown, excess = offset(box((0, 0, 0), (1, 1, 1)), 0.5, facets=20)
    >>> bool((grown.bounds[1] >= 1.5).all())
    True
    """

def contacts(parts: Iterable[Solid], *, progress: Progress = None, timeout: float | None = None) -> list[dict[str, Any]]:
    """
    Which parts of an assembly interfere, and which touch, and where. Exact.

    Parameters
    ----------
    parts : iterable of Solid
    progress, timeout
        As for Solid.

    Returns
    -------
    list of dict
        One per pair that is not apart: ``a``, ``b`` (numbers), ``relation``: "contact" or "interfering". Interfering:
        ``overlap``, a Solid. Contact: ``points`` (tuples of Fractions), ``facets`` (loops of numbers of points), ``edges``
        and ``vertices`` that lie in no facet, ``area`` and ``length``.

    Examples
    --------
    >>> pairs = contacts([box((0, 0, 0), (1, 1, 1)), box((1, 0, 0), (2, 1, 1)), box((1.5, 0, 0), (3, 1, 1))])
    >>> [(pair["a"], pair["b"], pair["relation"]) for pair in pairs]
    [(0, 1, 'contact'), (1, 2, 'interfering')]
    >>> pairs[0]["area"], pairs[1]["overlap"].volume
    (1.0, Fraction(1, 2))
    """

def distance(a: Solid, b: Solid) -> dict[str, Any]:
    """
    The least distance of two solids and where it is. Exact.

    Returns
    -------
    dict
        ``distance`` (float, within an ulp), ``squared`` (Fraction, exact); where they are apart also ``on_a`` and
        ``on_b``, a pair of closest points.

    Raises
    ------
    ValueError
        One of the solids is empty.

    Examples
    --------
    >>> distance(box((0, 0, 0), (1, 1, 1)), box((2, 2, 0), (3, 3, 1)))["squared"]
    Fraction(2, 1)
    """

class Locator:
    """
    Locates points in solids: in, on or out. Exact.

    Parameters
    ----------
    solids : iterable of Solid

    Examples
    --------
    >>> locator = Locator([box((0, 0, 0), (1, 1, 1))])
    >>> locator.membership([[.5, .5, .5], [1, .5, .5], [2, 0, 0]]).tolist()
    [1, 0, -1]
    """

    def __init__(self, solids: Iterable[Solid]) -> None: ...

    def membership(self, points: numpy.typing.ArrayLike) -> numpy.typing.NDArray[numpy.int8]:
        """
        Per point (n, 3): 0 on the boundary of a solid, else 1 in the interior of one, -1 outside of all. In parallel.
        """

    def locate(self, points: numpy.typing.ArrayLike) -> list[tuple[dict[int, int], dict[int, int]]]:
        """
        Per point the solids that it is in, with winding numbers, and those that it lies on, with a face.

        Examples
        --------
        >>> Locator([box((0, 0, 0), (1, 1, 1)), box((0, 0, 0), (2, 2, 2))]).locate([[.5, .5, .5]])
        [({0: 1, 1: 1}, {})]
        """

    def __copy__(self) -> object: ...

    def __deepcopy__(self, memo: object) -> object: ...

class RayCaster:
    """
    Exact ray queries over solids, from any point.

    Parameters
    ----------
    solids : iterable of Solid

    Examples
    --------
    >>> caster = RayCaster([box((0, 0, 0), (1, 1, 1))])
    >>> caster.first([[-1, .5, .5]], [[1, 0, 0]])["place"].tolist()
    [[0.0, 0.5, 0.5]]
    >>> [(t, passage) for t, _, _, passage, _ in caster.all((-1, .5, .5), (1, 0, 0))]
    [(Fraction(1, 1), 'entering'), (Fraction(2, 1), 'leaving')]
    """

    def __init__(self, solids: Iterable[Solid]) -> None: ...

    def first(self, origins: numpy.typing.ArrayLike, directions: numpy.typing.ArrayLike) -> dict[str, numpy.typing.NDArray[Any]]:
        """
        The first events of many rays, in parallel.

        Returns
        -------
        dict of arrays
            ``solid`` and ``face``, -1 where a ray meets nothing; ``t``, in lengths of the direction, and ``place`` (n, 3),
            each rounded to the nearest double.
        """

    def all(self, origin: PointLike, direction: PointLike) -> list[tuple[fractions.Fraction, int, int, str, tuple[fractions.Fraction, fractions.Fraction, fractions.Fraction]]]:
        """
        All events of one ray, exactly: (t, solid, face, passage, place); passage is entering, leaving, touching or along.
        """

    def __copy__(self) -> object: ...

    def __deepcopy__(self, memo: object) -> object: ...

class Layers:
    """
    Faces in layers as seen from an origin: `layers` makes them.

    Layer 1 has the faces that nothing is behind of, on any ray; going through the layers from the first to the last is the
    painter's order. Faces that cross, or that dominate one another in a cycle, are cut.
    """

    @property
    def count(self) -> int:
        """How many layers there are; they are numbered from 1."""

    def __len__(self) -> int: ...

    def mesh(self, layer: int) -> Mesh:
        """
        The pieces of a layer, 1 to `count`, as a Mesh with exact vertices; sources are the solid and its face.
        """

    @property
    def origin(self) -> tuple[float, float, float]:
        """The point, or the direction, of the view."""

    def _repr_html_(self) -> str:
        """A viewer, for notebooks."""

    @property
    def is_direction(self) -> bool:
        """Whether `origin` is the direction of parallel rays."""

    def __repr__(self) -> str: ...

    def __copy__(self) -> object: ...

    def __deepcopy__(self, memo: object) -> object: ...

def layers(solids: Iterable[Solid], *, origin: PointLike | None = None, direction: PointLike | None = None, progress: Progress = None, timeout: float | None = None) -> Layers:
    """
    The faces of solids in layers as seen from a point, or along a direction. Exact.

    Parameters
    ----------
    solids : iterable of Solid
    origin, direction : three numbers, optional
        The point of view, or the direction of parallel rays; without either, a point with few layers is chosen.
    progress, timeout
        As for Solid.

    Examples
    --------
    >>> layers([box((0, 0, 0), (1, 1, 1))], direction=(0, 0, 1)).count
    2
    """

class SelectiveComplex:
    """
    A point set of space that need not be regular: open, closed, of mixed dimension, unbounded.

    Cells that are pairwise disjoint and cover space, each in the set or not. Always the minimal complex of its set, so
    `==` compares point sets. `|`, `&`, `-`, `^`, `~` are not regularized. Immutable.

    Parameters
    ----------
    solid : Solid, optional
        Without: the empty set.
    open : bool
        Without its boundary.

    Examples
    --------
    >>> a, b = SelectiveComplex(box((0, 0, 0), (1, 1, 1))), SelectiveComplex(box((1, 0, 0), (2, 1, 1)))
    >>> (a & b).counts  # the square in which they touch
    {'vertices': 4, 'edges': 4, 'faces': 1, 'volumes': 1}
    >>> (a & b).volume, (a & b).area
    (Fraction(0, 1), 1.0)
    """

    @overload
    def __init__(self) -> None: ...

    @overload
    def __init__(self, solid: Solid, *, open: bool = False) -> None: ...

    @staticmethod
    def all() -> SelectiveComplex:
        """All of space."""

    @staticmethod
    def simplex(corners: numpy.typing.ArrayLike, *, open: bool = False) -> SelectiveComplex:
        """
        The convex hull of one to four points that are affinely independent: point, segment, triangle or tetrahedron.

        Examples
        --------
        >>> SelectiveComplex.simplex([[0, 0, 0], [3, 4, 0]]).length
        5.0
        """

    def __or__(self, arg: SelectiveComplex, /) -> SelectiveComplex: ...

    def __and__(self, arg: SelectiveComplex, /) -> SelectiveComplex: ...

    def __sub__(self, arg: SelectiveComplex, /) -> SelectiveComplex: ...

    def __xor__(self, arg: SelectiveComplex, /) -> SelectiveComplex: ...

    def __invert__(self) -> SelectiveComplex: ...

    def __eq__(self, other: object, /) -> bool: ...

    def __hash__(self) -> int: ...

    def __bool__(self) -> bool: ...

    def __repr__(self) -> str: ...

    def interior(self) -> SelectiveComplex:
        """The points with a neighbourhood in the set."""

    def closure(self) -> SelectiveComplex:
        """The points whose neighbourhoods all meet the set."""

    def boundary(self) -> SelectiveComplex:
        """The points whose neighbourhoods meet the set and its complement."""

    def exterior(self) -> SelectiveComplex:
        """The interior of the complement."""

    def regularized(self) -> SelectiveComplex:
        """The closure of the interior."""

    def membrane(self) -> SelectiveComplex:
        """The common boundary of interior and exterior."""

    def dangle(self) -> SelectiveComplex:
        """The rest of the boundary: walls, hair and cuts."""

    def components(self) -> list[SelectiveComplex]:
        """The connected components, each as a set."""

    def contains(self, point: PointLike) -> bool:
        """Whether a point is in the set. Exact, O(n)."""

    @property
    def counts(self) -> dict[str, int]:
        """How many cells of each dimension the minimal complex has."""

    @property
    def is_bounded(self) -> bool:
        """Whether it lies in some ball."""

    @property
    def is_open(self) -> bool:
        """Equal to its interior."""

    @property
    def is_closed(self) -> bool:
        """Equal to its closure."""

    @property
    def is_manifold(self) -> bool:
        """Whether the boundary is a surface everywhere."""

    @property
    def volume(self) -> fractions.Fraction | None:
        """The exact volume; None where it is unbounded."""

    @property
    def area(self) -> float | None:
        """
        The area of its faces, to a few units in the last place; None where one is unbounded.
        """

    @property
    def length(self) -> float:
        """The length of its edges, to a few units in the last place."""

    def __copy__(self) -> object: ...

    def __deepcopy__(self, memo: object) -> object: ...

def _run_command_line(words: Sequence[str]) -> int:
    """Runs the command line `strata` in this process: its exit code."""
