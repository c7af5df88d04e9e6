#include "core/kernel/grid_rounding.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "core/exact/big_integer.h"
#include "core/exact/two_product.h"

namespace strata {
namespace {

/// x with so many significant bits, ties to even.
double with_bits(double x, int bits) {
  if (bits <= 0 || x == 0) return 0;
  int exponent = 0;
  const double fraction = std::frexp(x, &exponent);  // in [1/2, 1)
  return std::ldexp(std::nearbyint(std::ldexp(fraction, bits)), exponent - bits);
}

/// The double nearest to k n / d, for an integer k, and integers n and d > 0 that are doubles.
double nearest_multiple(double k, double n, double d) {
  const double product = k * n, rest_of_product = product_error(k, n, product);
  const double quotient = product / d;
  constexpr double smallest = 0x1p-900;  // beyond it, remainders are no doubles
  if (std::isfinite(product) && std::abs(quotient) > smallest) {
    const double rest = (quotient_error(product, d, quotient) + rest_of_product) / d;
    const double sum = quotient + rest, lost = rest - (sum - quotient);
    const double below = std::abs(sum) - std::nextafter(std::abs(sum), 0.0);
    if (std::abs(lost) < below / 2 * (1 - 0x1p-20)) return sum;
  }
  return to_nearest_double(Rational(k) * Rational(n) / Rational(d));
}

}  // namespace

GridRounding::GridRounding(const CoordinateGrid& grid) : format_(grid.format) {
  if (grid.step == 0) return;
  numerator_ = to_nearest_double(Rational(numerator(grid.step)));
  denominator_ = to_nearest_double(Rational(denominator(grid.step)));
  if (!(numerator_ > 0) || !std::isfinite(numerator_) || !std::isfinite(denominator_) ||
      to_rational(numerator_) / to_rational(denominator_) != grid.step)
    throw std::invalid_argument("the step of a grid must be positive, and a quotient of integers that are doubles");
}

double GridRounding::to_format(double x) const {
  return format_ == CoordinateGrid::Format::float32 ? static_cast<double>(static_cast<float>(x)) : x;
}

double GridRounding::operator()(double x) const { return (*this)(x, 0); }

double GridRounding::operator()(double x, int bits_less) const {
  if (numerator_ == 0) {
    const int bits = format_ == CoordinateGrid::Format::float32 ? 24 : 53;
    return bits_less == 0 ? to_format(x) : to_format(with_bits(x, bits - bits_less));
  }
  if (bits_less >= most_bits) return 0;
  const double steps = std::ldexp(x * denominator_ / numerator_, -bits_less);
  if (!std::isfinite(steps)) return to_format(x);  // the grid is finer than the format
  return to_format(nearest_multiple(std::ldexp(std::nearbyint(steps), bits_less), numerator_, denominator_));
}

Vertex GridRounding::operator()(const Vertex& v, int bits_less) const {
  return {(*this)(v[0], bits_less), (*this)(v[1], bits_less), (*this)(v[2], bits_less)};
}

bool GridRounding::holds(const Vertex& v) const {
  return std::all_of(v.begin(), v.end(), [&](double x) { return (*this)(x) == x; });
}

double GridRounding::unit_at(double x) const {
  const double size = std::abs(x);
  const double of_format =
      format_ == CoordinateGrid::Format::float32
          ? static_cast<double>(std::nextafter(static_cast<float>(size), std::numeric_limits<float>::infinity())) -
                static_cast<double>(static_cast<float>(size))
          : std::nextafter(size, std::numeric_limits<double>::infinity()) - size;
  return std::max(of_format, numerator_ / denominator_);
}

}  // namespace strata
