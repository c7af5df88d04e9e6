#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>

#include "core/exact/double_double.h"
#include "strata/mesh.h"

namespace strata {

/// Numbers between two bounds.
struct Range {
  double lower = 0, upper = 0;

  void include(const Range& other) {
    lower = std::min(lower, other.lower);
    upper = std::max(upper, other.upper);
  }
};

/// The plane of a triangle, seen along the axis to which it is closest to orthogonal. Its normal has 106 bits: those of
/// a triangle a few units high are lost in doubles, in which the products of its sides cancel.
class ViewedPlane {
 public:
  ViewedPlane() = default;
  ViewedPlane(const Vertex& a, const Vertex& b, const Vertex& c);

  /// False for a triangle without area, as far as doubles tell, or one so large that differences of its coordinates are
  /// infinite.
  [[nodiscard]] bool is_valid() const { return area_.fraction > 0; }
  [[nodiscard]] const Vertex& corner() const { return at_; }

  /// The axis along which the plane is seen, and those that are seen.
  [[nodiscard]] std::size_t axis() const { return axis_; }
  [[nodiscard]] std::size_t first() const { return (axis_ + 1) % 3; }
  [[nodiscard]] std::size_t second() const { return (axis_ + 2) % 3; }

  /// How far a point is above the plane, along the axis.
  [[nodiscard]] Range height(const Vertex& p) const;
  /// False only if the height, either way, is above this.
  [[nodiscard]] bool may_be_within(const Vertex& p, double reach) const;
  /// The point of the plane that is seen there, about.
  [[nodiscard]] Vertex point(double first, double second) const;

  /// By the areas of the triangles, about.
  [[nodiscard]] bool has_more_area_than(const ViewedPlane& other) const {
    return std::pair(area_.exponent, area_.fraction) > std::pair(other.area_.exponent, other.area_.fraction);
  }

 private:
  /// fraction * 2^exponent, with a fraction of 1/2 to 1: areas may be beyond all doubles.
  struct Area {
    int exponent = std::numeric_limits<int>::min();
    double fraction = 0;
  };

  Vertex at_{}, normal_{};  ///< the largest component of the normal is 1 or -1
  std::array<DoubleDouble, 3> fine_normal_;
  std::size_t axis_ = 0;
  Area area_{};
};

}  // namespace strata
