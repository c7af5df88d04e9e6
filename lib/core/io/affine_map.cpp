#include "core/io/affine_map.h"

#include <cmath>

#include "core/exact/two_product.h"
#include "core/io/input.h"

namespace strata::io {
namespace {

/// A sum in twice the precision of doubles.
struct LongSum {
  double high = 0, low = 0;

  void add(double x) {
    const double sum = high + x, back = sum - high;
    low += (high - (sum - back)) + (x - back);
    high = sum;
  }
  void add_product(double a, double b) {
    const double product = a * b;
    add(product);
    low += product_error(a, b, product);
  }
};

Rational determinant(const ExactMap& map) {
  const auto& m = map.rows;
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

struct TwoDoubles {
  double high, low;
};

/// The nearest sum of two doubles. The low one is zero where it is far smaller, which bounds the length of numbers.
TwoDoubles nearest_sum(const Rational& x) {
  constexpr double far = 0x1p-120;
  const double high = to_nearest_double(x);
  if (!std::isfinite(high)) fail("a transform has a number beyond the range of doubles");
  const double low = to_nearest_double(x - Rational(high));
  return {high, std::abs(low) < far * std::abs(high) ? 0 : low};
}

}  // namespace

ExactMap ExactMap::identity() {
  ExactMap map;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 4; ++j) map.rows[i][j] = i == j ? 1 : 0;
  return map;
}

bool ExactMap::is_identity() const {
  const ExactMap one = identity();
  return rows == one.rows;
}

ExactMap product(const ExactMap& outer, const ExactMap& inner) {
  if (inner.is_identity()) return outer;
  ExactMap map;
  map.is_rounded = outer.is_rounded || inner.is_rounded;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 4; ++j) {
      Rational sum = j == 3 ? outer.rows[i][3] : Rational(0);
      for (std::size_t k = 0; k < 3; ++k) sum += outer.rows[i][k] * inner.rows[k][j];
      const TwoDoubles nearest = nearest_sum(sum);
      map.rows[i][j] = Rational(nearest.high) + Rational(nearest.low);
      map.is_rounded |= map.rows[i][j] != sum;
    }
  return map;
}

PointMap::PointMap(const ExactMap& map) : is_identity_(map.is_identity()), is_rounded_(map.is_rounded) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 4; ++j) {
      const TwoDoubles nearest = nearest_sum(map.rows[i][j]);
      high_[i][j] = nearest.high;
      low_[i][j] = nearest.low;
      is_rounded_ |= Rational(nearest.high) + Rational(nearest.low) != map.rows[i][j];
    }
  const Rational d = determinant(map);
  mirrors_ = d < 0;
  const double sign = mirrors_ ? -1 : 1;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      cofactors_[i][j] = sign * (high_[i1][j1] * high_[i2][j2] - high_[i1][j2] * high_[i2][j1]);
    }
}

Vertex PointMap::operator()(const Vertex& p, bool& is_rounded) const {
  Vertex image{};
  for (std::size_t i = 0; i < 3; ++i) {
    LongSum sum;
    sum.add(high_[i][3]);
    for (std::size_t j = 0; j < 3; ++j) sum.add_product(high_[i][j], p[j]);
    sum.low += low_[i][3];
    for (std::size_t j = 0; j < 3; ++j) sum.low += low_[i][j] * p[j];
    const double rest = sum.low;
    sum.low = 0;
    sum.add(rest);
    image[i] = sum.high;
    is_rounded |= sum.low != 0;
  }
  is_rounded |= is_rounded_;
  return image;
}

Vertex PointMap::normal(const Vertex& n) const {
  Vertex image{};
  double square = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) image[i] += cofactors_[i][j] * n[j];
    square += image[i] * image[i];
  }
  const double length = std::sqrt(square);
  if (!(length > 0) || !std::isfinite(length)) return n;
  for (double& x : image) x /= length;
  return image;
}

}  // namespace strata::io
