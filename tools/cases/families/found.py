"""The minimal cases of what was wrong once, here or in other engines."""
from fractions import Fraction

from solids import Solid, box, generated, octahedron, tetrahedron, together
from writer import OPERATIONS

ABOUT_AN_EDGE = [((0, 0, 0), (0, 0, 1), (0, 1, 0), (2, 3, 0)), ((0, 0, 0), (0, 0, 1), (0, 1, 0), (1, 0, 0)),
                 ((0, 0, 0), (0, 0, 1), (0, 1, 0), (3, 0, 1)), ((0, 0, 0), (0, 0, 1), (1, 2, 1), (2, 2.5, 0))]
IN_ONE_PLANE = [((0, 0, 0), (1, 0, 2), (0, 0, 1), (1, 1, 0)), ((0, 0, 1), (1, 0, 1), (0, 1, 1), (1, 1, 0)),
                ((0, 0, 0), (0, 1, 0), (1, 0, 0), (1, 1, 1)), ((0, 0, 0), (0, 0, 1), (0, 1, 0), (2, 0, 1))]


def add_to(cases):
    for name, corners in (("about-an-edge", ABOUT_AN_EDGE), ("in-one-plane", IN_ONE_PLANE)):
        solids = {f"t{k}": tetrahedron(*c) for k, c in enumerate(corners)}
        for operation, sign in (("union", "|"), ("intersection", "&"), ("difference", "-"), ("xor", "^")):
            cases.add(f"found-four-{name}-{operation}", solids, f" {sign} ".join(solids), ["found", "n-ary", operation],
                      f"four tetrahedra {name.replace('-', ' ')}, several of their faces coplanar: the boundary was open "
                      f"once ({operation})")
    shared_corner(cases)
    hourglass(cases)
    needles(cases)
    prisms(cases)
    listed_twice(cases)
    planes_through_a_line(cases)
    edge_on_a_face(cases)


def shared_corner(cases):
    a = tetrahedron((0, 0, 0), (3, 2, 0), (3, 0, 0), (3, 3, 3))
    points = [(2, 2.75, 1.5), (2, 2.75, 2.5), (3, 2.75, 2.5), (2, 1.75, 1.5), (2, 1.75, 2.5), (3, 2.75, 1.5),
              (4, 2.75, 2.5), (3, 1.75, 1.5), (3, 1.75, 2.5)]
    faces = [(0, 1, 2), (3, 0, 2), (3, 1, 0), (1, 4, 2), (3, 2, 4), (3, 4, 1), (5, 2, 6), (7, 5, 6), (7, 2, 5), (2, 8, 6),
             (7, 6, 8), (7, 8, 2)]
    for operation, expression in OPERATIONS.items():
        tags = ["found", "self-touching", operation]
        cases.add(f"found-shared-corner-{operation}", {"a": a, "b": Solid(points, faces)}, expression, tags,
                  "two pyramids that share a corner on a face of a tetrahedron, one inside and one outside: CGAL's "
                  f"regularization lost the difference ({operation})")
    stack = {"a": box((0, 0, 0), (1, 1, 1)), "b": box((0, 0, 0), (3, 3, 3)), "c": octahedron((2, 2, 2), 3),
             "d": box((0, 0, 0), (5, 5, 5))}
    cases.add("found-corner-on-octahedron", stack, "a ^ b ^ c ^ d", ["found", "n-ary", "xor"],
              "a corner of the smallest cube touches a face of the octahedron from its other side: it must be a vertex "
              "of that face")


def hourglass(cases):
    inner = tetrahedron((1, 1, 1), (.5, .5, .25), (.25, .5, .5), (.5, .25, .5))
    outer = tetrahedron((1, 1, 1), (1.5, 1.5, 1.75), (1.5, 1.75, 1.5), (1.75, 1.5, 1.5))
    solids = {"h": together([inner, outer], weld=True), "u": box((0, 0, 0), (1, 1, 1)),
              "i": box((.3, .3, .3), (.6, .6, .6)), "o": box((1.4, 1.4, 1.4), (1.6, 1.6, 1.6))}
    cases.add("found-hourglass-union", solids, "h | u | i | o", ["found", "n-ary", "union"],
              "faces on both sides of a corner of another operand: it was taken to be inside")
    cases.add("found-hourglass-difference", solids, "h - u - i - o", ["found", "n-ary", "difference"],
              "faces on both sides of a corner of another operand, which is taken away")


