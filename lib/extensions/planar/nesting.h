#pragma once
#include "extensions/planar/subdivision.h"

namespace strata::planar {

/// Tells which faces components lie in: looks from their least vertices to the left, or, where that has looked at too
/// much, sweeps once over all edges. O((n + k) log n) for all components together.
class Nesting {
 public:
  /// `patience`: how many segments may be looked at, per piece, before the sweep.
  Nesting(const Arrangement& a, const Subdivision& s, std::size_t patience) : a_(a), s_(s), patience_(patience) {}

  /// A half-edge with the face, in other components, that holds a component with this least vertex; none: the unbounded
  /// face.
  [[nodiscard]] std::uint32_t container_of(std::uint32_t vertex);

 private:
  [[nodiscard]] std::uint32_t chain_of(std::uint32_t piece);
  void sweep();

  const Arrangement& a_;
  const Subdivision& s_;
  std::size_t patience_;
  std::vector<std::uint32_t> chain_;  ///< of every piece, once it is asked for
  std::vector<std::uint32_t> below_;  ///< once swept: of every vertex that no edge comes to, the half-edge below
  std::size_t looked_at_ = 0;         ///< segments, so far
};

}  // namespace strata::planar
