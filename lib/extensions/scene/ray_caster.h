#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "extensions/scene/box_tree.h"
#include "extensions/scene/ray.h"
#include "extensions/scene/ray_line.h"
#include "extensions/scene/scene.h"

namespace strata {

/// Exact ray queries over a scene, from any point.
///
/// The events of a solid along a ray are the parameters at which the ray meets the solid's closed faces, edges and
/// corners included, and both ends of a stretch within a face; equal parameters of one solid are one event. A ray that
/// starts on a surface has an event at 0; what lies before is what the line passes just before its beginning, also if
/// that is another side of the surface. Events come by increasing parameter, equal ones by number of the solid.
/// Laws: places do not depend on the direction's length; a moved or scaled scene and ray (where that is exact) have the
/// same events; where an event is one of several faces, it does not depend on how facets are triangulated, but for
/// events between two stretches along.
///
/// Requires closed solids, as a Scene does. An immutable value, safe to ask from many threads; batches run in parallel
/// and answer the same for any number of threads. All throw std::invalid_argument for a zero direction and for
/// coordinates that are not finite. Exact at any scale: the answers are signs and rationals. A query is O(log n + faces
/// near the ray) in the usual case.
class RayCaster {
 public:
  /// O(n log n), in parallel. The scene is shared, not copied.
  explicit RayCaster(Scene scene) : scene_(std::move(scene)), tree_(scene_) {}

  [[nodiscard]] const Scene& scene() const { return scene_; }
  [[nodiscard]] const BoxTree& tree() const { return tree_; }

  /// The first event of all solids; nothing if the ray meets none.
  [[nodiscard]] std::optional<RayHit> first(const Ray& ray) const;
  [[nodiscard]] std::optional<RoundedHit> first_rounded(const Ray& ray) const;

  /// All events of all solids.
  [[nodiscard]] std::vector<RayHit> all(const Ray& ray) const;
  [[nodiscard]] std::vector<RoundedHit> all_rounded(const Ray& ray) const;

  /// Does the closed segment meet any closed face? No for one within a solid.
  [[nodiscard]] bool any(const Segment& segment) const;

  [[nodiscard]] std::vector<std::optional<RayHit>> first(std::span<const Ray> rays) const;
  [[nodiscard]] std::vector<std::vector<RayHit>> all(std::span<const Ray> rays) const;
  /// Requires as many answers as questions.
  void first_rounded(std::span<const Ray> rays, std::span<std::optional<RoundedHit>> answers) const;
  void all_rounded(std::span<const Ray> rays, std::span<std::vector<RoundedHit>> answers) const;
  void any(std::span<const Segment> segments, std::span<bool> answers) const;

 private:
  /// An event and a hit to take its place from.
  struct Found {
    FaceHit hit;
    std::uint32_t face = 0, solid = 0;
    Passage passage = Passage::entering;
  };
  [[nodiscard]] std::optional<Found> find_first(const RayLine& line) const;
  [[nodiscard]] std::vector<Found> find_all(const RayLine& line) const;
  [[nodiscard]] static RayHit exact(const RayLine& line, Found& found);
  [[nodiscard]] static RoundedHit rounded(const RayLine& line, Found& found);

  Scene scene_;
  BoxTree tree_;
};

}  // namespace strata
