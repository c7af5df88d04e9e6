"""Surfaces, sections, polygons, convex pieces, contacts, queries, layers and complexes."""

from __future__ import annotations

import copy
import json
import pickle
import weakref
from fractions import Fraction

import numpy as np
import pytest
import strata_csg as st

A = st.box((0, 0, 0), (2, 2, 2))
B = st.box((1, 1, 1), (3, 3, 3))


def test_surfaces():
    sheet = st.Surface(([[-9, -9, 1], [9, -9, 1], [0, 9, 1]], [[0, 1, 2]]))
    inside, outside, on = (st.clip(sheet, A, keep=keep) for keep in ("inside", "outside", "on"))
    assert inside.area == 4 and inside.area + outside.area == pytest.approx(sheet.area) and not on
    assert [piece.volume for piece in st.split(A, [sheet])] == [4, 4]
    assert [piece.volume for piece in st.split(A, [([[-9, -9, 1], [9, -9, 1], [0, 9, 1]], [[0, 1, 2]])])] == [4, 4]
    walls = st.imprint([A, B])
    assert [wall.area for wall in walls] == [24, 24] and len(walls[0].triangles) > 12
    assert sorted(cell.volume for cell in st.cells_of([A, B])) == [1, 7, 7]
    with pytest.raises(ValueError, match="keep: expected one of inside, outside, on"):
        st.clip(sheet, A, keep="within")
    with pytest.raises(st.InputError):
        st.Surface(([[0, 0, float("nan")]], [[0, 0, 0]]))


def test_sections():
    assert st.section(A | B, ((0, 0, 1), 1)).area == 7
    assert st.section(A, ((1, 1, 0), 2)).area == 4  # its projection along x
    layers = st.slice(A | B, 2, np.linspace(0, 3, 4).tolist())
    assert [layer.area for layer in layers] == [4, 7, 4, 0]


def test_polygons():
    square = st.Polygons([[(0, 0), (3, 0), (3, 3), (0, 3)]])
    hole = st.Polygons([[(1, 1), (2, 1), (2, 2), (1, 2)]])
    ring = square - hole
    assert ring.area == 8 and len(ring) == 1 and len(ring.loops[0]) == 2
    assert ring | hole == square and hash(ring | hole) == hash(square)
    assert [ring.membership(p) for p in [(0.5, 0.5), (1, 1.5), (1.5, 1.5)]] == [1, 0, -1]
    assert pickle.loads(pickle.dumps(ring)) == ring
    star = [(0, 0), (4, 3), (0, 3), (4, 0), (2, 5)]
    assert st.Polygons([star]).area > st.Polygons([star], fill="even-odd").area
    third = Fraction(1, 3)
    exact = st.Polygons([[(0, 0), (third, 0), (0, 1)]])
    assert st.Polygons.parse(exact.text(exact=True)) == exact
    assert json.loads(exact.text("geojson"))["type"] in ("Polygon", "MultiPolygon", "FeatureCollection")
    with pytest.raises(ValueError):
        exact.text("geojson", exact=True)
    with pytest.raises(ValueError, match="fill: expected one of"):
        st.Polygons([star], fill="odd")
    with pytest.raises(ValueError, match="expected pairs of numbers"):
        st.Polygons([[(1, 2, 3)]])
    with pytest.raises(st.FileError):
        st.Polygons.parse("POLYGON ((0 0, 1")


def test_geometries_of_shapely():
    shapely = pytest.importorskip("shapely")
    disc = shapely.Point(0, 0).buffer(2)
    ours = st.Polygons.from_geo(disc) - st.Polygons.from_geo(shapely.box(0, 0, 5, 5))
    back = shapely.geometry.shape(ours)
    assert back.area == pytest.approx(disc.difference(shapely.box(0, 0, 5, 5)).area, rel=1e-14)
    annulus = disc.difference(shapely.Point(0, 0).buffer(1))
    assert float(st.Polygons.from_geo(annulus).area) == pytest.approx(annulus.area, rel=1e-14)
    with pytest.raises(ValueError, match="expected polygons, found Point"):
        st.Polygons.from_geo(shapely.Point(0, 0))
    with pytest.raises(TypeError, match="__geo_interface__"):
        st.Polygons.from_geo(3)


def test_convex():
    part = A - st.box((1, 1, 0), (2, 2, 2))
    pieces = st.decompose(part)
    assert sum(piece.volume for piece in pieces) == 6 and st.union(pieces) == part
    assert st.convex_hull(part).volume == 7
    assert st.convex_hull(np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]])) == st.Solid()
    assert st.minkowski_sum(A, A).volume == 64
    assert st.erosion(A, st.box((0, 0, 0), (1, 1, 1))).volume == 1
    grown, excess = st.offset(A, 0.5, facets=80)
    assert 0 < excess < 0.2 and grown.volume > 8 and (A - grown).is_empty
    with pytest.raises(ValueError):
        st.erosion(A, st.Solid())


