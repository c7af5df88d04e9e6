#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "strata/mesh.h"
#include "support/random.h"

/// Random solids that love to touch: small integers and halves, shared planes, edges and vertices.
namespace strata::test {

/// Operands of one test case, and what they are, for messages.
struct Operands {
  std::string kind;
  std::vector<Mesh> meshes;
};

/// A small solid on the lattice [0, 4]^3 of integers, seldom halves: box, hull of lattice points, tetrahedra of a
/// Kuhn subdivision, cells, ring, solid with a cavity, separate parts.
[[nodiscard]] Mesh lattice_solid(Random& random);

/// Two solids that touch more often than chance has it. The same seed gives the same pair on every machine.
[[nodiscard]] Operands touching_pair(std::uint64_t seed);

/// The same for 3 to 5 solids; in half of the cases all of them pass through one point.
[[nodiscard]] Operands touching_operands(std::uint64_t seed);

/// 3 to 6 tetrahedra of integers, each with a face that a common line crosses from one edge to another: there the faces
/// cross. Some have the line as an edge.
[[nodiscard]] Operands about_a_line(Random& random);

/// One time in four, slivers or another scale: one axis of all solids stretched or shrunk, or all made huge or tiny, by
/// powers of two. The pairs and operands above have been through it.
void stretch(Random& random, Operands& operands);

}  // namespace strata::test
