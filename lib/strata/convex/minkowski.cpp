#include "strata/convex/minkowski.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "strata/convex/convex_solid.h"
#include "strata/convex/convolution.h"
#include "strata/convex/decompose.h"
#include "strata/convex/hull.h"
#include "strata/convex/membership.h"
#include "strata/convex/sum.h"
#include "strata/convex/surface.h"
#include "strata/csg/arena.h"
#include "strata/csg/combine.h"
#include "strata/kernel/disjoint_sets.h"
#include "strata/mesh/monitor.h"

namespace strata::convex {
namespace {

RationalPoint exact_normal(const ExactMesh& mesh, const Triangle& t) {
  const RationalPoint a = mesh.position(t[0]), b = mesh.position(t[1]), c = mesh.position(t[2]);
  const RationalPoint u{b[0] - a[0], b[1] - a[1], b[2] - a[2]}, v{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

/// A point inside a triangle; another one for every k > 0.
RationalPoint inner_point(const ExactMesh& mesh, const Triangle& t, int k) {
  const RationalPoint a = mesh.position(t[0]), b = mesh.position(t[1]), c = mesh.position(t[2]);
  RationalPoint p;
  for (std::size_t i = 0; i < 3; ++i) p[i] = (a[i] + k * b[i] + k * k * c[i]) / (1 + k + k * k);
  return p;
}

Operand operand_of(const ExactMesh& mesh) { return {mesh.mesh, mesh.exact, true}; }

/// Solids that are united with others, all of them known to be closed.
BooleanResult unite_checked(std::span<const ExactMesh> parts, InputClass input, const Options& options) {
  std::vector<Operand> operands;
  for (const ExactMesh& part : parts) operands.push_back(operand_of(part));
  Options inner = options;
  inner.input = input;
  inner.engine = Engine::arrangement;
  inner.exact_vertices = true;
  return combine(Operation::unite, std::span<const Operand>(operands), inner);
}

/// A vertex that no face has, listed as a rational: operands with rationals are taken as they are, whatever their
/// volume.
void mark_as_checked(ExactMesh& mesh) {
  if (!mesh.exact.empty() || mesh.mesh.vertices.empty()) return;
  const Vertex v = mesh.mesh.vertices[0];
  mesh.exact.push_back({static_cast<std::uint32_t>(mesh.mesh.vertices.size()),
                        {to_rational(v[0]), to_rational(v[1]), to_rational(v[2])}});
  mesh.mesh.vertices.push_back(v);
}

/// Faces connected by edges that two faces have.
std::vector<std::vector<std::uint32_t>> patches_of(const Mesh& mesh) {
  struct SideOf {
    std::uint32_t low = 0, high = 0, face = 0;
    auto operator<=>(const SideOf&) const = default;
  };
  std::vector<SideOf> sides;
  for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t v = mesh.triangles[f][i], w = mesh.triangles[f][(i + 1) % 3];
      sides.push_back({std::min(v, w), std::max(v, w), f});
    }
  std::sort(sides.begin(), sides.end());
  DisjointSets<std::uint32_t> parts(mesh.triangles.size());
  for (std::size_t i = 0, j = 0; i < sides.size(); i = j) {
    while (j < sides.size() && sides[j].low == sides[i].low && sides[j].high == sides[i].high) ++j;
    if (j == i + 2) parts.unite(sides[i].face, sides[i + 1].face);
  }
  std::vector<std::vector<std::uint32_t>> patches(mesh.triangles.size());
  for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) patches[parts.find(f)].push_back(f);
  std::erase_if(patches, [](const auto& patch) { return patch.empty(); });
  return patches;
}

/// Is what is in front of a patch part of the sum as well? Unknown if no point that is tried tells.
Side side_in_front(const ExactMesh& mesh, const std::vector<std::uint32_t>& patch, const SumMembership& membership) {
  constexpr int tries = 64;
  for (int k = 1; k <= tries; ++k) {
    const Triangle& t = mesh.mesh.triangles[patch[static_cast<std::size_t>(k - 1) % patch.size()]];
    const Side side = membership.side({inner_point(mesh, t, k + 1), exact_normal(mesh, t)});
    if (side != Side::unknown) return side;
  }
  return Side::unknown;
}

/// Nothing if some patch is not decided.
std::optional<ExactMesh> without_inner_patches(ExactMesh mesh, const SumMembership& membership,
                                               const Monitor& monitor) {
  const auto patches = patches_of(mesh.mesh);
  std::vector<Side> in_front(patches.size());
  tbb::parallel_for(std::size_t{0}, patches.size(), [&](std::size_t i) {
    monitor.check();
    in_front[i] = side_in_front(mesh, patches[i], membership);
  });
  std::vector<Triangle> kept;
  for (std::size_t i = 0; i < patches.size(); ++i) {
    if (in_front[i] == Side::unknown) return std::nullopt;
    if (in_front[i] == Side::out)
      for (const std::uint32_t f : patches[i]) kept.push_back(mesh.mesh.triangles[f]);
  }
  if (kept.size() < mesh.mesh.triangles.size()) mesh.mesh.triangles = std::move(kept);
  return mesh;
}

/// Convex pieces of a solid.
std::vector<Polytope> convex_pieces(const Solid& solid, const Monitor& monitor) {
  const Decomposition d = decompose(solid, monitor);
  std::vector<Polytope> pieces;
  for (std::uint32_t p = 0; p < d.pieces.size(); ++p) pieces.push_back(d.polytope(p));
  return pieces;
}

/// Two operands, of which the first one is a solid; the second one is a solid too, or a polytope.
class General {
 public:
  General(const Solid& a, const Solid* b, const Polytope* whole_b, const Options& options)
      : a_(a),
        b_(b),
        whole_b_(whole_b),
        options_(options),
        of_a_(surface_of(a.exact_mesh())),
        of_b_(b != nullptr ? surface_of(b->exact_mesh()) : surface_of(*whole_b)) {}

