#pragma once
#include <array>
#include <cstdint>

#include "strata/mesh.h"
#include "strata/rational.h"

namespace strata {

/// An exact sum of products of three finite doubles, of any magnitudes, in fixed space. A long accumulator after
/// Kulisch: a fixed-point number wide enough for every such product, with room for 2^64 of them. Positive and negative
/// terms are summed separately, so that carries are short.
class ProductSum {
 public:
  void add(double a, double b, double c);                                   ///< adds a b c. O(1).
  void add_determinant(const Vertex& a, const Vertex& b, const Vertex& c);  ///< adds det(a, b, c). O(1).
  void add(const ProductSum& other);
  [[nodiscard]] int sign() const;  ///< -1, 0 or 1
  [[nodiscard]] Rational value() const;

 private:
  static constexpr std::size_t limb_count = 102;  // bits: 6135 of exponents + 159 of a product + 64 of terms, and some
  using Limbs = std::array<std::uint64_t, limb_count>;
  static void add(Limbs& sum, const Limbs& term);
  static void add_shifted(Limbs& sum, unsigned shift, std::uint64_t w0, std::uint64_t w1, std::uint64_t w2);

  Limbs positive_{};  // in units of 2^-3222, the product of three smallest subnormals
  Limbs negative_{};
};

}  // namespace strata
