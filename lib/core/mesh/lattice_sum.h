#pragma once
#include <array>
#include <cstdint>
#include <span>

#include "strata/mesh.h"
#include "strata/rational.h"

namespace strata {

/// An exact sum of volumes between points that are integers times one power of two: 2^unit times integers below 2^61 in
/// magnitude, which is where doubles within a factor of 256 of the largest coordinate are. For up to 2^60 of them.
class LatticeSum {
 public:
  /// For points whose largest coordinate, in magnitude, is given.
  explicit LatticeSum(double largest);

  /// Adds det(a, b, c). If a coordinate is not on the lattice, adds nothing and returns false. O(1).
  [[nodiscard]] bool add_determinant(const Vertex& a, const Vertex& b, const Vertex& c);
  /// The next point of the lattice towards 0, from one whose coordinates are not larger than the largest. Coordinates
  /// change by less than one unit, and the changes are doubles.
  [[nodiscard]] Vertex truncated(const Vertex& p) const;
  /// Adds six times the signed volume between the triangle a b c and the plane z = 0, in the same way.
  [[nodiscard]] bool add_prism(const Vertex& a, const Vertex& b, const Vertex& c);
  /// Adds a sum on the same lattice.
  void add(const LatticeSum& other) { add(other.sum_); }
  [[nodiscard]] Rational value() const;

  /// A power of two, and its inverse.
  [[nodiscard]] double unit() const { return unit_; }
  [[nodiscard]] double scale() const { return scale_; }

 private:
  using Limbs = std::array<std::uint64_t, 4>;  ///< in two's complement
  void add(const Limbs& other);

  int exponent_;         ///< of the unit
  double unit_, scale_;  ///< 2^exponent and its inverse: both are normal doubles
  Limbs sum_{};          ///< in units of 2^(3 exponent)
};

/// The largest magnitude of a finite coordinate.
[[nodiscard]] double largest_coordinate(std::span<const Vertex> vertices);

}  // namespace strata
