"""Attributes as values, and through everything that makes meshes and solids."""

from __future__ import annotations

import copy
import gc
import pickle
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
import strata_csg as st

A = st.box((0, 0, 0), (2, 2, 2))
B = st.box((1, 1, 1), (3, 3, 3))
STEEL, PAINT = st.Material("steel", metallic=1), st.Material("paint", color=(0.8, 0, 0))


def numbered(solid: st.Solid, first: int = 0) -> st.Solid:
    """With the number of each face, and the position of each vertex."""
    faces = np.arange(first, first + len(solid.triangles))
    return solid.with_attributes(st.Attributes(vertex={"place": solid.vertices}, face={"id": faces}))


def places_of(solid: Any) -> np.ndarray:
    """The positions that a mesh carries at the corners of its triangles."""
    attributes = solid.attributes
    if "place" in attributes.corner:
        return attributes["place"].reshape(-1, 3, 3)
    return attributes["place"][solid.triangles]


# Values


@pytest.mark.parametrize(
    ("dtype", "expected"),
    [
        ("float32", "float32"),
        ("float64", "float64"),
        ("float16", "float32"),
        (">f8", "float64"),
        ("uint8", "uint8"),
        ("int8", "int32"),
        ("int64", "int32"),
        ("uint16", "int32"),
        ("uint64", "int32"),
        (">i4", "int32"),
    ],
)
def test_types_of_values(dtype, expected):
    channel = st.Channel("x", np.array([1, 2, 100], dtype))
    assert channel.values.dtype == expected and channel.values.tolist() == [1, 2, 100]
    assert channel.interpolation == ("nearest" if expected == "int32" else "linear")


def test_extreme_values_are_the_same_bits():
    for values in (
        np.array([-(2**31), 2**31 - 1]),
        np.array([np.nan, -np.inf, -0.0, 5e-324]),
        np.array([0, 255], np.uint8),
        np.array([np.nan, 3e38, 1e-45], np.float32),
    ):
        got = st.Channel("x", values).values
        assert got.astype(values.dtype).tobytes() == values.tobytes()


@pytest.mark.parametrize("columns", [1, 2, 3, 4])
def test_layouts(columns):
    values = np.arange(6 * columns, dtype=np.float32).reshape(6, columns)
    padded = np.zeros((12, columns + 2), np.float32)
    padded[::2, 1:-1] = values
    frozen = values.copy()
    frozen.flags.writeable = False
    for given in (values, np.asfortranarray(values), padded[::2, 1:-1], values[::-1][::-1], frozen):
        got = st.Channel("x", given).values
        assert got.shape == ((6, columns) if columns > 1 else (6,))
        assert np.array_equal(got.reshape(6, columns), values)


def test_lists_and_empty_arrays():
    assert st.Channel("x", [[1, 2], [3, 4]]).values.tolist() == [[1, 2], [3, 4]]
    assert st.Channel("x", np.empty((0, 3)), "corner").values.shape == (0, 3)
    assert st.Channel("x", []).values.shape == (0,)
    empty = st.Mesh([], [], attributes=st.Attributes(vertex={"x": []}, face={"id": np.empty(0, int)}))
    assert empty.attributes["id"].dtype == np.int32


def test_values_are_copied_and_read_only():
    values = np.zeros(3)
    channel = st.Channel("x", values)
    values[0] = 7
    assert channel.values[0] == 0
    with pytest.raises(ValueError, match="read-only"):
        channel.values[0] = 1


def test_arrays_outlive_what_they_come_from():
    results = [
        numbered(A).attributes["place"],
        st.boolean("union", [numbered(A)]).attributes.face["id"],
        (numbered(A) - B).attributes.channels[0].values,
        st.Channel("x", np.arange(1000.0)).values,
    ]
    copies = [values.copy() for values in results]
    gc.collect()
    junk = [np.random.rand(100) for _ in range(1000)]
    assert all(np.array_equal(a, b) for a, b in zip(results, copies, strict=True)) and len(junk) == 1000


