#pragma once
#include <cstdint>
#include <span>

namespace strata {

/// Are all hashes different? Most sets of things that are asked for equal ones have none: then this answers for less
/// than a hash table of them all, whose every access waits for memory. The hashes are sorted by their upper bits into
/// parts that fit the nearest cache, each with a table of its own. Hashes that differ only in the lowest bit count as
/// the same. Expected O(n) for well mixed hashes, in parallel; 8 bytes of memory for each.
[[nodiscard]] bool are_distinct(std::span<const std::uint64_t> hashes);

}  // namespace strata
