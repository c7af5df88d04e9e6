#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/arrange/face_points.h"
#include "core/overlap/constraint.h"

namespace strata {

/// The polygons of a face that another surface crosses and does not meet otherwise. Then the constraints are segments
/// of paths from boundary to boundary, and the names of their points show where they are. The only geometric test is
/// the order of points along the face's edges. theory.md, "Fast path: simple paths".
class PathPolygons {
 public:
  /// A side of a polygon, from its point to that of the next side; the polygon is on its left.
  struct Side {
    std::int32_t from = 0;
    std::int32_t carrier = 0;  ///< a constraint, or -1 - k on the face's edge k
    bool forward = true;       ///< runs along tail -> head of the constraint
  };

  PathPolygons(const InputComplex& input, FacePoints& points) : input_(input), points_(points) {}

  /// Adds the ends of all constraints to the points, which contain the face's corners only, and finds the polygons.
  /// False when names do not show that the constraints are simple paths. O(n log n).
  bool find(std::span<const Constraint> constraints);

  [[nodiscard]] std::size_t count() const { return first_.size() - 1; }
  /// Sides in counter-clockwise order.
  [[nodiscard]] std::span<const Side> operator[](std::size_t i) const {
    return std::span(sides_).subspan(first_[i], first_[i + 1] - first_[i]);
  }

 private:
  /// The paths at a point.
  struct Station {
    std::int32_t leaving = -1, arriving = -1;  ///< constraints
    int edge = inside;                         ///< the face's edge on which it is
    std::int32_t place = -1;                   ///< in the order of the boundary
  };
  static constexpr int inside = -1, elsewhere = -2;

  [[nodiscard]] int edge_of(const SymbolicPoint& name) const;
  [[nodiscard]] bool add_ends(std::span<const Constraint> constraints);
  [[nodiscard]] bool walk_border();
  void trace(std::int32_t start);
  [[nodiscard]] std::int32_t follow(std::int32_t from);

  const InputComplex& input_;
  FacePoints& points_;
  std::vector<std::array<std::int32_t, 2>> ends_;  ///< tail and head per constraint
  std::vector<Station> stations_;                  ///< per point
  std::vector<std::int32_t> border_;               ///< points around the face, counter-clockwise
  std::vector<bool> traced_;                       ///< per point of the boundary: the way to the next one
  std::vector<Side> sides_;
  std::vector<std::size_t> first_;  ///< side per polygon
};

}  // namespace strata