  Solid run() {
    const Monitor monitor(options_.cancel);
    // A polygon just inside of a face meets the notches that touch this face in a vertex or edge.
    if (of_b_.dimension == 2 && touches_itself(of_a_)) return by_pieces(monitor);
    Convolution found;
    arena_for(options_, of_a_.faces.size() + of_b_.faces.size()).execute([&] {
      found = convolution(of_a_, of_b_, monitor);
    });
    if (!found.has_rings)
      if (auto sum = outer_surface(std::move(found.surface), monitor)) return Solid::trusted(std::move(*sum));
    return by_pieces(monitor);
  }

 private:
  /// The surface of the sum, from the convolution.
  std::optional<ExactMesh> outer_surface(ExactMesh surface, const Monitor& monitor) const {
    mark_as_checked(surface);
    BooleanResult outer = unite_checked(std::span(&surface, 1), InputClass::overlapping, options_);
    const SumMembership membership(a_.exact_mesh(), of_a_, b_ != nullptr ? &b_->exact_mesh() : nullptr, of_b_,
                                   whole_b_);
    std::optional<ExactMesh> sum;
    arena_for(options_).execute([&] {
      sum = without_inner_patches({std::move(outer.mesh), std::move(outer.exact)}, membership, monitor);
    });
    return sum;
  }

  /// The union of the sums of all pairs of convex pieces.
  Solid by_pieces(const Monitor& monitor) const {
    const std::vector<Polytope> of_a = convex_pieces(a_, monitor);
    const std::vector<Polytope> of_b = b_ != nullptr ? convex_pieces(*b_, monitor) : std::vector{*whole_b_};
    std::vector<Solid> sums;
    for (const Polytope& p : of_a)
      for (const Polytope& q : of_b) {
        monitor.check();
        sums.push_back(solid_of(sum(p, q)));
      }
    return combine_solids(Operation::unite, sums, options_);
  }

  const Solid& a_;
  const Solid* b_;
  const Polytope* whole_b_;
  const Options& options_;
  const Surface of_a_, of_b_;
};

/// A box about all places from which something of the size of b reaches a, and more: powers of two.
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

/// The same solid: parts that touch in faces are one, and where it touches itself it has vertices.
ExactMesh resolved(const Solid& solid, const Options& options) {
  Options quiet = options;
  quiet.progress = {};
  const ExactMesh given[] = {solid.exact_mesh()};
  BooleanResult united = unite_checked(given, InputClass::overlapping, quiet);
  return {std::move(united.mesh), std::move(united.exact)};
}

/// What is between a box and the solid within: the box's faces, and those of the solid turned over. Parts of the solid
/// that touch in faces are united before: their common walls are no part of the rest.
ExactMesh rest_of(const Mesh& room, const Solid& solid, const Options& options) {
  ExactMesh rest = resolved(solid, options);
  for (Triangle& t : rest.mesh.triangles) std::swap(t[1], t[2]);
  const auto first = static_cast<std::uint32_t>(rest.mesh.vertices.size());
  rest.mesh.vertices.insert(rest.mesh.vertices.end(), room.vertices.begin(), room.vertices.end());
  for (const Triangle& t : room.triangles) rest.mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  return rest;
}

/// The part of a box half as large that no point of the obstacle's sum covers.
Solid uncovered(Mesh room, const Solid& covered, const Options& options) {
  for (Vertex& v : room.vertices)
    for (double& x : v) x /= 2;
  const Solid both[] = {Solid::trusted({std::move(room), {}}), covered};
  return combine_solids(Operation::subtract, both, options);
}

ExactMesh turned_about_origin(ExactMesh mesh) {
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
    auto& turned = result.facets.emplace_back(loop.rbegin(), loop.rend());
    for (std::uint32_t& v : turned) v = last - v;
  }
  return result;
}

Solid minkowski_sum(const Solid& a, const Polytope& b, const Options& options) {
  if (a.is_empty() || b.dimension < 0) return {};
  if (const auto convex = convex_solid(surface_of(a.exact_mesh()))) return solid_of(sum(*convex, b));
  if (b.dimension == 2) return General(Solid::trusted(resolved(a, options)), nullptr, &b, options).run();
  return General(a, nullptr, &b, options).run();
}

Solid minkowski_sum(const Solid& a, const Solid& b, const Options& options) {
  if (a.is_empty() || b.is_empty()) return {};
  if (const auto convex = convex_solid(surface_of(b.exact_mesh()))) return minkowski_sum(a, *convex, options);
  if (const auto convex = convex_solid(surface_of(a.exact_mesh()))) return minkowski_sum(b, *convex, options);
  return General(a, &b, nullptr, options).run();
}

Solid minkowski_sum(const Solid& a, std::span<const Polytope> b, const Options& options) {
  std::vector<Solid> sums;
  Options quiet = options;
  quiet.progress = {};
  for (const Polytope& polytope : b) sums.push_back(minkowski_sum(a, polytope, quiet));
  return combine_solids(Operation::unite, sums, options);
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
  return uncovered(room, minkowski_sum(rest, Solid::trusted(turned_about_origin(b.exact_mesh())), options), options);
}

}  // namespace strata::convex