def test_usual_interpolation():
    assert st.Channel("normal", np.ones((3, 3)), "corner").interpolation == "spherical"
    assert st.Channel("normal", np.ones((3, 2))).interpolation == "linear"
    assert st.Channel("normal", np.ones((3, 3), np.uint8)).interpolation == "linear"
    assert st.Channel("other", np.ones((3, 3)), interpolation="spherical").interpolation == "spherical"
    assert st.Channel("x", np.ones(3), interpolation="nearest").interpolation == "nearest"


@pytest.mark.parametrize(
    ("arguments", "error", "text"),
    [
        (("x", np.zeros((2, 2, 2))), ValueError, r'channel "x": expected an array of shape \(n,\) or \(n, k\), found shape'),
        (("x", 3.0), ValueError, r'channel "x": .*found shape \(\)'),
        (("x", [[1, 2], [3]]), ValueError, 'channel "x": .*rows of different lengths'),
        (("x", np.zeros((2, 5))), ValueError, 'channel "x": 5 components; there may be 1 to 4'),
        (("x", np.zeros((2, 0))), ValueError, 'channel "x": 0 components'),
        (("x", np.zeros(2, complex)), TypeError, 'channel "x": expected floats .*found type complex128'),
        (("x", np.zeros(2, bool)), TypeError, 'channel "x": .*found type bool'),
        (("x", np.zeros(2, np.longdouble)), TypeError, 'channel "x": expected floats'),
        (("x", ["a"]), TypeError, 'channel "x": expected floats'),
        (("x", [2**31]), ValueError, 'channel "x": 2147483648 is no integer of 32 bits'),
        (("x", [-(2**31) - 1]), ValueError, 'channel "x": -2147483649 is no integer of 32 bits'),
        (("x", np.array([2**64 - 1], np.uint64)), ValueError, "18446744073709551615 is no integer of 32 bits"),
        (("x", [1], "edge"), ValueError, "element: expected one of vertex, corner, face, found 'edge'"),
        (("x", [1], 3), TypeError, "element: expected a name"),
        (("x", [1.0], "face", "cubic"), ValueError, "interpolation: expected one of linear, spherical, nearest"),
        (("x", [1], "face", "linear"), ValueError, 'channel "x": integers of 32 bits can be interpolated as nearest only'),
        (("x", np.zeros((2, 3), np.uint8), "face", "spherical"), ValueError, 'channel "x": bytes are no directions'),
        (("x", np.zeros(4), "corner"), ValueError, 'channel "x": 4 values'),
        (("", [1.0]), ValueError, "it has no name"),
        ((3, [1.0]), TypeError, "name: expected a str, found int"),
    ],
)
def test_wrong_channels_are_named(arguments, error, text):
    with pytest.raises(error, match=text):
        st.Channel(*arguments)


@pytest.mark.parametrize(
    ("make", "error", "text"),
    [
        (lambda: st.Attributes(["x"]), TypeError, "channels: expected Channel, found str"),
        (lambda: st.Attributes(vertex=[1, 2]), TypeError, "vertex: expected a mapping of names to arrays, found list"),
        (lambda: st.Attributes(face={3: [1]}), TypeError, "face: expected a str, found int"),
        (lambda: st.Attributes(vertex={"x": [1.0]}, face={"x": [1]}), ValueError, 'channel "x": there are two of that name'),
        (lambda: st.Attributes(vertex={"x": [1.0], "y": [1.0, 2]}), ValueError, 'channel "y": 2 values; 1 elements'),
        (lambda: st.Attributes(corner={"x": np.zeros(6)}, face={"y": [1]}), ValueError, 'channel "y": 1 values; 2 elements'),
        (lambda: st.Attributes(face={"material": [1]}, materials=[STEEL]), ValueError, "index 1 in a list of 1"),
        (lambda: st.Attributes(materials=[st.Material(image=2)]), ValueError, "image 2 of 0"),
        (lambda: st.Attributes(materials=["steel"]), TypeError, "materials: expected Material, found str"),
        (lambda: st.Attributes(images=[b"png"]), TypeError, "images: expected Image, found bytes"),
        (lambda: st.Attributes(objects="ab"), TypeError, "objects: expected names in a list"),
        (lambda: st.Attributes(groups=[3]), TypeError, "groups: expected a str, found int"),
        (lambda: st.Material(color=(1, 2)), ValueError, "color: expected 3 or 4 numbers, found 2"),
        (lambda: st.Material("a", image=-1), ValueError, "material 'a': image: there is no number -1"),
        (lambda: st.Image("a", "image/png", 5), TypeError, "memoryview"),
        (lambda: st.Mesh([], [], attributes={"x": []}), TypeError, "attributes: expected Attributes or None, found dict"),
        (lambda: A.with_attributes(st.Attributes(face={"x": [1]})), ValueError, 'channel "x": 1 values; 12 elements'),
        (lambda: st.Mesh(A.vertices, A.triangles, attributes=st.Attributes(vertex={"x": [1]})), ValueError, '"x": 1 values'),
        (lambda: st.Mesh([], [], unit="furlong"), ValueError, "unit: expected one of micron, millimeter, .*found 'furlong'"),
        (lambda: st.boolean("union", [A], cut_material="red"), TypeError, "cut_material: expected Material, found str"),
        (lambda: st.union([A], cut_material=st.Material(image=0)), ValueError, "the material for cut faces has an image"),
    ],
)
def test_wrong_attributes_are_named(make, error, text):
    with pytest.raises(error, match=text):
        make()


