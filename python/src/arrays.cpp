#include "arrays.h"

#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <strata/carry_attributes.h>
#include <strata/check.h>
#include <strata/surface.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "errors.h"
#include "numpy.h"
#include "text.h"

namespace strata::python {

namespace {

/// An array of three columns.
nb::object array_of_rows(nb::handle source, const char* role) {
  const nb::object array = array_from(source, role, "(n, 3)");
  const auto dimensions = nb::cast<std::size_t>(array.attr("ndim"));
  if (dimensions == 1 && size_of(array) == 0) return array.attr("reshape")(0, 3);
  if (dimensions != 2 || nb::cast<std::size_t>(array.attr("shape")[1]) != 3)
    throw_value_error(std::string(role) + ": expected an array of shape (n, 3), found shape " +
                      text_of(array.attr("shape")));
  return array;
}

/// The same array in another type, if that changes no value.
nb::object converted(const nb::object& array, const char* type, const char* role) {
  const nb::object copy = array.attr("astype")(type);
  if (!nb::cast<bool>(numpy().attr("array_equal")(copy.attr("astype")(array.attr("dtype")), array)))
    throw_value_error(std::string(role) + ": not all numbers of type " + text_of(array.attr("dtype")) +
                      " are doubles; an array of objects is taken exactly");
  return copy;
}

/// Objects that are numbers, exactly.
ExactMesh exact_points(const nb::object& array, const char* role) {
  ExactMesh mesh;
  for (const nb::handle row : array) {
    RationalPoint position;
    for (std::size_t i = 0; i < 3; ++i) position[i] = to_rational(nb::object(row[i]), role);
    for (const double x : mesh.mesh.vertices[add_vertex(mesh, std::move(position))])
      if (!std::isfinite(x)) throw_value_error(std::string(role) + ": a coordinate is beyond all doubles");
  }
  return mesh;
}

void look_at(ArrayMesh& mesh, const DoubleRows& rows) {
  mesh.view.vertices = {reinterpret_cast<const Vertex*>(rows.data()), rows.shape(0)};
}

void look_at(ArrayMesh& mesh, const IndexRows& rows) {
  mesh.view.triangles = {reinterpret_cast<const Triangle*>(rows.data()), rows.shape(0)};
}

/// Only arrays are looked at without NumPy between: other buffers may go while the object stays.
void set_vertices(ArrayMesh& mesh, nb::handle source, const char* role) {
  if (DoubleRows rows; is_array(source) && nb::try_cast(source, rows, false)) {
    mesh.vertices = nb::borrow(source);
    return look_at(mesh, rows);
  }
  nb::object array = array_of_rows(source, role);
  const std::string kind = kind_of(array);
  if (kind == "O") {
    mesh.owned = exact_points(array, role);
    mesh.view.vertices = mesh.owned.mesh.vertices;
    return;
  }
  if (kind == "f" && item_size(array) > sizeof(double))
    array = converted(array, "float64", role);
  else if (kind == "i" || kind == "u")
    array = converted(array, "float64", role);
  else if (kind != "f" && size_of(array) != 0)
    throw_type_error(std::string(role) + ": expected numbers, found type " + text_of(array.attr("dtype")));
  mesh.vertices = contiguous(array, "float64");
  look_at(mesh, nb::cast<DoubleRows>(mesh.vertices));
}

void set_triangles(ArrayMesh& mesh, nb::handle source) {
  if (IndexRows rows; is_array(source) && nb::try_cast(source, rows, false)) {
    mesh.triangles = nb::borrow(source);
    return look_at(mesh, rows);
  }
  const nb::object array = array_of_rows(source, "triangles");
  mesh.triangles = indices_of(array, "triangles");
  look_at(mesh, nb::cast<IndexRows>(mesh.triangles));
}

NewMesh mesh_of(ExactMeshView view, nb::object owner) {
  const auto mesh = std::make_shared<ArrayMesh>();
  mesh->view = view.mesh;
  mesh->owned.exact.assign(view.exact.begin(), view.exact.end());
  mesh->vertices = nb::cast(rows_of(view.mesh.vertices, owner));
  mesh->triangles = nb::cast(rows_of(view.mesh.triangles, owner));
  return mesh;
}

nb::dict dict_of(const RoundingReport& rounding) {
  nb::dict report;
  report["rounds"] = rounding.rounds;
  report["moved_vertices"] = rounding.moved_vertices;
  report["largest_movement"] = rounding.largest_movement;
  report["unit"] = rounding.unit;
  report["far_vertices"] = rounding.far_vertices;
  report["vanished_faces"] = rounding.vanished_faces;
  report["vanished_components"] = rounding.vanished_components;
  return report;
}

/// The attribute of an object, or an invalid object where it has none. What a property raises is thrown.
nb::object attribute(nb::handle object, const char* name) {
  try {
    return object.attr(name);
  } catch (nb::python_error& error) {
    if (!error.matches(PyExc_AttributeError) || nb::hasattr(object.type(), name)) throw;
    return {};
  }
}

}  // namespace

ExactMesh ArrayMesh::copy() const {
  return {{{view.vertices.begin(), view.vertices.end()}, {view.triangles.begin(), view.triangles.end()}}, owned.exact};
}

std::uint32_t add_vertex(ExactMesh& mesh, RationalPoint position) {
  const auto number = static_cast<std::uint32_t>(mesh.mesh.vertices.size());
  Vertex& nearest = mesh.mesh.vertices.emplace_back();
  bool is_double = true;
  for (std::size_t i = 0; i < 3; ++i) {
    nearest[i] = to_nearest_double(position[i]);
    is_double = is_double && std::isfinite(nearest[i]) && strata::to_rational(nearest[i]) == position[i];
  }
  if (!is_double) mesh.exact.push_back({number, std::move(position)});
  return number;
}

NewMesh mesh_of_arrays(nb::handle vertices, nb::handle triangles) {
  const auto mesh = std::make_shared<ArrayMesh>();
  set_vertices(*mesh, vertices, "vertices");
  set_triangles(*mesh, triangles);
  return mesh;
}

void set_attributes(ArrayMesh& mesh, AttributesHandle attributes) {
  if (attributes) check_attributes(*attributes, mesh.view.vertices.size(), mesh.view.triangles.size());
  mesh.attributes = std::move(attributes);
}

Solid with_attributes_of(const ArrayMesh& mesh, Solid solid, const Options& options) {
  if (!mesh.attributes) return solid;
  const AttributedMesh given{mesh.exact_view(), mesh.attributes.get()};
  return solid.with_attributes(carry_attributes({&given, 1}, solid.exact_mesh(), solid.sources(), options));
}

NewMesh mesh_of(ExactMesh exact) {
  const auto mesh = std::make_shared<ArrayMesh>();
  mesh->owned = std::move(exact);
  mesh->view = mesh->owned.mesh;
  return mesh;
}

NewMesh mesh_of(BooleanResult result) {
  const NewMesh mesh = mesh_of(ExactMesh{std::move(result.mesh), std::move(result.exact)});
  mesh->attributes = handle_of(std::move(result.attributes));
  mesh->sources = std::move(result.sources);
  mesh->has_sources = true;
  mesh->notes = to_python(std::span<const Defect>(result.notes));
  if (result.rounding) mesh->rounding = dict_of(*result.rounding);
  mesh->seconds = std::move(result.profile.seconds);
  return mesh;
}

MeshHandle copy_of(const MeshHandle& original) {
  const NewMesh copied = mesh_of(original->copy());
  copied->attributes = original->attributes;
  const ArrayMesh& mesh = *copied;
  const std::size_t count = mesh.view.vertices.size();
  const bool is_readable =
      std::ranges::all_of(mesh.view.triangles,
                          [&](const Triangle& t) { return t[0] < count && t[1] < count && t[2] < count; }) &&
      std::ranges::all_of(
          mesh.view.vertices,
          [](const Vertex& p) { return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]); }) &&
      std::ranges::all_of(mesh.owned.exact, [&](const ExactVertex& v) { return v.vertex < count; });
  if (!is_readable) throw InputError(diagnose(mesh.exact_view()));
  return copied;
}

