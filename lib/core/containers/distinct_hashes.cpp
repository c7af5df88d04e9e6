#include "core/containers/distinct_hashes.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstddef>
#include <utility>
#include <vector>

#include "core/containers/huge_pages.h"

namespace strata {
namespace {

using Hashes = std::span<const std::uint64_t>;

/// Hashes sorted by their upper bits: a part for each value of these.
class HashParts {
 public:
  HashParts(Hashes hashes, const Monitor& monitor)
      : bits_(static_cast<int>(std::bit_width(hashes.size() / hashes_per_part))),
        blocks_(std::clamp<std::size_t>(hashes.size() / hashes_per_block, 1, most_blocks)) {
    const std::size_t parts = count();
    const auto for_each_block = [&](const auto& visit) {
      tbb::parallel_for(std::size_t{0}, blocks_, [&](std::size_t b) {
        monitor.check();
        const std::size_t first = hashes.size() * b / blocks_, last = hashes.size() * (b + 1) / blocks_;
        visit(b, hashes.subspan(first, last - first));
      });
    };
    // Per block and part: how many, and then where the next one goes.
    std::vector<std::uint32_t> next(blocks_ * parts, 0);
    for_each_block([&](std::size_t b, Hashes block) {
      for (const std::uint64_t h : block) ++next[b * parts + part_of(h)];
    });
    begin_.resize(parts + 1, 0);
    std::uint32_t at = 0;
    for (std::size_t p = 0; p < parts; ++p) {
      begin_[p] = at;
      for (std::size_t b = 0; b < blocks_; ++b) at += std::exchange(next[b * parts + p], at);
    }
    begin_[parts] = at;
    resize_fresh(sorted_, hashes.size());
    for_each_block([&](std::size_t b, Hashes block) {
      for (const std::uint64_t h : block) sorted_[next[b * parts + part_of(h)]++] = h;
    });
  }

  [[nodiscard]] std::size_t count() const { return std::size_t{1} << bits_; }
  [[nodiscard]] Hashes at(std::size_t part) const {
    return Hashes(sorted_).subspan(begin_[part], begin_[part + 1] - begin_[part]);
  }

 private:
  static constexpr std::size_t hashes_per_part = 1 << 10, hashes_per_block = 1 << 13, most_blocks = 64;

  // In two steps: a shift by 64 is not defined.
  [[nodiscard]] std::size_t part_of(std::uint64_t hash) const { return hash >> 1 >> (63 - bits_); }

  int bits_;
  std::size_t blocks_;
  std::vector<std::uint32_t> begin_;  ///< in `sorted_`, per part
  std::vector<std::uint64_t> sorted_;
};

/// As `are_distinct`. `table` is room to use.
bool are_distinct_in(Hashes part, std::vector<std::uint64_t>& table) {
  const std::size_t mask = std::bit_ceil(2 * part.size() + 1) - 1;
  table.assign(mask + 1, 0);
  return std::ranges::all_of(part, [&](std::uint64_t hash) {
    const std::uint64_t key = hash | 1u;  // 0 is a slot that is free
    std::size_t at = hash >> 1 & mask;
    for (; table[at] != 0; at = (at + 1) & mask)
      if (table[at] == key) return false;
    table[at] = key;
    return true;
  });
}

}  // namespace

bool are_distinct(Hashes hashes, const Monitor& monitor) {
  const HashParts parts(hashes, monitor);
  std::atomic<bool> result = true;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, parts.count(), 16), [&](const auto& range) {
    monitor.check();
    std::vector<std::uint64_t> table;
    for (std::size_t p = range.begin(); p != range.end() && result.load(std::memory_order_relaxed); ++p)
      if (!are_distinct_in(parts.at(p), table)) result.store(false, std::memory_order_relaxed);
  });
  return result;
}

}  // namespace strata
