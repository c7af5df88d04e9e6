"""meshio: conversions, and the files that it writes."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
import strata_csg as st

meshio = pytest.importorskip("meshio")
interop = pytest.importorskip("strata_csg.meshio")

#: 1 + TINY is a double that rounds to 1 as a float.
TINY = 2.0**-40

POINTS = [[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
FACES = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]


def test_doubles_survive_there_and_back() -> None:
    solid = st.box((1 + TINY, 1 / 3, 0), (2, 1, 1))
    mesh = interop.to_meshio(solid)
    assert mesh.points.dtype == np.float64
    assert st.Solid(interop.from_meshio(mesh)) == solid


def test_a_converted_mesh_can_be_changed() -> None:
    solid = st.box((0, 0, 0), (1, 1, 1))
    mesh = interop.to_meshio(solid)
    mesh.points += 5
    mesh.cells[0].data[:] = 0
    assert solid.bounds.tolist() == [[0, 0, 0], [1, 1, 1]]


def test_blocks_of_triangles_are_joined_in_order() -> None:
    blocks = [("triangle", FACES[:1]), ("line", [[0, 1]]), ("vertex", [[0]]), ("triangle", FACES[1:])]
    mesh = interop.from_meshio(meshio.Mesh(POINTS, blocks))
    assert mesh.triangles.tolist() == FACES
    assert st.Solid(mesh).volume * 6 == 1


@pytest.mark.parametrize(
    ("cells", "named"),
    [
        ([("quad", [[0, 1, 2, 3]])], "quad"),
        ([("triangle", FACES), ("tetra", [[0, 1, 2, 3]])], "tetra"),
        ([("triangle6", [[0, 1, 2, 3, 3, 3]]), ("quad", [[0, 1, 2, 3]])], "quad, triangle6"),
        ([("polygon", [[0, 1, 2, 3]])], "polygon"),
    ],
)
def test_other_cells_are_refused_by_name(cells: Any, named: str) -> None:
    with pytest.raises(ValueError, match=f"found {named}$"):
        interop.from_meshio(meshio.Mesh(POINTS, cells))


def test_points_of_the_plane_are_refused() -> None:
    with pytest.raises(ValueError, match=r"\(n, 3\)"):
        interop.from_meshio(meshio.Mesh([[0.0, 0], [1, 0], [0, 1]], [("triangle", [[0, 1, 2]])]))


def test_results_have_their_sources() -> None:
    result = st.boolean("union", [st.box((0, 0, 0), (1, 1, 1)), st.box((0.5, 0.5, 0.5), (2, 2, 2))])
    mesh = interop.to_meshio(result)
    assert np.array_equal(mesh.cell_data["strata_source_operand"][0], result.source_operands)
    assert np.array_equal(mesh.cell_data["strata_source_face"][0], result.source_faces)


def test_data_survives_there_and_back() -> None:
    blocks = [("triangle", FACES[:1]), ("line", [[0, 1]]), ("triangle", FACES[1:])]
    data = {"id": [np.array([5]), np.array([0]), np.array([6, 7, 8])]}
    mesh = interop.from_meshio(meshio.Mesh(POINTS, blocks, point_data={"place": np.array(POINTS)}, cell_data=data))
    assert mesh.attributes is not None and mesh.attributes["id"].tolist() == [5, 6, 7, 8]
    back = interop.to_meshio(mesh)
    assert back.point_data["place"].tolist() == POINTS and back.cell_data["id"][0].tolist() == [5, 6, 7, 8]


def test_data_of_results_is_that_of_operands() -> None:
    solid = st.Solid(interop.from_meshio(meshio.Mesh(POINTS, [("triangle", FACES)], point_data={"place": np.array(POINTS)})))
    part = solid - st.box((0, 0, 0), (1, 1, 0.25))
    joined, split = interop.to_meshio(part), interop.to_meshio(part, split=True)
    assert len(joined.points) == len(part.vertices) < len(split.points)
    own = part.source_operands == 0
    corners = split.cells[0].data[own]
    assert np.array_equal(split.point_data["place"][corners], split.points[corners])
    assert not split.point_data["place"][split.cells[0].data[~own]].any()


@pytest.mark.parametrize("name", ["part.vtk", "part.vtu"])
def test_files_hold_data(tmp_path: Path, name: str) -> None:
    solid = st.box((0, 0, 0), (1, 1, 1)).with_attributes(st.Attributes(vertex={"heat": np.arange(8.0)}, face={"id": range(12)}))
    interop.to_meshio(solid).write(tmp_path / name)
    back = interop.from_meshio(meshio.read(tmp_path / name))
    assert back.attributes is not None and back.attributes["heat"].tolist() == list(range(8))
    assert back.attributes["id"].tolist() == list(range(12))


def test_meshes_that_are_no_result_have_no_sources() -> None:
    assert interop.to_meshio(st.Mesh(POINTS, FACES)).cell_data == {}


def test_the_empty_solid_has_no_cells() -> None:
    mesh = interop.to_meshio(st.Solid())
    assert len(mesh.points) == 0
    assert len(mesh.cells[0]) == 0
    assert st.Solid(interop.from_meshio(mesh)).is_empty
    assert len(interop.from_meshio(meshio.Mesh(np.empty((0, 3)), [])).triangles) == 0


@pytest.mark.parametrize("name", ["part.vtk", "part.vtu", "part.ply", "part.off", "part.msh"])
def test_files_hold_doubles(tmp_path: Path, name: str) -> None:
    solid = st.box((1, 0, 0), (2, 1 / 3, 1)) - st.box((1, 0, 0), (1 + TINY, 1, 1))
    mesh = interop.to_meshio(solid)
    mesh.write(tmp_path / name)
    back = meshio.read(tmp_path / name)
    assert st.Solid(interop.from_meshio(back)) == solid
    if name.endswith(("vtk", "vtu")):
        assert np.array_equal(back.cell_data["strata_source_face"][0], solid.source_faces)
