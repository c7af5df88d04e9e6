#pragma once
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "extensions/scene/relation.h"

namespace strata {

/// Cuts pieces that dominate one another in cycles; theory.md, "Cycles".
class RingBreaker {
 public:
  /// `remaining`: the pieces in cycles, and those between cycles; no others.
  RingBreaker(Pieces& pieces, Relation& relation, const Origin& origin, const std::vector<std::uint32_t>& remaining)
      : pieces_(pieces), relation_(relation), origin_(origin), nodes_(remaining) {}

  /// Cuts pieces until no cycle is left.
  void run(const Monitor& monitor);

 private:
  using Ring = std::vector<std::uint32_t>;  ///< each dominated by the next, the last by the first

  void list_neighbours();
  [[nodiscard]] std::vector<Ring> find_rings() const;
  [[nodiscard]] Ring shortest_ring(std::uint32_t start) const;
  bool shorten(Ring& ring) const;
  void cut(const Ring& ring);

  Pieces& pieces_;
  Relation& relation_;
  const Origin& origin_;
  std::vector<std::uint32_t> nodes_;
  std::unordered_map<std::uint32_t, std::uint32_t> index_;
  std::vector<std::vector<std::uint32_t>> beyond_;  ///< among the nodes, by index
};

}  // namespace strata
