"""Laws of sets on random small solids that love to touch, and what memory they take."""

from __future__ import annotations

import gc
import resource
from fractions import Fraction

import strata_csg as st
from hypothesis import given, settings
from hypothesis import strategies as some

COORDINATE = some.integers(0, 3)


@some.composite
def boxes(draw: some.DrawFn) -> st.Solid:
    lower = draw(some.tuples(COORDINATE, COORDINATE, COORDINATE))
    sizes = draw(some.tuples(some.integers(1, 2), some.integers(1, 2), some.integers(1, 2)))
    return st.box(lower, tuple(a + b for a, b in zip(lower, sizes, strict=True)))


@some.composite
def tetrahedra(draw: some.DrawFn) -> st.Solid:
    point = some.tuples(COORDINATE, COORDINATE, COORDINATE)
    corners = [draw(point) for _ in range(4)]
    a, b, c, d = corners
    u, v, w = ([p[i] - a[i] for i in range(3)] for p in (b, c, d))
    if sum(u[i] * (v[i - 2] * w[i - 1] - v[i - 1] * w[i - 2]) for i in range(3)) == 0:
        return st.box(a, tuple(x + 1 for x in a))
    return st.tetrahedron(*corners)


@some.composite
def solids(draw: some.DrawFn) -> st.Solid:
    solid = draw(some.one_of(boxes(), tetrahedra()))
    if draw(some.booleans()):
        solid = solid | draw(boxes())
    if draw(some.booleans()):
        solid = solid.scaled(Fraction(draw(some.integers(1, 5)), 3))
    return solid


@given(solids(), solids())
@settings(max_examples=150, deadline=None)
def test_inclusion_and_exclusion(a: st.Solid, b: st.Solid) -> None:
    assert (a | b).volume + (a & b).volume == a.volume + b.volume
    assert (a - b).volume == a.volume - (a & b).volume
    assert (a ^ b).volume == (a | b).volume - (a & b).volume


@given(solids(), solids(), solids())
@settings(max_examples=60, deadline=None)
def test_laws_of_sets(a: st.Solid, b: st.Solid, c: st.Solid) -> None:
    assert a | b == b | a and a & b == b & a
    assert a & (b | c) == (a & b) | (a & c)
    assert a - (b | c) == (a - b) - c == (a - b) & (a - c)
    assert a | (a & b) == a == a & (a | b)
    assert (a ^ b) ^ b == a
    assert st.union([a, b, c]) == a | b | c
    assert st.Expression.any([st.Expression(x) for x in (a, b, c)]).evaluate() == a | b | c


@given(solids(), solids())
@settings(max_examples=60, deadline=None)
def test_polygons_of_sections_obey_the_same_laws(a: st.Solid, b: st.Solid) -> None:
    plane = ((0, 0, 1), 1)
    assert st.section(a | b, plane) == st.section(a, plane) | st.section(b, plane)
    assert st.section(a - b, plane) == st.section(a, plane) - st.section(b, plane)


@given(solids(), solids())
@settings(max_examples=60, deadline=None)
def test_arrays_give_what_solids_give(a: st.Solid, b: st.Solid) -> None:
    result = st.boolean("difference", [a, b], exact=True)
    assert st.Solid.trusted(result) == a - b
    assert all(defect.severity == "note" for defect in st.check(a - b))


def test_nothing_leaks() -> None:
    a, b = st.sphere(1, 12), st.sphere(1, 12).translated((0.3, 0.2, 0.1))
    arrays = [(a.vertices, a.triangles), (b.vertices, b.triangles)]

    def run(count: int) -> int:
        for _ in range(count):
            result = st.boolean("union", arrays)
            _ = result.vertices, result.triangles, result.source_faces, result.notes, result.seconds
            _ = (a - b).volume, (a & b).exact_vertices
            try:
                st.Solid((a.vertices, a.triangles[1:]))
            except st.InputError:
                pass
        gc.collect()
        return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss

    run(300)
    before = run(300)
    after = run(1000)
    assert after - before < 8 * 1024  # kB: a leak of one mesh per operation would be ten times that
