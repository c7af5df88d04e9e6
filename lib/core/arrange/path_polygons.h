#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/arrange/face_points.h"
#include "core/overlap/constraint.h"

namespace strata {

/// The polygons into which a face falls where another surface does nothing but cross it: the constraints are then
/// segments of paths from border to border, whose points have names that say where they are. No geometry is asked but
/// the order of points along the face's edges.
class PathPolygons {
 public:
  /// A side of a polygon, from its point to that of the next side; the polygon is on its left.
  struct Side {
    std::int32_t from = 0;
    std::int32_t carrier = 0;  ///< a constraint, or -1 - k on the face's edge k
    bool forward = true;       ///< runs along tail -> head of the constraint
  };

  PathPolygons(const InputComplex& input, FacePoints& points) : input_(input), points_(points) {}

  /// Adds the ends of all constraints to the points, which hold the face's corners only, and finds the polygons.
  /// False when the constraints are anything else than simple paths as far as names tell. O(n log n).
  bool find(std::span<const Constraint> constraints);

  [[nodiscard]] std::size_t count() const { return first_.size() - 1; }
  /// Sides in counter-clockwise order.
  [[nodiscard]] std::span<const Side> operator[](std::size_t i) const {
    return std::span(sides_).subspan(first_[i], first_[i + 1] - first_[i]);
  }

 private:
  /// What the paths do at a point.
  struct Station {
    std::int32_t leaving = -1, arriving = -1;  ///< constraints
    int edge = inside;                         ///< the face's edge on which it is
    std::int32_t place = -1;                   ///< in the order of the border
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
  std::vector<bool> traced_;                       ///< per border point: the way to the next
  std::vector<Side> sides_;
  std::vector<std::size_t> first_;  ///< side per polygon
};

}  // namespace strata
