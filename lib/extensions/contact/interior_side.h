#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "core/overlap/constraint.h"
#include "extensions/contact/parts.h"

namespace strata::contact {

/// The *interior side* of a face: the points just below its inside. Where no two faces of two parts prove interference,
/// the interior side of a face is inside the other part or outside of it, all of it, and the interiors of the parts
/// meet exactly where some interior side of one is inside the other. theory.md, section 3.
///
/// This notes which vertices of either part lie on the other one's surface, and which faces lie on one of its faces,
/// and then asks for the interior sides, of as few faces as it can.
class InteriorSides {
 public:
  InteriorSides(const Parts& parts, std::uint32_t a, std::uint32_t b);

  /// What two faces share, the first of a and the second of b. Requires that they do not prove interference.
  void note(const PairIntersections& intersections);
  /// Faces with the same corners, which look opposite ways.
  void note_coincident_faces(std::uint32_t f, std::uint32_t g);

  /// True when the interiors of the parts meet. Requires that everything which their faces share has been noted.
  /// O(n log n), one question of membership for each piece into which what is noted divides the surfaces.
  [[nodiscard]] bool show_interference() const;

 private:
  /// A part's surface, by local numbers.
  struct Surface {
    std::uint32_t part = 0;
    std::vector<bool> has_vertex_on;  ///< on the other surface
    std::vector<bool> has_face_on;    ///< shares an area with a face of the other part, which looks the other way
  };

  void note_vertex(std::uint32_t vertex);
  void note_faces(std::uint32_t f, std::uint32_t g);
  [[nodiscard]] bool has_interior_side_inside(const Surface& surface, const Surface& other) const;
  [[nodiscard]] bool is_interior_side_inside(std::uint32_t face, std::uint32_t other) const;

  const Parts& parts_;
  std::array<Surface, 2> surfaces_;
};

}  // namespace strata::contact
