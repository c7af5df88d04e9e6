#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/exact/sign.h"
#include "strata/mesh.h"

namespace strata::convex {

/// Side of x relative to the plane through p, q, r, all rounded to nearest doubles: positive where they are
/// counter-clockwise. Nullopt if doubles do not decide.
[[nodiscard]] std::optional<Sign> rounded_side(const Vertex& p, const Vertex& q, const Vertex& r, const Vertex& x);

/// A convex set in doubles: points of which it is the hull, and half-spaces that contain it.
class ApproximateConvexSet {
 public:
  /// All x with direction . x <= reach, for any direction.
  struct HalfSpace {
    Vertex direction{};
    double reach = 0;
  };

  /// The hull of points, given by nearest doubles. Its half-spaces are approximately those of the corners of facets.
  explicit ApproximateConvexSet(std::vector<Vertex> points) : points_(std::move(points)) {}
  /// Adds nothing if the computation overflows.
  void add_facet(const Vertex& p, const Vertex& q, const Vertex& r);

  /// Does no point of the exact a + b round to x? A positive answer is certain.
  friend bool sum_misses(const ApproximateConvexSet& a, const ApproximateConvexSet& b, const Vertex& x);

 private:
  std::vector<Vertex> points_;
  std::vector<HalfSpace> half_spaces_;
};

}  // namespace strata::convex
