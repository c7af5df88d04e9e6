#pragma once
/// Affine maps with rational coefficients.
#include <array>
#include <span>

#include "strata/mesh.h"
#include "strata/monitor.h"
#include "strata/plane.h"
#include "strata/rational.h"

namespace strata {

/// A quaternion w + x i + y j + z k that is not zero, as a rotation about the axis (x, y, z) by an angle a with
/// tan(a / 2) = |(x, y, z)| / w; counter-clockwise as seen from the end of the axis. Its length does not matter.
/// Rational entries give a rotation with rational coefficients, and these come close to every rotation: (w, x, y, z)
/// from any rotation, in doubles, is a rational quaternion. Source: Euler's parameters, Hamilton 1844.
struct Quaternion {
  Rational w = 1, x, y, z;

  /// About an axis, by the angle a with tan(a / 2) = tangent * |axis|: (1, tangent * axis). Every rotation by less than
  /// 180 degrees about an axis of length 1 has its tangent.
  [[nodiscard]] static Quaternion of_tangent(const RationalPoint& axis, const Rational& tangent);
  /// About an axis of any length, by an angle in degrees: entries are doubles within a few ulps of those of that
  /// rotation, so the angle is within 1e-15 of a full turn and the axis within 1e-15 of its length. Quarter and half
  /// turns about coordinate axes are exact. Throws std::invalid_argument for an axis 0 and for what is not finite.
  [[nodiscard]] static Quaternion of_angle(const std::array<double, 3>& axis, double degrees);

  friend bool operator==(const Quaternion&, const Quaternion&) = default;
};

/// An invertible affine map of space with rational coefficients: p -> M p + t. An immutable value: copies are
/// independent, reading is thread-safe. All arithmetic is exact; coefficients of products grow with the number of
/// factors.
class Transform {
 public:
  using Row = std::array<Rational, 4>;  ///< (M_i0, M_i1, M_i2, t_i)

  Transform();  ///< the identity
  /// Throws std::invalid_argument if M has determinant 0.
  explicit Transform(std::array<Row, 3> rows);
  /// Of a 4 x 4 matrix in doubles, which are taken as they are, row after row; the last row must be a multiple of
  /// (0, 0, 0, 1), by which all others are divided. Throws std::invalid_argument for one that is not, for what is not
  /// finite and for determinant 0.
  [[nodiscard]] static Transform from_matrix(std::span<const double, 16> rows);

  [[nodiscard]] static Transform translation(const RationalPoint& by);
  /// About the origin, by a factor per axis; negative ones mirror. Throws std::invalid_argument for a factor 0.
  [[nodiscard]] static Transform scaling(const RationalPoint& factors);
  /// In the plane through the origin with this normal. Throws std::invalid_argument for a normal 0.
  [[nodiscard]] static Transform mirror(const RationalPoint& normal);
  /// In any plane. Throws std::invalid_argument for a normal 0.
  [[nodiscard]] static Transform mirror(const Plane& plane);
  /// About an axis through the origin. M is exactly orthogonal with determinant 1: lengths, angles and volumes stay.
  /// Throws std::invalid_argument for a quaternion 0.
  [[nodiscard]] static Transform rotation(const Quaternion& by);

  [[nodiscard]] const std::array<Row, 3>& rows() const { return rows_; }
  [[nodiscard]] RationalPoint operator()(const RationalPoint& p) const;  ///< the image of a point
  [[nodiscard]] Rational determinant() const;                            ///< of M; negative for maps that mirror
  [[nodiscard]] Transform inverse() const;                               ///< inverse() * *this is the identity
  [[nodiscard]] bool is_identity() const { return *this == Transform(); }

  /// First b, then a: (a * b)(p) = a(b(p)).
  friend Transform operator*(const Transform& a, const Transform& b);
  friend bool operator==(const Transform&, const Transform&) = default;

 private:
  std::array<Row, 3> rows_;
};

/// How the coordinates of transformed vertices are kept.
enum class Placement {
  exact,   ///< as rationals, where they are not doubles
  rounded  ///< each coordinate to the nearest double, ties to even; this may fold thin solids over
};

/// The image of a mesh, vertex by vertex and triangle by triangle, in the same order. Triangles are turned round where
/// the map mirrors, so that outside stays outside. Under the identity the mesh comes back as it is, whatever the
/// placement. O(size), in parallel; the result does not depend on the number of threads. Throws std::overflow_error
/// where a coordinate is beyond all doubles.
[[nodiscard]] ExactMesh transform(const ExactMesh& mesh, const Transform& map, Placement placement,
                                  const Monitor& monitor = {});

}  // namespace strata
