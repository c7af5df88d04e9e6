"""How two solids can touch: every pair of features, from outside, from inside and across, on axes and sheared."""
from solids import box, cube, extruded, octahedron, prism, pyramid, tetrahedron

A = box((0, 0, 0), (4, 4, 4))
DIAMOND = [(2, 0), (4, 2), (2, 4), (0, 2)]
SQUARE = [(0, 0), (4, 0), (4, 4), (0, 4)]

# name, second solid, sentence, facts about the union (components, Euler characteristic)
CONTACTS = [
    ("vertex-vertex-outside", box((4, 4, 4), (8, 8, 8)), "two boxes share a corner only", (1, 3)),
    ("vertex-vertex-inside", tetrahedron((4, 4, 4), (1, 2, 3), (2, 3, 1), (3, 1, 2)),
     "a tetrahedron inside a box touches one of its corners", (1, 2)),
    ("vertex-edge-outside", tetrahedron((4, 4, 2), (6, 5, 1), (5, 6, 1), (6, 6, 3)),
     "an apex stands on the middle of an edge", (1, 3)),
    ("vertex-edge-inside", tetrahedron((4, 4, 2), (1, 2, 1), (2, 1, 2), (1, 1, 3)),
     "an apex touches an edge from inside", (1, 2)),
    ("vertex-face-outside", tetrahedron((2, 2, 4), (3, 2, 5), (2, 3, 5), (1, 1, 5)), "an apex stands on a face", (1, 3)),
    ("vertex-face-inside", tetrahedron((2, 2, 4), (1, 1, 3), (2, 3, 3), (3, 2, 3)),
     "an apex touches a face from inside", (1, 2)),
    ("edge-edge-same-outside", box((4, 4, 0), (8, 8, 4)), "two boxes share a whole edge", (1, 3)),
    ("edge-edge-same-inside", tetrahedron((4, 4, 0), (4, 4, 4), (1, 2, 1), (2, 1, 3)),
     "a tetrahedron inside a box has one of its edges in common", (1, 2)),
    ("edge-edge-within-outside", box((4, 4, 1), (8, 8, 3)), "an edge lies within a longer one", (1, 3)),
    ("edge-edge-within-inside", tetrahedron((4, 4, 1), (4, 4, 3), (1, 2, 1), (2, 1, 2)),
     "an edge lies within a longer one, from inside", (1, 2)),
    ("edge-edge-shifted-outside", box((4, 4, 2), (8, 8, 6)), "two edges overlap in a part of each", (1, 3)),
    ("edge-edge-crossing-outside", tetrahedron((3, 5, 2), (5, 3, 2), (6, 6, 1), (6, 6, 3)),
     "two edges cross in one point and nothing else meets", (1, 3)),
    ("edge-edge-crossing-across", tetrahedron((3, 5, 2), (5, 3, 2), (1, 1, 1), (1, 1, 3)),
     "two edges cross in one point, the solids through one another", None),
    ("edge-face-outside", tetrahedron((1, 2, 4), (3, 2, 4), (2, 3, 6), (2, 1, 6)), "an edge lies on a face", (1, 3)),
    ("edge-face-inside", tetrahedron((1, 2, 4), (3, 2, 4), (2, 3, 2), (2, 1, 2)), "an edge lies on a face, from inside",
     (1, 2)),
    ("edge-face-overhang-outside", tetrahedron((1, 2, 4), (7, 2, 4), (4, 3, 6), (4, 1, 6)),
     "an edge lies on a face and sticks out over its border", (1, 3)),
    ("edge-face-diagonal-outside", tetrahedron((0, 0, 4), (4, 4, 4), (4, 0, 7), (0, 4, 7)),
     "an edge is the diagonal of a face, corner to corner", (1, 3)),
    ("edge-face-across", tetrahedron((1, 2, 4), (3, 2, 4), (2, 3, 6), (2, 3, 1)),
     "an edge lies on a face, with one solid on both sides of it", None),
    ("face-face-same-outside", box((4, 0, 0), (8, 4, 4)), "two boxes share a whole face", (1, 2)),
    ("face-face-same-inside", pyramid(SQUARE, 4, (2, 2, 1)), "a pyramid inside a box has a face of the box as its base",
     (1, 2)),
    ("face-face-within-outside", box((4, 1, 1), (8, 3, 3)), "a face lies within a larger one", (1, 2)),
    ("face-face-within-inside", box((2, 1, 1), (4, 3, 3)), "a face lies within a larger one, from inside", (1, 2)),
    ("face-face-partly-outside", box((4, 2, 1), (8, 6, 3)), "two faces overlap in a part of each", (1, 2)),
    ("face-face-partly-across", box((2, 2, 1), (4, 6, 3)), "coplanar faces overlap in part, the solids cross", (1, 2)),
    ("face-face-corner-outside", box((4, 0, 0), (8, 2, 2)), "two faces share a corner and sides of each other", (1, 2)),
    ("face-face-corner-inside", box((2, 0, 0), (4, 2, 2)), "a box in the corner of another, three faces coplanar", (1, 2)),
    ("face-face-strip-inside", box((2, 0, 0), (4, 2, 4)), "a slab along an edge, four faces coplanar", (1, 2)),
    ("face-face-diamond-outside", prism(DIAMOND, 4, 6), "a diamond whose corners are on the sides of the square", (1, 2)),
    ("face-face-diamond-inside", prism(DIAMOND, 2, 4), "the same diamond from inside: its corners touch edges", (1, 2)),
    ("face-face-pyramid-outside", pyramid(DIAMOND, 4, (2, 2, 7)), "a pyramid on a face, its base inscribed", (1, 2)),
    ("face-face-crosswise-outside", box((-2, 1, 4), (6, 3, 6)), "a bar across a face, over both of its sides", (1, 2)),
    ("identical", A, "the same solid twice", (1, 2)),
    ("edge-through-vertex", tetrahedron((2, 6, 4), (6, 2, 4), (6, 6, 7), (1, 1, 1)),
     "an edge passes through a corner, the solids cross", None),
    ("vertex-in-plane-across", octahedron((4, 4, 4), 4), "an octahedron about a corner: its corners lie in the planes "
     "of faces and on edges", None),
    ("octahedron-inscribed", octahedron((2, 2, 2), 2), "an octahedron touches every face of a box from inside", (1, 2)),
]


