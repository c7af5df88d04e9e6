"""Laws of attributes on random solids that love to touch, and what memory they take."""

from __future__ import annotations

import gc
import multiprocessing
import resource
from concurrent.futures import ProcessPoolExecutor
from fractions import Fraction

import numpy as np
import strata_csg as st
from hypothesis import given, settings
from hypothesis import strategies as some
from test_laws import solids

#: Rows of affine functions of position: three factors and a constant.
AFFINE = np.array([[1.0, 2, -3, 4], [0.5, 0, 1, -8], [0, 0, 0, 7]])
OPERATIONS = ("union", "intersection", "difference", "symmetric-difference")


def affine_at(points: np.ndarray) -> np.ndarray:
    return np.asarray(points @ AFFINE[:, :3].T + AFFINE[:, 3])


def described(solid: st.Solid, operand: int) -> st.Solid:
    """With affine functions of position, and with numbers that say operand and face."""
    faces = np.arange(len(solid.triangles))
    attributes = st.Attributes(
        vertex={"affine": affine_at(solid.vertices)},
        corner={"corner": affine_at(solid.vertices[solid.triangles].reshape(-1, 3)).astype(np.float32)},
        face={"id": 1000 * operand + faces},
    )
    return solid.with_attributes(attributes)


def at_corners(mesh: st.Mesh | st.Solid, name: str) -> np.ndarray:
    assert mesh.attributes is not None
    values = mesh.attributes[name]
    values = values if name in mesh.attributes.corner else values[mesh.triangles]
    return np.asarray(values.reshape(-1, 3))


@given(solids(), solids(), some.sampled_from(OPERATIONS))
@settings(max_examples=100, deadline=None)
def test_affine_functions_stay_these_functions(a: st.Solid, b: st.Solid, operation: str) -> None:
    result = st.boolean(operation, [described(a, 0), described(b, 1)])  # type: ignore[arg-type]
    if not len(result.triangles):
        return
    expected = affine_at(result.vertices[result.triangles].reshape(-1, 3))
    scale = np.abs(AFFINE).sum() * max(1.0, float(np.abs(result.vertices).max()))
    assert np.abs(at_corners(result, "affine") - expected).max() <= 8 * np.finfo(np.float64).eps * scale
    assert np.abs(at_corners(result, "corner") - expected).max() <= 8 * np.finfo(np.float32).eps * scale


@given(solids(), solids(), some.sampled_from(OPERATIONS))
@settings(max_examples=100, deadline=None)
def test_identifiers_stay_identifiers(a: st.Solid, b: st.Solid, operation: str) -> None:
    operands = [described(a, 0), described(b, 1)]
    result = st.boolean(operation, operands)  # type: ignore[arg-type]
    assert result.attributes is not None
    ids = result.attributes["id"]
    assert np.array_equal(ids, 1000 * result.source_operands.astype(int) + result.source_faces)
    for triangle, number in zip(result.triangles, ids, strict=True):
        source, face = operands[number // 1000], number % 1000
        p, q, r = source.exact_vertices[source.triangles[face]]
        normal = np.cross(q - p, r - p)
        exact = st.Mesh(result.exact_vertices, result.triangles).exact_vertices[triangle]
        assert all(abs(float(normal @ (corner - p))) < 1e-9 for corner in exact)


@given(solids(), solids())
@settings(max_examples=60, deadline=None)
def test_ways_to_the_same_result_carry_the_same(a: st.Solid, b: st.Solid) -> None:
    a, b = described(a, 0), described(b, 1)
    result = a - b
    assert result.attributes == st.difference([a, b]).attributes
    assert result.attributes == st.boolean("difference", [a, b], exact=True, threads=1).attributes
    assert result == st.difference([x.with_attributes(None) for x in (a, b)])
    carried = st.carry_attributes([a, b], result)
    assert carried == (result.attributes or st.Attributes())


@given(solids(), some.integers(1, 7))
@settings(max_examples=60, deadline=None)
def test_halves_and_components_carry(solid: st.Solid, height: int) -> None:
    whole = described(solid, 0)
    for half in whole.split(((1, 2, 3), Fraction(height, 2))):
        for part in half.components():
            assert part.attributes is not None
            kept = part.source_operands == 0
            ids = part.attributes["id"]
            assert set(ids[kept].tolist()) <= set(range(len(whole.triangles)))


def growth() -> int:
    """By how many kB the memory of this process grows in a thousand rounds."""
    a, b = described(st.sphere(1, 12), 0), described(st.sphere(1, 12).translated((0.3, 0.2, 0.1)), 1)
    picture = st.Image("a", "image/png", bytes(10_000))

    def run(count: int) -> int:
        for _ in range(count):
            result = st.boolean("union", [a, b])
            assert result.attributes is not None
            _ = [channel.values for channel in result.attributes.channels], result.attributes.vertex
            values = np.zeros(1000)
            made = st.Attributes(vertex={"x": values}, materials=[st.Material("m", image=0)], images=[picture])
            _ = made.materials, made.images, made["x"], made.with_channels(st.Channel("x", values)), hash(made)
            try:
                a.with_attributes(made)
            except ValueError:
                pass
        gc.collect()
        return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss

    run(600)
    before = run(300)
    return run(1000) - before


def test_nothing_leaks() -> None:
    with ProcessPoolExecutor(1, multiprocessing.get_context("spawn")) as pool:  # memory of other tests is none of it
        assert pool.submit(growth).result() < 6 * 1024  # a leak of one image or array per round would be 8,000 kB
