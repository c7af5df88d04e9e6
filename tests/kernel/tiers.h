#pragma once
#include <array>
#include <cstdint>

#include "core/kernel/counters.h"

namespace strata::test {

/// Decisions per tier since the last call; all zero in builds that do not count.
class TierProbe {
 public:
  using Counts = TierCounts;

  TierProbe() { (void)take(); }

  Counts take() {
    const Counts now = tier_counts_now();
    Counts difference{};
    for (std::size_t i = 0; i < difference.size(); ++i) difference[i] = now[i] - before_[i];
    before_ = now;
    return difference;
  }

 private:
  Counts before_{};
};

#ifdef STRATA_COUNTERS
inline constexpr bool counts_tiers = true;
#else
inline constexpr bool counts_tiers = false;
#endif

}  // namespace strata::test
