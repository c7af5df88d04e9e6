#pragma once
#include <cstdint>
#include <span>

#include "strata/monitor.h"

namespace strata {

/// Are all hashes different? Most sets of things that are asked for equal ones have none: then this answers for less
/// than a hash table of them all, whose every access waits for memory. The hashes are sorted by their upper bits into
/// parts that fit the nearest cache, each with a table of its own. Hashes that differ only in the lowest bit count as
/// the same. Fewer than 2^32 hashes; expected O(n) where they are well mixed, in parallel; 8 bytes of memory for each.
/// Throws Cancelled.
[[nodiscard]] bool are_distinct(std::span<const std::uint64_t> hashes, const Monitor& monitor = {});

}  // namespace strata
