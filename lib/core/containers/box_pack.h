#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/kernel/box.h"

namespace strata {

/// Eight boxes, coordinate by coordinate. Empty ones are met by nothing.
struct BoxPack {
  static constexpr std::size_t width = 8;
  std::array<std::array<double, width>, 3> lower, upper;

  void set_empty(std::size_t k) { set(k, Box()); }
  void set(std::size_t k, const Box& box);
  [[nodiscard]] Box box(std::size_t k) const;
  [[nodiscard]] Box bounds() const;
};

/// Up to three keys of each of eight items, key by key.
struct KeyPack {
  static constexpr std::uint32_t no_key = 0xffffffffu;  ///< in common with nothing
  std::array<std::array<std::uint32_t, BoxPack::width>, 3> key;
};

/// Tests of eight boxes at once, in the instructions that a processor has. All answers are the same.
struct BoxPackTests {
  using Masks = std::array<std::uint32_t, BoxPack::width>;

  /// Bit k: box k has a point in common with this one.
  std::uint32_t (*overlapping)(const BoxPack& pack, const Box& box);
  /// Bit j of mask i: box i of a and box j of b have a point in common, and no key. Only for those i whose box meets
  /// the bounds of b, which are the bits of the result.
  std::uint32_t (*pairs)(const BoxPack& a, const KeyPack& keys_of_a, const BoxPack& b, const KeyPack& keys_of_b,
                         const Box& bounds_of_b, Masks& masks);

  /// All that this processor can do, the fastest one last.
  [[nodiscard]] static std::span<const BoxPackTests> available();
  [[nodiscard]] static const BoxPackTests& fastest() { return available().back(); }
};

inline void BoxPack::set(std::size_t k, const Box& box) {
  for (std::size_t i = 0; i < 3; ++i) {
    lower[i][k] = box.lower[i];
    upper[i][k] = box.upper[i];
  }
}

inline Box BoxPack::box(std::size_t k) const {
  return {{lower[0][k], lower[1][k], lower[2][k]}, {upper[0][k], upper[1][k], upper[2][k]}};
}

inline Box BoxPack::bounds() const {
  Box all;
  for (std::size_t k = 0; k < width; ++k) all.include(box(k));
  return all;
}

}  // namespace strata
