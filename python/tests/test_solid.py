"""Solids as values."""

from __future__ import annotations

import copy
import pickle
from concurrent.futures import ProcessPoolExecutor
from fractions import Fraction

import numpy as np
import pytest
import strata_csg as st

A = st.box((0, 0, 0), (2, 2, 2))
B = st.box((1, 1, 1), (3, 3, 3))


def test_operators():
    assert (A | B).volume == 15
    assert (A & B).volume == 1
    assert (A - B).volume == 7
    assert (A ^ B).volume == 14
    assert (~(~A | ~B)).evaluate() == A & B


def test_equality_is_that_of_point_sets():
    assert A == st.box((0, 0, 0), (1, 2, 2)) | st.box((1, 0, 0), (2, 2, 2))
    assert hash(A) == hash(st.box((0, 0, 0), (1, 2, 2)) | st.box((1, 0, 0), (2, 2, 2)))
    assert A != B and A != 3 and A != "solid"
    assert len({A, B, A | A, A & A}) == 2


def test_truth_and_text():
    assert A and not A & st.box((5, 5, 5), (6, 6, 6))
    assert repr(A) == "Solid(8 vertices, 12 triangles)"
    assert repr(st.Solid()) == "Solid(empty)"
    assert "rational" in repr(A.scaled(Fraction(1, 3)))


def test_copies():
    third = A.scaled(Fraction(1, 3)) - B.scaled(Fraction(1, 7))
    assert copy.copy(third) == third and copy.deepcopy(third) == third
    for protocol in range(2, pickle.HIGHEST_PROTOCOL + 1):
        again = pickle.loads(pickle.dumps(third, protocol))
        assert again == third
        assert np.array_equal(again.triangles, third.triangles)
        assert np.array_equal(again.source_operands, third.source_operands)
        assert np.array_equal(again.source_faces, third.source_faces)
        assert (again.exact_vertices == third.exact_vertices).all()


def test_meshes_are_pickled_with_their_sources():
    mesh = st.boolean("difference", [A.scaled(Fraction(1, 3)), B], exact=True)
    again = pickle.loads(pickle.dumps(mesh))
    assert again == mesh
    assert np.array_equal(again.source_faces, mesh.source_faces)
    assert np.array_equal(again.source_operands, mesh.source_operands)


def cut(solid: st.Solid) -> st.Solid:
    return solid - st.box((-9, -9, 0), (9, 9, 9))


def test_a_million_triangles_through_a_pool_of_processes():
    ball = st.sphere(1, 1002)
    assert len(ball.triangles) > 1_000_000
    with ProcessPoolExecutor(1) as pool:
        half = pool.submit(cut, ball).result()
    assert np.array_equal(half.triangles, cut(ball).triangles)


def test_maps():
    assert A.translated((1, 1, 1)).bounds.tolist() == [[1, 1, 1], [3, 3, 3]]
    assert A.scaled(3).volume == 8 * 27 and A.scaled((1, 2, Fraction(1, 2))).volume == 8
    assert A.mirrored((0, 0, 1)).bounds[0].tolist() == [0, 0, -2]
    assert A.rotated((0, 0, 1), 90) == A.mirrored((1, 0, 0))
    assert A.rotated((1, 1, 1), 33, exact=True).volume == 8
    matrix = np.eye(4)
    matrix[:3, 3] = 1, 1, 1
    assert A.transformed(matrix) == A.translated((1, 1, 1)) == A.transformed(matrix[:3].tolist())
    assert A.transformed(np.diag([1.0, 1, 1, 2])).volume == 1


