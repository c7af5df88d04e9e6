#pragma once
#include <cstdint>
#include <vector>

#include "core/kernel/input_complex.h"
#include "core/overlap/embedded_stars.h"

namespace strata {

/// The shells of a closed mesh: its faces, connected across edges that two faces have. Without self-intersections, the
/// winding number just above a shell is the same everywhere.
struct Shells {
  std::vector<std::uint32_t> of_face;  ///< numbered by their first faces
  std::uint32_t count = 0;
  bool share_edges = false;  ///< two of them, or two sheets of one, have an edge in common
};

/// The same for a mesh that crosses itself, without the faces that do: these are shells of their own. Winding numbers
/// above a shell are the same everywhere. `crossing`: by face. Requires that no other face shares a point with another
/// elsewhere than along vertices and edges that both have.
[[nodiscard]] Shells find_patches(const InputComplex& input, const EmbeddedStars& stars,
                                  const std::vector<bool>& crossing);

/// Of the first operand, by the numbers of vertices. Requires a closed chain of faces. O(n log d) for vertices of
/// degree d, near O(n) where stars are embedded.
[[nodiscard]] Shells find_shells(const InputComplex& input, const EmbeddedStars& stars);

}  // namespace strata
