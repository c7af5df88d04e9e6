#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include "core/cells/space.h"

namespace strata {

/// The brick of a point: one byte per axis, lowest byte x. 0 and count + 1 are outside.
using BrickCode = std::uint32_t;

/// A corner of the box of bricks that two points span: their bytewise minimum or maximum.
template <bool upper>
[[nodiscard]] BrickCode corner(BrickCode a, BrickCode b) {
#if defined(__SSE2__)
  const __m128i x = _mm_cvtsi32_si128(static_cast<int>(a)), y = _mm_cvtsi32_si128(static_cast<int>(b));
  return static_cast<BrickCode>(_mm_cvtsi128_si32(upper ? _mm_max_epu8(x, y) : _mm_min_epu8(x, y)));
#else
  const auto along = [&](BrickCode axis) {
    return upper ? std::max(a & axis, b & axis) : std::min(a & axis, b & axis);
  };
  return along(0xffu) | along(0xff00u) | along(0xff0000u);
#endif
}
[[nodiscard]] inline BrickCode lower_corner(BrickCode a, BrickCode b) { return corner<false>(a, b); }
[[nodiscard]] inline BrickCode upper_corner(BrickCode a, BrickCode b) { return corner<true>(a, b); }

/// A closed box of bricks.
struct BrickBox {
  BrickCode lower = 0, upper = 0;

  /// The box of both.
  [[nodiscard]] BrickBox with(const BrickBox& b) const {
    return {lower_corner(lower, b.lower), upper_corner(upper, b.upper)};
  }

  [[nodiscard]] static std::uint32_t along(BrickCode code, int axis) { return code >> (8 * axis) & 0xffu; }
  [[nodiscard]] std::uint32_t size() const {
    std::uint32_t n = 1;
    for (int axis = 0; axis < 3; ++axis) n *= along(upper, axis) - along(lower, axis) + 1;
    return n;
  }
};

/// The uniform grid: the space of interest, divided into cubic bricks of equal size, the last ones cut short, with one
/// layer of outside bricks around them. Bricks are numbered x fastest, the outside layer included. A brick contains the
/// points whose grid coordinates are in its box. Like the grid map, the map of points to bricks is monotone along each
/// axis.
class BrickGrid {
 public:
  static constexpr std::uint32_t most_per_axis = 254;

  BrickGrid() = default;
  /// At most `budget` bricks with sides of at least `least_side` on the grid, as many as fit. There are fewer where
  /// doubles are too coarse to put a point into each.
  BrickGrid(const Space& space, std::size_t budget, std::int32_t least_side);

  /// Number of bricks along an axis, the two outside bricks included.
  [[nodiscard]] std::uint32_t size(int axis) const { return size_[at(axis)]; }
  [[nodiscard]] std::size_t brick_count() const { return std::size_t{size_[0]} * size_[1] * size_[2]; }

  [[nodiscard]] BrickCode code(const std::array<std::int32_t, 3>& g) const {
    return along(0, g[0]) | along(1, g[1]) << 8 | along(2, g[2]) << 16;
  }
  [[nodiscard]] std::uint32_t index(BrickCode code) const {
    return (code & 0xffu) + stride_[1] * (code >> 8 & 0xffu) + stride_[2] * (code >> 16);
  }
  /// Visits the indices of all bricks of a box.
  template <class Visit>
  void for_each(const BrickBox& box, const Visit& visit) const {
    const auto low = [&](int axis) { return BrickBox::along(box.lower, axis); };
    const auto high = [&](int axis) { return BrickBox::along(box.upper, axis); };
    for (std::uint32_t z = low(2); z <= high(2); ++z)
      for (std::uint32_t y = low(1); y <= high(1); ++y) {
        const std::uint32_t first = index(y << 8 | z << 16);
        for (std::uint32_t x = low(0); x <= high(0); ++x) visit(first + x);
      }
  }
  [[nodiscard]] BrickCode code_of(std::uint32_t index) const {
    return index % stride_[1] | index / stride_[1] % size_[1] << 8 | index / stride_[2] << 16;
  }
  [[nodiscard]] bool is_outside(BrickCode code) const {
    for (int axis = 0; axis < 3; ++axis) {
      const std::uint32_t k = BrickBox::along(code, axis);
      if (k == 0 || k + 1 == size(axis)) return true;
    }
    return false;
  }
  /// Grid box of an inner brick, half-open.
  [[nodiscard]] GridBox box(BrickCode code) const;
  /// A point in an inner brick. Bricks in a row along an axis have equal coordinates across it.
  [[nodiscard]] InputComplex::Coordinates centre(BrickCode code) const;
  /// The least double of brick k along an axis, for k in 1 .. size - 1.
  [[nodiscard]] double lower_bound(int axis, std::uint32_t k) const;

 private:
  [[nodiscard]] static constexpr std::size_t at(int i) { return static_cast<std::size_t>(i); }
  [[nodiscard]] std::uint32_t along(int axis, std::int32_t g) const {
    if (g >= upper_[at(axis)]) return size_[at(axis)] - 1;
    const std::int32_t k = (g - lower_[at(axis)]) >> shift_;
    return static_cast<std::uint32_t>(std::max(k, -1) + 1);
  }
  void divide(const GridBox& interest, int shift);
  [[nodiscard]] double centre(int axis, std::uint32_t k) const;
  [[nodiscard]] bool has_centres() const;

  Grid grid_;
  InputComplex::Coordinates corner_{};             ///< of the space of interest
  std::array<std::int32_t, 3> lower_{}, upper_{};  ///< of the space of interest
  int shift_ = 30;
  std::array<std::uint32_t, 3> size_{};
  std::array<std::uint32_t, 3> stride_{};
};

}  // namespace strata