def test_contacts():
    pairs = st.contacts([A, st.box((2, 0, 0), (3, 1, 1)), B])
    assert [(p["a"], p["b"], p["relation"]) for p in pairs] == [
        (0, 1, "contact"),
        (0, 2, "interfering"),
        (1, 2, "contact"),
    ]
    assert pairs[0]["area"] == 1 and pairs[1]["overlap"].volume == 1 and pairs[2]["length"] == 1
    gap = st.distance(A, st.box((3, 3, 0), (4, 4, 1)))
    assert gap["squared"] == 2 and gap["on_a"] == (2, 2, 0)
    assert st.distance(A, B)["distance"] == 0


def test_queries():
    locator = st.Locator([A, B])
    assert locator.membership([[1.5, 1.5, 1.5], [0, 0, 0], [9, 9, 9]]).tolist() == [1, 0, -1]
    (windings, faces), (_, at_corner) = locator.locate([[1.5, 1.5, 1.5], [0, 0, 0]])
    assert windings == {0: 1, 1: 1} and faces == {} and list(at_corner) == [0]
    caster = st.RayCaster([A, B])
    hits = caster.first([[-1, 1.5, 1.5], [9, 9, 9]], [[1, 0, 0], [1, 0, 0]])
    assert hits["solid"].tolist() == [0, -1] and hits["t"].tolist() == [1, np.inf]
    assert hits["place"][0].tolist() == [0, 1.5, 1.5]
    events = caster.all((-1, 1.5, 1.5), (2, 0, 0))
    assert [(t, solid, passage) for t, solid, _, passage, _ in events] == [
        (Fraction(1, 2), 0, "entering"),
        (1, 1, "entering"),
        (Fraction(3, 2), 0, "leaving"),
        (2, 1, "leaving"),
    ]
    with pytest.raises(ValueError, match="as many as origins"):
        caster.first([[0, 0, 0]], [[1, 0, 0], [1, 0, 0]])
    with pytest.raises(ValueError):
        caster.all((0, 0, 0), (0, 0, 0))
    with pytest.raises(ValueError, match="finite"):
        locator.membership([[0, 0, np.nan]])


def test_layers():
    view = st.layers([A, st.box((0, 0, 5), (2, 2, 6))], direction=(0, 0, 1))
    assert view.count == len(view) == 4
    total = sum(len(view.mesh(i).triangles) for i in range(1, view.count + 1))
    assert total == 8  # the faces along the direction are in no layer
    assert set(view.mesh(1).source_operands.tolist()) == {1}
    assert len(st.layers([A]).origin) == 3
    with pytest.raises(IndexError):
        view.mesh(5)


def test_complexes():
    a, b = st.SelectiveComplex(A), st.SelectiveComplex(B)
    assert (a | b).volume == 15 and (a - b).volume == 7 and not (a - b).is_closed
    touching = a & st.SelectiveComplex(st.box((2, 0, 0), (3, 1, 1)))
    assert touching.volume == 0 and touching.area == 1 and touching.regularized() == st.SelectiveComplex()
    assert (~a).volume is None and not (~a).is_bounded and ~~a == a and hash(~~a) == hash(a)
    assert a.interior().is_open and a.interior().closure() == a and a.boundary() == a - a.interior()
    assert a.contains((2, 2, 2)) and not a.interior().contains((2, 2, 2))
    hair = a | st.SelectiveComplex.simplex([[2, 2, 2], [3, 3, 3]])
    assert hair.dangle().length == pytest.approx(3**0.5) and hair.regularized() == a
    assert len((a | st.SelectiveComplex(st.box((9, 9, 9), (10, 10, 10)))).components()) == 2


def test_geometries_that_are_none():
    recursive: dict[str, object] = {"type": "GeometryCollection"}
    recursive["geometries"] = [recursive]
    with pytest.raises(RecursionError):
        st.Polygons.from_geo(recursive)


def test_numbers_that_are_no_doubles_are_refused_where_doubles_are_meant():
    third = Fraction(1, 3)
    for call in (
        lambda: st.slice(A, 2, [third]),
        lambda: st.cylinder(third, 1),
        lambda: st.sphere(2**53 + 1),
        lambda: st.prism([(0, 0), (third, 0), (0, 1)], 0, 1),
        lambda: st.offset(A, third),
        lambda: A.rounded(0),
        lambda: st.boolean("union", [A], rounding=0),
    ):
        with pytest.raises(ValueError, match="double|positive step"):
            call()
    assert st.prism(np.array([[0, 0], [1, 0], [0, 1]]), 0, 1).volume == Fraction(1, 2)
    assert st.slice(A, 2, np.array([1.0]))[0].area == 4


def test_immutable_values_are_their_own_copies():
    things = [
        st.Surface(A),
        st.Expression(A),
        st.Workpiece(A),
        st.Polygons(),
        st.SelectiveComplex(A),
        st.Locator([A]),
        st.RayCaster([A]),
        st.layers([A]),
        st.Mesh(A.vertices, A.triangles),
    ]
    for thing in things:
        assert copy.copy(thing) is thing and copy.deepcopy(thing) is thing
        assert weakref.ref(thing)() is thing
