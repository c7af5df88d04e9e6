#!/usr/bin/env python3
"""Makes data/fonts/blocks.ttf, the font of the tests: glyphs of few straight strokes, whose areas are known.

Needs fontTools (Debian: python3-fonttools). Usage: tools/generate/font.py [FILE]

Coordinates are in units of 72 of 1000 to the em, each a tenth of OpenSCAD's `size`. Outer contours are clockwise.
"""
import pathlib
import sys

from fontTools.fontBuilder import FontBuilder
from fontTools.pens.ttGlyphPen import TTGlyphPen
from fontTools.ttLib import newTable
from fontTools.ttLib.tables.ttProgram import Program

UNIT = 72


def rectangle(left, bottom, right, top):
    return [(left, bottom), (left, top), (right, top), (right, bottom)]


def hole(left, bottom, right, top):
    return rectangle(left, bottom, right, top)[::-1]


# Name, character, advance, contours. A corner of three entries is the control point of a curve.
GLYPHS = [
    (".notdef", None, 5, [rectangle(0, 0, 4, 4)]),
    ("space", " ", 5, []),
    ("I", "I", 5, [rectangle(0, 0, 2, 10)]),
    ("L", "L", 8, [[(0, 0), (0, 10), (2, 10), (2, 2), (6, 2), (6, 0)]]),
    ("O", "O", 12, [rectangle(0, 0, 10, 10), hole(3, 3, 7, 7)]),
    ("D", "D", 10, [[(0, 0), (0, 8), (8, 8, "control"), (8, 0)]]),
    ("plus", "+", 12, [rectangle(4, 0, 6, 10), rectangle(0, 4, 10, 6)]),  # contours that overlap
    ("p", "p", 8, [rectangle(0, -4, 2, 6), rectangle(2, 2, 6, 6)]),
    ("f", "f", 5, [rectangle(0, 0, 2, 8)]),
    ("i", "i", 4, [rectangle(0, 0, 2, 4), rectangle(0, 6, 2, 8)]),
    ("f_i", None, 9, [rectangle(0, 0, 8, 8)]),
    ("e", "e", 5, [rectangle(0, 0, 4, 4)]),
    ("acute", "\u0301", 0, [rectangle(-3, 6, -1, 8)]),  # a mark, above the letter before it
    ("eacute", "\u00e9", 5, [rectangle(0, 0, 4, 4), rectangle(1, 6, 3, 8)]),
    ("alef", "\u05d0", 5, [rectangle(0, 0, 4, 4)]),
    ("bet", "\u05d1", 5, [rectangle(0, 0, 4, 8)]),
]

# A ligature, a pair of letters two units closer, and where the mark stands on `p`: with its middle above 1, and with its lower
# edge at 7.
FEATURES = f"""
feature liga {{ sub f i by f_i; }} liga;
feature kern {{ pos O I {-2 * UNIT}; }} kern;
markClass acute <anchor {-2 * UNIT} {6 * UNIT}> @above;
feature mark {{ pos base p <anchor {UNIT} {7 * UNIT}> mark @above; }} mark;
"""


def drawn(contours):
    pen = TTGlyphPen(None)
    for contour in contours:
        corners = [(x * UNIT, y * UNIT, *kind) for x, y, *kind in contour]
        pen.moveTo(corners[0][:2])
        at = 1
        while at < len(corners):
            if len(corners[at]) == 3:
                pen.qCurveTo(corners[at][:2], corners[at + 1][:2])
                at += 1
            else:
                pen.lineTo(corners[at])
            at += 1
        pen.closePath()
    return pen.glyph()


def left_edge(contours):
    return min((x * UNIT for contour in contours for x, *_ in contour), default=0)


def without_hinting():
    """A program that does nothing: FreeType hints fonts that have none by itself."""
    table = newTable("prep")
    table.program = Program()
    table.program.fromAssembly(["PUSHB[ ]", "0", "POP[ ]"] * 4)
    return table


def main():
    folder = pathlib.Path(__file__).resolve().parents[2] / "data" / "fonts"
    path = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else folder / "blocks.ttf"
    builder = FontBuilder(1000, isTTF=True)
    builder.setupGlyphOrder([name for name, *_ in GLYPHS])
    builder.setupCharacterMap({ord(character): name for name, character, *_ in GLYPHS if character})
    builder.setupGlyf({name: drawn(contours) for name, _, _, contours in GLYPHS})
    builder.setupHorizontalMetrics({name: (advance * UNIT, left_edge(contours)) for name, _, advance, contours in GLYPHS})
    builder.setupHorizontalHeader(ascent=10 * UNIT, descent=-4 * UNIT)
    builder.setupNameTable({"familyName": "Strata Blocks", "styleName": "Regular"})
    builder.setupOS2()
    builder.setupPost()
    builder.addOpenTypeFeatures(FEATURES)
    builder.font["prep"] = without_hinting()
    builder.font["head"].created = builder.font["head"].modified = 0
    builder.font.recalcTimestamp = False
    path.parent.mkdir(parents=True, exist_ok=True)
    builder.save(path)


if __name__ == "__main__":
    main()
