#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "strata/convex/decompose.h"

namespace strata::convex {

/// What a volume of space is: a piece of the solid is selected, the outside and cavities are not.
enum class Mark { outer, cavity, piece };

/// A part of a volume's boundary that is connected over edges as seen from inside the volume, as interfaces by number,
/// rising. Seen from outside, two cubes that touch in an edge are one part, two that touch in a vertex are two.
using Shell = std::vector<std::uint32_t>;

/// A part of space between interfaces.
struct Volume {
  Mark mark = Mark::outer;
  /// One for a piece; the outside has one per connected part of the solid's outer boundary, a cavity first the one that
  /// encloses it, then one per part that floats in it. In the order of their first triangles.
  std::vector<Shell> shells;
  std::vector<std::uint32_t> neighbours;  ///< volumes that it shares an interface with, rising
};

/// A convex polygon between two volumes.
struct Interface {
  std::array<std::uint32_t, 2> volumes;  ///< of two pieces the lower number first, otherwise the piece first
  std::vector<std::uint32_t> polygon;    ///< counter-clockwise as seen from the second volume
};

/// Space as divided by a solid and its decomposition. Volume 0 is the outside, then come the cavities, in the order of
/// their first triangles, then the pieces: piece p is volume `first_piece + p`.
struct VolumeComplex {
  std::vector<Vertex> points;      ///< in lexicographic order of their exact places
  std::vector<ExactVertex> exact;  ///< those that are no doubles
  std::vector<Volume> volumes;
  std::vector<Interface> interfaces;  ///< walls first, in their order, then parts of the boundary, by triangle
  std::uint32_t first_piece = 1;
};

/// Requires that the decomposition is that of the solid. Expected O(n log n); where
/// there are cavities and more outer shells than one, beside a search tree for each cavity.
[[nodiscard]] VolumeComplex volumes_of(const Solid& solid, const Decomposition& decomposition);

}  // namespace strata::convex
