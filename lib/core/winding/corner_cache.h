#pragma once
#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace strata {

/// A cache of facts about corners of faces, which many faces share. It contains the last ones. For one thread.
template <class Fact>
class CornerCache {
 public:
  /// For this number of vertices in all.
  explicit CornerCache(std::size_t vertices)
      : known_(std::bit_ceil(std::min(std::max(vertices, std::size_t{1}), std::size_t{4096}))) {}

  /// Null if nothing is cached for the vertex.
  [[nodiscard]] const Fact* find(std::uint32_t vertex) const {
    const Known& k = known_[vertex & (known_.size() - 1)];
    return k.vertex == vertex ? &k.fact : nullptr;
  }
  void remember(std::uint32_t vertex, const Fact& fact) {
    Known& k = known_[vertex & (known_.size() - 1)];
    if (k.vertex == vertex) return;
    k.vertex = vertex;
    k.fact = fact;
  }

 private:
  struct Known {
    std::uint32_t vertex = 0xffffffffu;
    Fact fact{};
  };
  std::vector<Known> known_;
};

}  // namespace strata
