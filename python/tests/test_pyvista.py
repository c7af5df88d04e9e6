"""PyVista: conversions and the accessor."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
import strata_csg as st

pyvista = pytest.importorskip("pyvista")
interop = pytest.importorskip("strata_csg.pyvista")

#: 1 + TINY is a double that rounds to 1 as a float.
TINY = 2.0**-40


def cube(at: Any = (0, 0, 0), size: float = 1) -> Any:
    """Of six squares, in doubles."""
    mesh = pyvista.Cube(bounds=(0, 1, 0, 1, 0, 1))
    mesh.points = np.asarray(mesh.points, dtype=np.float64) * size + np.asarray(at, dtype=np.float64)
    return mesh


# Conversions


def test_doubles_survive_there_and_back() -> None:
    mesh = cube((1 + TINY, 1 / 3, 0))
    back = interop.to_pyvista(interop.from_pyvista(mesh))
    assert back.points.dtype == np.float64
    assert set(map(tuple, back.points)) == set(map(tuple, mesh.points))


def test_floats_are_taken_as_they_are() -> None:
    mesh = pyvista.Sphere()
    assert mesh.points.dtype == np.float32
    assert interop.from_pyvista(mesh).bounds.ravel().tolist() == pytest.approx(
        [mesh.bounds[i] for i in (0, 2, 4, 1, 3, 5)], rel=1e-12
    )


def test_a_converted_mesh_can_be_changed() -> None:
    solid = st.box((0, 0, 0), (1, 1, 1))
    mesh = interop.to_pyvista(solid)
    mesh.points += 5
    mesh.regular_faces[:] = 0
    assert solid.bounds.tolist() == [[0, 0, 0], [1, 1, 1]]
    assert len(set(solid.triangles.ravel().tolist())) == 8


@pytest.mark.parametrize("mesh", [cube(), cube().triangulate(), cube().triangulate().strip()])
def test_polygons_triangles_and_strips_are_taken(mesh: Any) -> None:
    assert interop.from_pyvista(mesh).volume == 1


def test_vertices_and_lines_are_left_out() -> None:
    mesh = cube().triangulate()
    mesh.clear_data()
    mesh.verts, mesh.lines = [1, 0, 1, 1], [2, 0, 1]
    assert interop.from_pyvista(mesh).volume == 1
    assert mesh.n_cells == 15


def test_the_empty_solid_is_an_empty_mesh() -> None:
    assert interop.to_pyvista(st.Solid()).n_cells == 0
    assert interop.from_pyvista(pyvista.PolyData()).is_empty


def test_meshes_that_are_no_result_have_no_sources() -> None:
    mesh = interop.to_pyvista(st.Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]))
    assert mesh.cell_data.keys() == []


def test_other_data_sets_are_refused_by_name() -> None:
    with pytest.raises(TypeError, match="found ImageData"):
        interop.from_pyvista(pyvista.ImageData(dimensions=(2, 2, 2)))


def test_open_meshes_are_refused_with_their_defects() -> None:
    with pytest.raises(st.InputError) as caught:
        interop.from_pyvista(pyvista.Plane())
    assert {defect.kind for defect in caught.value.defects} == {"open edge"}


# What meshes carry


def test_data_survives_there_and_back() -> None:
    mesh = cube().triangulate()
    mesh.clear_data()
    mesh.point_data["place"] = np.array(mesh.points)
    mesh.point_data["Normals"] = np.array(mesh.points) - 0.5
    mesh.cell_data["id"] = np.arange(12)
    mesh.cell_data["place"] = np.arange(24, dtype=np.float32).reshape(12, 2)
    mesh.cell_data["flag"] = np.arange(12) % 2 == 0
    solid = interop.from_pyvista(mesh)
    assert {channel.name: channel.interpolation for channel in solid.attributes.channels} == {
        "place": "linear",
        "Normals": "spherical",
        "id": "nearest",
        "place_cell": "linear",
        "flag": "nearest",
    }
    back = interop.to_pyvista(solid)
    assert np.array_equal(back.point_data["place"], back.points)
    assert np.array_equal(back.cell_data["id"], np.arange(12))
    assert np.array_equal(back.cell_data["place"], mesh.cell_data["place"])
    assert np.array_equal(back.cell_data["flag"], mesh.cell_data["flag"])


def test_data_of_polygons_goes_to_their_triangles() -> None:
    mesh = cube()
    mesh.clear_data()
    mesh.cell_data["side"] = np.arange(6)
    solid = interop.from_pyvista(mesh)
    normals = np.cross(*(np.diff(solid.vertices[solid.triangles], axis=1).transpose(1, 0, 2)))
    for side in range(6):
        assert len(np.unique(normals[solid.attributes["side"] == side], axis=0)) == 1


def test_data_that_no_channel_holds_is_left_out_with_a_warning() -> None:
    mesh = cube()
    mesh.clear_data()
    mesh.cell_data["tensor"] = np.zeros((6, 9))
    with pytest.warns(UserWarning, match='not carried: channel "tensor": 9 components'):
        assert not interop.from_pyvista(mesh).attributes
    mesh = cube()
    mesh.clear_data()
    mesh.cell_data["id"] = np.arange(6)
    mesh.verts = [1, 0]
    with pytest.warns(UserWarning, match="not carried: 'id' has 6 values for 7 cells"):
        assert not interop.from_pyvista(mesh).attributes


# The accessor

accessor = pytest.mark.skipif(not hasattr(pyvista, "register_dataset_accessor"), reason="this PyVista has no accessors")


@accessor
@pytest.mark.parametrize(
    ("operation", "volume"),
    [("union", 1.5), ("intersection", 0.5), ("difference", 0.5), ("symmetric_difference", 1.0)],
)
def test_operations_have_their_volumes(operation: str, volume: float) -> None:
    result = getattr(cube().strata, operation)(cube((0.5, 0, 0)))
    assert isinstance(result, pyvista.PolyData)
    assert result.volume == pytest.approx(volume)
    assert result.is_manifold


@accessor
def test_results_hold_what_floats_do_not() -> None:
    result = cube((1, 0, 0)).strata.difference(cube((1 + TINY, 0, 0)))
    assert result.points.dtype == np.float64
    assert np.unique(result.points[:, 0]).tolist() == [1, 1 + TINY]


@accessor
def test_sources_are_cells_of_the_operands() -> None:
    first = cube().triangulate()
    first.clear_data()
    first.verts, first.lines = [1, 0, 1, 1], [2, 0, 1]  # cells 0 to 2
    operands = [first, cube((0.5, 0.5, 0.5))]
    result = operands[0].strata.union(operands[1])
    numbers = result.cell_data["strata_source_operand"]
    faces = result.cell_data["strata_source_face"]
    assert set(numbers) == {0, 1}
    assert set(faces[numbers == 0]) == set(range(3, 15))
    assert set(faces[numbers == 1]) == set(range(6))
    for triangle, operand, face in zip(range(result.n_cells), numbers, faces, strict=True):
        polygon, part = operands[operand].get_cell(face).points, result.get_cell(triangle).points
        normal = np.cross(polygon[1] - polygon[0], polygon[2] - polygon[0])
        assert np.allclose((part - polygon[0]) @ normal, 0)


@accessor
def test_many_operands_and_other_meshes_are_combined_at_once() -> None:
    solid = st.box((2, 0, 0), (3, 1, 1))
    result = cube().strata.union(cube((1, 0, 0)), solid, solid.rounded(), (solid.vertices, solid.triangles))
    assert result.volume == pytest.approx(3)
    assert result.bounds[1] == 3


@accessor
def test_data_goes_through_operations() -> None:
    operands = [cube().triangulate(), cube((0.5, 0.5, 0.5)).triangulate()]
    for number, mesh in enumerate(operands):
        mesh.clear_data()
        mesh.point_data["x"] = np.array(mesh.points[:, 0])
        mesh.cell_data["id"] = 100 * number + np.arange(mesh.n_cells)
    for operation in ("union", "intersection", "difference", "symmetric_difference"):
        result = getattr(operands[0].strata, operation)(operands[1])
        assert np.array_equal(result.point_data["x"], result.points[:, 0])
        expected = 100 * result.cell_data["strata_source_operand"].astype(int) + result.cell_data["strata_source_face"]
        assert np.array_equal(result.cell_data["id"], expected)
        assert result.is_manifold or operation == "symmetric_difference"
    tool = cube((0.25, 0.25, 0.25), 0.5)
    tool.point_data["x"] = np.array(tool.points[:, 0])
    chained = operands[0].strata.union(operands[1]).strata.difference(tool)
    assert np.allclose(chained.point_data["x"], chained.points[:, 0])


@accessor
def test_disjoint_meshes_have_an_empty_intersection() -> None:
    result = cube().strata.intersection(cube((5, 0, 0)))
    assert result.n_cells == 0
    assert set(result.cell_data) >= {"strata_source_face", "strata_source_operand"}


@accessor
def test_errors_name_the_operand() -> None:
    with pytest.raises(st.InputError) as caught:
        cube().strata.union(pyvista.Plane())
    assert caught.value.operand == 1
    with pytest.raises(TypeError, match="operand 1"):
        cube().strata.union(pyvista.ImageData(dimensions=(2, 2, 2)))


@accessor
def test_options_reach_the_engine() -> None:
    mesh = cube().triangulate()
    broken = pyvista.PolyData.from_regular_faces(mesh.points, mesh.regular_faces[1:])
    assert broken.strata.union(mesh, input="soup").volume == pytest.approx(1)
    assert broken.strata.solid(input="soup").volume == 1
    assert {defect.kind for defect in broken.strata.check()} == {"open edge"}
    assert mesh.strata.check() == ()


@accessor
def test_the_accessor_is_registered_once() -> None:
    interop._register()
    assert [record.name for record in pyvista.registered_accessors()].count("strata") == 1


def test_without_accessors_conversions_remain(monkeypatch: Any) -> None:
    monkeypatch.delattr(pyvista, "register_dataset_accessor", raising=False)
    interop._register()
    assert interop.from_pyvista(cube()).volume == 1
