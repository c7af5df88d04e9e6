#pragma once
#include <cstdint>
#include <vector>

#include "extensions/scene/visibility.h"
#include "strata/options.h"

namespace strata {

enum class EdgeKind : std::uint8_t {
  outline,  ///< faces on one side only as seen, or front and back faces meet
  crease,   ///< two faces meet at an angle, or more than two faces meet
};

/// An edge of a scene with the stretches of it that are seen.
struct SeenEdge {
  std::uint32_t a = 0, b = 0;  ///< vertices of the scene, a < b
  EdgeKind kind = EdgeKind::outline;
  std::vector<Stretch> seen;  ///< in order
};

/// The edges that a line drawing shows, by increasing vertices: outlines, and creases whose faces' normals differ by
/// more than an angle in degrees, which is a matter of style and measured in doubles. Edges within a plane are left
/// out, exactly. What is seen of them is exact. In parallel; the same for any number of threads.
[[nodiscard]] std::vector<SeenEdge> find_seen_edges(const Visibility& visibility, double crease_angle,
                                                    const Monitor& monitor = {});

}  // namespace strata
