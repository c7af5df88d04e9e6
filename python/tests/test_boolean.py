"""Booleans from arrays to arrays, and of many solids."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
import strata_csg as st

A = st.box((0, 0, 0), (2, 2, 2))
B = st.box((1, 1, 1), (3, 3, 3))
VOLUMES = {"union": 15, "intersection": 1, "difference": 7, "symmetric-difference": 14, "xor": 14}


@pytest.mark.parametrize("operation", VOLUMES)
@pytest.mark.parametrize("engine", [None, "bsp", "layers"])
def test_operations(operation, engine):
    result = st.boolean(operation, [A, B], engine=engine)
    assert st.Solid(result).volume == VOLUMES[operation]


def test_functions():
    assert st.union([A, B]) == A | B
    assert st.intersection(iter([A, B])) == A & B
    assert st.difference((A, B)) == A - B
    assert st.symmetric_difference({A, B}) == A ^ B
    assert not st.union([])
    with pytest.raises(TypeError, match="solids: expected solids, found 3"):
        st.union([A, 3])
    with pytest.raises(TypeError, match="solids: expected a list of solids"):
        st.union(A)


def test_results_do_not_depend_on_threads():
    a, b = st.sphere(1, 60), st.sphere(1, 60).translated((Fraction(1, 3), 0, 0))
    one = st.boolean("union", [a, b], threads=1)
    for threads in (0, 2, 3, 8):
        other = st.boolean("union", [a, b], threads=threads)
        assert one == other and np.array_equal(one.source_faces, other.source_faces)


def test_sources_lead_back():
    result = st.boolean("difference", [A, B])
    for triangle, operand, face in zip(result.triangles, result.source_operands, result.source_faces, strict=True):
        corners = result.vertices[triangle]
        source = (A, B)[operand]
        a, b, c = source.vertices[source.triangles[face]]
        normal = np.cross(b - a, c - a)
        assert np.all((corners - a) @ normal == 0)


def test_exact_results():
    tilted = B.rotated((1, 2, 3), 40)
    nearest = st.boolean("union", [A, tilted])
    exact = st.boolean("union", [A, tilted], exact=True)
    assert np.array_equal(nearest.vertices, exact.vertices)
    assert len(exact.exact_parts[0]) > 0 == len(nearest.exact_parts[0])
    assert st.Solid.trusted(exact) == A | tilted
    with pytest.raises(ValueError, match="expected exact or rounding"):
        st.boolean("union", [A], exact=True, rounding="float32")


def test_rounded_results():
    tilted = B.rotated((1, 2, 3), 40)
    result = st.boolean("union", [A, tilted], rounding="float32")
    assert np.array_equal(result.vertices, result.vertices.astype(np.float32))
    assert result.rounding is not None and st.check(result) == ()
    assert st.boolean("union", [A, B]).rounding is None


@pytest.mark.parametrize("operation", ["unite", "", 3])
def test_operations_that_are_none(operation):
    with pytest.raises((ValueError, TypeError), match="operation: expected"):
        st.boolean(operation, [A, B])


def test_defects_name_the_operand():
    with pytest.raises(st.InputError) as caught:
        st.boolean("union", [A, B, (A.vertices, A.triangles[1:])])
    assert caught.value.operand == 2
    assert caught.value.defects[0].kind == "open edge" and caught.value.defects[0].count == 3
    assert isinstance(caught.value, ValueError)


def test_expressions():
    hole = st.Expression(B, "hole")
    part = st.Expression(A, "block") - hole.transformed(np.eye(4))
    assert str(part) == "block - hole" and len(part) == 2
    assert part.evaluate() == A - B
    assert (A - hole).evaluate() == A - B and (hole | A).evaluate() == A | B
    parsed = st.Expression.parse("(a | b) & ~b", {"a": A, "b": B})
    assert parsed.evaluate() == A - B
    with pytest.raises(st.ParseError) as caught:
        st.Expression.parse("a - c", {"a": A})
    assert caught.value.position == 4
    with pytest.raises(ValueError, match="bounded"):
        (~A).evaluate()
    assert [name for name, *_ in part.primitives] == ["block", "hole"]
    assert st.Expression.any([]).evaluate() == st.Solid()


def test_a_long_expression_is_exact():
    part = st.Expression(st.box((0, 0, 0), (1000, 1, 1)))
    for i in range(1000):
        part = part - st.box((i, 0, 0), (i + 1, 1, 1)).scaled((1, 1, Fraction(1, 3)))
    assert part.evaluate().volume == Fraction(2000, 3)


def test_workpieces():
    work = st.Workpiece(st.box((0, 0, 0), (10, 10, 2)))
    versions = [work]
    for i in range(1, 9):
        versions.append(versions[-1].cut(st.box((i, 1, 1), (i + 0.5, 9, 3))))
    assert [v.solid.volume for v in versions] == [200 - 4 * i for i in range(9)]
    both = work.combined("difference", [st.box((i, 1, 1), (i + 0.5, 9, 3)) for i in range(1, 9)])
    assert both.solid == versions[-1].solid
    assert not st.Workpiece()
