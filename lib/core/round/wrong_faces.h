#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/overlap/embedded_stars.h"
#include "core/round/moving_mesh.h"
#include "strata/monitor.h"

namespace strata {

/// Faces of a mesh, in patches on each of which winding numbers are the same.
struct FacePatches {
  std::vector<std::uint32_t> faces;  ///< by increasing number
  std::vector<std::uint32_t> patch;  ///< of each
  std::vector<bool> is_known;        ///< per patch: the winding numbers on its sides are certain to be 0 and 1
};

/// The faces near those that changed: all of a closed mesh that rounding can have made wrong. Vertices with equal
/// coordinates are one here, and faces that have two of them are not there.
class ChangedRegion {
 public:
  /// Faces that meet a box of `swept`, or, if that is everything, the box of a changed face. O(n + m log m) for m of
  /// them, in parallel.
  ChangedRegion(const MovingMesh& mesh, const Monitor& monitor);

  /// By increasing number: faces that meet others elsewhere than along common edges and vertices, or have no area. At
  /// least one if there is one; all, unless there are more than `enough` pairs. Exact.
  [[nodiscard]] std::vector<std::uint32_t> wrong_faces(const Monitor& monitor, std::size_t enough = many_pairs);

  /// True when it found all.
  [[nodiscard]] bool is_complete() const { return is_complete_; }
  /// True when none of its faces has no area, nor any that is not there, if it was called.
  [[nodiscard]] bool has_area_everywhere() const { return has_area_everywhere_; }
  /// Of these, the pairs that meet, if it was called.
  [[nodiscard]] const std::vector<std::pair<std::uint32_t, std::uint32_t>>& wrong_pairs() const { return pairs_; }

  /// Its faces but for those of `wrong`, which are all that are wrong, in patches. Requires that `swept` is not
  /// everything. See round/theory.md.
  [[nodiscard]] FacePatches patches(std::span<const std::uint32_t> wrong) const;
  /// True where it is certain that winding numbers are 0 and 1 everywhere, as they were at the start. Requires that no
  /// faces are wrong.
  [[nodiscard]] bool keeps_windings() const;

  /// True when the region is the whole mesh.
  [[nodiscard]] bool is_all() const { return is_all_; }
  /// True when there are faces with two equal vertices.
  [[nodiscard]] bool has_collapsed() const { return !collapsed_at_.empty(); }
  /// Its faces and their vertices, equal ones with one number.
  [[nodiscard]] const Mesh& part() const { return part_; }
  /// Of that part, if `wrong_faces` needed them.
  [[nodiscard]] const std::optional<EmbeddedStars>& stars() const { return stars_; }

  /// The same, for the numbers of the whole mesh. Requires that the region is all of it, and `wrong_faces`.
  [[nodiscard]] EmbeddedStars stars_of_mesh() const {
    return stars_->of_whole(mesh_.mesh().vertices.size(), vertices_, equal_);
  }

  /// The faces of the region by increasing number.
  [[nodiscard]] const std::vector<std::uint32_t>& faces() const { return faces_; }
  /// Their vertices by increasing number, equal ones too.
  [[nodiscard]] const std::vector<std::uint32_t>& vertices() const { return vertices_; }
  /// Vertices that have the coordinates of one with a lower number, by increasing number, and that one.
  [[nodiscard]] const std::vector<std::pair<std::uint32_t, std::uint32_t>>& equal_vertices() const { return equal_; }

 private:
  static constexpr std::size_t many_pairs = 1 << 18;

  void leave_out_collapsed();
  [[nodiscard]] EmbeddedStars known_stars(const EmbeddedStars& of_mesh) const;

  const MovingMesh& mesh_;
  std::vector<std::uint32_t> faces_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> equal_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs_;
  Mesh part_;                       ///< those faces; equal vertices are one
  std::vector<bool> collapsed_at_;  ///< per vertex of it: faces with two equal vertices had this one; empty if none
  bool is_all_ = false, is_complete_ = false, has_area_everywhere_ = false;
  std::optional<EmbeddedStars> stars_;
  std::vector<std::uint32_t> vertices_;  ///< the mesh's number of each of its vertices
};

}  // namespace strata