def test_access():
    attributes = st.Attributes(
        [st.Channel("uv", np.zeros((6, 2)), "corner")],
        vertex={"heat": [1.0, 2, 3]},
        face={"material": [0, -1]},
        materials=[STEEL],
        images=[st.Image("a.png", "image/png", b"\x89PNG\x00")],
        objects=["bolt"],
        groups=["left", "right"],
    )
    assert list(attributes) == attributes.keys() == ["uv", "heat", "material"] and len(attributes) == 3
    assert "heat" in attributes and "x" not in attributes and 3 not in attributes
    assert attributes["heat"].tolist() == [1, 2, 3] and attributes.get("x") is None and attributes.get("x", 5) == 5
    assert (list(attributes.vertex), list(attributes.corner), list(attributes.face)) == (["heat"], ["uv"], ["material"])
    assert dict(attributes)["material"].tolist() == [0, -1]
    assert attributes.materials == (STEEL,) and attributes.images[0].data == b"\x89PNG\x00"
    assert attributes.objects == ("bolt",) and attributes.groups == ("left", "right")
    with pytest.raises(KeyError, match="no channel 'x', with uv, heat, material"):
        attributes["x"]
    assert attributes.only(["heat"]) == st.Attributes(vertex={"heat": [1.0, 2, 3]})
    assert attributes.with_channels(st.Channel("uv", [1, 2], "face")).keys() == ["uv", "heat", "material"]
    with pytest.raises(ValueError, match='channel "z": 3 values; 2 elements'):
        attributes.with_channels(st.Channel("z", [1, 2, 3], "face"))
    assert repr(attributes) == (
        "Attributes(uv: (6, 2) float64 per corner, heat: (3,) float64 per vertex, material: (2,) int32 per face, "
        "1 material, 1 image, 1 object, 2 groups)"
    )
    assert not st.Attributes() and st.Attributes(objects=["a"])


def test_equality_and_hashes():
    def make(**changes: Any) -> st.Attributes:
        return st.Attributes(**{"face": {"id": [1, 2]}, "materials": [PAINT], **changes})

    assert make() == make() and hash(make()) == hash(make())
    for other in (make(face={"id": [1, 3]}), make(face={"no": [1, 2]}), make(materials=[STEEL]), make(objects=["a"]), 3):
        assert make() != other
    assert st.Channel("x", [1]) == st.Channel("x", [1]) != st.Channel("x", [1], "face")
    assert st.Channel("x", [1.0]) != st.Channel("x", np.ones(1, np.float32))
    assert st.Material(color=(1, 0, 0)) == st.Material(color=[1, 0, 0, 1.0]) and len({STEEL, PAINT, STEEL}) == 2


