#pragma once
#include <array>
#include <cstdint>

#include "strata/kernel/counters.h"

namespace strata::test {

/// Decisions per tier since the last call; all zero in builds that do not count.
class TierProbe {
 public:
  using Counts = std::array<std::uint64_t, tier_count>;

  TierProbe() { (void)take(); }

  Counts take() {
    Counts difference{};
#ifdef STRATA_COUNTERS
    for (std::size_t i = 0; i < difference.size(); ++i) {
      const std::uint64_t now = tier_counts[i].load();
      difference[i] = now - before_[i];
      before_[i] = now;
    }
#endif
    return difference;
  }

 private:
  Counts before_{};
};

inline constexpr std::array tier_names{"filter", "names", "twofold", "128", "256", "512", "1024", "unbounded"};
static_assert(tier_names.size() == tier_count);

#ifdef STRATA_COUNTERS
inline constexpr bool counts_tiers = true;
#else
inline constexpr bool counts_tiers = false;
#endif

}  // namespace strata::test
