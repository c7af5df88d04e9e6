#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/overlap/candidates.h"
#include "core/select/extract.h"
#include "strata/surface.h"

namespace strata {

/// The faces of surfaces, divided at their intersections: pieces have whole edges and vertices in common, and nothing
/// else. Of coincident pieces there is one, that of the lowest face; `boundary.covers` lists the others. The surfaces
/// must outlive it.
class Walls {
 public:
  Walls(std::span<const Surface> surfaces, const Monitor& monitor);
  Walls(const Walls&) = delete;
  Walls& operator=(const Walls&) = delete;

  [[nodiscard]] const InputComplex& input() const { return candidates_.input(); }
  [[nodiscard]] const Boundary& boundary() const { return boundary_; }
  [[nodiscard]] std::size_t size() const { return boundary_.triangles.size(); }
  /// The face that wall is a part of, by its number in `input`.
  [[nodiscard]] std::uint32_t face(std::uint32_t wall) const { return number(boundary_.sources[wall]); }
  [[nodiscard]] Point point(std::uint32_t vertex) const { return boundary_.points.point(boundary_.point(vertex)); }
  /// An operand's face by its number in `input`, and back.
  [[nodiscard]] std::uint32_t number(const Source& face) const { return input().first_face(face.operand) + face.face; }
  [[nodiscard]] Source source(std::uint32_t face) const;
  /// True when the face is oriented against the wall that it covers.
  [[nodiscard]] bool is_reversed(const Cover& cover) const;

  /// The walls as a mesh. O(n).
  [[nodiscard]] ExactMesh mesh(const Monitor& monitor) const;

 private:
  Candidates candidates_;
  Boundary boundary_;
};

}  // namespace strata
