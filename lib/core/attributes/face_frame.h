#pragma once
#include <array>
#include <cstdint>
#include <optional>

#include "core/attributes/mesh_points.h"
#include "core/exact/sign.h"

namespace strata {

/// One face as a frame for places in it: barycentric coordinates, in double-doubles and exactly. The face is projected
/// along the axis in which its normal is longest. theory.md, "Places".
class FaceFrame {
 public:
  using Weights = std::array<Rational, 3>;

  FaceFrame(const MeshPoints& points, const Triangle& corners);

  /// A place in the face: the weights of its corners, which add up to 1. Refers to the frame.
  class Place {
   public:
    Place(const FaceFrame& frame, const MeshPoints& points, std::uint32_t vertex);

    /// False: the point is off the face, as projected, or the face has no area. Then `clamped` counts.
    [[nodiscard]] bool is_inside() const { return is_inside_; }
    /// The weights of the second and the third corner, of a point inside. The error may be infinite or NaN.
    [[nodiscard]] const DoubleDouble& second() const { return second_; }
    [[nodiscard]] const DoubleDouble& third() const { return third_; }
    /// The weights, of a point inside.
    [[nodiscard]] const Weights& exact() const;
    /// The weights of the nearest point of the sides, of a point that is not inside.
    [[nodiscard]] const std::array<double, 3>& clamped() const { return clamped_; }
    /// The corner to which the distance is least, the first of several.
    [[nodiscard]] std::size_t nearest_corner() const;

   private:
    void clamp();

    const FaceFrame& frame_;
    const MeshPoints& points_;
    std::uint32_t vertex_;
    std::array<DoubleDouble, 3> fine_;
    bool is_inside_ = true;
    DoubleDouble second_, third_;
    mutable std::optional<Weights> exact_;
    std::array<double, 3> clamped_{};
  };

  /// True when a triangle in the plane of the face has the opposite orientation, as projected.
  [[nodiscard]] bool is_opposite(const MeshPoints& points, const Triangle& triangle) const;

  /// The outward unit normal to a few units in the last place of its length; (0, 0, 0) for a face without area.
  [[nodiscard]] std::array<double, 3> unit_normal() const;

 private:
  using Fine = std::array<DoubleDouble, 3>;

  /// Twice the area of a projected triangle, with its sign; zero with an infinite error if it is not known.
  [[nodiscard]] DoubleDouble area(const Fine& p, const Fine& q, const Fine& r) const;
  [[nodiscard]] bool has_exact_normal(std::array<double, 3>& normal) const;
  [[nodiscard]] const std::array<RationalPoint, 3>& exact_corners() const;
  [[nodiscard]] Rational exact_area(const RationalPoint& p, const RationalPoint& q, const RationalPoint& r) const;
  /// The weights of a point; none if the face has no area.
  [[nodiscard]] std::optional<Weights> exact_weights(const RationalPoint& p) const;

  const MeshPoints& points_;
  Triangle corners_;
  std::array<Fine, 3> fine_;
  std::size_t u_ = 0, v_ = 1;  ///< the axes that are left after the projection
  DoubleDouble area_;
  bool has_certain_area_ = false;
  mutable std::optional<std::array<RationalPoint, 3>> exact_;
};

}  // namespace strata
