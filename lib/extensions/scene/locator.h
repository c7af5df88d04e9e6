#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/winding/location.h"
#include "extensions/scene/scene.h"
#include "strata/options.h"

namespace strata {

/// Tells where points lie in a scene, by signed coverings about many local origins: space is divided into cells, each
/// with an origin whose winding numbers are known, and the way from it to a point can cross the faces of its cell only.
/// In space without faces the origin's numbers are the answer. `SignedCovering` answers the same about one origin;
/// the answers are the same. theory.md, "Signed covering".
///
/// An immutable value, cheap to copy, safe to ask from many threads.
class Locator {
 public:
  /// O(n log n), in parallel; memory O(n) unless many faces are stacked on one another. Throws Cancelled.
  explicit Locator(Scene scene, const Monitor& monitor = {});

  [[nodiscard]] const Scene& scene() const;

  /// Is q in, on or outside of the solids of the scene taken together. Exact. O(log n + faces near q); O(1) where none
  /// is. Cells are no smaller than 2^-30 of the scene: all faces within that count as near.
  [[nodiscard]] Where membership(const Vertex& q) const;
  void membership(std::span<const Vertex> q, std::span<Where> answers) const;  ///< in parallel

  /// Which solids q is in, and on which faces it lies. Exact; the same cost.
  [[nodiscard]] Location locate(const Vertex& q) const;
  [[nodiscard]] std::vector<Location> locate(std::span<const Vertex> q) const;  ///< in parallel

  /// Memory held, the scene's own arrays left out.
  [[nodiscard]] std::size_t bytes() const;

 private:
  struct Data;
  std::shared_ptr<const Data> data_;
};

}  // namespace strata
