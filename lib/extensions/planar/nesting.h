#pragma once
#include "extensions/planar/subdivision.h"

namespace strata::planar {

/// Finds the faces that contain components: by rays to the left from their least vertices, or, where these have tested
/// too many segments, by one sweep over all edges. O((n + k) log n) for all components together.
class Nesting {
 public:
  /// `patience`: how many segments may be tested, per piece, before the sweep.
  Nesting(const Arrangement& a, const Subdivision& s, std::size_t patience) : a_(a), s_(s), patience_(patience) {}

  /// A half-edge with the face, in other components, that contains a component with this least vertex; none: the
  /// unbounded face.
  [[nodiscard]] std::uint32_t container_of(std::uint32_t vertex);

 private:
  [[nodiscard]] std::uint32_t chain_of(std::uint32_t piece);
  void sweep();

  const Arrangement& a_;
  const Subdivision& s_;
  std::size_t patience_;
  std::vector<std::uint32_t> chain_;  ///< of every piece, once it is needed
  std::vector<std::uint32_t>
      below_;                  ///< after the sweep: of every vertex at which no edge arrives, the half-edge below
  std::size_t looked_at_ = 0;  ///< segments, so far
};

}  // namespace strata::planar
