#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/exact/sign.h"
#include "strata/mesh.h"

namespace strata::convex {

/// Side of the plane through p, q, r that x is on, all rounded to nearest doubles: positive where they are
/// counter-clockwise. Nothing if doubles cannot tell.
[[nodiscard]] std::optional<Sign> rounded_side(const Vertex& p, const Vertex& q, const Vertex& r, const Vertex& x);

/// A convex set as doubles see it: points that it is the hull of, and half-spaces that hold it.
class ApproximateConvexSet {
 public:
  /// All x with direction . x <= reach. Any direction will do.
  struct HalfSpace {
    Vertex direction{};
    double reach = 0;
  };

  /// The hull of points, given by nearest doubles. Its half-spaces are those of the corners of facets, nearly.
  explicit ApproximateConvexSet(std::vector<Vertex> points) : points_(std::move(points)) {}
  /// Adds nothing where that overflows.
  void add_facet(const Vertex& p, const Vertex& q, const Vertex& r);

  /// Is no point of the exact a + b rounded to x? Certain where the answer is yes.
  friend bool sum_misses(const ApproximateConvexSet& a, const ApproximateConvexSet& b, const Vertex& x);

 private:
  std::vector<Vertex> points_;
  std::vector<HalfSpace> half_spaces_;
};

}  // namespace strata::convex
