#pragma once
#include <array>
#include <cstddef>

#include "core/exact/double_double.h"
#include "core/exact/long_int.h"
#include "strata/rational.h"

namespace strata {

/// A point of the line, the plane or space.
template <int D>
using RationalVector = std::array<Rational, D>;

/// The hyperplane n . x + c = 0 of D-space: a point of the line, a line of the plane, a plane of space. The
/// coefficients are coprime integers and the first component of n that is not zero is positive: equal hyperplanes have
/// equal coefficients. The side that n points to is the plus side.
template <int D>
class Hyperplane {
 public:
  using Coefficients = std::array<Integer, D + 1>;  ///< n, then c

  /// Any multiple of n and c, not zero. Requires n != 0.
  explicit Hyperplane(Coefficients coefficients);
  /// The same, several times as fast; none may be lost.
  explicit Hyperplane(std::array<LongInt, D + 1> coefficients);

  [[nodiscard]] const Coefficients& exact() const { return exact_; }
  /// Within bounds, divided by a power of two: the longest component of n is between 1/2 and 1.
  [[nodiscard]] const std::array<DoubleDouble, D + 1>& fine() const { return fine_; }
  [[nodiscard]] const std::array<Bounded, D + 1>& bounded() const { return bounded_; }
  /// The axis along which n is longest, judged in doubles; n is not zero there.
  [[nodiscard]] std::size_t longest_axis() const;
  [[nodiscard]] std::size_t hash() const;

  friend bool operator==(const Hyperplane& a, const Hyperplane& b) { return a.exact_ == b.exact_; }

 private:
  void approximate();

  Coefficients exact_;
  std::array<DoubleDouble, D + 1> fine_;
  std::array<Bounded, D + 1> bounded_;
};

/// A hyperplane with its given orientation: `is_reversed` when the given normal points to the minus side.
template <int D>
struct OrientedHyperplane {
  Hyperplane<D> hyperplane;
  bool is_reversed = false;
};

/// The hyperplane with these coefficients, and their orientation. Requires n != 0.
template <int D>
[[nodiscard]] OrientedHyperplane<D> oriented_hyperplane(const std::array<Integer, D + 1>& coefficients);
template <int D>
[[nodiscard]] OrientedHyperplane<D> oriented_hyperplane(const std::array<LongInt, D + 1>& coefficients);

/// The same for rational coefficients.
template <int D>
[[nodiscard]] OrientedHyperplane<D> oriented_hyperplane(const std::array<Rational, D + 1>& coefficients);

/// Through three points, positive where they are seen counter-clockwise; they must not be collinear.
[[nodiscard]] OrientedHyperplane<3> plane_through(const RationalVector<3>& p, const RationalVector<3>& q,
                                                  const RationalVector<3>& r);
/// Through two different points, positive on the left of the direction from p to q.
[[nodiscard]] OrientedHyperplane<2> line_through(const RationalVector<2>& p, const RationalVector<2>& q);

/// x_axis = value, positive for larger values.
template <int D>
[[nodiscard]] Hyperplane<D> axis_hyperplane(std::size_t axis, const Rational& value);

extern template class Hyperplane<1>;
extern template class Hyperplane<2>;
extern template class Hyperplane<3>;

}  // namespace strata