def sheared(p):
    """An affine map by integers, of determinant 78: no face is parallel to an axis any more."""
    x, y, z = p
    return (3 * x + y - 2 * z + 7, x + 4 * y + z - 5, 2 * x - y + 5 * z + 3)


def add_to(cases):
    for name, b, why, facts in CONTACTS:
        known = {"union": {"components": facts[0], "euler": facts[1]}} if facts else {}
        kind = [t for t in ("vertex", "edge", "face") if t in name.split("-")[:2]]
        tags = ["contact"] + [f"{k}-contact" for k in kind]
        cases.operations(f"contact-{name}", A, b, tags, why, known)
        cases.operations(f"sheared-{name}", A.mapped(sheared), b.mapped(sheared), [*tags, "sheared"],
                         f"{why}, in no direction of an axis", known)
    thirds = cube(0, 0, 0, 3).scaled(1)
    l_shape = extruded([(0, 0), (4, 0), (4, 2), (2, 2), (2, 4), (0, 4)], 0, 2,
                       [box((0, 0, 0), (4, 2, 2)), box((0, 2, 0), (2, 4, 2))])
    cases.operations("contact-l-shape-notch", l_shape, box((2, 2, 0), (4, 4, 2)), ["contact", "face-contact"],
                     "a box fills the notch of an L: two faces touch, four are coplanar",
                     {"union": {"volume": 32, "components": 1, "euler": 2, "facets": 6}})
    cases.operations("contact-l-shape-over-edge", l_shape, box((1, 1, 2), (3, 3, 4)), ["contact", "face-contact"],
                     "a box stands on an L over its inner corner, overhanging the notch")
    cases.operations("contact-cube-in-grid-plane", thirds, box((1, 1, 0), (2, 2, 3)), ["contact", "face-contact"],
                     "a square hole through a cube, its ends in the cube's faces",
                     {"difference": {"volume": 24, "components": 1, "euler": 0, "facets": 10}})
