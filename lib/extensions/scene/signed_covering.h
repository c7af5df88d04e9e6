#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/cells/windings.h"
#include "core/kernel/point.h"
#include "extensions/scene/cone_filter.h"
#include "extensions/scene/direction_index.h"
#include "extensions/scene/location.h"
#include "extensions/scene/walk_step.h"
#include "strata/query.h"

namespace strata {

/// The covering of a scene by the tetrahedra of its faces and an origin, with the sign of a tetrahedron positive if the
/// outward normal points away from the origin. For a point on no face, the winding number of a solid is the sum of the
/// signs of its tetrahedra that contain the point (Feito and Torres 1997). Here it is computed as the change along the
/// walk from the origin, so that origins may lie anywhere and rays may be degenerate (core/cells/walk.h). theory.md,
/// "Signed covering".
///
/// An immutable value; queries are thread-safe.
class SignedCovering {
 public:
  /// O(n log n). The scene is shared, not copied. Throws std::invalid_argument for an invalid origin.
  /// `keep_footprints`: the index keeps its squares until it forgets the footprints.
  SignedCovering(Scene scene, const Origin& origin, bool keep_footprints = false, const Monitor& monitor = {});

  [[nodiscard]] const Scene& scene() const { return scene_; }
  [[nodiscard]] const Origin& origin() const { return origin_; }
  [[nodiscard]] const DirectionIndex& index() const { return index_; }
  [[nodiscard]] DirectionIndex& index() { return index_; }

  /// The orientation of a face as seen from the origin: positive when its outer side is seen, zero when it is flat.
  [[nodiscard]] Sign orientation(std::uint32_t face) const { return orientations_[face]; }
  [[nodiscard]] const std::vector<Sign>& orientations() const { return orientations_; }
  /// The winding numbers at the perturbed origin, where walks begin.
  [[nodiscard]] const Windings& windings_of_origin() const { return at_origin_; }

  /// Is q in, on or outside of the solids of the scene taken together: on: on a face of any; in: the winding number
  /// about one of them is not zero. Exact. O(log n + faces in q's direction).
  [[nodiscard]] Where membership(const Vertex& q) const;
  void membership(std::span<const Vertex> q, std::span<Where> answers) const;  ///< in parallel

  /// Which solids q is in, and on which faces it lies. Exact; the same cost.
  [[nodiscard]] Location locate(const Vertex& q) const;
  [[nodiscard]] std::vector<Location> locate(std::span<const Vertex> q) const;  ///< in parallel

  /// Memory used, without the scene's own arrays.
  [[nodiscard]] std::size_t bytes() const {
    return index_.bytes() + cones_.size() * sizeof(ConeFilter) + (orientations_.size() + starts_.size()) * sizeof(Sign);
  }

  /// Change of a solid's winding number at a face along the walk from the origin to q: +1, 0 or -1. A face whose plane
  /// contains q counts as not crossed.
  [[nodiscard]] int crossing(std::uint32_t face, const Point& q) const;

 private:
  [[nodiscard]] WalkStep step(std::uint32_t face, const Vertex& vertex, const Point& q, const ConeRay& ray) const;
  template <class Visit>
  void for_each_face_of_walk(const Vertex& q, const Visit& visit) const;
  void find_windings_of_origin();
  void make_cones();

  Scene scene_;
  Origin origin_;
  std::vector<Sign> orientations_;
  std::vector<Sign> starts_;  ///< side of the origin, perturbed: never zero
  DirectionIndex index_;
  Windings at_origin_;
  double scale_ = 1;               ///< of the cones
  std::vector<ConeFilter> cones_;  ///< per face, if the origin is a point and no vertex a rational
};

}  // namespace strata
