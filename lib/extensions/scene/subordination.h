#pragma once
#include <array>
#include <cstdint>

#include "extensions/scene/sight.h"

namespace strata {

/// How two tetrahedra, each of the origin and a triangle, overlap: which of them rays from the origin meet first.
///
/// | value     | on rays                                                                                |
/// |-----------|----------------------------------------------------------------------------------------|
/// | apart     | none meets both                                                                        |
/// | touching  | some meet both, but only in the triangles' rims                                        |
/// | before    | of those that meet both inside, all meet the first triangle first, or both in one point |
/// | behind    | the same the other way round                                                           |
/// | crossing  | some meet the first triangle first, some the other                                     |
/// | coplanar  | some meet both inside, all of them in one point                                        |
enum class TetrahedraOverlap : std::uint8_t { apart, touching, before, behind, crossing, coplanar };

/// A triangle with its orientation as seen from the origin, which is not zero: flat tetrahedra contain no rays.
struct SeenTriangle {
  Corners corners;
  Sign orientation;
};

/// Law: exchanging the triangles exchanges before and behind. Exact; at most some fifty signs, few where the triangles
/// are apart.
[[nodiscard]] TetrahedraOverlap overlap_of(const Sight& sight, const SeenTriangle& s, const SeenTriangle& t);

/// The edges of a triangle, the first from corner 0 to corner 1.
using SightLines = std::array<SightLine, 3>;

/// The overlaps of one tetrahedron with many.
class Subordination {
 public:
  Subordination(const Sight& sight, const SeenTriangle& s);

  /// As `overlap_of`, but distinguishes apart and touching only where that costs nothing.
  [[nodiscard]] TetrahedraOverlap to(const SeenTriangle& t) const;

 private:
  const Sight& sight_;
  SeenTriangle s_;
  SightLines lines_;
};

}  // namespace strata
