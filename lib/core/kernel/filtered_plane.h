#pragma once
#include <cmath>

#include "core/kernel/filters.h"
#include "core/kernel/input_complex.h"

namespace strata {

/// The plane through three points, in doubles, prepared for many tests of sides. A default plane is uncertain about all
/// points.
///
/// Evaluates orient3d(a, b, c, p) with Shewchuk's bound for the determinant of differences, and 2^-1000 of the last
/// factors for products that underflow; core/kernel/theory.md, "Filters".
class FilteredPlane {
 public:
  FilteredPlane() = default;
  FilteredPlane(const InputComplex::Coordinates& a, const InputComplex::Coordinates& b,
                const InputComplex::Coordinates& c)
      : FilteredPlane(a, {b[0] - a[0], b[1] - a[1], b[2] - a[2]}, {c[0] - a[0], c[1] - a[1], c[2] - a[2]}, Spanned()) {}

  /// The plane through a and b that is parallel to a direction: the side of p is the sign of ((b - a) x d) . (p - a).
  static FilteredPlane along(const InputComplex::Coordinates& a, const InputComplex::Coordinates& b,
                             const InputComplex::Coordinates& direction) {
    return {a, {b[0] - a[0], b[1] - a[1], b[2] - a[2]}, direction, Spanned()};
  }

  /// 1 above (on the outer side), -1 below, 0 when doubles do not decide.
  [[nodiscard]] int side(const InputComplex::Coordinates& p) const { return side(p, 0); }

  /// The same for a point within bounds. The plane's linear form changes by at most the error of the point times the
  /// normal, which `magnitude_` bounds from above up to rounding and underflow.
  [[nodiscard]] int side_within(const BoundedPoint& p) const {
    const double off = magnitude_[0] * p[0].error + magnitude_[1] * p[1].error + magnitude_[2] * p[2].error;
    const double lost = 0x1p-1000 * (p[0].error + p[1].error + p[2].error);
    return side({p[0].value, p[1].value, p[2].value}, (off + lost) * Bounded::slack);
  }

  /// The axis along which the normal is longest, in doubles.
  [[nodiscard]] std::size_t widest_axis() const {
    std::size_t axis = 0;
    for (std::size_t i = 1; i < 3; ++i)
      if (std::abs(normal_[i]) > std::abs(normal_[axis])) axis = i;
    return axis;
  }

 private:
  struct Spanned {};
  FilteredPlane(const InputComplex::Coordinates& a, const InputComplex::Coordinates& u,
                const InputComplex::Coordinates& v, Spanned)
      : a_(a) {
    const double yz = u[1] * v[2], zy = u[2] * v[1], zx = u[2] * v[0], xz = u[0] * v[2], xy = u[0] * v[1],
                 yx = u[1] * v[0];
    normal_ = {yz - zy, zx - xz, xy - yx};
    magnitude_ = {std::abs(yz) + std::abs(zy), std::abs(zx) + std::abs(xz), std::abs(xy) + std::abs(yx)};
  }
  [[nodiscard]] int side(const InputComplex::Coordinates& p, double off) const {
    const double wx = p[0] - a_[0], wy = p[1] - a_[1], wz = p[2] - a_[2];
    const double value = normal_[0] * wx + normal_[1] * wy + normal_[2] * wz;
    const double size = magnitude_[0] * std::abs(wx) + magnitude_[1] * std::abs(wy) + magnitude_[2] * std::abs(wz);
    constexpr double factor = (7 + 56 * 0x1p-53) * 0x1p-53;
    const double bound = factor * size + 0x1p-1000 * (1 + std::abs(wx) + std::abs(wy) + std::abs(wz)) + off;
    return static_cast<int>(value > bound) - static_cast<int>(-value > bound);
  }

  InputComplex::Coordinates a_{}, normal_{}, magnitude_{};
};

}  // namespace strata
