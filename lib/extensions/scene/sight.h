#pragma once
#include <array>
#include <cstdint>

#include "core/kernel/filtered_plane.h"
#include "core/kernel/input_complex.h"
#include "core/kernel/predicates.h"
#include "strata/query.h"

namespace strata {

/// A triangle by its vertices' numbers in the input complex.
using Corners = InputComplex::Indices;

/// Visibility predicates from an origin, as exact signs. Vertices are those of the input complex.
class Sight {
 public:
  Sight(const InputComplex& input, const Origin& origin) : input_(input), origin_(origin) {}

  [[nodiscard]] const InputComplex& input() const { return input_; }
  [[nodiscard]] const Origin& origin() const { return origin_; }

  /// positive: a, b, c are seen counter-clockwise; zero: the origin is in their plane. orient3d(a, b, c, origin).
  [[nodiscard]] Sign orientation(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;
  [[nodiscard]] Sign orientation(const Corners& f) const { return orientation(f[0], f[1], f[2]); }

  /// Depth of a vertex relative to the plane of a triangle with the given orientation: positive beyond it, negative
  /// before it, zero in the plane.
  [[nodiscard]] Sign depth(const Corners& triangle, Sign orientation_of_triangle, std::uint32_t vertex) const;

 private:
  [[nodiscard]] Point point(std::uint32_t v) const { return make_point(input_, SymbolicPoint::input(v)); }

  const InputComplex& input_;
  const Origin& origin_;
};

/// One edge of a triangle as seen from the origin, for the orientations of many vertices.
class SightLine {
 public:
  SightLine(const Sight& sight, std::uint32_t a, std::uint32_t b);

  /// Sight::orientation(a, b, c)
  [[nodiscard]] Sign orientation(std::uint32_t c) const;

 private:
  const Sight& sight_;
  std::uint32_t a_, b_;
  bool filtered_;
  FilteredPlane plane_;  ///< the points above it have a negative orientation
};

}  // namespace strata
