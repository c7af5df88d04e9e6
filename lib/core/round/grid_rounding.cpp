#include "core/round/grid_rounding.h"

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
  constexpr double largest = 0x1p53;
  const double step = to_nearest_double(grid.step);
  const double inverse = step > 0 ? to_nearest_double(Rational(1) / grid.step) : 0;
  if (inverse >= 1 && inverse <= largest && std::floor(inverse) == inverse && to_rational(inverse) * grid.step == 1) {
    inverse_ = inverse;
  } else if (step > 0 && std::isfinite(step) && to_rational(step) == grid.step) {
    step_ = step;
  } else {
    throw std::invalid_argument("the step of a grid must be positive, and a double or the inverse of an integer");
  }
}

double GridRounding::to_format(double x) const {
  return format_ == CoordinateGrid::Format::float32 ? static_cast<double>(static_cast<float>(x)) : x;
}

double GridRounding::operator()(double x) const { return (*this)(x, 0); }

double GridRounding::operator()(double x, int bits_less) const {
  if (step_ == 0 && inverse_ == 0) {
    const int bits = format_ == CoordinateGrid::Format::float32 ? 24 : 53;
    return bits_less == 0 ? to_format(x) : to_format(with_bits(x, bits - bits_less));
  }
  if (bits_less >= most_bits) return 0;
  const double steps = inverse_ != 0 ? x * inverse_ : x / step_;
  const double rounded = std::ldexp(std::nearbyint(std::ldexp(steps, -bits_less)), bits_less);
  if (!std::isfinite(rounded)) return to_format(x);  // the grid is finer than the format
  return to_format(inverse_ != 0 ? rounded / inverse_ : rounded * step_);
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
  return std::max({of_format, step_, inverse_ == 0 ? 0 : 1 / inverse_});
}

}  // namespace strata
