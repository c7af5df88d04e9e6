#pragma once
/// Affine maps with rational coefficients.
#include <array>
#include <span>

#include "strata/mesh.h"
#include "strata/rational.h"

namespace strata {

/// An invertible affine map of space with rational coefficients: p -> M p + t. An immutable value.
class Transform {
 public:
  using Row = std::array<Rational, 4>;  ///< (M_i0, M_i1, M_i2, t_i)

  Transform();  ///< the identity
  /// Throws std::invalid_argument if M has determinant 0.
  explicit Transform(std::array<Row, 3> rows);
  /// Of doubles, which are taken as they are, row after row; the fourth row must be a multiple of (0, 0, 0, 1).
  /// Throws std::invalid_argument for one that is not, for what is not finite and for determinant 0.
  static Transform from_matrix(std::span<const double, 16> rows);

  static Transform translation(const RationalPoint& by);
  static Transform scaling(const RationalPoint& factors);  ///< about the origin; throws for a factor 0
  /// About the plane through the origin with this normal; throws for a normal 0.
  static Transform mirror(const RationalPoint& normal);

  [[nodiscard]] const std::array<Row, 3>& rows() const { return rows_; }
  [[nodiscard]] RationalPoint operator()(const RationalPoint& p) const;
  [[nodiscard]] Rational determinant() const;
  [[nodiscard]] bool is_identity() const { return *this == Transform(); }

  /// First b, then a.
  friend Transform operator*(const Transform& a, const Transform& b);
  friend bool operator==(const Transform&, const Transform&) = default;

 private:
  std::array<Row, 3> rows_;
};

/// How coordinates of transformed vertices are kept.
enum class Placement {
  exact,   ///< as rationals, where doubles do not do
  rounded  ///< each coordinate to the nearest double; this may fold thin solids over
};

/// The image of a mesh. Triangles are turned where the map mirrors, so outside stays outside. O(size).
/// Throws std::overflow_error where a coordinate is beyond all doubles.
[[nodiscard]] ExactMesh transform(const ExactMesh& mesh, const Transform& map, Placement placement);

}  // namespace strata