def test_names_that_are_no_utf_8():
    name = "caf\udce9"  # as paths with other bytes
    attributes = st.Attributes(vertex={name: [1.0]}, objects=[name])
    assert attributes.keys() == [name] and attributes.objects == (name,)
    assert pickle.loads(pickle.dumps(attributes)) == attributes


# Copies


def rich() -> st.Attributes:
    return st.Attributes(
        vertex={"place": A.vertices, "byte": np.arange(8, dtype=np.uint8)},
        corner={"uv": np.linspace(0, 1, 72, dtype=np.float32).reshape(36, 2)},
        face={"material": np.arange(12) % 2, "id": np.arange(12)},
        materials=[STEEL, st.Material("wood", (0.5, 0.25, 0, 0.5), 0.25, 0.75, 0)],
        images=[st.Image("wood.png", "image/png", bytes(range(256)))],
        objects=["a"],
        groups=["\u00e9"],
    )


@pytest.mark.parametrize("protocol", range(2, pickle.HIGHEST_PROTOCOL + 1))
def test_pickles(protocol):
    def again(thing: Any) -> Any:
        return pickle.loads(pickle.dumps(thing, protocol))

    attributes = rich()
    assert again(attributes) == attributes
    assert again(attributes.channels[2]) == attributes.channels[2]
    assert again(STEEL) == STEEL
    solid = (A.with_attributes(attributes) - B).scaled(Fraction(1, 3))
    assert again(solid) == solid and again(solid).attributes == solid.attributes is not None
    mesh = st.Mesh(A.vertices, A.triangles, attributes=attributes, unit="inch")
    assert again(mesh) == mesh and again(mesh).unit == "inch"


def test_pickles_of_meshes_keep_what_is_known_of_them(tmp_path):
    both = st.Mesh(np.vstack([A.vertices, B.vertices]), np.vstack([A.triangles, B.triangles + 8]))
    result = st.boolean("union", [both, A.scaled(Fraction(1, 3))], rounding="float32")
    again = pickle.loads(pickle.dumps(result))
    assert again.notes == result.notes != ()
    assert again.rounding == result.rounding is not None
    assert again.seconds == result.seconds != {}
    path = tmp_path / "flat.off"
    path.write_text("OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 1\n")
    read = st.read(path)
    assert len(read.file_notes) == 1 and pickle.loads(pickle.dumps(read)).file_notes == read.file_notes


def test_facts_of_meshes_cannot_be_changed_through_what_is_returned():
    result = st.boolean("union", [A, B], rounding="float32")
    result.seconds["x"] = 1
    result.rounding["rounds"] = 77
    assert "x" not in result.seconds and result.rounding["rounds"] != 77


def test_copies_of_immutable_values():
    solid = A.with_attributes(rich())
    mesh = st.Mesh(A.vertices, A.triangles, attributes=rich())
    for thing in (solid, mesh, rich(), rich().channels[0], STEEL):
        assert copy.copy(thing) == thing == copy.deepcopy(thing)
    assert copy.deepcopy(solid).attributes == solid.attributes
    assert st.Mesh(A.vertices, A.triangles) != mesh
    assert st.Mesh(A.vertices, A.triangles, unit="mm") != st.Mesh(A.vertices, A.triangles)


class Part(st.Solid):
    """A solid with a price."""

    def __init__(self, mesh: Any, price: list[int]) -> None:
        super().__init__(mesh)
        self.price = price


def test_subclasses_are_copied_and_pickled_as_such():
    part = Part(A.with_attributes(rich()), [3])
    shallow, deep, pickled = copy.copy(part), copy.deepcopy(part), pickle.loads(pickle.dumps(part))
    for other in (shallow, deep, pickled):
        assert type(other) is Part and other == part and other.price == [3] and other is not part
        assert other.attributes == part.attributes
    part.price.append(4)
    assert shallow.price == [3, 4] and deep.price == pickled.price == [3]
    part.itself = part
    assert copy.deepcopy(part).itself.price == [3, 4]


