#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/attributes/mesh_points.h"
#include "core/containers/fresh_array.h"
#include "strata/carry_attributes.h"

namespace strata {

/// How the triangles of a result come from their source faces: as they are, with corners in another order, or as parts
/// of them. Refers to operands, result and sources.
class TriangleOrigins {
 public:
  /// Compares corners, in parallel. Throws std::invalid_argument for sources of no face, another number of sources than
  /// triangles, and triangles with vertices that there are not. `may_turn`: false where none has the opposite
  /// orientation of its source.
  TriangleOrigins(std::span<const AttributedMesh> operands, ExactMeshView result, std::span<const Source> sources,
                  bool may_turn, const Monitor& monitor);

  [[nodiscard]] std::span<const Source> sources() const { return sources_; }
  [[nodiscard]] const MeshView& result() const { return points_.mesh(); }
  [[nodiscard]] const MeshPoints& points() const { return points_; }
  [[nodiscard]] const MeshPoints& points_of(std::uint32_t operand) const { return operands_[operand]; }
  [[nodiscard]] const Triangle& source_corners(const Source& s) const {
    return operands_[s.operand].mesh().triangles[s.face];
  }

  /// The triangles that are not their source faces, rising.
  [[nodiscard]] std::span<const std::uint32_t> parts() const { return parts_; }
  [[nodiscard]] bool is_whole(std::size_t triangle) const { return origin_[triangle] < part; }
  /// True when a triangle has the corners of its source in their order.
  [[nodiscard]] bool is_as_it_was(std::size_t triangle) const { return origin_[triangle] == 0; }
  /// Of a whole triangle, the corner of its source at each of its corners.
  [[nodiscard]] const std::array<std::uint8_t, 3>& order(std::size_t triangle) const {
    return orders[origin_[triangle]];
  }
  /// True when a triangle has the opposite orientation of its source face. Of parts, known after `find_turned_parts`.
  [[nodiscard]] bool is_turned(std::size_t triangle) const {
    if (!is_whole(triangle)) return origin_[triangle] == turned_part;
    return may_turn_ && origin_[triangle] >= first_turned;
  }
  void find_turned_parts(const Monitor& monitor);

 private:
  static constexpr std::array<std::array<std::uint8_t, 3>, 6> orders{
      {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}, {0, 2, 1}, {1, 0, 2}}};
  static constexpr std::uint8_t first_turned = 3, part = 6, turned_part = 7;

  std::vector<MeshPoints> operands_;
  MeshPoints points_;
  std::span<const Source> sources_;
  bool may_turn_;
  FreshArray<std::uint8_t> origin_;  ///< per triangle: a number of `orders`, or one of the values above
  std::vector<std::uint32_t> parts_;
};

}  // namespace strata
