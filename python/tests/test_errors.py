"""Exceptions, and files that are none."""

from __future__ import annotations

import pickle

import numpy as np
import pytest
import strata_csg as st

A = st.box((0, 0, 0), (2, 2, 2))


def open_box_error() -> st.InputError:
    with pytest.raises(st.InputError) as caught:
        st.Solid((A.vertices, A.triangles[1:]))
    return caught.value


def test_exceptions_can_be_pickled():
    error = open_box_error()
    again = pickle.loads(pickle.dumps(error))
    assert type(again) is st.InputError and str(again) == str(error) and again.defects == error.defects
    for other in (st.FileError("text", "path", 3, None, "reason"), st.ParseError("text", 4)):
        again = pickle.loads(pickle.dumps(other))
        assert str(again) == str(other) and vars(again) == vars(other)


def test_defects_are_records():
    defect = open_box_error().defects[0]
    assert defect.severity == "error" and defect.where is not None and defect.faces
    assert str(defect) == defect.text and defect.message in str(defect)


def test_check_lists_all_kinds():
    broken = (A.vertices, np.vstack([A.triangles[1:], A.triangles[5:6], [[0, 0, 1]]]))
    kinds = {defect.kind for defect in st.check(broken)}
    assert {"open edge", "degenerate triangle", "duplicate face"} <= kinds
    assert sum(defect.count for defect in st.check((A.vertices, A.triangles[6:]), listed=1)) > 1


def test_indices_that_nothing_checks_later():
    for mesh in ((A.vertices, [[0, 1, 99]]), ([[0, 0, float("inf")]], [])):
        with pytest.raises(st.InputError):
            st.measure(mesh)
        with pytest.raises(st.InputError):
            st.Solid.trusted(mesh)
    make, (kind, vertices, triangles, exact, operands, faces, attributes), _ = A.__reduce__()
    for wrong in (
        (vertices, triangles + 8, exact, operands, faces, attributes),
        (vertices, triangles, "9 1/3 0 0\n", operands, faces, attributes),
        (vertices, triangles, "1 1/3", operands, faces, attributes),
        (vertices, triangles, exact, operands[:3], faces[:3], attributes),
        (vertices, triangles, exact, operands, faces, st.Attributes(face={"id": [1]})),
    ):
        with pytest.raises(ValueError):
            make(kind, *wrong)
    with pytest.raises(TypeError):
        make(int, vertices, triangles, exact, operands, faces, attributes)


def test_files(tmp_path):
    part = A - st.box((1, 1, 1), (3, 3, 3)).rotated((1, 2, 3), 40)
    path = tmp_path / "part.xoff"
    assert st.write(path, part) == []
    assert st.Solid.trusted(st.read(path)) == part
    assert st.write(str(tmp_path / "part.stl"), part)  # a note: floats
    assert st.read(tmp_path / "part.stl").triangles.shape == part.triangles.shape
    for format in ("obj", "off", "ply", "ply-ascii", "stl-ascii"):
        data = st.write_bytes(part, format)
        assert isinstance(data, bytes) and np.array_equal(st.read_bytes(data, format).triangles.shape, part.triangles.shape)
    assert st.read(tmp_path / "part.xoff", format="xoff") == st.read(path)


def test_files_that_are_none(tmp_path):
    with pytest.raises(OSError, match="missing"):
        st.read(tmp_path / "missing.stl")
    bad = tmp_path / "bad.obj"
    bad.write_text("v 1 2 3\nv 1 2\n")
    with pytest.raises(st.FileError) as caught:
        st.read(bad)
    assert caught.value.line == 2 and caught.value.path == str(bad) and caught.value.reason
    with pytest.raises(ValueError, match="format: there is none of the name 'abc'"):
        st.read(bad, format="abc")
    with pytest.raises(st.FileError):
        st.write(tmp_path / "no" / "folder" / "part.stl", A)
    with pytest.raises(TypeError):
        st.read(None)
    with pytest.raises(OSError):
        st.read(b"/\xff\xfe.stl")


def test_names_that_are_not_ascii(tmp_path):
    path = tmp_path / "\u0442\u0435\u043b\u043e \u00e9 \u4f53.off"
    st.write(path, A)
    assert st.Solid(st.read(path)) == A


def test_openscad(tmp_path):
    model = tmp_path / "model.csg"
    model.write_text("difference() { cube(size = [2, 2, 2]); cube(size = [1, 1, 3]); }")
    assert st.read_openscad(model).evaluate().volume == 6
    model.write_text("difference() {\n linear_extrude(height = 1) { roof() { square(size = [1, 1]); } }\n}")
    with pytest.raises(st.FileError) as caught:
        st.read_openscad(model)
    assert caught.value.line == 2


@pytest.mark.parametrize(
    "call",
    [
        lambda: st.box((0, 0, 0), (0, 1, 1)),
        lambda: st.box((0, 0, 0), (float("nan"), 1, 1)),
        lambda: st.sphere(-1),
        lambda: st.sphere(1, 2),
        lambda: st.cylinder(1, 0, 8),
        lambda: st.torus(1, 2),
        lambda: st.tetrahedron((0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0)),
        lambda: st.prism([(0, 0), (1, 0)], 0, 1),
        lambda: st.prism([(0, 0), (1, 1), (1, 0), (0, 1)], 0, 1),
        lambda: st.offset(A, float("inf")),
        lambda: A.split(((0, 0, 0), 1)),
        lambda: st.layers([A], origin=(0, 0, 0), direction=(0, 0, 1)),
        lambda: st.slice(A, 5, [0.5]),
        lambda: st.slice(A, 2, [1, 0]),
        lambda: st.distance(A, st.Solid()),
    ],
)
def test_arguments_that_mean_nothing(call):
    with pytest.raises(ValueError):
        call()


@pytest.mark.parametrize("call", [lambda: st.box((0, 0), (1, 1)), lambda: A.split(3), lambda: st.sphere("a"), lambda: A | 3])
def test_arguments_of_other_types(call):
    with pytest.raises(TypeError):
        call()
