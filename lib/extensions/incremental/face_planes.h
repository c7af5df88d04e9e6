#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "core/kernel/input_complex.h"
#include "extensions/incremental/face_tree.h"

namespace strata {

/// The source planes of the faces of an evaluation, computed when they are first needed. For one thread.
class FacePlanes {
 public:
  explicit FacePlanes(const InputComplex& input) : input_(input), planes_(std::size_t{2} * input.face_count()) {}

  /// Sets the known plane of a face.
  void know(std::uint32_t face, const PlanePointer& plane) { planes_[std::size_t{2} * face] = plane; }
  /// The plane of a face; `reversed`: with opposite orientation.
  [[nodiscard]] const PlanePointer& of(std::uint32_t face, bool reversed);

 private:
  const InputComplex& input_;
  std::vector<PlanePointer> planes_;  ///< per face, as it is and with opposite orientation
};

}  // namespace strata
