#pragma once
#include <array>
#include <cstdint>

#include "core/kernel/carriers.h"
#include "core/kernel/filtered_plane.h"
#include "core/kernel/predicates.h"
#include "strata/query.h"

namespace strata {

/// A triangle by its vertices' numbers in the carriers.
using Corners = Carriers::Indices;

/// What is seen from an origin, as exact signs. Vertices are those of the carriers.
class Sight {
 public:
  Sight(const Carriers& carriers, const Origin& origin) : carriers_(carriers), origin_(origin) {}

  [[nodiscard]] const Carriers& carriers() const { return carriers_; }
  [[nodiscard]] const Origin& origin() const { return origin_; }

  /// positive: a, b, c are seen counter-clockwise; zero: the origin is in their plane. orient3d(a, b, c, origin).
  [[nodiscard]] Sign turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;
  [[nodiscard]] Sign turn(const Corners& f) const { return turn(f[0], f[1], f[2]); }

  /// Depth of a vertex against the plane of a triangle that is seen as `turn`: positive when it is beyond it, negative
  /// when it is before it, zero in the plane.
  [[nodiscard]] Sign depth(const Corners& triangle, Sign turn_of_triangle, std::uint32_t vertex) const;

 private:
  [[nodiscard]] Point point(std::uint32_t v) const { return make_point(carriers_, PointName::input(v)); }

  const Carriers& carriers_;
  const Origin& origin_;
};

/// One edge of a triangle as seen from the origin: asks `turn` of many vertices.
class SightLine {
 public:
  SightLine(const Sight& sight, std::uint32_t a, std::uint32_t b);

  /// Sight::turn(a, b, c)
  [[nodiscard]] Sign turn(std::uint32_t c) const;

 private:
  const Sight& sight_;
  std::uint32_t a_, b_;
  bool filtered_;
  FilteredPlane plane_;  ///< above it are the points with a negative turn
};

}  // namespace strata