@pytest.mark.filterwarnings("ignore::RuntimeWarning")
def test_what_was_never_initialised_is_refused():
    class Broken(st.Solid):
        def __init__(self) -> None:
            pass

    for make in (pickle.dumps, copy.copy, copy.deepcopy):
        with pytest.raises(TypeError):
            make(Broken())
    for thing in (st.Attributes.__new__(st.Attributes), st.Channel.__new__(st.Channel)):
        with pytest.raises(TypeError):
            repr(thing)
        with pytest.raises(TypeError):
            st.Mesh([], [], attributes=thing)


def cut(solid: st.Solid) -> st.Solid:
    return solid - B


def test_through_a_pool_of_processes():
    with ProcessPoolExecutor(1) as pool:
        far = pool.submit(cut, A.with_attributes(rich())).result()
    assert far.attributes == cut(A.with_attributes(rich())).attributes


def test_threads_give_the_same():
    solid = st.sphere(1, 60)
    solid = solid.with_attributes(st.Attributes(vertex={"place": solid.vertices}, face={"id": range(len(solid.faces))}))
    moved = solid.translated((Fraction(1, 3), 0, 0))
    expected = st.boolean("union", [solid, moved], threads=1)
    with ThreadPoolExecutor(4) as pool:
        results = list(pool.map(lambda threads: st.boolean("union", [solid, moved], threads=threads), [0, 2, 3, 8] * 3))
    assert all(result == expected for result in results)


# Through operations


