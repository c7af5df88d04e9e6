#pragma once
#include <array>
#include <cstdint>

#include "core/kernel/approximation.h"
#include "core/kernel/filtered_plane.h"
#include "core/kernel/input_complex.h"
#include "core/overlap/triangle.h"

namespace strata {

/// A face with all that a first look at it in doubles needs.
struct FilteredFace {
  std::uint32_t face = 0;
  InputComplex::Indices vertices{};
  std::array<InputComplex::Coordinates, 3> corners{};
  FilteredPlane plane;                       ///< if exact
  ApproximatePlane<Bounded> rational_plane;  ///< otherwise
  bool is_exact = true;                      ///< vertices are where the corners say; else these are the nearest doubles

  FilteredFace() = default;
  FilteredFace(const InputComplex& input, std::uint32_t face);
  FilteredFace(const InputComplex& input, std::uint32_t operand, std::uint32_t face);

  /// Sides of this face's plane on which another's vertices are: above positive; zero when doubles do not tell.
  [[nodiscard]] Signs sides_of(const FilteredFace& other) const;
  /// True when a face with these sides, but for vertices that both have, is strictly on one side of this one's plane.
  [[nodiscard]] bool is_beside(const FilteredFace& other, const Signs& sides) const;
  /// True when, seen along the axis across which this face is widest, the line of one of its edges has the face on one
  /// side and all of the other face on the other, strictly or beyond an end, but for ends of the edge that both have.
  [[nodiscard]] bool is_off(const FilteredFace& other) const;

  /// A corner within bounds.
  [[nodiscard]] BoundedPoint corner(std::size_t i) const;
  [[nodiscard]] bool has(std::uint32_t v) const { return v == vertices[0] || v == vertices[1] || v == vertices[2]; }
};

/// orient3d of an edge i of f and an edge k of g, each given by its first vertex. The same with edges swapped, since
/// that is an even permutation.
[[nodiscard]] Sign orient_edges(const InputComplex& input, const FilteredFace& f, int i, const FilteredFace& g, int k);

}  // namespace strata
