"""Solids in a viewer, for notebooks and for web pages.

>>> import strata_csg as st
>>> from strata_csg._notebook import show
>>> show(st.box((0, 0, 0), (1, 2, 3)))
Viewer(Solid: 12 triangles, volume 6, from (0, 0, 0) to (1, 2, 3))

The viewer is a page of its own, within an `iframe` of the output. It loads nothing, and works without a network.
"""

from __future__ import annotations

import functools
import html
import json
import math
import os
import uuid
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from decimal import Context, Decimal
from fractions import Fraction
from importlib import resources
from typing import Any, Literal

import numpy as np

from strata_csg import _native
from strata_csg._picture import Frame, Part, packed, part_of, placed_parts

__all__ = ["Viewer", "html_of", "show"]

#: More triangles are not drawn: the picture is the bounding box then. 200,000 make a page of some 8 MB.
MOST_TRIANGLES = 200_000

#: Exact volumes are computed up to so many vertices, and shown up to so many bits.
MOST_EXACT_VERTICES = 1_000
MOST_EXACT_BITS = 72

#: Colours of parts, one after the other.
PALETTE = ("#7aa6d8", "#e8a15a", "#7fbf7b", "#d98080", "#a991cc", "#c9b458", "#6fbfbf", "#d58fb8", "#a58d75", "#9aa5b1")

#: Colours of the first and the last layer; those between are mixed.
FIRST_LAYER, LAST_LAYER = "#2c4a7c", "#f3d27a"

#: What a set of parts is, which says how it is coloured, described, and moved by the slider.
Kind = Literal["one", "explode", "layers"]

#: Red, green and blue from 0 to 255.
Color = tuple[int, int, int]


@dataclass(frozen=True)
class Viewer:
    """
    A picture that notebooks show, and that can be saved as a page; `show` makes them.

    Attributes
    ----------
    facts : str
        The line above the picture.
    page : str
        The page with the picture, in HTML; empty where there is nothing to draw.
    """

    facts: str
    page: str = ""

    def __repr__(self) -> str:
        return f"Viewer({self.facts})"

    def _repr_html_(self) -> str:
        """The line of facts and the picture, as HTML with an identifier of its own."""
        facts = html.escape(self.facts)
        identifier = f"strata-{uuid.uuid4().hex}"
        line = f'<div style="font-size:small;margin:0.3em 0">{facts}</div>'
        if not self.page:
            return f'<div id="{identifier}">{line}</div>'
        return (
            f'<div id="{identifier}">{line}<iframe title="{facts}" sandbox="allow-scripts" '
            f'srcdoc="{html.escape(self.page)}" '
            'style="width:100%;height:420px;border:1px solid #c8ccd2;box-sizing:border-box"></iframe></div>'
        )

    def save(self, path: str | os.PathLike[str], *, title: str = "Strata") -> None:
        """
        Writes a page that browsers show without a network.

        Parameters
        ----------
        path : str or path
        title : str
            Of the window.

        Examples
        --------
        >>> import os, tempfile
        >>> import strata_csg as st
        >>> show(st.box((0, 0, 0), (1, 1, 1))).save(os.path.join(tempfile.mkdtemp(), "cube.html"))
        """
        style = "html{font-family:sans-serif}iframe{height:85vh!important}"
        head = f'<meta charset="utf-8"><title>{html.escape(title)}</title><style>{style}</style>'
        page = f'<!DOCTYPE html>\n<html lang="en"><head>{head}</head>\n<body>{self._repr_html_()}</body></html>\n'
        with open(path, "w", encoding="utf-8") as file:
            file.write(page)


def html_of(thing: Any) -> str:
    """The HTML that shows a solid, or anything else that `show` takes."""
    return show(thing)._repr_html_()


def show(things: Any, *, colors: Any = None) -> Viewer:
    """
    A viewer of a solid, a mesh, a surface, layers, or a list of solids, meshes and surfaces.

    Dragging turns, and shifts with the shift key; the wheel zooms; two fingers shift and zoom. Arrow keys turn, and
    shift with the shift key; plus and minus zoom; Home resets. Edges between coplanar triangles are not drawn.

    Parameters
    ----------
    things : Solid, Mesh, Surface, Layers, object with `vertices` and `faces`, pair of arrays, or iterable of those
        The parts of a list have different colours, and a slider moves them apart. So have layers, and a slider says how
        many are shown, from the first on.
    colors : str, or sequence of one per part, optional
        Such as ``"#80a0ff"``, or three numbers from 0 to 1. Without, parts that carry colours or materials have these;
        textures are not shown.

    Returns
    -------
    Viewer
        Of more than 200,000 triangles it shows the bounding box alone, and says so.

    Raises
    ------
    TypeError
        For things that have no triangles.
    ValueError
        For colours of another form, and another number of colours than of parts.

    Examples
    --------
    >>> import strata_csg as st
    >>> notched = st.box((0, 0, 0), (2, 2, 1)) - st.box((1, 1, 0), (2, 2, 1))
    >>> show(st.decompose(notched))
    Viewer(2 parts: 24 triangles, volume 3, from (0, 0, 0) to (2, 2, 1))
    >>> show(st.layers([notched], direction=(0, 0, 1)), colors=["#000080", "#8080ff"])
    Viewer(2 layers: 8 triangles, from (0, 0, 0) to (2, 2, 1))
    """
    kind, meshes = _meshes_of(things)
    shades = _colors_of(colors, len(meshes), kind)
    parts = [part_of(mesh, colored=colors is None) for mesh in meshes]
    frame = Frame.around(parts)
    facts = [_counts(parts), *_sizes(meshes, parts), *_places(parts, frame)]
    drawn = sum(len(part.triangles) for part in parts)
    if drawn > MOST_TRIANGLES:
        facts.append(f"the picture is the bounding box, as of all with more than {MOST_TRIANGLES:,} triangles")
    line = f"{_heading(kind, things, meshes)}: {', '.join(facts)}"
    if frame is None:
        return Viewer(line)
    if drawn > MOST_TRIANGLES:
        return Viewer(line, _page(_data([frame.box()], [(0, 0, 0)], "one"), "one", 1, line))
    slider: Kind = kind if len(parts) > 1 else "one"
    return Viewer(line, _page(_data(placed_parts(parts, frame), shades, slider), slider, len(parts), line))


