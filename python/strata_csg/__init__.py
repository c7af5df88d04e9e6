"""Exact Booleans of solids: union, intersection, difference of triangle meshes, on the doubles that you give.

>>> import strata_csg as st
>>> part = st.box((0, 0, 0), (4, 4, 2)) - st.cylinder(1, 2, 64).translated((2, 2, 0))
>>> part
Solid(136 vertices, 272 triangles, 120 vertices rational)

`Solid` is a value with operators; `boolean` goes from arrays to arrays; `Expression` and `Workpiece` are for chains of
thousands of operations. Volumes and coordinates of results are fractions where they are not doubles.
"""

import importlib
from typing import TYPE_CHECKING, Any

from strata_csg._attributes import Image, Material
from strata_csg._errors import Defect, FileError, InputError, InternalError, ParseError
from strata_csg._native import (
    Attributes,
    Channel,
    Expression,
    Layers,
    Locator,
    Mesh,
    Polygons,
    RayCaster,
    SelectiveComplex,
    Solid,
    Surface,
    Workpiece,
    boolean,
    box,
    carry_attributes,
    cells_of,
    check,
    clip,
    cone,
    contacts,
    convex_hull,
    cylinder,
    decompose,
    difference,
    distance,
    erosion,
    formats,
    imprint,
    intersection,
    layers,
    measure,
    minkowski_sum,
    offset,
    prism,
    read,
    read_bytes,
    read_openscad,
    resolve,
    section,
    slice,
    sphere,
    split,
    symmetric_difference,
    tetrahedron,
    torus,
    union,
    write,
    write_bytes,
)
from strata_csg._native import version as __version__

if TYPE_CHECKING:
    from strata_csg._batch import Record, batch
    from strata_csg._notebook import Viewer, show

__all__ = [
    "__version__",
    "Attributes",
    "batch",
    "boolean",
    "box",
    "carry_attributes",
    "cells_of",
    "Channel",
    "check",
    "clip",
    "cone",
    "contacts",
    "convex_hull",
    "cylinder",
    "decompose",
    "Defect",
    "difference",
    "distance",
    "erosion",
    "Expression",
    "FileError",
    "formats",
    "Image",
    "imprint",
    "InputError",
    "InternalError",
    "intersection",
    "layers",
    "Layers",
    "Locator",
    "Material",
    "measure",
    "Mesh",
    "minkowski_sum",
    "offset",
    "ParseError",
    "Polygons",
    "prism",
    "RayCaster",
    "read",
    "read_bytes",
    "read_openscad",
    "Record",
    "resolve",
    "section",
    "SelectiveComplex",
    "show",
    "slice",
    "Solid",
    "sphere",
    "split",
    "Surface",
    "symmetric_difference",
    "tetrahedron",
    "torus",
    "union",
    "Viewer",
    "Workpiece",
    "write",
    "write_bytes",
]


#: What takes longer to import than all the rest, and is imported when it is used.
_LATER = {"Record": "_batch", "batch": "_batch", "Viewer": "_notebook", "show": "_notebook"}


def __getattr__(name: str) -> Any:
    if name not in _LATER:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(importlib.import_module(f"strata_csg.{_LATER[name]}"), name)