@pytest.mark.parametrize(
    ("matrix", "error"),
    [
        (np.zeros((4, 4)), ValueError),
        (np.eye(3), ValueError),
        (np.eye(5), ValueError),
        ([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [1, 0, 0, 1]], ValueError),
        ([[1, 0, 0, 0], [1, 0, 0, 0], [0, 0, 1, 0]], ValueError),
        ([[1, 0, 0, float("nan")], [0, 1, 0, 0], [0, 0, 1, 0]], ValueError),
        (3, ValueError),
        ([["a"] * 4] * 3, TypeError),
    ],
)
def test_maps_that_are_none(matrix, error):
    with pytest.raises(error, match="matrix|determinant"):
        A.transformed(matrix)


def test_scaling_by_nothing_and_beyond_everything():
    with pytest.raises(ValueError):
        A.scaled(0)
    with pytest.raises(OverflowError):
        A.scaled(10**400)
    with pytest.raises(TypeError, match="by: expected three numbers"):
        A.translated((1, 2))
    with pytest.raises(ValueError, match="by: expected a finite number"):
        A.translated((1, 2, float("nan")))


def test_parts():
    below, above = A.split(((0, 0, 1), Fraction(1, 3)))
    assert (below.volume, above.volume) == (Fraction(4, 3), Fraction(20, 3))
    assert below | above == A
    shell = st.box((0, 0, 0), (3, 3, 3)) - st.box((1, 1, 1), (2, 2, 2))
    assert shell.without_cavities().volume == 27
    assert [part.volume for part in (A | st.box((5, 5, 5), (6, 6, 6))).components()] == [8, 1]


def test_boxes_of_fractions():
    third = Fraction(1, 3)
    cube = st.box((0, 0, 0), (third, third, third))
    assert cube.volume == third**3 and cube == st.box((0, 0, 0), (1, 1, 1)).scaled(third)


def test_numbers_of_any_size():
    tiny = Fraction(1, 3**400)
    cube = st.box((0, 0, 0), (1, 1, 1)).translated((tiny, -tiny, 10**20))
    assert cube.volume == 1
    assert cube.exact_vertices[0].tolist()[0] in (tiny, 1 + tiny)
    assert (cube - st.box((0, 0, 0), (1, 1, 1)).translated((0, 0, 10**20))).volume == 1 - (1 - tiny) ** 2


def test_sources():
    part = A - B
    assert set(part.source_operands.tolist()) == {0, 1}
    assert part.source_faces.max() < 12 and len(part.source_faces) == len(part.triangles)


def test_rounding():
    third = A.scaled(Fraction(1, 3))
    mesh = third.rounded("float32")
    assert np.array_equal(mesh.vertices, mesh.vertices.astype(np.float32))
    assert mesh.rounding is not None and mesh.rounding["largest_movement"] < 4e-8
    assert st.check(mesh) == ()
    step = third.rounded(Fraction(1, 8))
    assert set(step.vertices.ravel().tolist()) == {0.0, 0.625}
    with pytest.raises(ValueError, match="rounding: expected one of float64, float32"):
        third.rounded("float16")
    with pytest.raises(ValueError):
        third.rounded(-1)


def test_classes_of_input():
    both = st.Mesh(np.vstack([A.vertices, B.vertices]), np.vstack([A.triangles, B.triangles + 8]))
    resolved = st.Solid(both)
    assert resolved.volume == 15 and resolved.notes[0].kind == "self-intersection"
    assert st.Solid(both, input="overlapping") == resolved == st.resolve(both)
    assert st.resolve(both, inside="even-odd").volume == 14
    assert st.resolve(both, inside="outer").volume == 15
    with pytest.raises(ValueError, match="input: expected one of automatic, solid, overlapping, repair, soup, found 'x'"):
        st.Solid(both, input="x")
    with pytest.raises(TypeError, match="input: expected a name"):
        st.Solid(both, input=3)


def test_soup_fills_holes():
    open_box = st.Mesh(A.vertices, A.triangles[1:])
    with pytest.raises(st.InputError):
        st.Solid(open_box)
    filled = st.Solid(open_box, input="soup")
    assert filled == A and filled.notes
    with pytest.raises(st.InputError):
        st.Solid(open_box, input="soup", most_hole_edges=2)
