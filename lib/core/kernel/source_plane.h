#pragma once
#include <array>
#include <optional>

#include "core/exact/double_double.h"
#include "core/exact/sign.h"
#include "core/kernel/filters.h"
#include "core/kernel/homogeneous.h"
#include "strata/rational.h"

namespace strata {

/// The oriented plane of a face as it was first given. All parts of the face keep it, however small they are and
/// whatever their vertices are. So constructions from planes stay of bounded size through any number of steps.
class SourcePlane {
 public:
  /// Through three points in units of 2^unit; `at` is the first of them. Requires that they are not collinear.
  SourcePlane(const HPlane<Integer>& plane, int unit, const RealPoint<DoubleDouble>& at);

  /// The same plane with the opposite orientation.
  [[nodiscard]] SourcePlane reversed() const;

  /// a x + b y + c z + d, positive on the outer side, in integers that are not all even.
  [[nodiscard]] const HPlane<Integer>& exact() const { return exact_; }
  /// A point of the plane, within bounds.
  [[nodiscard]] const RealPoint<DoubleDouble>& at() const { return at_; }
  /// The outward normal, within bounds; its longest component is between 1/2 and 1.
  [[nodiscard]] const RealPoint<DoubleDouble>& normal() const { return normal_; }
  [[nodiscard]] const BoundedPoint& bounded_at() const { return bounded_at_; }
  [[nodiscard]] const BoundedPoint& bounded_normal() const { return bounded_normal_; }

 private:
  HPlane<Integer> exact_;
  RealPoint<DoubleDouble> at_, normal_;
  BoundedPoint bounded_at_, bounded_normal_;
};

/// True when the normals of two planes are parallel, of whatever direction.
[[nodiscard]] bool are_parallel(const SourcePlane& p, const SourcePlane& q);
/// True when parallel planes have the same orientation.
[[nodiscard]] bool have_same_direction(const SourcePlane& p, const SourcePlane& q);
/// True when three planes meet in exactly one point.
[[nodiscard]] bool are_independent(const SourcePlane& p, const SourcePlane& q, const SourcePlane& r);

/// The intersection point of three independent planes. Its integers have the size of determinants of the coefficients
/// of the planes, whatever the history of the planes is.
struct MeetOfPlanes {
  std::array<const SourcePlane*, 3> planes{};
  RealPoint<DoubleDouble> at;  ///< values are the nearest doubles

  [[nodiscard]] HPoint<Integer> exact() const;
};

/// Computes the coordinates: in double-doubles, and where these do not determine the nearest doubles, from the exact
/// position.
[[nodiscard]] MeetOfPlanes meet_of(const SourcePlane& p, const SourcePlane& q, const SourcePlane& r);

/// The position as doubles, if it is exactly that.
[[nodiscard]] std::optional<std::array<double, 3>> exact_doubles(const MeetOfPlanes& meet);

}  // namespace strata
