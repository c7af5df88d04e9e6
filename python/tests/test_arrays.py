"""Arrays of every layout, and what is answered to those that are no meshes."""

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest
import strata_csg as st

VOLUME = Fraction(32, 3)


@pytest.mark.parametrize("dtype", ["float64", "float32", "float16", "int8", "int64", "uint16", ">f8", "longdouble", object])
def test_vertices_of_every_type_are_taken_exactly(corner, dtype):
    vertices, triangles = corner
    assert st.Solid((vertices.astype(dtype), triangles)).volume == VOLUME


@pytest.mark.parametrize("dtype", ["uint32", "int32", "int64", "uint8", "uint64", ">i4", "int16"])
def test_indices_of_every_type(corner, dtype):
    vertices, triangles = corner
    assert st.Solid((vertices, triangles.astype(dtype))).volume == VOLUME


def test_layouts(corner):
    vertices, triangles = corner
    padded = np.zeros((8, 5))
    padded[::2, 1:4] = vertices
    wide = np.zeros((4, 9), dtype=np.int64)
    wide[:, ::3] = triangles
    for v in (vertices, np.asfortranarray(vertices), padded[::2, 1:4], vertices[::-1][::-1], vertices.tolist()):
        for t in (triangles, np.asfortranarray(triangles), wide[:, ::3], triangles.tolist()):
            assert st.Solid((v, t)).volume == VOLUME


def test_read_only_arrays(corner):
    vertices, triangles = corner
    vertices.flags.writeable = False
    triangles.flags.writeable = False
    assert st.boolean("union", [(vertices, triangles)]).vertices.shape == (4, 3)


def test_contiguous_arrays_are_looked_at(corner):
    vertices, triangles = corner
    mesh = st.Mesh(vertices, triangles)
    assert mesh.vertices is vertices and mesh.triangles is triangles
    vertices[1, 0] = 8
    assert st.Solid(mesh).volume == 2 * VOLUME


def test_results_own_their_memory(corner):
    result = st.boolean("union", [corner, corner])
    vertices, triangles, faces = result.vertices, result.triangles, result.source_faces
    expected = vertices.copy(), triangles.copy(), faces.copy()
    del result
    junk = [np.random.rand(4, 3) for _ in range(1000)]
    assert np.array_equal(vertices, expected[0]) and np.array_equal(triangles, expected[1])
    assert np.array_equal(faces, expected[2]) and len(junk) == 1000


def test_numbers_that_are_no_doubles_are_exact(corner):
    _, triangles = corner
    third = Fraction(1, 3)
    exact = np.array([[third * x for x in row] for row in [[0, 0, 0], [4, 0, 0], [0, 4, 0], [0, 0, 4]]], dtype=object)
    solid = st.Solid((exact, triangles))
    assert solid.volume == VOLUME / 27
    assert (solid.exact_vertices == exact).all()
    numbers, above, below = solid.exact_parts
    assert numbers.tolist() == [1, 2, 3] and above[0, 0] == 4 and below[0, 0] == 3
    decimals = np.array([[Decimal("0.1") * Decimal(float(x)) for x in row] for row in corner[0]], dtype=object)
    assert st.Solid((decimals, triangles)).volume == VOLUME / 1000


def test_other_meshes(corner):
    class Foreign:
        vertices, faces = corner

    assert st.Solid(Foreign()).volume == VOLUME
    assert st.boolean("union", [Foreign(), st.Solid(corner), st.Mesh(*corner), corner]).triangles.shape == (4, 3)


def test_empty_arrays():
    for vertices, triangles in [([], []), (np.zeros((0, 3)), np.zeros((0, 3), dtype=int)), (np.zeros((3, 3)), [])]:
        assert not st.Solid((vertices, triangles))
    assert st.Solid() == st.Solid(([], []))
    assert st.boolean("union", []).triangles.shape == (0, 3)


