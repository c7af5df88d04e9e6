#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/containers/packed_boxes.h"
#include "core/kernel/box.h"
#include "core/kernel/input_complex.h"
#include "core/overlap/embedded_stars.h"

namespace strata {

/// Vertices of many faces, and the pairs of faces around each of them that can meet.
///
/// Boxes cannot part faces with a vertex in common: all of them contain it. Their directions from there can. Two
/// triangles are convex, so if they share a point other than the vertex, they share the segment up to it, and its
/// direction. A direction is a point on the surface of a cube around the vertex; a face is an arc there, and has a box.
/// theory.md, "Fans". An immutable value, the same for any number of threads. Holds a view of the input.
class Fans {
 public:
  /// A vertex of at least about this many faces is a fan: below, comparing all pairs costs less.
  static constexpr std::uint32_t least_faces = 32;

  /// Of the first operand, whose indices are valid and whose faces have positive area. `stars`: of this mesh, if it is
  /// closed, else null; their vertices are no fans. O(n + m log m) for m faces in fans, in parallel.
  Fans(const InputComplex& input, const EmbeddedStars* stars);

  [[nodiscard]] bool at(std::uint32_t vertex) const {
    return !vertices_.empty() && std::binary_search(vertices_.begin(), vertices_.end(), vertex);
  }

  [[nodiscard]] std::size_t part_count() const { return parts_.size(); }

  /// Appends the pairs of faces whose first member is in this part. Over all parts: every pair of faces of a fan that
  /// share more than its vertex, and some that do not, once. Always in the same order. Thread-safe. O(n + pairs that
  /// overlap along the axis of a sweep).
  void append_pairs_of(std::size_t part, std::vector<PackedBoxes::Pair>& pairs) const;

 private:
  /// A face of a fan. Those of one fan follow one another in the order of a sweep.
  struct Blade {
    std::uint32_t face;
    Box directions;
  };
  struct Part {
    std::size_t first, end, end_of_fan, axis;
    std::uint32_t vertex;
  };

  [[nodiscard]] std::vector<std::vector<std::uint32_t>> faces_around() const;
  [[nodiscard]] bool have_earlier_fan(std::uint32_t face, std::uint32_t other, std::uint32_t vertex) const;

  std::span<const InputComplex::Indices> faces_;
  std::vector<std::uint32_t> vertices_;  ///< by increasing number
  std::vector<Blade> blades_;
  std::vector<Part> parts_;
};

}  // namespace strata
