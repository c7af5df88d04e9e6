#include "core/mesh/lattice_sum.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/exact/big_integer.h"

namespace strata {
namespace {

using Wide = __int128;
using Unsigned = unsigned __int128;
using LatticePoint = std::array<std::int64_t, 3>;

/// p / unit, truncated to integers, which are below 2^61. Returns whether nothing was lost.
bool to_lattice(const Vertex& p, double scale, double unit, LatticePoint& integers) {
  bool is_exact = true;
  for (std::size_t i = 0; i < 3; ++i) {
    integers[i] = static_cast<std::int64_t>(p[i] * scale);
    is_exact &= static_cast<double>(integers[i]) * unit == p[i];
  }
  return is_exact;
}

/// high 2^64 + low.
struct Product {
  Wide high, low;
};

/// Requires a product of the lower half of p and q below 2^127; the arithmetic of its parts is modulo 2^128.
Product product(Wide p, std::int64_t q) {
  const auto bottom = static_cast<Unsigned>(static_cast<std::uint64_t>(p));
  const Unsigned correction = q < 0 ? bottom << 64 : 0;
  return {(p >> 64) * q, static_cast<Wide>(bottom * static_cast<std::uint64_t>(q) - correction)};
}

std::array<std::uint64_t, 4> limbs_of(const Product& p) {
  const Wide high = p.high + (p.low >> 64);
  return {static_cast<std::uint64_t>(p.low), static_cast<std::uint64_t>(high), static_cast<std::uint64_t>(high >> 64),
          static_cast<std::uint64_t>(high >> 127)};
}

}  // namespace

// The largest coordinate is below 2^(e + 1), e its exponent, so it is below 2^61 units of 2^(e - 60).
LatticeSum::LatticeSum(double largest)
    : exponent_(largest == 0 ? 0 : std::clamp(std::ilogb(largest) - 60, -1022, 1022)),
      unit_(std::ldexp(1.0, exponent_)),
      scale_(std::ldexp(1.0, -exponent_)) {}

// Products of two coordinates are below 2^122, their differences below 2^123; three products with a coordinate below
// 2^186. Of each of the latter `high` is below 2^120 and `low` below 2^125.
bool LatticeSum::add_determinant(const Vertex& a, const Vertex& b, const Vertex& c) {
  LatticePoint p, q, r;
  if (!to_lattice(a, scale_, unit_, p) || !to_lattice(b, scale_, unit_, q) || !to_lattice(c, scale_, unit_, r))
    return false;
  const auto minor = [&](std::size_t i, std::size_t j) {
    return static_cast<Wide>(q[i]) * r[j] - static_cast<Wide>(q[j]) * r[i];
  };
  const Product x = product(minor(1, 2), p[0]), y = product(minor(2, 0), p[1]), z = product(minor(0, 1), p[2]);
  add(limbs_of({x.high + y.high + z.high, x.low + y.low + z.low}));
  return true;
}

Vertex LatticeSum::truncated(const Vertex& p) const {
  LatticePoint integers;
  to_lattice(p, scale_, unit_, integers);
  return {static_cast<double>(integers[0]) * unit_, static_cast<double>(integers[1]) * unit_,
          static_cast<double>(integers[2]) * unit_};
}

// The sum of heights is below 3 * 2^61, differences are below 2^62, their products below 2^124, and twice the area
// below 2^125. Of the product `high` is below 2^124 and `low` below 3 * 2^125.
bool LatticeSum::add_prism(const Vertex& a, const Vertex& b, const Vertex& c) {
  LatticePoint p, q, r;
  if (!to_lattice(a, scale_, unit_, p) || !to_lattice(b, scale_, unit_, q) || !to_lattice(c, scale_, unit_, r))
    return false;
  const Wide area = static_cast<Wide>(q[0] - p[0]) * (r[1] - p[1]) - static_cast<Wide>(q[1] - p[1]) * (r[0] - p[0]);
  add(limbs_of(product(area, p[2] + q[2] + r[2])));
  return true;
}

void LatticeSum::add(const Limbs& other) {
  Unsigned carry = 0;
  for (std::size_t i = 0; i < sum_.size(); ++i) {
    carry += static_cast<Unsigned>(sum_[i]) + other[i];
    sum_[i] = static_cast<std::uint64_t>(carry);
    carry >>= 64;
  }
}

Rational LatticeSum::value() const {
  const bool is_negative = sum_.back() >> 63 != 0;
  Limbs magnitude = sum_;
  if (is_negative) {
    std::uint64_t carry = 1;
    for (std::uint64_t& limb : magnitude) {
      limb = ~limb + carry;
      carry = static_cast<std::uint64_t>(carry != 0 && limb == 0);
    }
  }
  const Integer sum = integer_of_limbs(magnitude, is_negative);
  const std::size_t power = 3 * static_cast<std::size_t>(std::abs(exponent_));
  return exponent_ < 0 ? Rational(sum, Integer(1) << power) : Rational(Integer(sum << power));
}

double largest_coordinate(std::span<const Vertex> vertices) {
  using Range = tbb::blocked_range<std::size_t>;
  return tbb::parallel_reduce(
      Range(0, vertices.size(), 4096), 0.0,
      [&](const Range& range, double largest) {
        Vertex of_axis{};  // the three do not wait for each other
        for (std::size_t v = range.begin(); v != range.end(); ++v)
          for (std::size_t i = 0; i < 3; ++i) {
            const double x = std::abs(vertices[v][i]);
            of_axis[i] = x > of_axis[i] && x <= std::numeric_limits<double>::max() ? x : of_axis[i];
          }
        return std::max({largest, of_axis[0], of_axis[1], of_axis[2]});
      },
      [](double a, double b) { return std::max(a, b); });
}

}  // namespace strata
