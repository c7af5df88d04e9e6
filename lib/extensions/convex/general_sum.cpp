#include "extensions/convex/general_sum.h"

#include <optional>
#include <utility>

#include "core/csg/arena.h"
#include "core/exact/failure.h"
#include "core/mesh/prepare.h"
#include "core/overlap/candidates.h"
#include "core/overlap/intersect.h"
#include "core/round/rounding.h"
#include "core/select/extract.h"
#include "core/select/label.h"
#include "core/select/subdivide.h"
#include "core/winding/local_windings.h"
#include "extensions/convex/membership.h"
#include "extensions/convex/outer_pieces.h"
#include "extensions/convex/touching_faces.h"
#include "strata/options.h"

namespace strata::convex {
namespace {

/// Two operands; the second one is a solid or a polytope.
struct Operands {
  const SolidSurface& a;
  const ExactMesh* solid_b;    ///< or null
  const Polytope* polytope_b;  ///< or null
  const Surface& of_b;
};

/// A point inside a piece, moved outwards by an infinitesimal distance; another point for every k > 0.
NearPoint place_in_front(const InputComplex& input, const PointTable& points, const PieceOfFace& piece, int k) {
  const auto place = [&](PointId v) { return exact_position(input, points.point(v)); };
  const RationalPoint a = place(piece.corners[0]), b = place(piece.corners[1]), c = place(piece.corners[2]);
  const Rational second = k, third = Rational(k) * k, sum = 1 + second + third;
  NearPoint result;
  RationalPoint u, v;
  for (std::size_t i = 0; i < 3; ++i) {
    result.p[i] = (a[i] + second * b[i] + third * c[i]) / sum;
    u[i] = b[i] - a[i];
    v[i] = c[i] - a[i];
  }
  result.n = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  return result;
}

ExactMesh outer_boundary(const ExactMesh& touching, const Operands& operands, const Monitor& monitor) {
  InputComplex complex(SelfIntersections::possible);
  complex.add(touching.mesh.vertices, touching.mesh.triangles, touching.exact);
  const Candidates candidates = find_candidates(std::move(complex), monitor);
  const InputComplex& input = candidates.input();
  const LocalWindings windings(input, candidates.cells());
  const Rule rule = Rule::every_sheet();
  const Classifier classifier{rule, windings};
  Subdivision subdivision = subdivide(input, intersect(candidates, monitor), classifier, monitor);
  std::vector<Verdict> verdicts = label(input, subdivision, classifier, monitor);
  const SumMembership membership(operands.a.mesh, operands.a.surface, operands.solid_b, operands.of_b,
                                 operands.polytope_b, monitor);
  const PointTable& points = subdivision.points;
  keep_outer_pieces(
      input, verdicts, subdivision,
      [&](const PieceOfFace& piece, int k) { return membership.side(place_in_front(input, points, piece, k)); },
      monitor);
  Boundary boundary = extract(input, verdicts, std::move(subdivision), monitor);
  ExactMesh sum;
  sum.mesh.vertices = round_to_doubles(input, boundary, monitor);
  sum.exact = exact_positions(input, boundary, sum.mesh.vertices, monitor);
  sum.mesh.triangles = std::move(boundary.triangles);
  if (!chain_is_closed(sum.mesh)) throw LogicError("the boundary of a sum is not closed");
  return sum;
}

Solid sum_of(const Operands& operands, const Options& options) {
  const Monitor monitor(options.cancel, &options.progress);
  monitor.check();
  ExactMesh touching, sum;
  arena_for(options, operands.a.surface.faces.size() + operands.of_b.faces.size()).execute([&] {
    touching = touching_faces(operands.a.surface, operands.of_b, monitor);
  });
  monitor.report(0.1);
  // Faces that cross many others take ten times as long as those of ordinary solids, or more.
  arena_for(options, 10 * touching.mesh.triangles.size()).execute([&] {
    sum = outer_boundary(touching, operands, monitor);
  });
  monitor.report(1);
  return Solid::trusted(std::move(sum));
}

}  // namespace

Solid general_sum(const SolidSurface& a, const SolidSurface& b, const Options& options) {
  return sum_of({a, &b.mesh, nullptr, b.surface}, options);
}

Solid general_sum(const SolidSurface& a, const Polytope& b, const Options& options) {
  return sum_of({a, nullptr, &b, surface_of(b, Monitor(options.cancel))}, options);
}

}  // namespace strata::convex
