#pragma once
#include <array>
#include <cmath>
#include <cstdint>

#include "core/exact/vector.h"
#include "core/kernel/input_complex.h"

namespace strata {

/// A direction from the origin, its largest coordinate 1 or -1, and the distance of a point along it in units of a
/// scale.
struct ConeRay {
  std::array<float, 3> direction{};
  float distance = 0;
};

/// A face's tetrahedron about a point as origin, in floats. One cache line decides for most walks from the origin
/// whether they cross the face. Bounds: theory.md, "Cones in floats".
class ConeFilter {
 public:
  enum class Answer : std::uint8_t {
    passes,   ///< the walk does not meet the closed face
    crosses,  ///< it crosses the interior of the face
    unknown
  };

  ConeFilter() = default;
  /// Always undecided if the face is seen too thin or too close to edge-on.
  ConeFilter(const InputComplex::Coordinates& origin, const std::array<InputComplex::Coordinates, 3>& corners,
             double scale);

  [[nodiscard]] Answer ask(const ConeRay& ray) const {
    constexpr float bound = 0x1p-20f;
    bool inside = true;
    for (const auto& e : edges_) {
      const float value = dot(e, ray.direction);
      if (value < -bound) return Answer::passes;
      inside = inside && value > bound;
    }
    if (!inside) return Answer::unknown;
    const float depth = ray.distance * dot(plane_, ray.direction), error = bound * ray.distance * size_;
    if (depth - error > 1) return Answer::crosses;
    return depth + error < 1 ? Answer::passes : Answer::unknown;
  }

 private:
  std::array<std::array<float, 3>, 3>
      edges_{};                   ///< unit normals of the planes through the origin and the edges, inwards
  std::array<float, 3> plane_{};  ///< at distance 1 / (plane . direction) rays meet the face's plane
  float size_ = 0;                ///< sum of the plane's absolute coordinates
};

/// The walk from the origin to q. All zero, for which every cone is undecided, where doubles overflow or q is the
/// origin.
[[nodiscard]] inline ConeRay cone_ray(const InputComplex::Coordinates& origin, const InputComplex::Coordinates& q,
                                      double scale) {
  const double x = q[0] - origin[0], y = q[1] - origin[1], z = q[2] - origin[2];
  const double largest = std::fmax(std::abs(x), std::fmax(std::abs(y), std::abs(z)));
  const double distance = largest / scale;
  if (!(distance > 0x1p-100 && distance < 0x1p100)) return {};
  const double factor = 1 / largest;
  return {{static_cast<float>(x * factor), static_cast<float>(y * factor), static_cast<float>(z * factor)},
          static_cast<float>(distance)};
}

}  // namespace strata
