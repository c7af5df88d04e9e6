#pragma once
#include <array>
#include <cstdint>

#include "strata/contact/parts.h"
#include "strata/exact/rational.h"

namespace strata::contact {

/// A vertex, edge or face of a part, by vertex numbers of its mesh in increasing order; the unused ones are 0.
struct MeshFeature {
  enum class Kind : std::uint8_t { vertex, edge, face };
  Kind kind = Kind::vertex;
  std::array<std::uint32_t, 3> vertices{};

  friend auto operator<=>(const MeshFeature&, const MeshFeature&) = default;
};

/// vertex, edge, face.
[[nodiscard]] constexpr const char* name(MeshFeature::Kind kind) {
  constexpr std::array names{"vertex", "edge", "face"};
  return names[static_cast<std::size_t>(kind)];
}

/// The least distance of two parts, exactly, and a pair of points that have it.
///
/// Of all pairs of closest points it is the one whose point on a is lexicographically least, and with it the one on b:
/// it depends on the point sets only. A feature is the lowest-dimensional one of the mesh that has the point inside.
struct Nearest {
  Rational squared;     ///< exact, positive
  double distance = 0;  ///< its root, within an ulp; infinite beyond doubles
  RationalPoint on_a, on_b;
  MeshFeature feature_a, feature_b;
};

/// Requires two parts that are apart and not empty. Branch and bound over pairs of boxes with bounds in doubles; what
/// these leave is decided in rationals. O(n log n) to make the trees, and the pairs of faces that are as near as the
/// nearest up to rounding. theory.md, section 7.
[[nodiscard]] Nearest nearest_of(const Parts& parts, std::uint32_t a, std::uint32_t b);

}  // namespace strata::contact
