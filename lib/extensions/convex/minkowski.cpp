#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "extensions/convex/convex_solid.h"
#include "extensions/convex/general_sum.h"
#include "extensions/convex/surface.h"
#include "strata/combine.h"
#include "strata/convex.h"

namespace strata::convex {
namespace {

/// A box around all positions in which b meets a, and more: its coordinates are powers of two.
Mesh room_around(const Solid& a, const BoundingBox& of_b) {
  const BoundingBox of_a = a.bounding_box();
  double reach = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (const double x : {of_a.lower[i], of_a.upper[i], of_b.lower[i], of_b.upper[i]})
      reach = std::max(reach, std::abs(x));
  const double side = std::ldexp(1.0, std::ilogb(reach) + 4);
  if (!std::isfinite(side)) throw std::overflow_error("the operands of an erosion are too large for a box about them");
  Mesh box;
  for (int k = 0; k < 8; ++k)
    box.vertices.push_back({(k & 1) != 0 ? side : -side, (k & 2) != 0 ? side : -side, (k & 4) != 0 ? side : -side});
  box.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                   {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return box;
}

/// The same solid in which components that touch in faces are united, and which has vertices where it touches itself.
ExactMesh resolved(const Solid& solid, const Options& options) {
  const ExactMesh mesh = solid.exact_mesh();
  const Operand operand[] = {{mesh.mesh, mesh.exact, true}};
  Options inner = options;
  inner.progress = {};
  inner.input = InputClass::overlapping;
  inner.engine = nullptr;
  inner.exact_vertices = true;
  BooleanResult united = combine(Operation::union_, std::span<const Operand>(operand), inner);
  return {std::move(united.mesh), std::move(united.exact)};
}

/// The region between a box and the solid in it: the box's faces, and those of the solid with opposite orientation.
/// Components of the solid that touch in faces are united before, because their common facets are not in the boundary
/// of that region.
ExactMesh rest_of(const Mesh& room, const Solid& solid, const Options& options) {
  ExactMesh rest = resolved(solid, options);
  for (Triangle& t : rest.mesh.triangles) std::swap(t[1], t[2]);
  const auto first = static_cast<std::uint32_t>(rest.mesh.vertices.size());
  rest.mesh.vertices.insert(rest.mesh.vertices.end(), room.vertices.begin(), room.vertices.end());
  for (const Triangle& t : room.triangles) rest.mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  return rest;
}

/// The part of a box of half the size that the sum with the obstacle does not cover.
Solid uncovered(Mesh room, const Solid& covered, const Options& options) {
  for (Vertex& v : room.vertices)
    for (double& x : v) x /= 2;
  const Solid both[] = {Solid::trusted({std::move(room), {}}), covered};
  return combine_solids(Operation::difference, both, options);
}

ExactMesh reflected_in_origin(ExactMesh mesh) {
  for (Vertex& v : mesh.mesh.vertices)
    for (double& x : v) x = -x;
  for (ExactVertex& e : mesh.exact)
    for (Rational& x : e.position) x = -x;
  for (Triangle& t : mesh.mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

}  // namespace

Polytope reflected(const Polytope& polytope) {
  Polytope result;
  result.dimension = polytope.dimension;
  const auto last = static_cast<std::uint32_t>(polytope.vertices.size()) - 1;
  for (auto v = polytope.vertices.rbegin(); v != polytope.vertices.rend(); ++v)
    result.vertices.push_back({0 - (*v)[0], 0 - (*v)[1], 0 - (*v)[2]});
  for (auto e = polytope.exact.rbegin(); e != polytope.exact.rend(); ++e)
    result.exact.push_back({last - e->vertex, {-e->position[0], -e->position[1], -e->position[2]}});
  for (const auto& loop : polytope.facets) {
    auto& reversed = result.facets.emplace_back(loop.rbegin(), loop.rend());
    for (std::uint32_t& v : reversed) v = last - v;
  }
  return result;
}

Solid minkowski_sum(const Solid& a, const Polytope& b, const Options& options) {
  if (a.is_empty() || b.dimension < 0) return {};
  const Monitor monitor(options.cancel);
  const Surface of_a = surface_of(a.exact_mesh(), monitor);
  if (const auto convex = convex_solid(of_a, monitor)) return solid_of(sum(*convex, b, monitor));
  return general_sum({a.exact_mesh(), of_a}, b, options);
}

Solid minkowski_sum(const Solid& a, const Solid& b, const Options& options) {
  if (a.is_empty() || b.is_empty()) return {};
  const Monitor monitor(options.cancel);
  const Surface of_b = surface_of(b.exact_mesh(), monitor);
  if (const auto convex = convex_solid(of_b, monitor)) return minkowski_sum(a, *convex, options);
  const Surface of_a = surface_of(a.exact_mesh(), monitor);
  if (const auto convex = convex_solid(of_a, monitor)) return minkowski_sum(b, *convex, options);
  return general_sum({a.exact_mesh(), of_a}, {b.exact_mesh(), of_b}, options);
}

Solid minkowski_sum(const Solid& a, std::span<const Polytope> b, const Options& options) {
  std::vector<Solid> sums;
  Options quiet = options;
  quiet.progress = {};
  for (const Polytope& polytope : b) sums.push_back(minkowski_sum(a, polytope, quiet));
  return combine_solids(Operation::union_, sums, options);
}

Solid erosion(const Solid& a, const Polytope& b, const Options& options) {
  if (b.dimension < 0) throw std::invalid_argument("an erosion by nothing is all of space");
  if (a.is_empty()) return {};
  BoundingBox of_b{b.vertices[0], b.vertices[0]};
  for (const Vertex& v : b.vertices)
    for (std::size_t i = 0; i < 3; ++i) {
      of_b.lower[i] = std::min(of_b.lower[i], v[i]);
      of_b.upper[i] = std::max(of_b.upper[i], v[i]);
    }
  const Mesh room = room_around(a, of_b);
  const Solid rest = Solid::trusted(rest_of(room, a, options));
  return uncovered(room, minkowski_sum(rest, reflected(b), options), options);
}

Solid erosion(const Solid& a, const Solid& b, const Options& options) {
  if (b.is_empty()) throw std::invalid_argument("an erosion by nothing is all of space");
  if (a.is_empty()) return {};
  const Mesh room = room_around(a, b.bounding_box());
  const Solid rest = Solid::trusted(rest_of(room, a, options));
  return uncovered(room, minkowski_sum(rest, Solid::trusted(reflected_in_origin(b.exact_mesh())), options), options);
}

}  // namespace strata::convex
