#include "strata/select/point_table.h"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <numeric>

namespace strata {

PointTable::PointTable(const SplitFaces& split, std::span<const EqualVertices> equal) {
  for (const SplitFace& f : split.faces) names_.insert(names_.end(), f.points.begin(), f.points.end());
  for (const auto& [a, b] : split.equal) names_.insert(names_.end(), {a, b});
  for (const EqualVertices& e : equal) names_.insert(names_.end(), {PointName::input(e.a), PointName::input(e.b)});
  tbb::parallel_sort(names_.begin(), names_.end());
  names_.erase(std::unique(names_.begin(), names_.end()), names_.end());
  parent_.resize(names_.size());
  std::iota(parent_.begin(), parent_.end(), 0u);
  for (const auto& [a, b] : split.equal) join(index(a), index(b));
  for (const EqualVertices& e : equal) join(index(PointName::input(e.a)), index(PointName::input(e.b)));
  for (std::uint32_t i = 0; i < parent_.size(); ++i) parent_[i] = root(i);
}

std::uint32_t PointTable::index(const PointName& name) const {
  return static_cast<std::uint32_t>(std::lower_bound(names_.begin(), names_.end(), name) - names_.begin());
}

std::uint32_t PointTable::root(std::uint32_t i) {
  while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
  return i;
}

void PointTable::join(std::uint32_t a, std::uint32_t b) {
  a = root(a);
  b = root(b);
  parent_[std::max(a, b)] = std::min(a, b);
}

}  // namespace strata
