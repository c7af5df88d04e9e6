"""MIGRATION.md: every line of its tables runs, and both columns mean the same."""

from __future__ import annotations

import re
from collections.abc import Iterator
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import strata_csg as st

TEXT = (Path(__file__).parents[1] / "MIGRATION.md").read_text()
SECTIONS = re.split(r"^## ", TEXT, flags=re.MULTILINE)
#: Packages that the left columns use; trimesh needs others for much of what it does.
NEEDED = {
    "manifold3d": ["manifold3d"],
    "libigl": ["igl"],
    "trimesh": ["trimesh", "manifold3d", "scipy", "networkx", "rtree", "shapely"],
    "PyVista": ["pyvista"],
}

#: The first column returns other things here: cells with the one outside, curves, distances, whether it was possible.
NOT_COMPARED = {
    "libigl: cells",
    "trimesh: section",
    "trimesh: holes",
    "PyVista: section",
    "PyVista: components",
}


def first_code(text: str) -> str:
    found = re.search(r"```python\n(.*?)```", text, flags=re.DOTALL)
    assert found
    return found[1]


def cells(line: str) -> list[str]:
    return [cell.replace(r"\|", "|").strip() for cell in re.split(r"(?<!\\)\|", line)[1:-1]]


def code_of(cell: str) -> str | None:
    found = re.match(r"`([^`]+)`", cell)
    return found[1] if found else None


def rows() -> Iterator[Any]:
    for section in SECTIONS[1:]:
        name = section.split("\n", 1)[0]
        for line in section.splitlines():
            if line.startswith("|") and "`" in line:
                title, theirs, ours = cells(line)
                yield pytest.param(name, title, code_of(theirs), code_of(ours), id=f"{name}: {theirs or ours}")


@pytest.fixture(scope="module")
def ours() -> dict[str, Any]:
    names: dict[str, Any] = {}
    exec(first_code(SECTIONS[0]), names)
    return names


@cache
def names_of(name: str) -> dict[str, Any]:
    """What the code of a section's left column refers to."""
    names: dict[str, Any] = {}
    exec(first_code(SECTIONS[0]), names)
    exec(first_code(next(section for section in SECTIONS if section.startswith(name))), names)
    return names


def size(value: Any) -> Any:
    """What must be equal in both columns: numbers, volumes and areas; None where there is no such thing."""
    for name in ("nearest_volume", "volume", "area"):
        if hasattr(value, name):
            found = getattr(value, name)
            return float(found() if callable(found) else found)
    if isinstance(value, (bool, int, float, np.floating, Fraction)):
        return float(value)
    if isinstance(value, st.Mesh):
        return float(st.Solid(value).volume)
    if isinstance(value, (list, tuple)) and len(value) == 2:
        sizes = [size(part) for part in value]
        return None if None in sizes else sorted(sizes)
    return None


@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize(("name", "title", "their_code", "our_code"), list(rows()))
def test_both_columns_mean_the_same(
    name: str, title: str, their_code: str | None, our_code: str | None, ours: Any
) -> None:
    for package in NEEDED[name]:
        pytest.importorskip(package)
    names = names_of(name)
    result = eval(our_code, names if name == "libigl" else ours) if our_code else None
    expected = eval(their_code, names) if their_code else None
    if name == "libigl" and isinstance(expected, tuple):
        expected = st.Solid(expected[:2]) if "trim_with_solid" not in str(their_code) else None
    if None not in (size(expected), size(result)) and f"{name}: {title}" not in NOT_COMPARED:
        assert size(result) == pytest.approx(size(expected), rel=1e-6)