MeshHandle MeshLike::value(const char* role) const {
  if (nb::isinstance<ArrayMesh>(object)) return nb::cast<MeshHandle>(object);
  if (nb::isinstance<Solid>(object)) {
    const auto& solid = nb::cast<const Solid&>(object);
    const NewMesh mesh = mesh_of(ExactMeshView(solid.exact_mesh()), object);
    mesh->attributes = attributes_of(solid);
    return mesh;
  }
  if (nb::isinstance<Surface>(object))
    return mesh_of(ExactMeshView(nb::cast<const Surface&>(object).exact_mesh()), object);
  if (nb::isinstance<nb::tuple>(object) && nb::len(object) == 2) return mesh_of_arrays(object[0], object[1]);
  if (const nb::object vertices = attribute(object, "vertices"); vertices.is_valid()) {
    // In this order: the triangles of trimesh are coordinates.
    for (const char* name : {"faces", "triangles"})
      if (const nb::object triangles = attribute(object, name); triangles.is_valid())
        return mesh_of_arrays(vertices, triangles);
  }
  throw_type_error(std::string(role) +
                   ": expected a Mesh, a Solid, a pair (vertices, triangles), or an object with vertices and faces, "
                   "found " +
                   text_of(nb::handle(reinterpret_cast<PyObject*>(Py_TYPE(object.ptr())))));
}