# What is shown.


def _meshes_of(things: Any) -> tuple[Kind, list[Any]]:
    """The meshes of the parts."""
    if isinstance(things, _native.Layers):
        return "layers", [things.mesh(layer) for layer in range(1, things.count + 1)]
    if _has_triangles(things):
        return "one", [things]
    if not isinstance(things, Iterable):
        raise TypeError(f"expected solids, meshes, surfaces or layers, found {type(things).__name__}")
    meshes = list(things)
    if isinstance(things, tuple) and len(meshes) == 2 and not any(map(_has_triangles, meshes)):
        return "one", [_native.Mesh(*meshes)]
    for mesh in meshes:
        if not _has_triangles(mesh):
            raise TypeError(f"expected solids, meshes and surfaces, found {type(mesh).__name__}")
    return "explode", meshes


def _has_triangles(thing: Any) -> bool:
    return hasattr(thing, "vertices") and hasattr(thing, "faces")


# Colours.


def _colors_of(colors: Any, count: int, kind: Kind) -> list[Color]:
    """One colour per part."""
    if colors is None:
        return _ramp(count) if kind == "layers" else [_color(PALETTE[i % len(PALETTE)]) for i in range(count)]
    given = [colors] if kind == "one" and _is_color(colors) else list(colors)
    if len(given) != count:
        raise ValueError(f"colors: expected {count}, found {len(given)}")
    return [_color(color) for color in given]


def _is_color(colors: Any) -> bool:
    """One colour, and no sequence of colours."""
    if isinstance(colors, str):
        return True
    return len(colors) == 3 and not any(isinstance(part, str) or np.ndim(part) for part in colors)


def _color(color: Any) -> Color:
    red, green, blue = _hexadecimal(color) if isinstance(color, str) else _fractions(color)
    return red, green, blue


def _hexadecimal(text: str) -> list[int]:
    digits = text[1:] if len(text) != 4 else "".join(2 * digit for digit in text[1:])
    if text[:1] != "#" or len(digits) != 6 or not set(digits) <= set("0123456789abcdefABCDEF"):
        raise ValueError(f"colors: expected a text such as '#80a0ff', found {text!r}")
    return [int(digits[i : i + 2], 16) for i in (0, 2, 4)]


def _fractions(color: Any) -> list[int]:
    numbers = np.asarray(color, np.float64)
    if numbers.shape != (3,) or not np.all((numbers >= 0) & (numbers <= 1)):
        raise ValueError(f"colors: expected three numbers from 0 to 1, found {color!r}")
    return [int(number) for number in np.rint(255 * numbers)]


def _ramp(count: int) -> list[Color]:
    """Colours from the first to the last layer."""
    first, last = _color(FIRST_LAYER), _color(LAST_LAYER)
    weights = [i / max(1, count - 1) for i in range(count)]
    mixed = [[round(a + weight * (b - a)) for a, b in zip(first, last)] for weight in weights]
    return [(red, green, blue) for red, green, blue in mixed]


# The line of facts.


def _heading(kind: Kind, things: Any, meshes: Sequence[Any]) -> str:
    if kind == "one":
        return type(meshes[0]).__name__
    noun = "part" if kind == "explode" else "layer"
    return f"{len(meshes):,} {noun}{'' if len(meshes) == 1 else 's'}"


def _counts(parts: Sequence[Part]) -> str:
    return f"{sum(len(part.triangles) + part.omitted for part in parts):,} triangles"


def _sizes(meshes: Sequence[Any], parts: Sequence[Part]) -> list[str]:
    """The volume, where the meshes bound solids; the area of a surface."""
    if meshes and all(isinstance(mesh, _native.Solid) for mesh in meshes):
        return [f"volume {_volume(meshes)}"]
    if len(meshes) != 1 or parts[0].omitted:
        return []
    if isinstance(meshes[0], _native.Surface):
        return [f"area {_decimal(meshes[0].area)}"]
    if isinstance(meshes[0], _native.Mesh) and len(parts[0].triangles):
        volume = _native.measure(meshes[0])["volume"]
        return [f"volume {_decimal(volume)}"] if volume is not None else ["not closed"]
    return []


