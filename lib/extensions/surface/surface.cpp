#include "strata/surface.h"

#include <array>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/csg/plane_rectangle.h"
#include "core/mesh/defect_list.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/equal_vertices.h"
#include "core/mesh/prepare_steps.h"
#include "core/mesh/zero_area.h"
#include "extensions/surface/surface_data.h"
#include "strata/carry_attributes.h"
#include "strata/measure.h"

namespace strata {
namespace {

/// The vertices that triangles use, under new numbers in the old order.
ExactMesh without_unused_vertices(ExactMeshView mesh, const std::vector<Triangle>& triangles) {
  constexpr std::uint32_t unused = 0xffffffffu;
  std::vector<std::uint32_t> number(mesh.mesh.vertices.size(), unused);
  for (const Triangle& t : triangles)
    for (const std::uint32_t v : t) number[v] = 0;
  ExactMesh result;
  auto exact = mesh.exact.begin();
  for (std::uint32_t v = 0; v < number.size(); ++v) {
    const bool is_exact = exact != mesh.exact.end() && exact->vertex == v;
    if (number[v] != unused) {
      number[v] = static_cast<std::uint32_t>(result.mesh.vertices.size());
      Vertex p = mesh.mesh.vertices[v];
      for (double& x : p) x += 0.0;  // -0 becomes 0
      result.mesh.vertices.push_back(p);
      if (is_exact) result.exact.push_back({number[v], exact->position});
    }
    if (is_exact) ++exact;
  }
  for (const auto& [a, b, c] : triangles) result.mesh.triangles.push_back({number[a], number[b], number[c]});
  return result;
}

Surface::Data clean(ExactMeshView mesh, const Monitor& monitor) {
  require_nearest_doubles(mesh, monitor);
  Surface::Data result;
  std::vector<Defect> errors;
  SourcedTriangles faces = sound_faces(mesh.mesh, Severity::error, errors, few_defects, monitor);
  if (!errors.empty()) throw InputError(std::move(errors));
  const std::vector<std::uint32_t> first = equal_vertices(mesh, monitor);
  for (Triangle& t : faces.triangles)
    for (std::uint32_t& v : t) v = first[v];

  const ZeroAreaTest has_no_area(ExactMeshView({mesh.mesh.vertices, faces.triangles}, mesh.exact));
  DefectList left_out(DefectKind::degenerate_triangle, Severity::note, "it was left out");
  std::vector<Triangle> kept;
  Pace pace(monitor);
  for (std::uint32_t f = 0; f < faces.triangles.size(); ++f) {
    pace.step();
    const Triangle& t = faces.triangles[f];
    if (repeats_vertex(t) || has_no_area(f)) {
      left_out.add(mesh.mesh.vertices[t[0]], {f}, [&] { return "face " + std::to_string(f) + " has zero area"; });
      continue;
    }
    kept.push_back(t);
    result.sources.push_back({0, f});
  }
  left_out.append_to(result.notes);
  result.mesh = without_unused_vertices(mesh, kept);
  return result;
}

}  // namespace

Surface surface_of(ExactMesh mesh, std::vector<Source> sources) {
  return Surface(Shared<Surface::Data>::make(Surface::Data{std::move(mesh), std::move(sources), {}, {}}));
}

Surface::Surface() : data_(Shared<Data>::make()) {}
Surface::Surface(Shared<Data> data) : data_(std::move(data)) {}
Surface::Surface(const Mesh& mesh, const Monitor& monitor)
    : data_(Shared<Data>::make(clean(ExactMeshView(mesh, {}), monitor))) {}
Surface::Surface(const ExactMesh& mesh, const Monitor& monitor) : data_(Shared<Data>::make(clean(mesh, monitor))) {}
// A solid's mesh need not be as a surface's is: sources lead to it.
Surface::Surface(const Solid& solid) : Surface(solid.exact_mesh()) {
  if (solid.attributes().empty()) return;
  const std::array given{AttributedMesh{solid.exact_mesh(), &solid.attributes()}};
  *this = with_attributes(carry_attributes(given, exact_mesh(), sources()));
}

Surface Surface::of_plane(const Plane& plane, const BoundingBox& around) {
  const std::size_t axis = main_axis(plane);
  const bool is_empty = around.lower[0] > around.upper[0];
  ExactMesh rectangle = rectangle_in(plane, axis, is_empty ? BoundingBox{} : around);
  if (plane.normal[axis] < 0)
    for (Triangle& t : rectangle.mesh.triangles) std::swap(t[1], t[2]);
  return Surface(rectangle);
}

const Mesh& Surface::mesh() const { return data_->mesh.mesh; }
const ExactMesh& Surface::exact_mesh() const { return data_->mesh; }
const std::vector<Source>& Surface::sources() const { return data_->sources; }
const std::vector<Defect>& Surface::notes() const { return data_->notes; }
const Attributes& Surface::attributes() const { return data_->attributes; }

Surface Surface::with_attributes(Attributes attributes) const {
  check_attributes(attributes, mesh().vertices.size(), mesh().triangles.size());
  Data data = *data_;
  data.attributes = std::move(attributes);
  return Surface(Shared<Data>::make(std::move(data)));
}

bool Surface::is_empty() const { return data_->mesh.mesh.triangles.empty(); }
double Surface::area() const { return strata::area(data_->mesh); }

}  // namespace strata
