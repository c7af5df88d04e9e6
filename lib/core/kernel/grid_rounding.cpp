#include "core/kernel/grid_rounding.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "core/exact/big_integer.h"

namespace strata {
namespace {

/// x with so many significant bits, ties to even.
double with_bits(double x, int bits) {
  if (bits <= 0 || x == 0) return 0;
  int exponent = 0;
  const double fraction = std::frexp(x, &exponent);  // in [1/2, 1)
  return std::ldexp(std::nearbyint(std::ldexp(fraction, bits)), exponent - bits);
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
  const double rounded = std::ldexp(std::nearbyint(steps), bits_less) * numerator_ / denominator_;
  return to_format(std::isfinite(rounded) ? rounded : x);  // beyond that, the grid is finer than the format
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
