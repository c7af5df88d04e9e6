#pragma once
#include <cstdint>
#include <vector>

namespace strata {

/// What was found out at corners of faces, which many faces share: remembers the last ones. For one thread.
template <class Fact>
class CornerCache {
 public:
  /// Null if nothing was remembered of late.
  [[nodiscard]] const Fact* find(std::uint32_t vertex) const {
    if (known_.empty()) return nullptr;
    const Known& k = known_[vertex % size];
    return k.vertex == vertex ? &k.fact : nullptr;
  }
  void remember(std::uint32_t vertex, const Fact& fact) {
    if (known_.empty()) known_.resize(size);
    Known& k = known_[vertex % size];
    if (k.vertex == vertex) return;
    k.vertex = vertex;
    k.fact = fact;
  }

 private:
  static constexpr std::size_t size = 4096;
  struct Known {
    std::uint32_t vertex = 0xffffffffu;
    Fact fact{};
  };
  std::vector<Known> known_;
};

}  // namespace strata
