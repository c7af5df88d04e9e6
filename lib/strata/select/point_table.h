#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "strata/kernel/point.h"
#include "strata/overlap/constraint.h"
#include "strata/select/split_faces.h"

namespace strata {

/// The points that occur in pieces or equalities: one number for each place.
class PointTable {
 public:
  /// Numbers the points in the order of their first occurrence and tells the faces (SplitFace::ids). Points of
  /// different names that were found equal get one number: that of an input vertex, the lowest, if there is one.
  /// O(n), in parallel; the numbers do not depend on threads.
  PointTable(SplitFaces& split, std::span<const EqualVertices> equal);

  [[nodiscard]] std::size_t size() const { return names_.size(); }
  [[nodiscard]] const PointName& name(std::uint32_t id) const { return names_[id]; }
  /// Input vertices and the equal ones that stand for them: pairs of vertices, by no order.
  [[nodiscard]] const std::vector<EqualVertices>& replaced() const { return replaced_; }

 private:
  std::vector<PointName> names_;
  std::vector<EqualVertices> replaced_;
};

}  // namespace strata