def _volume(solids: Sequence[_native.Solid]) -> str:
    """As a decimal number; also as a fraction where that is short and not the same."""
    nearest = math.fsum(solid.nearest_volume for solid in solids)
    empty = all(solid.is_empty for solid in solids)
    beyond = not math.isfinite(nearest) or nearest < 1e-290 and not empty
    if not beyond and sum(len(solid.vertices) for solid in solids) > MOST_EXACT_VERTICES:
        return _decimal(nearest)
    volume = sum((solid.volume for solid in solids), Fraction(0))
    decimal = _decimal_of_fraction(volume) if beyond else _decimal(nearest)
    bits = volume.numerator.bit_length() + volume.denominator.bit_length()
    if bits > MOST_EXACT_BITS or Fraction(decimal) == volume:
        return decimal
    return f"{decimal} (exactly {volume})"


def _decimal(number: Any, digits: int = 9) -> str:
    return format(float(number) + 0.0, f".{digits}g")


def _decimal_of_fraction(number: Fraction) -> str:
    """Of numbers beyond doubles, too."""
    context = Context(prec=9, Emax=10**9, Emin=-(10**9))
    quotient = context.divide(Decimal(number.numerator), Decimal(number.denominator))
    return str(quotient.normalize(context)).lower()


def _places(parts: Sequence[Part], frame: Frame | None) -> list[str]:
    """The bounds, and how many triangles have no place."""
    facts = []
    if frame is not None:
        lower, upper = (", ".join(_decimal(x, frame.digits) for x in point) for point in (frame.lower, frame.upper))
        facts.append(f"from ({lower}) to ({upper})")
    omitted = sum(part.omitted for part in parts)
    if omitted:
        facts.append(f"{omitted:,} not drawn: coordinates not finite, or no such vertex")
    return facts if facts else ["nothing to draw"]


# The page.


def _data(parts: Sequence[Part], colors: Sequence[Color], slider: Kind) -> str:
    """What the script reads, as JSON that may stand in HTML."""
    arrays = packed(parts, colors)
    listed = [
        {"ends": ends, "color": color, "away": _away(part) if slider == "explode" else [0, 0, 0]}
        for part, color, ends in zip(parts, colors, arrays.pop("ends"))
    ]
    data = {**arrays, "parts": listed, "slider": slider}
    return json.dumps(data, allow_nan=False, separators=(",", ":")).replace("<", "\\u003c")


def _away(part: Part) -> list[float]:
    """Where a part moves when parts are moved apart: on from the middle of all."""
    if not len(part.vertices):
        return [0, 0, 0]
    middle = (part.vertices.min(axis=0) + part.vertices.max(axis=0)) / 2
    return [round(float(x), 6) for x in middle]


STYLE = """
html,body{margin:0;height:100%;overflow:hidden;font:13px sans-serif;color:#20242c;background:#f6f7fa}
#stage{position:absolute;inset:0;touch-action:none;cursor:grab}
#stage:focus-visible{outline:2px solid #3b6fd0;outline-offset:-2px}
canvas{display:block;width:100%;height:100%}
#bar{position:absolute;top:6px;right:8px;display:flex;gap:10px;align-items:center}
#message{position:absolute;inset:0;border:0;background:#f6f7fa;font:inherit;color:inherit}
label{display:flex;align-items:center;gap:4px}
[hidden]{display:none!important}
"""

HELP = "Arrow keys turn, shift and arrow keys shift, plus and minus zoom, Home resets."


def _page(data: str, slider: Kind, count: int, facts: str) -> str:
    """The page in the `iframe`."""
    label = html.escape(f"{facts}. {HELP}")
    return (
        f'<!DOCTYPE html><html lang="en"><head><meta charset="utf-8"><style>{STYLE}</style></head><body>'
        f'<div id="stage" tabindex="0" role="application" aria-label="{label}" title="{HELP}"></div>'
        '<div id="bar" hidden>'
        f'{_slider(slider, count)}<label><input type="checkbox" id="lines" checked>edges</label>'
        '<button id="reset" type="button">reset</button></div>'
        '<button id="message" type="button">No picture yet: scripts draw it.</button>'
        f'<script type="application/json" id="data">{data}</script><script>{_script()}</script></body></html>'
    )


def _slider(slider: Kind, count: int) -> str:
    if slider == "one":
        return ""
    if slider == "layers":
        return (
            f'<label><span id="label">layers {count} of {count}</span>'
            f'<input type="range" id="slider" min="0" max="{count}" value="{count}"></label>'
        )
    return '<label><span id="label">explode</span><input type="range" id="slider" min="0" max="100" value="0"></label>'


@functools.cache
def _script() -> str:
    return resources.files("strata_csg").joinpath("_viewer.js").read_text(encoding="utf-8")
