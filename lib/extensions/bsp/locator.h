#pragma once
#include "extensions/scene/location.h"
#include "strata/mesh.h"
#include "strata/options.h"
#include "strata/query.h"
#include "strata/shared.h"

namespace strata::bsp {

/// Tells where points lie in a scene, with the same answers as `Locator`, by descending a tree for each solid.
/// An immutable value, cheap to copy, safe to ask from many threads.
class PartitionLocator {
 public:
  /// The solids of the scene must not cross themselves. Expected O(n log^2 n) for n faces. Throws Cancelled.
  explicit PartitionLocator(Scene scene, const Monitor& monitor = {});

  /// Which solids q is in, and on which faces it lies. Exact. O(solids * depth); on a boundary all planes of that solid
  /// are asked, and the faces in those through q.
  [[nodiscard]] Location locate(const Vertex& q) const;

 private:
  struct Data;
  Shared<Data> data_;
};

}  // namespace strata::bsp
