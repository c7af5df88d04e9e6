#pragma once
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace strata {

/// A partition of 0 .. n-1 whose sets are only ever merged. The representative is the smallest member. Near O(1) per
/// call, by path halving.
template <class Index>
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), Index{0}); }

  [[nodiscard]] Index find(Index x) {
    while (parent_[x] != x) x = parent_[x] = parent_[parent_[x]];
    return x;
  }

  /// True if these were two sets.
  bool unite(Index a, Index b) {
    a = find(a);
    b = find(b);
    if (b < a) std::swap(a, b);
    parent_[b] = a;
    return a != b;
  }

 private:
  std::vector<Index> parent_;
};

}  // namespace strata
