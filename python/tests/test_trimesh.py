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


# What meshes carry


def test_face_colours_are_carried() -> None:
    mesh = cube()
    mesh.visual.face_colors = np.arange(48).reshape(12, 4)
    solid = st.Solid.from_trimesh(mesh)
    assert solid.attributes is not None and np.array_equal(solid.attributes.face["color"], mesh.visual.face_colors)
    assert np.array_equal(solid.to_trimesh().visual.face_colors, mesh.visual.face_colors)
    below, _ = solid.split(((0, 0, 1), Fraction(1, 2)))
    kept = below.source_operands == 0
    faces = below.to_trimesh().visual.face_colors[kept]
    assert np.array_equal(faces, np.asarray(mesh.visual.face_colors)[below.source_faces[kept]])


def test_vertex_colours_are_carried() -> None:
    mesh = cube()
    colors = np.arange(32, dtype=np.uint8).reshape(8, 4)
    mesh.visual.vertex_colors = colors
    back = interop.to_trimesh(interop.from_trimesh(mesh))
    assert back.visual.kind == "vertex" and np.array_equal(back.visual.vertex_colors, colors)
    assert back.is_volume


def test_operands_without_colours_are_white() -> None:
    first, second = cube(), cube((0.5, 0.5, 0.5))
    first.visual.face_colors = [9, 8, 7, 6]
    result = interop.boolean([first, second], "union")
    operand = result.face_attributes["strata_source_operand"]
    assert set(map(tuple, result.visual.face_colors[operand == 0].tolist())) == {(9, 8, 7, 6)}
    assert set(map(tuple, result.visual.face_colors[operand == 1].tolist())) == {(255, 255, 255, 255)}


def test_seams_are_split_on_request_only() -> None:
    first, second = cube(), cube((0.5, 0.5, 0.5))
    first.visual.vertex_colors, second.visual.vertex_colors = [10, 0, 0, 255], [20, 0, 0, 255]
    solid = interop.from_trimesh(first) | interop.from_trimesh(second)
    joined, split = interop.to_trimesh(solid), interop.to_trimesh(solid, split=True)
    assert joined.is_volume and not split.is_watertight
    first = [np.flatnonzero(solid.triangles.reshape(-1) == v)[0] for v in range(len(solid.vertices))]
    assert solid.attributes is not None
    assert np.array_equal(joined.visual.vertex_colors, solid.attributes.corner["color"][first])
    assert np.array_equal(split.vertices[: len(joined.vertices)], joined.vertices)
    assert np.array_equal(split.triangles, joined.triangles)
    red = split.visual.vertex_colors[split.faces][:, :, 0]
    assert np.array_equal(red, np.repeat(10 + 10 * solid.source_operands[:, None], 3, axis=1))
    assert interop.boolean([split, cube((9, 9, 9))], "union").volume == pytest.approx(joined.volume + 1)


def textured(at: Any, picture: Any, name: str) -> Any:
    mesh = cube(at)
    uv = np.column_stack([mesh.vertices[:, 0] - at[0], mesh.vertices[:, 1] - at[1]])
    material = trimesh.visual.material.PBRMaterial(name=name, baseColorTexture=picture, metallicFactor=0.25)
    mesh.visual = trimesh.visual.TextureVisuals(uv=uv, material=material)
    return mesh


def test_textures_are_carried_with_their_pictures() -> None:
    pictures = pytest.importorskip("PIL.Image")
    red, blue = (pictures.new("RGB", (2, 3), color) for color in ("red", "blue"))
    meshes = [textured((0, 0, 0), red, "red"), textured((0.5, 0.5, 0.5), blue, "blue")]
    back = interop.to_trimesh(interop.from_trimesh(meshes[0]))
    assert back.visual.kind == "texture" and back.visual.material.name == "red"
    assert back.visual.material.baseColorTexture.getpixel((0, 0)) == (255, 0, 0)
    assert back.visual.material.metallicFactor == 0.25
    assert np.array_equal(back.visual.uv, meshes[0].visual.uv)
    result = interop.boolean(meshes, "difference")
    operand = result.face_attributes["strata_source_operand"]
    places = np.array([[0, 0, 0], [0.5, 0.5, 0.5]])[operand][:, None, :2]
    assert np.allclose(result.visual.uv[result.faces], result.triangles[:, :, :2] - places)
    names = [material.name for material in result.visual.material.materials]
    assert names == ["red", "blue"] and np.array_equal(result.visual.face_materials, operand)
    again = interop.from_trimesh(result)
    assert again.attributes is not None and [m.name for m in again.attributes.materials] == ["red", "blue"]
    assert np.array_equal(again.attributes["material"], operand)


def test_textures_without_pillow_have_no_pictures(monkeypatch: Any) -> None:
    pictures = pytest.importorskip("PIL.Image")
    solid = interop.from_trimesh(textured((0, 0, 0), pictures.new("RGB", (2, 3)), "wood"))
    monkeypatch.setitem(__import__("sys").modules, "PIL.Image", None)
    material = solid.to_trimesh().visual.material
    assert material.name == "wood" and material.baseColorTexture is None


def test_materials_without_texture_coordinates_are_colours() -> None:
    cut = st.difference([st.box((0, 0, 0), (1, 1, 1)), st.box((0, 0, 0.5), (1, 1, 2))], cut_material=st.Material("m", (1, 0, 0)))
    mesh = cut.to_trimesh()
    assert set(map(tuple, mesh.visual.face_colors.tolist())) == {(255, 0, 0, 255), (255, 255, 255, 255)}
    assert set(mesh.face_attributes["material"].tolist()) == {-1, 0}


def test_attributes_of_vertices_and_faces_are_carried() -> None:
    mesh = trimesh.Trimesh(
        *(cube().vertices, cube().faces),
        vertex_attributes={"heat": np.arange(8.0)},
        face_attributes={"heat": np.arange(12), "name": np.array(["a"] * 12)},
        process=False,
    )
    with pytest.warns(UserWarning, match='not carried: channel "name": expected floats'):
        solid = interop.from_trimesh(mesh)
    back = solid.to_trimesh()
    assert back.vertex_attributes["heat"].tolist() == list(range(8))
    assert back.face_attributes["heat"].tolist() == list(range(12))


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