def needles(cases):
    from math import nextafter
    solids = {"plate": box((0.0, 0.0, 0.0), (8.0, 8.0, 1.0))}
    for i in range(6):
        top = 1.0 if i % 3 == 0 else nextafter(1.0, 2.0 if i % 3 == 1 else 0.0)
        x = 1.0 + i
        solids[f"n{i}"] = tetrahedron((x, 1.0, -1.0), (x + .5, 1.0, -1.0), (x, 1.5, -1.0), (x + .1, 1.1, top))
    names = list(solids)
    for operation, sign in (("union", "|"), ("difference", "-"), ("xor", "^")):
        cases.add(f"found-needles-{operation}", solids, f" {sign} ".join(names), ["found", "ulp", "n-ary", operation],
                  f"needles whose tips are on a face, an ulp above and an ulp below ({operation})")


def prisms(cases):
    for n in (12, 100):
        a = generated("prism", sides=n, radius=1, centre=[0, 0], bottom=0, top=1)
        for name, radius, centre, bottom in (("same-plane", 1.0000000000000002, [1e-9, 0], 1),
                                             ("half-inside", 1.0000000000000002, [1e-9, 0], 0.5),
                                             ("same-axis", 0.5, [0, 0], 0)):
            b = generated("prism", sides=n, radius=radius, centre=centre, bottom=bottom, top=bottom + 1)
            cases.operations(f"found-prisms-{n}-{name}", a, b, ["found", "prism", "coplanar"],
                             f"prisms of {n} sides, nearly or exactly in contact all around ({name})")
    plate = box((0, 0, 0), (4, 4, 1))
    drills = {f"d{k}": generated("prism", sides=24, radius=0.5, centre=[1 + k % 2 * 2, 1 + k // 2 * 2], bottom=-1 + k % 2,
                                 top=2 - k // 2) for k in range(4)}
    cases.add("found-drilled-plate", {"plate": plate, **drills}, "plate - d0 - d1 - d2 - d3", ["found", "prism"],
              "drills through a plate: from over both faces, and flush with one or both of them",
              {"components": 1, "euler": 2 - 2 * 4})


def listed_twice(cases):
    parts = [box((2, 0, -1), (5, 3, 2)), box((5, 3, -1), (8, 6, 2))]
    cases.operations("found-edge-listed-twice", box((3, 0, 0), (6, 3, 3)), together(parts),
                     ["found", "self-touching", "coplanar"],
                     "two boxes list the edge in which they touch each for itself; it ends away from the other operand, "
                     "whose corner it meets: the boundary was open once")
    cubes = [box(p, tuple(x + 1 for x in p)).moved(0, 0, Fraction(-1, 3)) for p in ((1, 2, 1), (1, 3, 0), (2, 2, 0))]
    cases.operations("found-thirds-listed-twice", together(cubes), box((1.5, 2, 0), (2, 3, 1)),
                     ["found", "self-touching", "rational"],
                     "three cubes that list the edges in which they touch each for itself, at thirds: the boundary was "
                     "open once")


def planes_through_a_line(cases):
    corners = [((0, 2, 2), (0, 3, 1), (1, 2, 2), (3, 0, 0)), ((1, 2, 1), (2, 0, 1), (2, 0, 2), (2, 2, 0)),
               ((1, 0, 0), (2, 0, 0), (2, 1, 2), (2, 2, 1))]
    solids = {f"t{k}": tetrahedron(*c) for k, c in enumerate(corners)}
    cases.add("found-three-planes-one-line", solids, "t0 ^ t1 ^ t2", ["found", "n-ary", "xor"],
              "three faces cross in one line and are kept on both sides of it: the line must be an edge of all three")


def edge_on_a_face(cases):
    points = [(0, 2, 1), (1, 0, 0), (1, 0, 2), (1, 2, 0), (2, 0, 2), (2, 1, 1), (1, 1.5, 1), (1.5, 1.25, 1)]
    faces = [(0, 1, 2), (0, 2, 4), (0, 3, 1), (1, 3, 5), (1, 4, 2), (1, 5, 4), (5, 7, 4), (6, 0, 4), (0, 6, 3), (7, 5, 3),
             (6, 4, 3), (7, 3, 4)]
    hull = Solid([(0, 1, 1), (1, 2, 0), (2, 0, 1), (2, 0, 2), (2, 1, 1)],
                 [(0, 1, 2), (0, 2, 3), (0, 3, 4), (0, 4, 1), (1, 4, 2), (2, 4, 3)])
    cases.operations("found-edge-on-face", Solid(points, faces), hull, ["found", "self-touching", "non-manifold"],
                     "an edge of four faces lies on a face of the other operand, which was not divided there")
