#pragma once
#include <array>
#include <bit>
#include <cstdint>

namespace strata {

/// Both halves of a product: every bit of a and b reaches the low bits and the high ones.
inline std::uint64_t folded_product(std::uint64_t a, std::uint64_t b) {
  const auto p = static_cast<unsigned __int128>(a) * b;
  return static_cast<std::uint64_t>(p) ^ static_cast<std::uint64_t>(p >> 64);
}

/// 64 bits, all of them fit to choose by. Equal points have equal hashes: adding 0 turns -0 into 0.
inline std::uint64_t hash_of(const std::array<double, 3>& p) {
  const auto bits = [&](std::size_t i) { return std::bit_cast<std::uint64_t>(p[i] + 0.0); };
  const std::uint64_t xy = folded_product(bits(0) ^ 0x9e3779b97f4a7c15u, bits(1) ^ 0xd6e8feb86659fd93u);
  return folded_product(xy ^ bits(2), 0xa0761d6478bd642fu);
}

inline std::uint64_t hash_of(const std::array<float, 3>& p) {
  const auto bits = [&](std::size_t i) { return std::uint64_t{std::bit_cast<std::uint32_t>(p[i] + 0.0F)}; };
  const std::uint64_t xy = bits(0) | bits(1) << 32, z = bits(2) * 0xa0761d6478bd642fu;
  return folded_product(xy ^ 0x9e3779b97f4a7c15u, z ^ 0xd6e8feb86659fd93u);
}

inline std::uint64_t hash_of(const std::array<double, 2>& p) {
  const auto bits = [&](std::size_t i) { return std::bit_cast<std::uint64_t>(p[i] + 0.0); };
  return folded_product(folded_product(bits(0) ^ 0x9e3779b97f4a7c15u, bits(1) ^ 0xd6e8feb86659fd93u),
                        0xa0761d6478bd642fu);
}

/// Equality without branches: which coordinate differs is a matter of chance.
template <class Scalar>
bool are_equal(const std::array<Scalar, 3>& p, const std::array<Scalar, 3>& q) {
  // No branches: `&` of integers.
  return (static_cast<int>(p[0] == q[0]) & static_cast<int>(p[1] == q[1]) & static_cast<int>(p[2] == q[2])) != 0;
}

}  // namespace strata