def test_functions_carry():
    a, b = numbered(A), numbered(B, 100)
    results = [
        a - b,
        st.difference([a, b]),
        (st.Expression(a) - b).evaluate(),
        st.Solid(st.boolean("difference", [a, b], exact=True)),
        st.Solid.trusted(st.boolean("difference", [a, b], exact=True)),
        pickle.loads(pickle.dumps(a)) - b,
        st.Workpiece(a).cut(b).solid,
        (a - b).rounded(),
        st.boolean("difference", [a, b], rounding="float32"),
        st.boolean("difference", [a, b], engine="layers"),
        (a - b).separated(),
        (a - b).components()[0],
        (a - b).without_cavities(),
    ]
    for result in results:
        assert {number // 100 for number in result.attributes["id"].tolist()} == {0, 1}
        assert np.array_equal(places_of(result), np.asarray(result.vertices)[result.triangles])


def test_identifiers_are_those_of_the_sources():
    a, b = numbered(A), numbered(B, 100)
    for operation in ("union", "intersection", "difference", "symmetric-difference"):
        result = st.boolean(operation, [a, b])
        assert np.array_equal(result.attributes["id"], result.source_faces + 100 * result.source_operands)


def test_what_meshes_carry_goes_into_solids():
    attributes = numbered(A).attributes
    mesh = st.Mesh(A.vertices, A.triangles, attributes=attributes)
    assert st.Solid(mesh).attributes == attributes == st.Solid.trusted(mesh).attributes
    assert st.resolve(mesh).attributes == attributes
    both = st.Mesh(
        np.vstack([A.vertices, B.vertices]),
        np.vstack([A.triangles, B.triangles + 8]),
        attributes=st.Attributes(face={"id": range(24)}, vertex={"place": np.vstack([A.vertices, B.vertices])}),
    )
    for solid in (st.Solid(both), st.resolve(both), st.resolve(both, inside="outer")):
        assert np.array_equal(solid.attributes["id"], solid.source_faces)
        assert np.array_equal(places_of(solid), np.asarray(solid.vertices)[solid.triangles])
    holed = st.Mesh(A.vertices, A.triangles[1:], attributes=st.Attributes(face={"id": range(1, 12)}))
    assert len(st.Solid(holed, input="soup").attributes["id"]) == 12


def test_transforms_turn_normals():
    normals = np.repeat(np.array([[0.0, 0, 1]]), 12, axis=0)
    solid = A.with_attributes(st.Attributes(face={"normal": normals}))
    assert np.allclose(solid.rotated((1, 0, 0), 90).attributes["normal"], [0, -1, 0])
    assert np.allclose(solid.scaled((1, 1, 5)).attributes["normal"], [0, 0, 1])
    assert solid.translated((1, 2, 3)).attributes == solid.attributes
    tilted = numbered(A).rotated((1, 2, 3), 40)
    assert np.array_equal(tilted.attributes["id"], np.arange(12))


def test_splits_carry_and_have_cut_faces():
    below, above = numbered(A).split(((0, 0, 1), Fraction(1, 3)), cut_material=PAINT)
    for half in (below, above):
        cap = half.attributes["material"] == 0
        assert half.attributes.materials == (PAINT,)
        assert cap.sum() >= 2 and np.allclose(np.asarray(half.vertices)[half.triangles[cap]][:, :, 2], 1 / 3)
    plane = st.Surface.of_plane(((1, 0, 0), 1), (0, 0, 0), (2, 2, 2))
    for piece in st.split(numbered(A), [plane], cut_material=PAINT):
        assert set(piece.attributes["material"].tolist()) == {-1, 0}


@pytest.mark.parametrize(
    "make",
    [
        lambda m: st.boolean("difference", [A, B], cut_material=m),
        lambda m: st.difference([A, B], cut_material=m),
        lambda m: (st.Expression(A) - B).evaluate(cut_material=m),
    ],
)
def test_cut_faces_are_of_a_material(make):
    result = make(PAINT)
    material = result.attributes["material"]
    assert result.attributes.materials == (PAINT,)
    assert np.array_equal(material == 0, np.asarray(result.source_operands) == 1) and (material >= -1).all()
    assert make(None).attributes is None


def test_cut_faces_of_a_workpiece_are_of_a_material():
    work = st.Workpiece(numbered(A)).cut(B)
    material = work.finished(cut_material=PAINT).attributes["material"]
    cut = np.asarray(st.difference([A, B]).source_operands) == 1
    assert set(material.tolist()) == {-1, 0} and (material == 0).sum() == cut.sum()
    assert "material" not in work.finished().attributes
    with pytest.raises(TypeError, match="cut_material: expected Material, found str"):
        work.finished(cut_material="red")


def test_cut_faces_of_intersections():
    result = st.intersection([A, B], cut_material=PAINT)
    assert np.array_equal(result.attributes["material"] == 0, result.source_operands == 1)


def test_convex_pieces_carry_and_have_walls_of_a_material():
    notched = numbered(A) - B
    bare, cut = st.decompose(notched), st.decompose(notched, cut_material=PAINT)
    assert len(bare) == len(cut) > 1 and sum(piece.volume for piece in cut) == notched.volume
    for piece, painted in zip(bare, cut):
        assert piece == painted and "material" not in piece.attributes
        number, material = painted.attributes["id"], painted.attributes["material"]
        walls = painted.source_operands == 1
        assert np.array_equal(material == 0, walls) and walls.any()
        assert np.array_equal(number[~walls], notched.attributes["id"][painted.source_faces[~walls]])
    assert not st.decompose(A - B)[0].attributes
    with pytest.raises(TypeError, match="cut_material: expected Material, found str"):
        st.decompose(notched, cut_material="red")


def test_operands_with_other_channels():
    a = A.with_attributes(st.Attributes(face={"color": np.full((12, 3), 9, np.uint8)}))
    b = B.with_attributes(st.Attributes(vertex={"heat": np.full(8, 7.0)}))
    result = a | b
    of_b = result.source_operands == 1
    assert set(result.attributes["color"][of_b].ravel().tolist()) == {255}
    assert set(result.attributes["color"][~of_b].ravel().tolist()) == {9}
    heat = result.attributes["heat"].reshape(-1, 3) if "heat" in result.attributes.corner else None
    assert heat is not None and set(heat[of_b].ravel().tolist()) == {7} and set(heat[~of_b].ravel().tolist()) == {0}


def test_nothing_is_carried_where_there_is_nothing():
    assert (A - B).attributes is None and st.boolean("union", [A, B]).attributes is None
    assert A.with_attributes(st.Attributes()).attributes is None
    assert numbered(A).with_attributes(None).attributes is None
    assert st.Mesh(A.vertices, A.triangles, attributes=st.Attributes()).attributes is None
    assert numbered(A) == A and hash(numbered(A)) == hash(A)
    assert repr(numbered(A)) == "Solid(8 vertices, 12 triangles, with place, id)"


def test_engines_that_carry_nothing_say_so():
    with pytest.raises(ValueError, match="the engine bsp carries no attributes"):
        st.boolean("union", [numbered(A), B], engine="bsp")


def test_carrying_to_other_meshes():
    a = numbered(A)
    sheet = st.Mesh([[-9, -9, 1], [9, -9, 1], [0, 9, 1]], [[0, 1, 2]])
    assert st.carry_attributes([sheet, a], st.clip(sheet, a)) .keys() == ["place", "id"]
    halves = st.imprint([a, B])
    carried = st.carry_attributes([a, numbered(B, 100)], halves[1])
    assert set(carried["id"].tolist()) == set(range(100, 112))
    layers = st.layers([a], direction=(0, 0, 1))
    back = layers.mesh(1)
    assert np.array_equal(st.carry_attributes([a], back)["id"], back.source_faces)
    piece = ([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 2, 1]])
    bottom = next(f for f, t in enumerate(A.triangles) if (A.vertices[t, 2] == 0).all())
    assert st.carry_attributes([a], piece, ([0], [bottom]))["id"].tolist() == [bottom]
    whole = st.carry_attributes([A], A, cut_material=PAINT, cut_faces="of-later-operands")
    assert whole["material"].tolist() == [-1] * 12


