#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "files.h"
#include "strata/query.h"
#include "strata/solid.h"

/// The scene of the operands, one solid each, which knows their faces by the numbers that they have in the files.
class SceneInput {
 public:
  /// Throws strata::InputError, which names the operand.
  SceneInput(std::span<const LoadedMesh> operands, const Settings& settings);

  [[nodiscard]] const strata::Scene& scene() const { return scene_; }
  /// The number in its file of a face of the scene, from 0.
  [[nodiscard]] std::uint32_t file_face(std::uint32_t face) const { return file_faces_[face]; }

 private:
  strata::Scene scene_;
  std::vector<std::uint32_t> file_faces_;
};
