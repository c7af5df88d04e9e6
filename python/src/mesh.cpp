#include <nanobind/stl/optional.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <algorithm>

#include "arrays.h"
#include "module.h"
#include "names.h"

namespace strata::python {

namespace {

using namespace nb::literals;

nb::object vertices_of(const ArrayMesh& mesh) {
  if (mesh.vertices.is_valid()) return mesh.vertices;
  return nb::cast(rows_of(mesh.view.vertices, nb::find(mesh)));
}

nb::object triangles_of(const ArrayMesh& mesh) {
  if (mesh.triangles.is_valid()) return mesh.triangles;
  return nb::cast(rows_of(mesh.view.triangles, nb::find(mesh)));
}

std::optional<IndexColumn> source_operands(const ArrayMesh& mesh) {
  if (!mesh.has_sources) return std::nullopt;
  return operands_of(mesh.sources, nb::find(mesh));
}

std::optional<IndexColumn> source_faces(const ArrayMesh& mesh) {
  if (!mesh.has_sources) return std::nullopt;
  return faces_of(mesh.sources, nb::find(mesh));
}

nb::object rounding_of(const ArrayMesh& mesh) {
  return mesh.rounding.is_none() ? mesh.rounding : mesh.rounding.attr("copy")();
}

std::string describe(const ArrayMesh& mesh) {
  std::string text = "Mesh(" + std::to_string(mesh.view.vertices.size()) + " vertices, " +
                     std::to_string(mesh.view.triangles.size()) + " triangles";
  if (!mesh.owned.exact.empty()) text += ", " + std::to_string(mesh.owned.exact.size()) + " vertices rational";
  if (mesh.attributes) text += names_in(*mesh.attributes);
  return text + ")";
}

bool carry_the_same(const AttributesHandle& a, const AttributesHandle& b) { return a == b || (a && b && *a == *b); }

bool are_equal(const ArrayMesh& a, const ArrayMesh& b) {
  return std::ranges::equal(a.view.vertices, b.view.vertices) &&
         std::ranges::equal(a.view.triangles, b.view.triangles) &&
         std::ranges::equal(a.owned.exact, b.owned.exact,
                            [](const ExactVertex& p, const ExactVertex& q) {
                              return p.vertex == q.vertex && p.position == q.position;
                            }) &&
         carry_the_same(a.attributes, b.attributes) && a.unit == b.unit;
}

nb::dict seconds_of(const ArrayMesh& mesh) {
  nb::dict seconds;
  for (const auto& [stage, time] : mesh.seconds) seconds[stage.c_str()] = time;
  return seconds;
}

MeshHandle made(const ArrayLike& vertices, const ArrayLike& triangles, const AttributesOption& attributes,
                const UnitName& unit) {
  const NewMesh mesh = mesh_of_arrays(vertices.object, triangles.object);
  set_attributes(*mesh, attributes.value());
  mesh->unit = unit.value();
  return mesh;
}

nb::tuple reduce(const ArrayMesh& mesh) {
  nb::dict rest;
  rest["attributes"] = mesh.attributes;
  rest["unit"] = name_of(mesh.unit);
  rest["source_operands"] = source_operands(mesh);
  rest["source_faces"] = source_faces(mesh);
  rest["notes"] = mesh.notes;
  rest["file_notes"] = mesh.file_notes;
  rest["rounding"] = mesh.rounding;
  rest["seconds"] = seconds_of(mesh);
  const nb::object vertices = mesh.owned.exact.empty() ? vertices_of(mesh) : exact_rows(mesh.exact_view());
  return nb::make_tuple(nb::module_::import_("strata_csg._pickle").attr("mesh"),
                        nb::make_tuple(vertices, triangles_of(mesh), rest));
}

MeshHandle restored(nb::object vertices, nb::object triangles, const nb::dict& rest) {
  const NewMesh mesh = mesh_of_arrays(vertices, triangles);
  set_attributes(*mesh, AttributesOption{rest["attributes"]}.value());
  mesh->unit = UnitName{rest["unit"]}.value();
  const nb::object operands = rest["source_operands"];
  mesh->has_sources = !operands.is_none();
  if (mesh->has_sources) mesh->sources = sources_of(operands, nb::object(rest["source_faces"]));
  mesh->notes = rest["notes"];
  mesh->file_notes = rest["file_notes"];
  mesh->rounding = rest["rounding"];
  for (const auto& [stage, time] : nb::cast<nb::dict>(rest["seconds"]))
    mesh->seconds.emplace_back(nb::cast<std::string>(stage), nb::cast<double>(time));
  return mesh;
}

}  // namespace

void bind_mesh(nb::module_& m) {
  nb::class_<ArrayMesh>(m, "Mesh", nb::is_weak_referenceable(),
                        R"(A triangle mesh: arrays of vertices and of triangles. No invariant, nothing checked.

Parameters
----------
vertices : array_like, shape (n, 3)
    Coordinates in model units, taken exactly. C-contiguous float64 is looked at, not copied. An array of objects
    (int, Fraction, Decimal) is taken exactly, too.
triangles : array_like of integers, shape (m, 3)
    Numbers of vertices, counter-clockwise seen from outside. C-contiguous uint32 is looked at, not copied.
attributes : Attributes, optional
    What the mesh carries: colours, texture coordinates, materials and so on.
unit : str, optional
    Of coordinates: "micron", "millimeter", "centimeter", "inch", "foot", "meter", or the short "um", "mm", "cm", "in",
    "ft", "m". Nothing is converted.

Raises
------
TypeError, ValueError
    For arrays of other types and shapes, for negative indices, and where attributes have another number of values.

Notes
-----
Meshes are equal where vertices, triangles, attributes and units are. Results of `boolean` are meshes, too, with the source of every triangle. Meshes are immutable, but arrays that are
looked at are the caller's: nothing may write to them while a computation uses them.

Examples
--------
>>> mesh = Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
>>> mesh
Mesh(4 vertices, 4 triangles)
>>> Solid(mesh).volume
Fraction(1, 6)
)")
      .def(nb::new_(&made), "vertices"_a, "triangles"_a, nb::kw_only(), "attributes"_a = nb::none(),
           "unit"_a = nb::none())
      .def_prop_ro("vertices", vertices_of, nb::sig("def vertices(self) -> numpy.typing.NDArray[numpy.float64]"),
                   "Coordinates, shape (n, 3), rounded to the nearest doubles where they are not doubles.")
      .def_prop_ro("triangles", triangles_of, nb::sig("def triangles(self) -> numpy.typing.NDArray[numpy.uint32]"),
                   "Numbers of vertices, shape (m, 3).")
      .def_prop_ro("faces", triangles_of, nb::sig("def faces(self) -> numpy.typing.NDArray[numpy.uint32]"),
                   "The triangles, by the name that trimesh gives them.")
      .def_prop_ro(
          "exact_vertices", [](const ArrayMesh& mesh) { return exact_rows(mesh.exact_view()); },
          nb::sig("def exact_vertices(self) -> numpy.typing.NDArray[numpy.object_]"),
          "Exact coordinates as an array of objects, shape (n, 3), of fractions.Fraction. O(n).")
      .def_prop_ro(
          "exact_parts", [](const ArrayMesh& mesh) { return exact_parts(mesh.owned.exact); },
          nb::sig(
              "def exact_parts(self) -> tuple[numpy.typing.NDArray[numpy.uint32], numpy.typing.NDArray[numpy.object_], "
              "numpy.typing.NDArray[numpy.object_]]"),
          "Of the vertices that are not three doubles: their numbers (k,), numerators and denominators (k, 3), ints.")
      .def_prop_ro(
          "attributes", [](const ArrayMesh& mesh) { return mesh.attributes; },
          nb::sig("def attributes(self) -> Attributes | None"), "What the mesh carries; None where it is nothing.")
      .def_prop_ro(
          "unit", [](const ArrayMesh& mesh) { return name_of(mesh.unit); }, nb::sig("def unit(self) -> str | None"),
          "Of coordinates, where somebody said one.")
      .def_prop_ro("source_operands", source_operands,
                   nb::sig("def source_operands(self) -> numpy.typing.NDArray[numpy.uint32] | None"),
                   "Per triangle of a result, the operand that it is part of, from 0. None for other meshes.")
      .def_prop_ro("source_faces", source_faces,
                   nb::sig("def source_faces(self) -> numpy.typing.NDArray[numpy.uint32] | None"),
                   "Per triangle of a result, the triangle of that operand that it is part of. None for other meshes.")
      .def_prop_ro(
          "notes", [](const ArrayMesh& mesh) { return mesh.notes; }, nb::sig("def notes(self) -> tuple[Defect, ...]"),
          "Of a result: what was resolved in operands on the way in.")
      .def_prop_ro(
          "file_notes", [](const ArrayMesh& mesh) { return mesh.file_notes; },
          nb::sig("def file_notes(self) -> tuple[str, ...]"),
          "Of a mesh that was read: what was left out or decided, a sentence each.")
      .def_prop_ro("rounding", rounding_of, nb::sig("def rounding(self) -> dict[str, int | float] | None"),
                   "Of a rounded result: rounds, moved_vertices, largest_movement, unit, far_vertices, vanished_faces, "
                   "vanished_components.")
      .def_prop_ro("seconds", seconds_of, nb::sig("def seconds(self) -> dict[str, float]"),
                   "Of a result: the time that each stage took.")
      .def("__repr__", describe)
      .def(
          "_repr_html_",
          [](nb::object thing) { return nb::module_::import_("strata_csg._notebook").attr("html_of")(thing); },
          nb::sig("def _repr_html_(self) -> str"), "A viewer, for notebooks.")
      .def("__eq__", are_equal, nb::is_operator(), nb::sig("def __eq__(self, other: object, /) -> bool"))
      .def("__hash__", [](const ArrayMesh& mesh) { return mesh.view.triangles.size(); })
      .def("__reduce__", reduce, nb::sig("def __reduce__(self) -> tuple[typing.Any, ...]"));
  m.def("_mesh_of", restored, "vertices"_a, "triangles"_a, "rest"_a,
        nb::sig("def _mesh_of(vertices: object, triangles: object, rest: dict[str, typing.Any]) -> Mesh"),
        "What pickle calls for a Mesh.");
}

}  // namespace strata::python