@pytest.mark.parametrize(
    ("sources", "error", "text"),
    [
        (None, ValueError, "sources: expected a pair"),
        ([[0], [0]], TypeError, "sources: expected a pair .*found list"),
        (([0], [12]), ValueError, "there is no face 12 of operand 0"),
        (([1], [0]), ValueError, "there is no face 0 of operand 1"),
        (([0, 0], [0, 0]), ValueError, "2 sources of 1"),
        (([0], [0, 0]), ValueError, "as many operands as faces"),
        (([0], [-1]), ValueError, "sources: index -1 is negative"),
        (([0], [0.5]), TypeError, "sources: expected integers"),
    ],
)
def test_sources_that_are_none(sources, error, text):
    with pytest.raises(error, match=text):
        st.carry_attributes([numbered(A)], ([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 2, 1]]), sources)


def test_meshes_that_cannot_be_carried_to():
    for mesh in (([[0, 0, 0]], [[0, 0, 9]]), ([[0, 0, np.nan]] * 3, [[0, 1, 2]])):
        with pytest.raises(st.InputError):
            st.carry_attributes([numbered(A)], mesh, ([0], [0]))


# Units and files


def test_units():
    assert st.Mesh([], []).unit is None
    assert [st.Mesh([], [], unit=name).unit for name in ("um", "cm", "inch", "ft", "meter")] == [
        "micron",
        "centimeter",
        "inch",
        "foot",
        "meter",
    ]
    inch, nothing, mm = (st.Mesh(A.vertices, A.triangles, unit=unit) for unit in ("inch", None, "mm"))
    assert st.boolean("union", [nothing, inch]).unit == "inch" and st.boolean("union", [nothing]).unit is None
    with pytest.raises(ValueError, match="operand 2: its unit is millimeter, that of operand 0 is inch"):
        st.boolean("union", [inch, nothing, mm])


@pytest.mark.parametrize("format", ["3mf", "glb", "gltf", "ply", "ply-ascii", "ply-big-endian"])
def test_files_keep_colours(format):
    colors = np.arange(24, dtype=np.uint8).reshape(8, 3)
    painted = A.with_attributes(st.Attributes(vertex={"color": colors}))
    again = st.read_bytes(st.write_bytes(painted, format), format)
    assert "color" in again.attributes
    back = st.Solid(again)
    found = {tuple(p): tuple(c[:3]) for p, c in zip(corners_of(back, back.vertices), corners_of(back, None), strict=True)}
    assert found == {tuple(p): tuple(c) for p, c in zip(A.vertices.tolist(), colors.tolist(), strict=True)}


