#pragma once
#include <cstdint>
#include <vector>

#include "core/kernel/input_complex.h"
#include "extensions/incremental/face_tree.h"

namespace strata {

/// Some faces of an incremental solid as the arrays of an operand. The tree must outlive it.
class Patch {
 public:
  /// All faces that a tool in this box may meet, and those that a walk from the box towards greater x may cross.
  Patch(const FaceTree& tree, const Box& tool);

  /// Adds the patch as an operand with the bounds of the whole incremental solid: where it has no faces, a point may be
  /// inside.
  void add_to(InputComplex& input) const { input.add(points_, triangles_, placed_, planes_, bounds_); }

  [[nodiscard]] std::uint32_t face_count() const { return static_cast<std::uint32_t>(faces_.size()); }
  [[nodiscard]] const WorkFace& face(std::uint32_t i) const { return *faces_[i]; }
  [[nodiscard]] const IncrementalVertexPointer& corner(std::uint32_t vertex) const { return *corners_[vertex]; }
  [[nodiscard]] std::uint32_t vertex_count() const { return static_cast<std::uint32_t>(corners_.size()); }

 private:
  std::vector<const WorkFace*> faces_;
  std::vector<const IncrementalVertexPointer*> corners_;  ///< in faces
  std::vector<InputComplex::Coordinates> points_;
  std::vector<InputComplex::Indices> triangles_;
  std::vector<PlacedVertex> placed_;
  std::vector<const SourcePlane*> planes_;
  Box bounds_;  ///< of the incremental solid
};

}  // namespace strata
