#include "extensions/openscad/solid_operations.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/kernel/rational_point.h"
#include "core/mesh/fill_holes.h"
#include "extensions/openscad/rational_mesh.h"
#include "extensions/openscad/shape_operations.h"
#include "strata/convex.h"
#include "strata/section.h"

namespace strata::openscad {
namespace {

/// Calls `visit` with every vertex and its exact position.
template <class Visit>
void for_positions(const ExactMesh& mesh, const Visit& visit) {
  auto next = mesh.exact.begin();
  for (std::uint32_t v = 0; v < mesh.mesh.vertices.size(); ++v) {
    const bool is_listed = next != mesh.exact.end() && next->vertex == v;
    visit(v, is_listed ? next->position : to_rational(mesh.mesh.vertices[v]));
    if (is_listed) ++next;
  }
}

void add(const ExactMesh& mesh, VertexCollector& points) {
  if (mesh.exact.empty()) {
    for (const Vertex& p : mesh.mesh.vertices) points.add(p);
  } else {
    for_positions(mesh, [&](std::uint32_t, RationalPoint p) { points.add(std::move(p)); });
  }
}

}  // namespace

Solid evaluated(const Part& part, const Options& options) {
  if (!part.value()) return part.solid().evaluate(options);
  const auto& [solid, map] = *part.value();
  return map.is_identity() ? solid : solid.transformed(map, Placement::exact, Monitor(options.cancel));
}

Solid hull(std::span<const Part> parts, const Options& options) {
  VertexCollector points;
  for (const Part& part : parts) {
    if (!part.is_union()) {
      add(evaluated(part, options).exact_mesh(), points);
      continue;
    }
    for (const auto& p : part.solid().primitives())
      add(p.map.is_identity() ? p.solid.exact_mesh() : transform(p.solid.exact_mesh(), p.map, p.placement), points);
  }
  return convex::solid_of(convex::convex_hull(ExactMeshView(points.mesh()), options.threads, Monitor(options.cancel)));
}

planar::Region section_at_zero(const Solid& solid, const Options& options) {
  const planar::Region above = section(solid, {{0, 0, 1}, 0}, options);
  const planar::Region below = section(solid, {{0, 0, -1}, 0}, options);  // its coordinates are y, x
  return planar::union_(above, transformed(below, {{{0, 1, 0}, {1, 0, 0}}}, Placement::exact));
}

planar::Region shadow(const Solid& solid) {
  const ExactMesh& mesh = solid.exact_mesh();
  std::vector<planar::RationalPlacement> at(mesh.mesh.vertices.size());
  for_positions(mesh, [&](std::uint32_t v, RationalPoint p) { at[v] = {std::move(p[0]), std::move(p[1])}; });
  SourcedTriangles seen_from_above;
  for (const Triangle& t : mesh.mesh.triangles) {
    const auto &a = at[t[0]], &b = at[t[1]], &c = at[t[2]];
    if ((b[0] - a[0]) * (c[1] - a[1]) > (b[1] - a[1]) * (c[0] - a[0])) seen_from_above.add(t, 0);
  }
  // Edges between two such faces are inside the shadow. The others go around it, turned over, as often as faces cover
  // it.
  planar::LoopsBuilder loops;
  for (const Hole& hole : find_holes(mesh.mesh.vertices, seen_from_above)) {
    for (const std::uint32_t v : hole.loop) loops.add_vertex(at[v]);
    loops.end_loop();
  }
  return planar::fill(loops.finish());
}

RationalPoint resize_factors(const std::array<double, 3>& new_size, const std::array<bool, 3>& automatic,
                             const RationalPoint& size) {
  const std::size_t largest =
      static_cast<std::size_t>(std::max_element(new_size.begin(), new_size.end()) - new_size.begin());
  const auto own_factor = [&](std::size_t axis) {
    return new_size[axis] > 0 && size[axis].sign() > 0 ? to_rational(new_size[axis]) / size[axis] : Rational(1);
  };
  RationalPoint factors;
  for (std::size_t axis = 0; axis < 3; ++axis)
    factors[axis] = own_factor(new_size[axis] > 0 || !automatic[axis] ? axis : largest);
  return factors;
}

std::array<RationalPoint, 2> bounding_box(const Solid& solid) {
  std::array<RationalPoint, 2> box;
  for_positions(solid.exact_mesh(), [&](std::uint32_t v, const RationalPoint& p) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (v == 0 || p[i] < box[0][i]) box[0][i] = p[i];
      if (v == 0 || p[i] > box[1][i]) box[1][i] = p[i];
    }
  });
  return box;
}

}  // namespace strata::openscad
