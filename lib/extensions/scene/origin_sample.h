#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/kernel/input_complex.h"
#include "strata/query.h"

namespace strata {

/// Some of the faces of a scene, in a frame in which its bounding box is centred and extends from -1 to 1 along its
/// longest axis, whatever the scale. For estimates: everything is rounded.
class OriginSample {
 public:
  using Vector = std::array<double, 3>;

  /// Requires a scene with faces.
  explicit OriginSample(const Scene& scene);

  /// Candidates for origins: the middle of the box and of the vertices, a few inside of solids, a few outside.
  [[nodiscard]] std::vector<Vector> places() const;
  /// The cost of a position: the sum, over rays through some faces, of the fourth power of the number of faces that
  /// they meet, because the longest sequences of faces determine the number of layers.
  [[nodiscard]] std::uint64_t cost(const Vector& place) const;
  /// In the scene's coordinates; may overflow.
  [[nodiscard]] Vector in_scene(const Vector& place) const;

  /// 2^exponent is beyond all coordinates of the scene.
  [[nodiscard]] int exponent() const { return exponent_; }
  /// 2^size_exponent is about half the longest side of the bounding box.
  [[nodiscard]] int size_exponent() const;

 private:
  using Face = std::array<Vector, 3>;
  void find_frame(const Scene& scene);
  [[nodiscard]] Vector in_frame(const InputComplex::Coordinates& v) const;
  [[nodiscard]] std::optional<Vector> place_behind(std::size_t face) const;

  std::vector<Face> faces_;
  int exponent_ = 0;  ///< in_frame(v) = (v * 2^-exponent - centre) / size
  Vector centre_{};
  double size_ = 1;
};

}  // namespace strata
