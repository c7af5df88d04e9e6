#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "strata/kernel/point.h"
#include "strata/overlap/constraint.h"
#include "strata/select/split_faces.h"

namespace strata {

/// The points that occur in pieces or equalities, with one representative for each place.
class PointTable {
 public:
  PointTable(const SplitFaces& split, std::span<const EqualVertices> equal);

  /// All names, sorted: input vertices first.
  [[nodiscard]] std::span<const PointName> names() const { return names_; }
  /// Where a name stands. Requires a name of the table. O(log n).
  [[nodiscard]] std::uint32_t index(const PointName& name) const;
  /// The first of the names that are known to be equal to this one.
  [[nodiscard]] std::uint32_t representative(std::uint32_t index) const { return parent_[index]; }

 private:
  [[nodiscard]] std::uint32_t root(std::uint32_t i);
  void join(std::uint32_t a, std::uint32_t b);

  std::vector<PointName> names_;
  std::vector<std::uint32_t> parent_;
};

}  // namespace strata
