"""trimesh: conversions, the engine, its registration."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
import strata_csg as st

trimesh = pytest.importorskip("trimesh")
interop = pytest.importorskip("strata_csg.trimesh")

#: 1 + TINY is a double that rounds to 1 as a float.
TINY = 2.0**-40


@pytest.fixture
def registered() -> Iterator[None]:
    interop.register()
    yield
    interop.unregister()


def cube(at: Any = (0, 0, 0), size: float = 1) -> Any:
    lower = np.asarray(at, dtype=float)
    return trimesh.creation.box(bounds=[lower, lower + size])


# Conversions


def test_doubles_survive_there_and_back() -> None:
    mesh = cube()
    mesh.vertices += np.array([1 + TINY, 1 / 3, 0])
    back = interop.to_trimesh(interop.from_trimesh(mesh))
    assert back.vertices.dtype == np.float64
    assert set(map(tuple, back.vertices)) == set(map(tuple, mesh.vertices))


def test_vertices_are_neither_merged_nor_removed() -> None:
    solid = (st.box((0, 0, 0), (1, 1, 1)) | st.box((1, 1, 0), (2, 2, 1))).separated()
    mesh = interop.to_trimesh(solid)
    assert np.array_equal(mesh.vertices, solid.vertices)
    assert np.array_equal(mesh.faces, solid.triangles)


def test_a_converted_mesh_can_be_changed() -> None:
    solid = st.box((0, 0, 0), (1, 1, 1))
    mesh = interop.to_trimesh(solid)
    mesh.apply_translation([5, 0, 0])
    mesh.invert()
    assert solid.bounds.tolist() == [[0, 0, 0], [1, 1, 1]]


def test_methods_of_solid_convert() -> None:
    assert st.Solid.from_trimesh(cube()).volume == 1
    assert st.Solid.from_trimesh(cube(), input="solid").to_trimesh().is_volume


def test_a_solid_of_a_later_changed_mesh_stays() -> None:
    mesh = cube()
    solid = interop.from_trimesh(mesh)
    mesh.apply_scale(3)
    assert solid.volume == 1


def test_primitives_are_meshes() -> None:
    assert interop.from_trimesh(trimesh.primitives.Box(extents=(1, 2, 3))).volume == 6


def test_meshes_without_shared_vertices_are_joined() -> None:
    mesh = cube()
    soup = trimesh.Trimesh(mesh.triangles.reshape(-1, 3), np.arange(36).reshape(-1, 3), process=False)
    assert interop.from_trimesh(soup).volume == 1


def test_the_empty_solid_is_an_empty_mesh() -> None:
    assert interop.to_trimesh(st.Solid()).is_empty
    assert interop.from_trimesh(trimesh.Trimesh()).is_empty


def test_rational_vertices_become_the_nearest_doubles() -> None:
    third = Fraction(1, 3)
    mesh = interop.to_trimesh(st.box((0, 0, 0), (1, 1, 1)).scaled(third))
    assert mesh.bounds[1].tolist() == [1 / 3] * 3


def test_meshes_that_are_no_result_have_no_sources() -> None:
    mesh = interop.to_trimesh(st.Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]))
    assert mesh.face_attributes == {}
    assert len(mesh.faces) == 1


def test_notes_are_metadata() -> None:
    a, b = cube(), cube((0.5, 0, 0))
    both = trimesh.util.concatenate([a, b])
    mesh = interop.boolean([both, cube((9, 9, 9))], "difference")
    assert mesh.volume == pytest.approx(1.5)
    assert any("self-intersection" in note for note in mesh.metadata["strata_notes"])
    assert "strata_notes" not in interop.boolean([a, b], "union").metadata


def test_what_is_no_mesh_is_refused_by_name() -> None:
    with pytest.raises(TypeError, match="found Scene"):
        interop.from_trimesh(trimesh.Scene([cube()]))


def test_open_meshes_are_refused_with_their_defects() -> None:
    mesh = cube()
    with pytest.raises(st.InputError) as caught:
        interop.from_trimesh(trimesh.Trimesh(mesh.vertices, mesh.faces[1:]))
    assert {defect.kind for defect in caught.value.defects} == {"open edge"}


@pytest.mark.parametrize("mesh", [cube(), trimesh.creation.icosphere()], ids=["box", "sphere"])
def test_functions_of_the_package_take_trimesh_meshes(mesh: Any) -> None:
    # Trimesh.triangles are coordinates: catches their use as numbers of vertices.
    assert float(st.Solid(mesh).volume) == pytest.approx(mesh.volume)
    assert len(st.boolean("union", [mesh, mesh]).triangles) == len(mesh.faces)


# The engine


@pytest.mark.parametrize(
    ("operation", "volume"),
    [("union", 1.5), ("intersection", 0.5), ("difference", 0.5), ("symmetric-difference", 1.0)],
)
def test_operations_have_their_volumes(operation: str, volume: float) -> None:
    result = interop.boolean([cube(), cube((0.5, 0, 0))], operation)
    assert result.is_volume
    assert result.volume == pytest.approx(volume)


def test_results_hold_what_floats_do_not() -> None:
    result = interop.boolean([cube((1, 0, 0)), cube((1 + TINY, 0, 0))], "difference")
    assert result.bounds.tolist() == [[1, 0, 0], [1 + TINY, 1, 1]]


def test_many_operands_are_combined_at_once() -> None:
    block, holes = cube(size=8), [cube((i, 1, 1)) for i in range(1, 8, 2)]
    assert interop.boolean([block, *holes], "difference").volume == pytest.approx(8**3 - 4)


def test_sources_name_the_plane_of_every_triangle() -> None:
    meshes = [cube(), cube((0.5, 0.5, 0.5))]
    result = interop.boolean(meshes, "union")
    operands, faces = (result.face_attributes[f"strata_source_{of}"] for of in ("operand", "face"))
    assert set(operands) == {0, 1}
    for triangle, operand, face in zip(result.triangles, operands, faces, strict=True):
        corners, normal = meshes[operand].triangles[face], meshes[operand].face_normals[face]
        assert np.allclose((triangle - corners[0]) @ normal, 0)


def test_disjoint_meshes_have_an_empty_intersection() -> None:
    result = interop.boolean([cube(), cube((5, 0, 0))], "intersection")
    assert isinstance(result, trimesh.Trimesh)
    assert result.is_empty
    assert result.faces.shape == (0, 3)


def test_non_volumes_are_refused_as_trimesh_does() -> None:
    mesh = cube()
    broken = trimesh.Trimesh(mesh.vertices, mesh.faces[1:])
    with pytest.raises(ValueError, match="Not all meshes are volumes! Mesh 1 is not watertight; open edge") as caught:
        interop.boolean([mesh, broken], "union")
    assert isinstance(caught.value, st.InputError)
    assert caught.value.operand == 1
    with pytest.raises(ValueError, match="Mesh 0 is empty"):
        interop.boolean([trimesh.Trimesh(), mesh], "union")
    mesh.invert()
    with pytest.raises(ValueError, match="Mesh 0 has no positive volume; inside-out"):
        interop.boolean([mesh, cube()], "union")


def test_without_the_check_strata_decides() -> None:
    mesh = cube()
    broken = trimesh.Trimesh(mesh.vertices, mesh.faces[1:])
    assert interop.boolean([mesh, trimesh.Trimesh()], "union", check_volume=False).is_volume
    touching = interop.to_trimesh(st.box((0, 0, 0), (1, 1, 1)) | st.box((1, 1, 0), (2, 2, 1)))
    assert not touching.is_volume  # four faces at one edge
    assert interop.boolean([touching, mesh], "union", check_volume=False).volume == pytest.approx(2)
    with pytest.raises(st.InputError) as caught:
        interop.boolean([mesh, broken], "union", check_volume=False)
    assert caught.value.operand == 1
    assert interop.boolean([mesh, broken], "union", check_volume=False, input="soup").volume == pytest.approx(1)


def test_unknown_operations_and_missing_operands_are_refused() -> None:
    with pytest.raises(ValueError, match="invert"):
        interop.boolean([cube(), cube()], "invert")
    with pytest.raises(ValueError, match="two meshes"):
        interop.boolean([cube()], "difference")


# Registration


@pytest.mark.usefixtures("registered")
def test_trimesh_finds_the_engine() -> None:
    interop.register()  # again: harmless
    a, b = cube(), cube((0.5, 0, 0))
    assert "strata" in trimesh.boolean.engines_available
    for result, volume in [
        (trimesh.boolean.union([a, b], engine="strata"), 1.5),
        (a.intersection(b, engine="strata"), 0.5),
        (a.difference([b], engine="strata", threads=1), 0.5),
    ]:
        assert result.volume == pytest.approx(volume)
        assert "strata_source_face" in result.face_attributes


@pytest.mark.usefixtures("registered")
def test_options_reach_the_engine_through_trimesh() -> None:
    a, b = cube(), trimesh.Trimesh()
    assert a.union(b, engine="strata", check_volume=False, rounding="float32").volume == pytest.approx(1)
    with pytest.raises(ValueError, match="Not all meshes are volumes"):
        a.union(b, engine="strata")


def test_registration_is_undone() -> None:
    before = dict(trimesh.boolean._engines), set(trimesh.boolean.engines_available)
    interop.register(default=True)
    interop.register(default=True)
    interop.register()
    assert "strata_source_face" in cube().union(cube()).face_attributes
    interop.unregister()
    assert (trimesh.boolean._engines, trimesh.boolean.engines_available) == before
    interop.unregister()
    assert (trimesh.boolean._engines, trimesh.boolean.engines_available) == before


@pytest.mark.parametrize("engines", [None, [], {"other": None}])
def test_another_layout_of_trimesh_is_an_error_with_its_version(monkeypatch: Any, engines: Any) -> None:
    monkeypatch.setattr(trimesh.boolean, "_engines", engines)
    with pytest.raises(NotImplementedError, match=trimesh.__version__):
        interop.register()
