#pragma once
#include <span>

#include "strata/carry_attributes.h"

namespace strata {

/// What else is known about a result.
struct CarryRules {
  const Material* cut_material = nullptr;  ///< null: cut faces keep what they have
  CutFaces cut_faces = CutFaces::turned;
  bool may_turn = true;  ///< triangles may have the opposite orientation of their sources
};

/// `carry_attributes` in the current task arena.
[[nodiscard]] Attributes carry(std::span<const AttributedMesh> operands, ExactMeshView result,
                               std::span<const Source> sources, const CarryRules& rules, const Monitor& monitor);

}  // namespace strata