def corners_of(solid: st.Solid, vertices: Any) -> list:
    """Positions at corners, or else colours as bytes."""
    if vertices is not None:
        return np.asarray(vertices)[solid.triangles].reshape(-1, 3).tolist()
    color = solid.attributes["color"]
    color = color[solid.triangles].reshape(len(solid.triangles) * 3, -1) if "color" in solid.attributes.vertex else color
    return (color if color.dtype == np.uint8 else np.rint(255 * color).astype(int)).tolist()


def test_files_keep_materials_units_and_images(tmp_path):
    red, blue = st.Material("red", (1, 0, 0)), st.Material("blue", (0, 0, 1, 0))
    attributes = st.Attributes(face={"material": np.arange(12) % 2}, materials=[red, blue])
    mesh = st.Mesh(A.vertices, A.triangles, attributes=attributes, unit="inch")
    assert st.write(tmp_path / "part.3mf", mesh) == []
    again = st.read(tmp_path / "part.3mf")
    assert again.unit == "inch" and again.attributes.materials == (red, blue)
    assert np.array_equal(again.attributes["material"], np.arange(12) % 2)
    st.write(tmp_path / "other.3mf", mesh, unit="mm", attributes=None)
    other = st.read(tmp_path / "other.3mf")
    assert other.unit == "millimeter" and "material" not in (other.attributes or {})
    given = st.Attributes(face={"id": range(12)})
    again = st.read_bytes(st.write_bytes((A.vertices, A.triangles), "ply", attributes=given), "ply")
    assert again.attributes.face["id"].tolist() == list(range(12))
    assert st.read_bytes(st.write_bytes(again, "ply", attributes=None), "ply").attributes is None
    pixels = st.Image("dot.png", "image/png", b"\x89PNG\r\n\x1a\n" + bytes(range(256)))
    textured = A.with_attributes(
        st.Attributes(
            corner={"texcoord": np.linspace(0, 1, 72, dtype=np.float32).reshape(36, 2)},
            face={"material": np.zeros(12, int)},
            materials=[st.Material("wood", image=0)],
            images=[pixels],
        )
    )
    for name in ("part.obj", "part.glb"):
        assert st.write(tmp_path / name, textured) == []
        assert st.read(tmp_path / name).attributes.images[0].data == pixels.data
    assert (tmp_path / "part.mtl").exists()


def test_what_files_lose_is_told(tmp_path):
    path = tmp_path / "part.stl"
    (note,) = st.write(path, numbered(A).with_attributes(st.Attributes(face={"id": range(12)})))
    assert "id" in note or "attribute" in note or "channel" in note
    with pytest.raises(st.FileError):
        st.write(tmp_path / "strict.stl", numbered(A), strict=True)
    assert not (tmp_path / "strict.stl").exists()
    with pytest.raises(st.FileError):
        st.write_bytes(numbered(A), "stl", strict=True)
    assert st.write(path, numbered(A), attributes=None, strict=True) == []
    with pytest.raises(ValueError, match='channel "x"'):
        st.write(tmp_path / "part.ply", A, attributes=st.Attributes(face={"x": [1]}))
    with pytest.raises(ValueError, match="attributes: expected \"all\", Attributes or None, found 'some'"):
        st.write(path, A, attributes="some")
    with pytest.raises(ValueError, match="unit: expected one of"):
        st.write(path, A, unit="furlong")


def test_formats_are_those_that_can_be_named():
    formats = {record["name"]: record for record in st.formats()}
    assert {"stl", "obj", "3mf", "glb", "vtk", "amf"} <= set(formats)
    for name, record in formats.items():
        if record["writes"] and record["reads"]:
            assert len(st.read_bytes(st.write_bytes(A, name), name).triangles) == 12
        elif record["writes"]:
            assert st.write_bytes(A, name)


# Meshes of others


def test_what_properties_raise_is_what_is_said():
    class Bad:
        vertices = A.vertices

        @property
        def faces(self) -> Any:
            raise RuntimeError("the faces are on the moon")

    class Missing(Bad):
        @property
        def faces(self) -> Any:
            return self.nothing

    for call in (st.Solid, st.convex_hull):
        with pytest.raises(RuntimeError, match="on the moon"):
            call(Bad())
    with pytest.raises(AttributeError, match="nothing"):
        st.Solid(Missing())
