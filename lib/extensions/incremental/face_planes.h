#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "core/kernel/input_complex.h"
#include "extensions/incremental/face_tree.h"

namespace strata {

/// The source planes of the faces of an evaluation, made when they are asked for. For one thread.
class FacePlanes {
 public:
  explicit FacePlanes(const InputComplex& input) : input_(input), planes_(std::size_t{2} * input.face_count()) {}

  /// The plane of a face is known.
  void know(std::uint32_t face, const PlanePointer& plane) { planes_[std::size_t{2} * face] = plane; }
  /// The plane of a face; `turned`: looking the other way.
  [[nodiscard]] const PlanePointer& of(std::uint32_t face, bool turned);

 private:
  const InputComplex& input_;
  std::vector<PlanePointer> planes_;  ///< per face, as it is and turned
};

}  // namespace strata
