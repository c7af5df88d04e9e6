#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "core/overlap/constraint.h"
#include "extensions/contact/parts.h"
#include "strata/monitor.h"

namespace strata::contact {

/// The *interior side* of a face: the points just below its interior. Where no two faces of two parts prove
/// interference, the interior side of a face is entirely inside the other part or entirely outside, and the interiors
/// of the parts meet exactly where an interior side of one part is inside the other. theory.md, section 3.
///
/// This class records which vertices of either part lie on the other one's surface, and which faces overlap one of its
/// faces. Then it tests the interior sides, of as few faces as possible.
class InteriorSides {
 public:
  InteriorSides(const Parts& parts, std::uint32_t a, std::uint32_t b);

  /// What two faces share, the first of a and the second of b. Requires that they do not prove interference.
  void note(const PairIntersections& intersections);
  /// Records coincident faces, which have opposite orientations.
  void note_coincident_faces(std::uint32_t f, std::uint32_t g);

  /// True when the interiors of the parts meet. Requires that all intersections of their faces have been recorded. O(n
  /// log n), and one membership test for each component into which the recorded facts divide the surfaces. Throws
  /// Cancelled.
  [[nodiscard]] bool show_interference(const Monitor& monitor) const;

 private:
  /// A part's surface, by local numbers.
  struct Surface {
    std::uint32_t part = 0;
    std::vector<bool> has_vertex_on;  ///< on the other surface
    std::vector<bool>
        has_face_on;  ///< shares an area with a face of the other part, which has the opposite orientation
  };

  void note_vertex(std::uint32_t vertex);
  void note_faces(std::uint32_t f, std::uint32_t g);
  [[nodiscard]] bool has_interior_side_inside(const Surface& surface, const Surface& other,
                                              const Monitor& monitor) const;
  [[nodiscard]] bool is_interior_side_inside(std::uint32_t face, std::uint32_t other) const;

  const Parts& parts_;
  std::array<Surface, 2> surfaces_;
};

}  // namespace strata::contact
