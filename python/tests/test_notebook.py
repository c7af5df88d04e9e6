"""The viewer for notebooks. browser_notebook.py looks at it in a browser."""

from __future__ import annotations

import base64
import html
import json
import math
import re
from fractions import Fraction
from html.parser import HTMLParser

import numpy as np
import pytest
import strata_csg as st
from strata_csg import _notebook
from strata_csg._notebook import Viewer, html_of, show
from strata_csg._picture import Frame, part_of, placed_parts

CUBE = st.box((0, 0, 0), (1, 1, 1))
NOTCHED = st.box((0, 0, 0), (2, 2, 1)) - st.box((1, 1, 0), (2, 2, 1))


class Attributes(HTMLParser):
    """The attributes of all elements, by the rules of browsers."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.found: list[tuple[str, dict[str, str | None]]] = []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        self.found.append((tag, dict(attributes)))


def page_of(text: str) -> str:
    """The page within the iframe."""
    (frame,) = [attributes for tag, attributes in Attributes(text).found if tag == "iframe"]
    return frame["srcdoc"]


def data_of(text: str) -> dict:
    found = re.search(r'<script type="application/json" id="data">(.*?)</script>', page_of(text), re.DOTALL)
    return json.loads(found.group(1))


def positions_of(data: dict) -> np.ndarray:
    return np.frombuffer(base64.b64decode(data["positions"]), "<f4").reshape(-1, 3)


def edges_of(data: dict) -> np.ndarray:
    return np.frombuffer(base64.b64decode(data["edges"]), "<u4").reshape(-1, 2)


def test_a_cube_is_small():
    assert len(CUBE._repr_html_()) < 30_000


def test_the_identifiers_of_two_viewers_differ():
    first, second = (re.findall(r'id="(strata-\w+)"', html_of(CUBE)) for _ in range(2))
    assert len(first) == len(second) == 1
    assert first != second


@pytest.mark.parametrize("word", ["http", "//cdn", "import(", "fetch(", "XMLHttpRequest", "url("])
def test_nothing_is_loaded(word):
    assert word not in html.unescape(html_of(CUBE))


def test_the_script_stands_alone():
    tags = [tag for tag, _ in Attributes(page_of(html_of(CUBE))).found]
    assert "link" not in tags and "img" not in tags
    assert not any("src" in attributes for _, attributes in Attributes(page_of(html_of(CUBE))).found)
    assert "</script" not in _notebook._script()


def test_the_line_of_facts():
    corner = st.tetrahedron((0, 0, 0), (4, 0, 0), (0, 4, 0), (0, 0, 4))
    rest = corner - corner.translated((1, 0, 0))
    assert show(rest).facts == "Solid: 8 triangles, volume 6.16666667 (exactly 37/6), from (0, 0, 0) to (1, 4, 4)"
    assert show(CUBE).facts.startswith("Solid: 12 triangles, volume 1, ")
    assert "exactly" not in show(st.sphere(1, 8)).facts
    assert show(st.boolean("union", [CUBE, CUBE])).facts.startswith("Mesh: 12 triangles, volume 1, ")
    assert show(st.Surface(CUBE)).facts.startswith("Surface: 12 triangles, area 6, ")


def test_edges_of_coplanar_triangles_are_not_drawn():
    assert len(edges_of(data_of(html_of(CUBE)))) == 12
    notched = data_of(html_of(NOTCHED))
    assert len(edges_of(notched)) == 18 + len(positions_of(notched)) - 12  # some have vertices in their middle


def test_edges_of_flat_and_of_fine_meshes():
    square = st.Mesh([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], [[0, 1, 2], [0, 2, 3]])
    assert len(edges_of(data_of(html_of(square)))) == 4
    folded = st.Mesh([[0, 0, 0], [1, 0, 0], [1, 1, 0], [1, 0.5, 0]], [[0, 1, 2], [0, 2, 3]])
    assert len(edges_of(data_of(html_of(folded)))) == 5
    sphere = st.sphere(1, 100)
    assert len(edges_of(data_of(html_of(sphere)))) > len(sphere.triangles)


def test_vertices_at_one_place_are_joined():
    separate = st.Mesh(CUBE.vertices[CUBE.triangles].reshape(-1, 3), np.arange(36).reshape(-1, 3))
    assert len(positions_of(data_of(html_of(separate)))) == 8


def test_what_is_written_by_others_is_escaped():
    viewer = Viewer('<b onclick="x">&', CUBE._repr_html_())
    text = viewer._repr_html_()
    assert "<b " not in text
    (frame,) = [attributes for tag, attributes in Attributes(text).found if tag == "iframe"]
    assert frame["title"] == viewer.facts
    assert frame["srcdoc"] == viewer.page

    named = type("<i>Mesh", (), {"vertices": CUBE.vertices, "faces": CUBE.triangles})()
    assert "<i>" not in html.unescape(html_of(named)).replace(show(named).facts, "")
    assert "<i>" not in page_of(html_of(named)).replace(html.escape("<i>"), "")


def test_a_page_is_saved(tmp_path):
    show(CUBE).save(tmp_path / "cube.html", title="<cube> & more")
    text = (tmp_path / "cube.html").read_text(encoding="utf-8")
    assert "<title>&lt;cube&gt; &amp; more</title>" in text
    assert len(positions_of(data_of(text))) == 8


@pytest.mark.parametrize("thing", [st.Solid(), [], [st.Solid()], st.Mesh(np.empty((0, 3)), np.empty((0, 3), int))])
def test_what_is_empty_has_no_picture(thing):
    text = html_of(thing)
    assert "nothing to draw" in text
    assert "iframe" not in text


@pytest.mark.parametrize(
    "solid",
    [
        CUBE.scaled(1e300).translated((5e299, 0, 0)),
        CUBE.scaled(Fraction(17 * 10**307)).translated((-(10**308), -(10**308), -(10**308))),
        CUBE.scaled(1e-300),
        CUBE.scaled(5e-324),
        CUBE.scaled(Fraction(1, 10**400)),
        CUBE.translated((1e15, -1e15, 1e15)),
        CUBE.scaled(Fraction(1, 10**20)).translated((1, 1, 1)),
        CUBE.scaled((1e-200, 1, 1e200)),
    ],
    ids=["1e300", "greatest", "1e-300", "least", "1e-400", "far", "exactly small", "thin"],
)
def test_solids_of_any_size_anywhere(solid):
    text = html_of(solid)
    assert "nan" not in show(solid).facts.lower()
    assert "NaN" not in text and "Infinity" not in text
    places = positions_of(data_of(text))
    assert np.isfinite(places).all()
    assert 0.8 < np.linalg.norm(places, axis=1).max() <= 1.0000001


def test_places_are_those_of_the_cube_wherever_it_is():
    here = positions_of(data_of(html_of(CUBE)))
    speck = CUBE.scaled(Fraction(1, 10**25)).translated((1, 0, 0))
    for solid in (CUBE.translated((1e15, 0, 0)), CUBE.scaled(2.0**-1000), speck):
        np.testing.assert_allclose(positions_of(data_of(html_of(solid))), here, atol=1e-6)


def test_volumes_beyond_doubles():
    assert "volume 1e+900" in show(CUBE.scaled(1e300)).facts
    assert "volume 1e-1200," in show(CUBE.scaled(Fraction(1, 10**400))).facts


def test_a_mesh_that_cannot_be_drawn_as_a_whole():
    vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [math.nan, 0, 0], [math.inf, 0, 0]]
    text = html_of(st.Mesh(vertices, [[0, 1, 2], [0, 1, 3], [0, 1, 4], [0, 1, 7]]))
    assert "4 triangles" in text and "3 not drawn" in text
    assert "NaN" not in text
    assert len(positions_of(data_of(text))) == 3


def test_a_decomposition():
    pieces = st.decompose(NOTCHED)
    data = data_of(html_of(pieces))
    assert data["slider"] == "explode"
    assert len(data["parts"]) == len(pieces) == 2
    assert data["parts"][0]["color"] != data["parts"][1]["color"]
    assert np.allclose([part["ends"][1] for part in data["parts"]], np.cumsum([len(p.triangles) for p in pieces]))
    away = np.array([part["away"] for part in data["parts"]])
    assert np.linalg.norm(away, axis=1).max() <= 1
    assert np.linalg.norm(away[0] - away[1]) > 0.1
    assert "volume 3," in show(pieces).facts
    assert 'max="100"' in page_of(html_of(pieces))


def test_empty_parts_among_others():
    data = data_of(html_of([st.Solid(), CUBE, st.Solid()]))
    assert [part["ends"][1] for part in data["parts"]] == [0, 12, 12]


def test_layers():
    layers = st.layers([NOTCHED], direction=(1, 2, 3))
    data = data_of(html_of(layers))
    assert data["slider"] == "layers"
    assert len(data["parts"]) == len(layers) > 1
    assert len({tuple(part["color"]) for part in data["parts"]}) == len(layers)
    assert all(part["away"] == [0, 0, 0] for part in data["parts"])
    assert f'max="{len(layers)}"' in page_of(html_of(layers))


@pytest.mark.parametrize("color", ["#ff8000", "#f80", (1.0, 0.5, 0.0), np.array([1, 0.5, 0])])
def test_colors(color):
    expected = [255, 136, 0] if isinstance(color, str) and color == "#f80" else [255, 128, 0]
    for things, colors in ((CUBE, color), (CUBE, [color]), ([CUBE, NOTCHED], [color, "#000000"])):
        assert data_of(show(things, colors=colors)._repr_html_())["parts"][0]["color"] == expected


@pytest.mark.parametrize("colors", ["red", "<b>", (1, 2, 3), ["#000", "#000"], "#gggggg", [math.nan, 0, 0], []])
def test_colors_that_are_none(colors):
    with pytest.raises(ValueError, match="colors: expected"):
        show(CUBE, colors=colors)


def colors_of(data: dict) -> np.ndarray:
    return np.frombuffer(base64.b64decode(data["colors"]), np.uint8).reshape(-1, 3)


def corner_colors(data: dict) -> np.ndarray:
    triangles = np.frombuffer(base64.b64decode(data["triangles"]), "<u4")
    return colors_of(data)[triangles].reshape(-1, 3, 3)


def edge_places(data: dict) -> set:
    ends = positions_of(data)[edges_of(data)]
    return {frozenset(map(tuple, pair)) for pair in ends.tolist()}


@pytest.mark.parametrize("dtype", [np.uint8, np.float32])
def test_colors_of_faces_corners_and_vertices(dtype):
    scale = 1 if dtype == np.uint8 else 1 / 255
    faces = np.arange(36).reshape(12, 3)
    corners = np.arange(108).reshape(36, 3)
    vertices = np.arange(200, 224).reshape(8, 3)
    for element, values, expected in [
        ("face", faces, np.repeat(faces[:, None], 3, axis=1)),
        ("corner", corners, corners.reshape(12, 3, 3)),
        ("vertex", vertices, vertices[CUBE.triangles]),
    ]:
        channel = st.Channel("color", (values * scale).astype(dtype), element)
        data = data_of(html_of(CUBE.with_attributes(st.Attributes([channel]))))
        assert np.array_equal(corner_colors(data), expected)
        assert edge_places(data) == edge_places(data_of(html_of(CUBE)))
        assert len(positions_of(data)) == len(colors_of(data)) == data["parts"][0]["ends"][0]


def test_colors_of_materials():
    red = st.Material("red", color=(1, 0, 0.2158605))
    cut = st.difference([CUBE, CUBE.translated((0, 0, 0.5))], cut_material=red)
    found = corner_colors(data_of(html_of(cut)))
    assert np.array_equal(found[:, 0], np.where(cut.source_operands[:, None] == 1, [255, 0, 128], [255, 255, 255]))


def test_colors_that_are_given_come_before_those_carried():
    painted = CUBE.with_attributes(st.Attributes(face={"color": np.zeros((12, 3), np.uint8)}))
    assert "colors" not in data_of(show(painted, colors="#ff8000")._repr_html_())
    assert "colors" not in data_of(html_of(CUBE))


def test_parts_with_and_without_colors():
    painted = CUBE.with_attributes(st.Attributes(face={"color": np.full((12, 3), 7, np.uint8)}))
    data = data_of(html_of([CUBE, painted]))
    first, second = data["parts"]
    assert set(map(tuple, colors_of(data)[: first["ends"][0]].tolist())) == {tuple(first["color"])}
    assert set(map(tuple, colors_of(data)[first["ends"][0] :].tolist())) == {(7, 7, 7)}
    assert second["ends"][0] == len(positions_of(data))


def test_colors_of_what_is_not_drawn_are_not_needed():
    points, triangles = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [math.nan, 0, 0]], [[0, 1, 3], [0, 1, 2], [0, 1, 7]]
    faces, corners = (np.arange(3 * n, dtype=np.uint8).reshape(n, 3) for n in (3, 9))
    vertices = np.arange(12, dtype=np.uint8).reshape(4, 3)
    for attributes, expected in [
        (st.Attributes(face={"color": faces}), [faces[1]] * 3),
        (st.Attributes(corner={"color": corners}), corners[3:6]),
        (st.Attributes(vertex={"color": vertices}), vertices[:3]),
    ]:
        mesh = st.Mesh(points, triangles, attributes=attributes)
        assert np.array_equal(corner_colors(data_of(html_of(mesh))), [expected])


@pytest.mark.parametrize("things", [3, None, "cube", [3], object()])
def test_things_that_are_no_meshes(things):
    with pytest.raises(TypeError, match="expected solids, meshes"):
        show(things)


def test_a_pair_of_arrays_is_a_mesh():
    assert show((CUBE.vertices, CUBE.triangles)).facts.startswith("Mesh: 12 triangles")
    assert show((CUBE, CUBE)).facts.startswith("2 parts: 24 triangles")


def test_very_large_meshes_are_a_box(monkeypatch):
    monkeypatch.setattr(_notebook, "MOST_TRIANGLES", 20)
    text = html_of(st.sphere(3, 16))
    assert "the picture is the bounding box" in text
    data = data_of(text)
    assert data["triangles"] == ""
    assert len(edges_of(data)) == 12
    np.testing.assert_allclose(np.abs(positions_of(data)), 1 / math.sqrt(3), rtol=1e-6)


def test_vertices_that_no_triangle_has_do_not_count():
    frame = Frame.around([part_of(st.Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1e9, 0, 0]], [[0, 1, 2]]))])
    assert frame is not None
    assert frame.upper.tolist() == [1, 1, 0]


def test_parts_stay_in_place_relative_to_each_other():
    boxes = [CUBE, CUBE.translated((2, 0, 0))]
    parts = [part_of(box) for box in boxes]
    frame = Frame.around(parts)
    assert frame is not None
    first, second = placed_parts(parts, frame)
    np.testing.assert_allclose(second.vertices - first.vertices, [[4 / math.sqrt(11), 0, 0]] * 8)
