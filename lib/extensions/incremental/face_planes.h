#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/kernel/input_complex.h"
#include "extensions/incremental/face_tree.h"

namespace strata {

/// A face of an evaluation as it is, or with the opposite orientation.
struct OrientedFace {
  std::uint32_t face = 0;
  bool reversed = false;
};

/// The source planes of the faces of an evaluation, computed when they are first needed. For one thread.
class FacePlanes {
 public:
  explicit FacePlanes(const InputComplex& input) : input_(input), planes_(std::size_t{2} * input.face_count()) {}

  /// Sets the known plane of a face.
  void know(std::uint32_t face, const PlanePointer& plane) { planes_[std::size_t{2} * face] = plane; }
  /// Computes the planes of some faces, which may repeat, by all threads.
  void compute(std::span<const OrientedFace> faces);
  /// The plane of a face.
  [[nodiscard]] const PlanePointer& of(OrientedFace face);

 private:
  [[nodiscard]] static std::size_t place(OrientedFace f) { return std::size_t{2} * f.face + (f.reversed ? 1 : 0); }

  const InputComplex& input_;
  std::vector<PlanePointer> planes_;  ///< per face, as it is and with opposite orientation
};

}  // namespace strata
