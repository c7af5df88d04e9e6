#pragma once
#include <array>
#include <atomic>
#include <cstdint>

namespace strata {

/// The tier that made a decision.
enum class Tier { filter, names, twofold, bits_128, bits_256, bits_512, bits_1024, unbounded };
inline constexpr int tier_count = 8;

#ifdef STRATA_COUNTERS
/// Decisions per tier, over the whole process: for benchmarks and tests only (build option STRATA_COUNTERS).
inline std::array<std::atomic<std::uint64_t>, tier_count> tier_counts{};
inline void count(Tier t) { tier_counts[static_cast<std::size_t>(t)].fetch_add(1, std::memory_order_relaxed); }
#else
inline void count(Tier) {}
#endif

}  // namespace strata
