#pragma once
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace strata {

/// The tier that made a decision.
enum class Tier { filter, names, steps, double_double, bits_128, bits_256, bits_512, bits_1024, bits_4096, unbounded };
inline constexpr int tier_count = 10;

#ifdef STRATA_COUNTERS
/// Decisions per tier, over the whole process: for benchmarks and tests only (build option STRATA_COUNTERS).
inline std::array<std::atomic<std::uint64_t>, tier_count> tier_counts{};
inline void count(Tier t) { tier_counts[static_cast<std::size_t>(t)].fetch_add(1, std::memory_order_relaxed); }
#else
inline void count(Tier) {}
#endif

using TierCounts = std::array<std::uint64_t, tier_count>;
inline constexpr std::array<const char*, tier_count> tier_names{
    "by_filter",   "by_names",    "by_steps",     "by_twofold",   "by_128_bits",
    "by_256_bits", "by_512_bits", "by_1024_bits", "by_4096_bits", "by_integers"};

/// Decisions of the process so far; zeros in a build without counters.
[[nodiscard]] inline TierCounts tier_counts_now() {
  TierCounts now{};
#ifdef STRATA_COUNTERS
  for (std::size_t i = 0; i < now.size(); ++i) now[i] = tier_counts[i].load(std::memory_order_relaxed);
#endif
  return now;
}

}  // namespace strata
