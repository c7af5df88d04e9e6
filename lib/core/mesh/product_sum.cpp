#include "core/mesh/product_sum.h"

#include <bit>

#include "core/exact/big_integer.h"

namespace strata {
namespace {

using Word2 = unsigned __int128;

/// |x| = significand * 2^(exponent - 1075), with exponent >= 1, subnormals included.
struct Parts {
  std::uint64_t significand;
  unsigned exponent;
};

Parts parts(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const auto fraction = bits & ((std::uint64_t{1} << 52) - 1);
  const auto exponent = static_cast<unsigned>(bits >> 52) & 0x7FFU;
  return exponent == 0 ? Parts{fraction, 1} : Parts{fraction | std::uint64_t{1} << 52, exponent};
}

bool is_negative(double x) { return std::bit_cast<std::uint64_t>(x) >> 63 != 0; }

std::uint64_t low_word(Word2 x) { return static_cast<std::uint64_t>(x); }
std::uint64_t high_word(Word2 x) { return static_cast<std::uint64_t>(x >> 64); }

template <class Limbs>
Integer to_integer(const Limbs& limbs) {
  return integer_of_limbs(limbs, false);
}

}  // namespace

/// Adds (w0 + w1 2^64 + w2 2^128) 2^shift, where w2 < 2^63.
void ProductSum::add_shifted(Limbs& sum, unsigned shift, std::uint64_t w0, std::uint64_t w1, std::uint64_t w2) {
  const unsigned bit = shift % 64;
  std::size_t limb = shift / 64;
  const Word2 first = static_cast<Word2>(w0) << bit;
  const Word2 second = static_cast<Word2>(w1) << bit;
  const Word2 third = static_cast<Word2>(w2) << bit;
  const std::uint64_t words[4] = {low_word(first), high_word(first) | low_word(second),
                                  high_word(second) | low_word(third), high_word(third)};
  std::uint64_t carry = 0;
  for (const std::uint64_t word : words) {
    const Word2 total = static_cast<Word2>(sum[limb]) + word + carry;
    sum[limb++] = low_word(total);
    carry = high_word(total);
  }
  for (; carry != 0; ++limb) carry = ++sum[limb] == 0;
}

void ProductSum::add(double a, double b, double c) {
  if (a == 0 || b == 0 || c == 0) return;
  const Parts p = parts(a);
  const Parts q = parts(b);
  const Parts r = parts(c);
  const Word2 ab = static_cast<Word2>(p.significand) * q.significand;
  const Word2 low = static_cast<Word2>(low_word(ab)) * r.significand;
  const Word2 high = static_cast<Word2>(high_word(ab)) * r.significand + high_word(low);
  Limbs& sum = (is_negative(a) != is_negative(b)) != is_negative(c) ? negative_ : positive_;
  add_shifted(sum, p.exponent + q.exponent + r.exponent - 3, low_word(low), low_word(high), high_word(high));
}

void ProductSum::add_determinant(const Vertex& a, const Vertex& b, const Vertex& c) {
  add(a[0], b[1], c[2]);
  add(a[1], b[2], c[0]);
  add(a[2], b[0], c[1]);
  add(-a[0], b[2], c[1]);
  add(-a[1], b[0], c[2]);
  add(-a[2], b[1], c[0]);
}

void ProductSum::add(const ProductSum& other) {
  add(positive_, other.positive_);
  add(negative_, other.negative_);
}

void ProductSum::add(Limbs& sum, const Limbs& term) {
  Word2 carry = 0;
  for (std::size_t i = 0; i < limb_count; ++i) {
    carry += static_cast<Word2>(sum[i]) + term[i];
    sum[i] = low_word(carry);
    carry >>= 64;
  }
}

int ProductSum::sign() const {
  for (std::size_t i = limb_count; i-- > 0;) {
    if (positive_[i] != negative_[i]) return positive_[i] > negative_[i] ? 1 : -1;
  }
  return 0;
}

Rational ProductSum::value() const {
  return Rational(to_integer(positive_) - to_integer(negative_), Integer(1) << 3222);
}

}  // namespace strata
