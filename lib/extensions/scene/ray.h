#pragma once
#include <cstdint>

#include "strata/mesh.h"
#include "strata/rational.h"

namespace strata {

/// The points from + t * direction, t >= 0. The direction is any finite vector but zero; its length is the unit of t.
struct Ray {
  Vertex from{}, direction{};
};

/// The points from + t * (to - from), 0 <= t <= 1, with the exact difference; both ends may be one point.
struct Segment {
  Vertex from{}, to{};
};

/// What a ray does to a solid at an event, by what lies just before and just after it:
///
/// | value    | before                | after                                                                   |
/// |----------|-----------------------|-------------------------------------------------------------------------|
/// | entering | out, or on            | in                                                                      |
/// | leaving  | in, or on             | out                                                                     |
/// | touching | out                   | out                                                                     |
/// | touching | in                    | in                                                                      |
/// | along    | any                   | on: the ray runs within a face or along an edge                         |
///
/// In a solid that covers places more than once, a greater winding number after the event counts as entering, a smaller
/// one as leaving, and after a stretch on the surface any winding number but zero as in.
enum class Passage : std::uint8_t { entering, leaving, touching, along };

/// An event of a ray and a solid.
struct RayHit {
  Rational t;              ///< along the direction
  RationalPoint place;     ///< from + t * direction
  Vertex rounded{};        ///< the nearest doubles
  std::uint32_t face = 0;  ///< of the scene: the solid's lowest face at the place
  std::uint32_t solid = 0;
  Passage passage = Passage::entering;

  friend bool operator==(const RayHit&, const RayHit&) = default;
};

/// The same without the rationals.
struct RoundedHit {
  double t = 0;    ///< nearest double; infinite beyond the largest
  Vertex place{};  ///< nearest doubles
  std::uint32_t face = 0;
  std::uint32_t solid = 0;
  Passage passage = Passage::entering;

  friend bool operator==(const RoundedHit&, const RoundedHit&) = default;
};

}  // namespace strata
