#pragma once
#include <array>
#include <cstdint>

#include "core/kernel/approximation.h"
#include "core/kernel/filtered_plane.h"
#include "core/kernel/input_complex.h"
#include "core/overlap/triangle.h"

namespace strata {

/// A face with the data for filters in doubles.
struct FilteredFace {
  std::uint32_t face = 0;
  InputComplex::Indices vertices{};
  std::array<InputComplex::Coordinates, 3> corners{};
  FilteredPlane plane;                       ///< if exact
  ApproximatePlane<Bounded> rational_plane;  ///< otherwise
  bool is_exact = true;                      ///< the corners are exact; otherwise they are the nearest doubles
  int level_axis = -1;                       ///< if exact, the axis along which all corners have one coordinate, if any

  FilteredFace() = default;
  FilteredFace(const InputComplex& input, std::uint32_t face);
  FilteredFace(const InputComplex& input, std::uint32_t operand, std::uint32_t face);

  /// Becomes another face in two steps. After the first, its plane is not known: it can only be compared with the
  /// planes of others, which is enough for most.
  void set_corners(const InputComplex& input, std::uint32_t operand, std::uint32_t face);
  void find_plane(const InputComplex& input);

  /// Sides of this face's plane on which another face's vertices lie: above positive; zero when doubles do not decide.
  [[nodiscard]] Signs sides_of(const FilteredFace& other) const;
  /// True when a face with these sides, except vertices that both have, is strictly on one side of this face's plane.
  [[nodiscard]] bool is_beside(const FilteredFace& other, const Signs& sides) const;
  /// True when the line of one of this face's edges separates the faces, seen along the axis of this face's longest
  /// normal component: this face is on one side, and all of the other face is on the other, strictly or beyond an end,
  /// except ends of the edge that both have.
  [[nodiscard]] bool is_off(const FilteredFace& other) const;

  /// True when both faces are exact and at right angles to one axis. Then their planes are equal where `level` is, and
  /// else apart.
  [[nodiscard]] bool is_level_as(const FilteredFace& other) const {
    return level_axis >= 0 && level_axis == other.level_axis;
  }
  [[nodiscard]] double level() const { return corners[0][static_cast<std::size_t>(level_axis)]; }

  /// A corner within bounds.
  [[nodiscard]] BoundedPoint corner(std::size_t i) const;
  [[nodiscard]] bool has(std::uint32_t v) const { return v == vertices[0] || v == vertices[1] || v == vertices[2]; }
};

/// orient3d of an edge i of f and an edge k of g, each given by its first vertex. Swapping the edges does not change
/// it, because that is an even permutation.
[[nodiscard]] Sign orient_edges(const InputComplex& input, const FilteredFace& f, int i, const FilteredFace& g, int k);

}  // namespace strata