@pytest.mark.parametrize(
    ("vertices", "triangles", "error", "text"),
    [
        ([[0, 0]], [[0, 0, 0]], ValueError, r"vertices: expected an array of shape \(n, 3\), found shape \(1, 2\)"),
        ([0, 0, 0], [[0, 0, 0]], ValueError, r"vertices: .*found shape \(3,\)"),
        (np.zeros((2, 3, 3)), [[0, 0, 0]], ValueError, r"vertices: .*found shape \(2, 3, 3\)"),
        ([[0, 0, 0], [0, 0]], [[0, 0, 0]], ValueError, "vertices: "),
        (5, [[0, 0, 0]], ValueError, "vertices: "),
        ([["a", "b", "c"]], [[0, 0, 0]], TypeError, "vertices: expected numbers"),
        (np.zeros((3, 3), dtype=complex), [[0, 1, 2]], TypeError, "vertices: expected numbers, found type complex128"),
        (np.zeros((3, 3), dtype=bool), [[0, 1, 2]], TypeError, "vertices: expected numbers, found type bool"),
        (np.array([[None, 0, 0]], dtype=object), [[0, 0, 0]], TypeError, "vertices: expected an int, a float"),
        (np.array([[2**53 + 1, 0, 0]]), [[0, 0, 0]], ValueError, "vertices: not all numbers of type int64 are doubles"),
        (np.array([[10**400, 0, 0]], dtype=object), [[0, 0, 0]], ValueError, "beyond all doubles"),
        (np.zeros((3, 3)), [[0, 1, -1]], ValueError, "triangles: index -1 is negative"),
        (np.zeros((3, 3)), [[0, 1, 2**33]], ValueError, "triangles: index 8589934592 is beyond 32 bits"),
        (np.zeros((3, 3)), [[0, 1, 2.0]], TypeError, "triangles: expected integers, found type float64"),
        (np.zeros((3, 3)), [[0, 1]], ValueError, "triangles: expected an array of shape"),
        (np.zeros((3, 3)), np.zeros((1, 3), dtype=bool), TypeError, "triangles: expected integers"),
        (np.ma.masked_equal(np.eye(3), 1), [[0, 1, 2]], ValueError, "vertices: some numbers are masked"),
        (
            np.zeros((3, 3)),
            np.ma.masked_equal(np.array([[0, 1, 2]], dtype=np.uint32), 2),
            ValueError,
            "triangles: some numbers are masked",
        ),
    ],
)
def test_wrong_arrays_are_named(vertices, triangles, error, text):
    with pytest.raises(error, match=text):
        st.Solid((vertices, triangles))
    with pytest.raises(error, match=text):
        st.Mesh(vertices, triangles)


def test_arrays_of_derived_types_are_taken(corner):
    vertices, triangles = corner
    for derived in (np.ma.asarray, lambda a: a.view(np.recarray)):
        assert st.Solid((derived(vertices), derived(triangles))) == st.Solid(corner)


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf])
def test_coordinates_that_are_not_finite(corner, value):
    vertices, triangles = corner
    vertices[2, 1] = value
    with pytest.raises(st.InputError) as caught:
        st.Solid((vertices, triangles))
    assert caught.value.defects[0].kind == "non-finite coordinate"


def test_indices_out_of_range(corner):
    vertices, triangles = corner
    triangles[0, 0] = 7
    with pytest.raises(st.InputError) as caught:
        st.boolean("union", [corner, (vertices, triangles)])
    assert caught.value.defects[0].kind == "index out of range"


@pytest.mark.parametrize("thing", [None, 3, "text", [], [1, 2], object(), (1, 2, 3)])
def test_what_is_no_mesh(thing):
    with pytest.raises(TypeError, match="expected a Mesh, a Solid, a pair|mesh: MeshLike"):
        st.Solid(thing)
    with pytest.raises(TypeError, match="operand 1: expected a Mesh"):
        st.boolean("union", [st.box((0, 0, 0), (1, 1, 1)), thing])


def test_results_of_solids_cannot_be_written_to():
    solid = st.box((0, 0, 0), (1, 1, 1))
    with pytest.raises(ValueError, match="read-only"):
        solid.vertices[0, 0] = 3


def test_buffers_are_kept_while_they_are_looked_at(corner):
    vertices, triangles = corner
    memory = bytearray(vertices.tobytes())
    mesh = st.Mesh(memoryview(memory).cast("B").cast("d", (4, 3)), triangles)
    with pytest.raises(BufferError):
        memory.clear()
    assert isinstance(mesh.vertices, np.ndarray) and st.Solid(mesh).volume == VOLUME


@pytest.mark.filterwarnings("ignore::RuntimeWarning")
def test_objects_that_were_never_initialised():
    for thing in (st.Solid.__new__(st.Solid), st.Mesh.__new__(st.Mesh)):
        with pytest.raises(TypeError):
            st.boolean("union", [thing])
    with pytest.raises(TypeError):
        st.union([st.Solid.__new__(st.Solid)])
