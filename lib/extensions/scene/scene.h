#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "core/kernel/carriers.h"
#include "strata/mesh.h"

namespace strata {

/// Solids in one numbering of vertices and faces, those of the first solid first. An immutable value, cheap to copy.
class Scene {
 public:
  Scene() : Scene(std::vector<ExactMesh>{}) {}
  /// Requires closed meshes without degenerate faces, as solids have. Solids may touch, overlap and cross each other
  /// and themselves. Throws InputError where an index is out of range, a coordinate not finite or a face degenerate,
  /// naming the solid; std::length_error for more than 2^32 - 2 faces or vertices.
  explicit Scene(std::vector<ExactMesh> solids);

  [[nodiscard]] std::uint32_t solid_count() const { return carriers().operand_count(); }
  [[nodiscard]] std::uint32_t face_count() const { return carriers().face_count(); }
  [[nodiscard]] const ExactMesh& solid(std::uint32_t i) const { return data_->solids[i]; }
  [[nodiscard]] std::uint32_t solid_of(std::uint32_t face) const { return carriers().operand_of_face(face); }
  /// The number of a face within its solid.
  [[nodiscard]] std::uint32_t local(std::uint32_t face) const {
    return face - carriers().first_face(carriers().operand_of_face(face));
  }
  [[nodiscard]] const Carriers& carriers() const { return data_->carriers; }

 private:
  struct Data {
    std::vector<ExactMesh> solids;
    Carriers carriers;
  };
  std::shared_ptr<const Data> data_;
};

}  // namespace strata
