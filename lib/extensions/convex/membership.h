#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/containers/box_tree.h"
#include "core/kernel/box.h"
#include "extensions/convex/approximate_convex_set.h"
#include "extensions/convex/surface.h"
#include "strata/convex.h"
#include "strata/mesh.h"
#include "strata/monitor.h"
#include "strata/rational.h"

namespace strata::convex {

/// A point with an infinitesimal displacement: p + e n, e > 0.
struct NearPoint {
  RationalPoint p;
  RationalPoint n;
};

/// The position of such a point. `unknown`: n is parallel to a boundary that contains p.
enum class Side { out, in, unknown };

/// The position relative to a polytope of any dimension; a polytope of a dimension below 3 has no interior. O(facets),
/// exact.
[[nodiscard]] Side side_of(const Polytope& polytope, const NearPoint& point);

[[nodiscard]] Polytope triangle_polytope(ExactMeshView mesh, const Triangle& triangle);

/// Boxes of triangles, and a tree over them.
class TriangleBoxes {
 public:
  TriangleBoxes() = default;
  /// O(n log n). Throws Cancelled.
  TriangleBoxes(const Mesh& mesh, const Monitor& monitor);

  [[nodiscard]] const Box& operator[](std::size_t triangle) const { return boxes_[triangle]; }
  /// Calls `visit(triangle)` for every box that overlaps `range` until it returns false; false if it did. The order is
  /// the same each time. O(log n + found) for small boxes that are apart.
  template <class Visit>
  bool for_each_overlapping(const Box& range, const Visit& visit) const {
    return tree_.for_each_near(range, [&](std::uint32_t t) { return !boxes_[t].overlaps(range) || visit(t); });
  }

 private:
  std::vector<Box> boxes_;
  BoxTree tree_;
};

/// Decides whether points lie in the sum of two solids, or of a solid and a polytope, by its definition: x is in A + B
/// if A meets x - B. Then their boundaries meet, or one contains a component of the other.
class SumMembership {
 public:
  /// `b` is a solid, or null where the second operand is a polytope. The arguments must outlive it. It and `side` throw
  /// Cancelled.
  SumMembership(const ExactMesh& a, const Surface& of_a, const ExactMesh* b, const Surface& of_b,
                const Polytope* whole_b, const Monitor& monitor);

  /// Exact. Where boxes overlap little, O(m log n + sums of pieces near the point) for m triangles of b, or for m = 1
  /// where b is a polytope, and as much for every component of an operand.
  [[nodiscard]] Side side(const NearPoint& point) const;

 private:
  [[nodiscard]] Side side_of_boundaries(const NearPoint& point) const;
  template <class PieceOfB>
  [[nodiscard]] Side side_of_sums(const NearPoint& point, const Vertex& near, const Box& bounds_of_b,
                                  const ApproximateConvexSet& set_b, const PieceOfB& piece_of_b) const;

  const ExactMesh& a_;
  const ExactMesh* b_;
  const Polytope* whole_b_;
  Monitor monitor_;
  TriangleBoxes triangles_of_a_, triangles_of_b_;
  Box bounds_of_b_;                                                  ///< of a polytope
  std::optional<ApproximateConvexSet> set_b_;                        ///< of a polytope
  std::vector<std::vector<RationalPoint>> parts_of_a_, parts_of_b_;  ///< vertices of every shell
};

}  // namespace strata::convex