MeshHandle points_of(nb::handle points, const char* role) {
  if (attribute(points, "vertices").is_valid()) return MeshLike{nb::borrow(points)}.value(role);
  auto mesh = std::make_shared<ArrayMesh>();
  set_vertices(*mesh, points, role);
  return mesh;
}

DoubleRows rows_of(std::span<const Vertex> vertices, nb::handle owner) {
  return DoubleRows(reinterpret_cast<const double*>(vertices.data()), {vertices.size(), 3}, owner);
}

IndexRows rows_of(std::span<const Triangle> triangles, nb::handle owner) {
  return IndexRows(reinterpret_cast<const std::uint32_t*>(triangles.data()), {triangles.size(), 3}, owner);
}

IndexColumn operands_of(std::span<const Source> sources, nb::handle owner) {
  return IndexColumn(sources.empty() ? nullptr : &sources.front().operand, {sources.size()}, owner, {2});
}

IndexColumn faces_of(std::span<const Source> sources, nb::handle owner) {
  return IndexColumn(sources.empty() ? nullptr : &sources.front().face, {sources.size()}, owner, {2});
}

std::vector<Source> sources_of(nb::handle operands, nb::handle faces) {
  using Column = nb::ndarray<const std::uint32_t, nb::ndim<1>>;
  const auto operand = nb::cast<Column>(operands), face = nb::cast<Column>(faces);
  if (operand.shape(0) != face.shape(0)) throw_value_error("sources: expected as many operands as faces");
  std::vector<Source> sources(operand.shape(0));
  for (std::size_t i = 0; i < sources.size(); ++i)
    sources[i] = {operand.data()[static_cast<std::ptrdiff_t>(i) * operand.stride(0)],
                  face.data()[static_cast<std::ptrdiff_t>(i) * face.stride(0)]};
  return sources;
}

nb::object exact_rows(ExactMeshView mesh) {
  const nb::object rows = numpy().attr("empty")(nb::make_tuple(mesh.mesh.vertices.size(), 3), nb::arg("dtype") = "O");
  std::size_t next = 0;
  for (std::size_t v = 0; v < mesh.mesh.vertices.size(); ++v) {
    const bool is_exact = next < mesh.exact.size() && mesh.exact[next].vertex == v;
    const RationalPoint position =
        is_exact ? mesh.exact[next++].position
                 : RationalPoint{mesh.mesh.vertices[v][0], mesh.mesh.vertices[v][1], mesh.mesh.vertices[v][2]};
    for (std::size_t i = 0; i < 3; ++i) rows[nb::make_tuple(v, i)] = to_python(position[i]);
  }
  return rows;
}

nb::tuple exact_parts(std::span<const ExactVertex> exact) {
  std::vector<std::uint32_t> numbers;
  const nb::tuple shape = nb::make_tuple(exact.size(), 3);
  const nb::object above = numpy().attr("empty")(shape, nb::arg("dtype") = "O");
  const nb::object below = numpy().attr("empty")(shape, nb::arg("dtype") = "O");
  for (std::size_t k = 0; k < exact.size(); ++k) {
    numbers.push_back(exact[k].vertex);
    for (std::size_t i = 0; i < 3; ++i) {
      above[nb::make_tuple(k, i)] = to_python(numerator(exact[k].position[i]));
      below[nb::make_tuple(k, i)] = to_python(denominator(exact[k].position[i]));
    }
  }
  return nb::make_tuple(column_of(std::move(numbers)), above, below);
}

}  // namespace strata::python
