"""Every example in a docstring runs."""

from __future__ import annotations

import doctest
import importlib
import pkgutil

import pytest
import strata_csg as st
from strata_csg import _native

#: Modules that need a package that may be missing.
OPTIONAL = {
    "strata_csg.trimesh": "trimesh",
    "strata_csg._trimesh_visuals": "trimesh",
    "strata_csg.pyvista": "pyvista",
    "strata_csg.meshio": "meshio",
}


def documented(name: str, thing: object) -> list[tuple[str, str]]:
    found = []
    text = getattr(thing, "__doc__", None)
    if text and ">>>" in text:
        found.append((name, text))
    if isinstance(thing, type):
        for key, value in vars(thing).items():
            if not key.startswith("__"):
                found += documented(f"{name}.{key}", value)
    return found


EXAMPLES = [
    example
    for name, thing in vars(_native).items()
    if not name.startswith("_") and not isinstance(thing, str)
    for example in documented(name, thing)
]


@pytest.mark.parametrize(("name", "text"), EXAMPLES, ids=[name for name, _ in EXAMPLES])
def test_example(name, text):
    names = {name: getattr(st, name) for name in st.__all__}
    test = doctest.DocTestParser().get_doctest(text, names, name, None, 0)
    assert doctest.DocTestRunner().run(test).failed == 0


@pytest.mark.parametrize("module", ["strata_csg", *(f"strata_csg.{m.name}" for m in pkgutil.iter_modules(st.__path__))])
def test_module(module):
    if module == "strata_csg._native":
        pytest.skip("its examples are those above")
    if module in OPTIONAL:
        pytest.importorskip(OPTIONAL[module])
    assert doctest.testmod(importlib.import_module(module)).failed == 0


def test_all_public_functions_have_an_example():
    without = {name for name in st.__all__ if name[0].islower()} - {name for name, _ in EXAMPLES}
    assert without <= {"batch", "show", "read_openscad"}
