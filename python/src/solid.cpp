#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>
#include <strata/carry_attributes.h>
#include <strata/expression.h>
#include <strata/measure.h>
#include <strata/primitives.h>
#include <strata/rounding.h>
#include <strata/solid.h>

#include <limits>

#include "arrays.h"
#include "errors.h"
#include "module.h"
#include "names.h"
#include "run.h"

namespace strata::python {

namespace {

using namespace nb::literals;

Solid solid_of(const MeshLike& argument, const InputName& input, std::optional<std::size_t> most_hole_edges,
               unsigned threads, ProgressOption progress, std::optional<double> timeout) {
  const MeshHandle mesh = argument.value();
  const InputClass expected = input.value();
  return run({threads, std::move(progress), timeout}, [&](const Computation& computation) {
    Options options = computation.options();
    options.input = expected;
    options.most_hole_edges = most_hole_edges.value_or(std::numeric_limits<std::size_t>::max());
    return with_attributes_of(*mesh, Solid(mesh->copy(), options), options);
  });
}

std::string describe(const Solid& solid) {
  if (solid.is_empty()) return "Solid(empty)";
  std::string text = "Solid(" + std::to_string(solid.mesh().vertices.size()) + " vertices, " +
                     std::to_string(solid.mesh().triangles.size()) + " triangles";
  const std::size_t rationals = solid.exact_mesh().exact.size();
  if (rationals != 0) text += ", " + std::to_string(rationals) + " vertices rational";
  return text + names_in(solid.attributes()) + ")";
}

Solid combined(Operation operation, const Solid& a, const Solid& b) {
  return run({}, [&](const Computation& computation) {
    return combine_solids(operation, {a, b}, computation.options());
  });
}

nb::object bounds_of(const Solid& solid) {
  const BoundingBox box = solid.bounding_box();
  auto* const kept = new std::array<Vertex, 2>{box.lower, box.upper};
  const nb::capsule owner(kept, [](void* p) noexcept { delete static_cast<std::array<Vertex, 2>*>(p); });
  return nb::cast(nb::ndarray<nb::numpy, double, nb::shape<2, 3>>(kept->data(), {2, 3}, owner));
}

MeshHandle rounded(const Solid& solid, const Grid& to, unsigned threads, ProgressOption progress,
                   std::optional<double> timeout) {
  const CoordinateGrid grid = to.value().value_or(CoordinateGrid{});
  return mesh_of(run({threads, std::move(progress), timeout}, [&](const Computation& computation) {
    RoundedMesh rounded = round_to_solid(solid.exact_mesh(), grid, computation.options());
    BooleanResult result;
    const AttributedMesh exact{solid.exact_mesh(), &solid.attributes()};
    if (!solid.attributes().empty()) result.attributes = carry_attributes(exact, rounded, grid, computation.options());
    result.mesh = std::move(rounded.mesh);
    for (const std::uint32_t face : rounded.source_face) result.sources.push_back(solid.sources()[face]);
    result.rounding = rounded.report;
    return result;
  }));
}

Solid trusted(const MeshLike& argument) {
  const MeshHandle mesh = copy_of(argument.value());
  const Solid solid = Solid::trusted(mesh->owned);
  return mesh->attributes ? solid.with_attributes(*mesh->attributes) : solid;
}

Solid with_attributes(const Solid& solid, const AttributesOption& attributes) {
  const AttributesHandle carried = attributes.value();
  return solid.with_attributes(carried ? *carried : Attributes());
}

bool are_equal(const Solid& a, const Solid& b) {
  if (&a.mesh() == &b.mesh()) return true;  // of one boundary
  return run(Watch{}, [&](const Computation& c) { return a.canonical(c.monitor()) == b.canonical(c.monitor()); });
}

std::int64_t hash_of(const Solid& solid) {
  const auto hash = [&](const Computation& c) { return solid.canonical(c.monitor()).hash(c.monitor()); };
  return static_cast<std::int64_t>(run(Watch{}, hash) >> 2);
}

Solid moved(const Solid& solid, const Transform& map, Placement placement) {
  return run(Watch{}, [&](const Computation& c) { return solid.transformed(map, placement, c.monitor()); });
}

void bind_measures(nb::class_<Solid>& type) {
  type.def_prop_ro(
          "vertices", [](const Solid& s) { return rows_of(s.mesh().vertices, nb::find(s)); },
          nb::sig("def vertices(self) -> numpy.typing.NDArray[numpy.float64]"),
          "Coordinates, shape (n, 3), rounded to the nearest doubles. Read-only; `exact_vertices` are the solid's own.")
      .def_prop_ro(
          "triangles", [](const Solid& s) { return rows_of(s.mesh().triangles, nb::find(s)); },
          nb::sig("def triangles(self) -> numpy.typing.NDArray[numpy.uint32]"),
          "Numbers of vertices, shape (m, 3), counter-clockwise seen from outside. Read-only.")
      .def_prop_ro(
          "faces", [](const Solid& s) { return rows_of(s.mesh().triangles, nb::find(s)); },
          nb::sig("def faces(self) -> numpy.typing.NDArray[numpy.uint32]"),
          "The triangles, by the name that trimesh gives them.")
      .def_prop_ro(
          "exact_vertices", [](const Solid& s) { return exact_rows(s.exact_mesh()); },
          nb::sig("def exact_vertices(self) -> numpy.typing.NDArray[numpy.object_]"),
          "Exact coordinates as an array of objects, shape (n, 3), of fractions.Fraction. O(n).")
      .def_prop_ro(
          "exact_parts", [](const Solid& s) { return exact_parts(s.exact_mesh().exact); },
          nb::sig(
              "def exact_parts(self) -> tuple[numpy.typing.NDArray[numpy.uint32], numpy.typing.NDArray[numpy.object_], "
              "numpy.typing.NDArray[numpy.object_]]"),
          "Of the vertices that are not three doubles: their numbers (k,), numerators and denominators (k, 3), ints.")
      .def_prop_ro(
          "attributes", [](const Solid& s) { return attributes_of(s); },
          nb::sig("def attributes(self) -> Attributes | None"),
          "What the boundary carries, per vertex, corner and triangle; None where it is nothing.")
      .def_prop_ro(
          "source_operands", [](const Solid& s) { return operands_of(s.sources(), nb::find(s)); },
          nb::sig("def source_operands(self) -> numpy.typing.NDArray[numpy.uint32]"),
          "Per triangle the operand that it is part of, in the operation that made the solid.")
      .def_prop_ro(
          "source_faces", [](const Solid& s) { return faces_of(s.sources(), nb::find(s)); },
          nb::sig("def source_faces(self) -> numpy.typing.NDArray[numpy.uint32]"),
          "Per triangle the triangle of that operand that it is part of.")
      .def_prop_ro(
          "notes", [](const Solid& s) { return to_python(std::span(s.notes())); },
          nb::sig("def notes(self) -> tuple[Defect, ...]"),
          "What was resolved when the solid was made; nothing, if it comes from a pickle.")
      .def_prop_ro(
          "volume", [](const Solid& s) { return run([&] { return s.volume(); }); }, "The exact volume. O(n).")
      .def_prop_ro(
          "nearest_volume", [](const Solid& s) { return run([&] { return nearest_volume(s.exact_mesh()); }); },
          "The double nearest to the volume: much faster where the solid has many rational vertices. O(n).")
      .def_prop_ro(
          "area", [](const Solid& s) { return run([&] { return s.area(); }); },
          "The area of the boundary, to a few units in the last place. O(n).")
      .def_prop_ro("bounds", bounds_of, nb::sig("def bounds(self) -> numpy.typing.NDArray[numpy.float64]"),
                   "Least and greatest coordinates, shape (2, 3); infinite for the empty solid. O(n).")
      .def_prop_ro("is_empty", &Solid::is_empty, "Whether it has no points.")
      .def(
          "canonical_text",
          [](const Solid& s) {
            return run(Watch{}, [&](const Computation& c) { return s.canonical(c.monitor()).text(); });
          },
          R"(Facets, edges and exact vertices as a text that does not depend on how the boundary is triangulated.

Equal for equal point sets. O(n log n).

Examples
--------
>>> box((0, 0, 0), (1, 1, 1)).canonical_text() == (box((0, 0, 0), (1, 1, .5)) | box((0, 0, .5), (1, 1, 1))).canonical_text()
True
)");
}

void bind_maps(nb::class_<Solid>& type) {
  type.def(
          "transformed",
          [](const Solid& s, const Matrix& matrix, bool rounded_) {
            const Transform map = matrix.value();
            return moved(s, map, rounded_ ? Placement::rounded : Placement::exact);
          },
          "matrix"_a, nb::kw_only(), "rounded"_a = false,
          R"(The image under an affine map.

Parameters
----------
matrix : array_like, shape (3, 4) or (4, 4)
    Numbers of any kind, taken exactly; the last of four rows is a multiple of (0, 0, 0, 1).
rounded : bool
    Round vertices to doubles. A thin part may come to cross itself then, which `check` finds.

Raises
------
ValueError
    For a matrix of another shape, or of determinant 0.
OverflowError
    Where a coordinate is beyond all doubles.

Examples
--------
>>> from fractions import Fraction
>>> third = Fraction(1, 3)
>>> box((0, 0, 0), (1, 1, 1)).transformed([[third, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]).volume
Fraction(1, 3)
)")
      .def(
          "translated",
          [](const Solid& s, const Point& by) {
            const RationalPoint vector = by.value("by");
            return moved(s, Transform::translation(vector), Placement::exact);
          },
          "by"_a, R"(Moved by a vector, exactly.

Examples
--------
>>> box((0, 0, 0), (1, 1, 1)).translated((10, 0, 0)).bounds[1].tolist()
[11.0, 1.0, 1.0]
)")
      .def(
          "scaled",
          [](const Solid& s, nb::object factors) {
            if (nb::hasattr(factors, "__len__")) {
              return moved(s, Transform::scaling(Point{factors}.value("factors")), Placement::exact);
            }
            const Rational by = to_rational(factors, "factors");
            return moved(s, Transform::scaling({by, by, by}), Placement::exact);
          },
          "factors"_a, nb::sig("def scaled(self, factors: Number | PointLike) -> Solid"),
          R"(Scaled about the origin, by one factor or a factor per axis, exactly. Negative ones mirror.

Examples
--------
>>> box((0, 0, 0), (1, 1, 1)).scaled(2).volume
Fraction(8, 1)
)")
      .def(
          "mirrored",
          [](const Solid& s, const Point& normal) {
            const RationalPoint n = normal.value("normal");
            return moved(s, Transform::mirror(n), Placement::exact);
          },
          "normal"_a, R"(Mirrored in the plane through the origin with this normal, exactly.

Examples
--------
>>> box((0, 0, 0), (1, 1, 1)).mirrored((1, 0, 0)).bounds[0].tolist()
[-1.0, 0.0, 0.0]
)")
      .def(
          "rotated",
          [](const Solid& s, const Point& axis, double degrees, bool exact) {
            const auto about = axis.doubles("axis");
            const auto map = Transform::rotation(Quaternion::of_angle(about, degrees));
            return moved(s, map, exact ? Placement::exact : Placement::rounded);
          },
          "axis"_a, "degrees"_a, nb::kw_only(), "exact"_a = false,
          R"(Rotated about an axis through the origin, counter-clockwise as seen from the axis's end.

Quarter and half turns about coordinate axes are exact. Otherwise vertices are rounded to doubles, unless `exact`:
then the solid stays congruent, with rationals of some 200 bits.

Examples
--------
>>> box((0, 0, 0), (1, 2, 3)).rotated((0, 0, 1), 90).bounds[0].tolist()
[-2.0, 0.0, 0.0]
>>> box((0, 0, 0), (1, 1, 1)).rotated((1, 1, 1), 20, exact=True).volume
Fraction(1, 1)
)");
}

void bind_parts(nb::class_<Solid>& type) {
  type.def(
          "split",
          [](const Solid& s, const PlanePair& plane, const MaterialOption& cut_material, unsigned threads,
             ProgressOption progress, std::optional<double> timeout) {
            const Plane p = plane.value();
            const Solid::Halves halves =
                run({threads, std::move(progress), timeout, cut_material.value("cut_material")},
                    [&](const Computation& c) { return s.split(p, c.options()); });
            return std::pair(halves.behind, halves.in_front);
          },
          "plane"_a, nb::kw_only(), "cut_material"_a = nb::none(), STRATA_WATCH_ARGUMENTS,
          R"(What is behind a plane, and what is in front of it. Exact: volumes add up.

Parameters
----------
plane : (normal, offset)
    The points p with normal . p = offset; three numbers and one.
cut_material : Material, optional
    What the faces in the plane are made of; see `union`.
threads, progress, timeout
    As for Solid.

Returns
-------
behind, in_front : Solid

Examples
--------
>>> below, above = box((0, 0, 0), (1, 1, 1)).split(((0, 0, 1), 0.25))
>>> below.volume, above.volume
(Fraction(1, 4), Fraction(3, 4))
)")
      .def(
          "components", [](const Solid& s) { return run([&] { return s.components(); }); },
          R"(The connected components of the interior, each with its cavities. Volumes add up.

Examples
--------
>>> two = box((0, 0, 0), (1, 1, 1)) | box((2, 0, 0), (3, 1, 1))
>>> [part.volume for part in two.components()]
[Fraction(1, 1), Fraction(1, 1)]
)")
      .def(
          "without_cavities",
          [](const Solid& s, unsigned threads, ProgressOption progress, std::optional<double> timeout) {
            return run({threads, std::move(progress), timeout},
                       [&](const Computation& c) { return s.without_cavities(c.options()); });
          },
          nb::kw_only(), STRATA_WATCH_ARGUMENTS, R"(The solid and its cavities: all that it closes off from infinity.

Examples
--------
>>> shell = box((0, 0, 0), (3, 3, 3)) - box((1, 1, 1), (2, 2, 2))
>>> shell.without_cavities().volume
Fraction(27, 1)
)")
      .def(
          "separated", [](const Solid& s) { return run([&] { return s.separated(); }); },
          R"(The same point set with edges and vertices of its own for every sheet: a 2-manifold mesh.

Examples
--------
>>> touching = box((0, 0, 0), (1, 1, 1)) | box((1, 1, 0), (2, 2, 1))
>>> len(touching.vertices), len(touching.separated().vertices)
(14, 16)
)")
      .def("rounded", rounded, "to"_a = nb::str("float64"), nb::kw_only(), STRATA_WATCH_ARGUMENTS,
           R"(The boundary with coordinates of few digits, a solid still: closed, and nothing crosses.

Parameters
----------
to : "float64", "float32" or a number
    A number is a step: coordinates are the doubles nearest to its multiples.

Returns
-------
Mesh
    Its `rounding` tells what moved, and how far.

Examples
--------
>>> from fractions import Fraction
>>> mesh = box((0, 0, 0), (1, 1, 1)).scaled(Fraction(1, 3)).rounded("float32")
>>> float(mesh.vertices.max())
0.3333333432674408
)");
}

}  // namespace

void bind_solid(nb::module_& m) {
  nb::class_<Solid> type(m, "Solid", nb::is_weak_referenceable(),
                         R"(A bounded solid, given by its boundary: a closed triangle mesh. An immutable value.

Operations are exact: vertices are doubles or, where operations made them, fractions. `|` is union, `&` intersection,
`-` difference, `^` symmetric difference; `~` is the complement, an Expression. Solids are equal when they are the same
set of points, however they are triangulated and whatever they carry, and may be keys of dictionaries.

What meshes carry, such as colours and materials, goes through all operations: `attributes`. Of coincident faces the
first operand speaks; faces that a cut makes belong to the operand that cut, or are of a material of their own.

Parameters
----------
mesh : Mesh, pair of arrays, or an object with `vertices` and `faces`, as of trimesh; without: the empty solid
    Attributes of a Mesh are carried; its unit is not.
input : {"automatic", "solid", "overlapping", "repair", "soup"}
    What is expected of the mesh. "automatic": closed; what crosses itself is resolved, which `notes` say. "solid": the
    caller's promise that nothing crosses itself. "overlapping": inside is where the winding number is positive.
    "repair": any triangles; doubled faces and orientation are mended. "soup": any triangles; holes are filled.
most_hole_edges : int, optional
    For "soup": holes of more edges are refused.
threads : int
    0: all cores. Results do not depend on it.
progress : callable, True or None
    Called with the fraction done; True shows a bar where tqdm is installed.
timeout : float, optional
    Seconds, after which TimeoutError is raised.

Raises
------
InputError
    The mesh is not what was expected; its `defects` say what and where.

Examples
--------
>>> corner = Solid(([[0, 0, 0], [4, 0, 0], [0, 4, 0], [0, 0, 4]], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]))
>>> (corner - corner.translated((1, 0, 0))).volume
Fraction(37, 6)
)");
  type.def(nb::init<>())
      .def(
          "__init__",
          [](Solid* self, const MeshLike& mesh, const InputName& input, std::optional<std::size_t> most_hole_edges,
             unsigned threads, ProgressOption progress, std::optional<double> timeout) {
            new (self) Solid(solid_of(mesh, input, most_hole_edges, threads, std::move(progress), timeout));
          },
          "mesh"_a, nb::kw_only(), "input"_a = nb::str("automatic"), "most_hole_edges"_a = nb::none(),
          STRATA_WATCH_ARGUMENTS)
      .def_static("trusted", trusted, "mesh"_a,
                  R"(Of a mesh that is known to bound a solid, such as a result: nothing is checked.

Results are unspecified where it does not bound one.

Examples
--------
>>> a, b = box((0, 0, 0), (2, 2, 2)), box((1, 1, 1), (3, 3, 3))
>>> Solid.trusted(boolean("union", [a, b], exact=True)) == a | b
True
)")
      .def(
          "__or__", [](const Solid& a, const Solid& b) { return combined(Operation::union_, a, b); }, nb::is_operator())
      .def(
          "__and__", [](const Solid& a, const Solid& b) { return combined(Operation::intersection, a, b); },
          nb::is_operator())
      .def(
          "__sub__", [](const Solid& a, const Solid& b) { return combined(Operation::difference, a, b); },
          nb::is_operator())
      .def(
          "__xor__", [](const Solid& a, const Solid& b) { return combined(Operation::symmetric_difference, a, b); },
          nb::is_operator())
      .def("__eq__", are_equal, nb::is_operator(), nb::sig("def __eq__(self, other: object, /) -> bool"))
      .def("__hash__", hash_of)
      .def("__bool__", [](const Solid& s) { return !s.is_empty(); })
      .def("__repr__", describe)
      .def_static(
          "from_trimesh",
          [](nb::object mesh, nb::kwargs options) {
            return nb::module_::import_("strata_csg.trimesh").attr("from_trimesh")(mesh, **options);
          },
          "mesh"_a, "options"_a, nb::sig("def from_trimesh(mesh: object, **options: object) -> Solid"),
          "The solid that a trimesh.Trimesh bounds; options are those of Solid.")
      .def(
          "to_trimesh",
          [](nb::object solid) { return nb::module_::import_("strata_csg.trimesh").attr("to_trimesh")(solid); },
          nb::sig("def to_trimesh(self) -> typing.Any"), "The boundary as a trimesh.Trimesh, in nearest doubles.")
      .def(
          "_repr_html_",
          [](nb::object solid) { return nb::module_::import_("strata_csg._notebook").attr("html_of")(solid); },
          nb::sig("def _repr_html_(self) -> str"), "The solid in a viewer, for notebooks.");
  type.def("with_attributes", with_attributes, "attributes"_a.none(),
           R"(The same solid with these attributes in place of its own; None for nothing.

Raises
------
ValueError
    Where they do not fit the boundary, with the name of the channel.

Examples
--------
>>> block = box((0, 0, 0), (2, 2, 2)).with_attributes(Attributes(face={"side": range(12)}))
>>> part = block - box((1, 1, 1), (3, 3, 3))
>>> int(part.attributes["side"].max())
11
)");
  bind_measures(type);
  bind_maps(type);
  bind_parts(type);
}

}  // namespace strata::python
