#include <nanobind/stl/optional.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>
#include <strata/carry_attributes.h>
#include <strata/surface.h>

#include "arrays.h"
#include "attributes.h"
#include "errors.h"
#include "module.h"
#include "names.h"
#include "run.h"

namespace strata::python {

namespace {

using namespace nb::literals;

/// A Surface, or what is a mesh.
Surface surface_of(nb::handle object, const char* role) {
  if (nb::isinstance<Surface>(object)) return nb::cast<Surface>(object);
  const MeshHandle mesh = MeshLike{nb::borrow(object)}.value(role);
  return run(Watch{}, [&](const Computation& c) {
    const Surface surface(mesh->copy(), c.monitor());
    if (!mesh->attributes) return surface;
    const AttributedMesh given{mesh->exact_view(), mesh->attributes.get()};
    return surface.with_attributes(carry_attributes({&given, 1}, surface.exact_mesh(), surface.sources()));
  });
}

std::vector<Surface> surfaces_of(const MeshList& objects) {
  std::vector<Surface> surfaces;
  for (const nb::handle object : objects.object) surfaces.push_back(surface_of(object, "surfaces"));
  return surfaces;
}

std::string describe(const Surface& surface) {
  return "Surface(" + std::to_string(surface.mesh().vertices.size()) + " vertices, " +
         std::to_string(surface.mesh().triangles.size()) + " triangles" + names_in(surface.attributes()) + ")";
}

/// What a surface carries, as long as it lives; null: nothing.
AttributesHandle attributes_of(const Surface& surface) {
  if (surface.attributes().empty()) return nullptr;
  const auto kept = std::make_shared<const Surface>(surface);
  return {kept, &kept->attributes()};
}

Surface clipped(const MeshLike& surface, const Solid& solid, const ClipName& keep, unsigned threads,
                ProgressOption progress, std::optional<double> timeout) {
  const Surface whole = surface_of(surface.object, "surface");
  const ClipTo part = keep.value();
  return run({threads, std::move(progress), timeout},
             [&](const Computation& c) { return clip(whole, solid, part, c.options()); });
}

std::vector<Solid> pieces_of(const Solid& solid, const MeshList& surfaces, const MaterialOption& cut_material,
                             unsigned threads, ProgressOption progress, std::optional<double> timeout) {
  const std::vector<Surface> dividing = surfaces_of(surfaces);
  return run({threads, std::move(progress), timeout, cut_material.value("cut_material")},
             [&](const Computation& c) { return split(solid, dividing, c.options()); });
}

std::vector<Surface> imprinted(const MeshList& surfaces, unsigned threads, ProgressOption progress,
                               std::optional<double> timeout) {
  const std::vector<Surface> all = surfaces_of(surfaces);
  return run({threads, std::move(progress), timeout}, [&](const Computation& c) { return imprint(all, c.options()); });
}

std::vector<Solid> cells(const MeshList& surfaces, unsigned threads, ProgressOption progress,
                         std::optional<double> timeout) {
  const std::vector<Surface> all = surfaces_of(surfaces);
  return run({threads, std::move(progress), timeout}, [&](const Computation& c) { return cells_of(all, c.options()); });
}

}  // namespace

void bind_surface(nb::module_& m) {
  nb::class_<Surface>(m, "Surface", nb::is_weak_referenceable(),
                      R"(A set of triangles in space: open or closed, oriented or not, crossing itself or not.

Vertices at one position become one; triangles without area are left out, which `notes` say. Immutable.

Parameters
----------
mesh : mesh, as for `boolean`

Raises
------
InputError
    For indices out of range and coordinates that are not finite.

Examples
--------
>>> sheet = Surface(([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]))
>>> sheet.area
0.5
)")
      .def(
          "__init__", [](Surface* self, const MeshLike& mesh) { new (self) Surface(surface_of(mesh.object, "mesh")); },
          "mesh"_a)
      .def_static(
          "of_plane",
          [](const PlanePair& plane, const Point& lower, const Point& upper) {
            return Surface::of_plane(plane.value(), {lower.doubles("lower"), upper.doubles("upper")});
          },
          "plane"_a, "lower"_a, "upper"_a,
          R"(A rectangle of a plane (normal, offset) that reaches beyond a box on all sides.

Examples
--------
>>> cut = Surface.of_plane(((0, 0, 1), 0.5), (0, 0, 0), (1, 1, 1))
>>> [piece.volume for piece in split(box((0, 0, 0), (1, 1, 1)), [cut])]
[Fraction(1, 2), Fraction(1, 2)]
)")
      .def_prop_ro(
          "vertices", [](const Surface& s) { return rows_of(s.mesh().vertices, nb::find(s)); },
          nb::sig("def vertices(self) -> numpy.typing.NDArray[numpy.float64]"),
          "Coordinates, shape (n, 3), rounded to the nearest doubles. Read-only.")
      .def_prop_ro(
          "triangles", [](const Surface& s) { return rows_of(s.mesh().triangles, nb::find(s)); },
          nb::sig("def triangles(self) -> numpy.typing.NDArray[numpy.uint32]"), "Numbers of vertices, shape (m, 3).")
      .def_prop_ro(
          "faces", [](const Surface& s) { return rows_of(s.mesh().triangles, nb::find(s)); },
          nb::sig("def faces(self) -> numpy.typing.NDArray[numpy.uint32]"),
          "The triangles, by the name that trimesh gives them.")
      .def_prop_ro(
          "exact_vertices", [](const Surface& s) { return exact_rows(s.exact_mesh()); },
          nb::sig("def exact_vertices(self) -> numpy.typing.NDArray[numpy.object_]"),
          "Exact coordinates as an array of objects, shape (n, 3), of fractions.Fraction.")
      .def_prop_ro(
          "source_operands", [](const Surface& s) { return operands_of(s.sources(), nb::find(s)); },
          nb::sig("def source_operands(self) -> numpy.typing.NDArray[numpy.uint32]"),
          "Per triangle the operand that it is part of.")
      .def_prop_ro(
          "source_faces", [](const Surface& s) { return faces_of(s.sources(), nb::find(s)); },
          nb::sig("def source_faces(self) -> numpy.typing.NDArray[numpy.uint32]"),
          "Per triangle the triangle of that operand that it is part of.")
      .def_prop_ro(
          "notes", [](const Surface& s) { return to_python(std::span(s.notes())); },
          nb::sig("def notes(self) -> tuple[Defect, ...]"), "What was left out when the surface was made.")
      .def_prop_ro(
          "attributes", [](const Surface& s) { return attributes_of(s); },
          nb::sig("def attributes(self) -> Attributes | None"),
          "What the surface carries, per vertex, corner and triangle; None where it is nothing.")
      .def(
          "with_attributes",
          [](const Surface& s, const AttributesOption& attributes) {
            const AttributesHandle carried = attributes.value();
            return s.with_attributes(carried ? *carried : Attributes());
          },
          "attributes"_a.none(),
          R"(The same surface with these attributes in place of its own; None for nothing.

Clips, imprints, cells and splits carry on what surfaces carry; a mesh with attributes makes a surface with them.

Raises
------
ValueError
    Where they do not fit the surface, with the name of the channel.

Examples
--------
>>> sheet = Surface(([[0, 0, 0.5], [4, 0, 0.5], [0, 4, 0.5]], [[0, 1, 2]]))
>>> map_of_it = sheet.with_attributes(Attributes(vertex={"texcoord": [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]}))
>>> float(clip(map_of_it, box((0, 0, 0), (1, 1, 1))).attributes["texcoord"].max())
0.25
)")
      .def_prop_ro("area", &Surface::area, "Of all triangles, to a few units in the last place.")
      .def("__bool__", [](const Surface& s) { return !s.is_empty(); })
      .def(
          "_repr_html_",
          [](nb::object thing) { return nb::module_::import_("strata_csg._notebook").attr("html_of")(thing); },
          nb::sig("def _repr_html_(self) -> str"), "A viewer, for notebooks.")
      .def("__repr__", describe);

  m.def("clip", clipped, "surface"_a, "solid"_a, nb::kw_only(), "keep"_a = nb::str("inside"), STRATA_WATCH_ARGUMENTS,
        R"(The part of a surface inside, outside or on a solid. Exact.

Parameters
----------
surface : Surface or mesh
solid : Solid
keep : {"inside", "outside", "on"}
threads, progress, timeout
    As for Solid.

Examples
--------
>>> sheet = Surface(([[-9, -9, .5], [9, -9, .5], [0, 9, .5]], [[0, 1, 2]]))
>>> clip(sheet, box((0, 0, 0), (1, 1, 1))).area
1.0
)");
  m.def("split", pieces_of, "solid"_a, "surfaces"_a, nb::kw_only(), "cut_material"_a = nb::none(),
        STRATA_WATCH_ARGUMENTS,
        R"(The pieces into which surfaces divide a solid. Exact: they unite to the solid, and volumes add up.

Parameters
----------
solid : Solid
surfaces : iterable of Surface or mesh
    Those that end inside the solid do not divide it there.
cut_material : Material, optional
    What the faces are made of that the surfaces cut.
threads, progress, timeout
    As for Solid.

Examples
--------
>>> cut = Surface.of_plane(((1, 1, 0), 1), (0, 0, 0), (1, 1, 1))
>>> sum(piece.volume for piece in split(box((0, 0, 0), (1, 1, 1)), [cut]))
Fraction(1, 1)
)");
  m.def("imprint", imprinted, "surfaces"_a, nb::kw_only(), STRATA_WATCH_ARGUMENTS,
        R"(Each surface with the traces of the others as edges: nothing is added or removed. Exact.

Examples
--------
>>> a, b = imprint([box((0, 0, 0), (1, 1, 1)), box((1, .25, .25), (2, .75, .75))])
>>> a.area
6.0
)");
  m.def("cells_of", cells, "surfaces"_a, nb::kw_only(), STRATA_WATCH_ARGUMENTS,
        R"(Every volume that surfaces enclose together, closed or not, as a solid. Exact.

Examples
--------
>>> parts = cells_of([box((0, 0, 0), (2, 1, 1)), box((1, 0, 0), (3, 1, 1))])
>>> [part.volume for part in parts]
[Fraction(1, 1), Fraction(1, 1), Fraction(1, 1)]
)");
}

}  // namespace strata::python
