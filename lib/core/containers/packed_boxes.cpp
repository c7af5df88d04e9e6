#include "core/containers/packed_boxes.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <span>
#include <utility>

#include "core/containers/huge_pages.h"
#include "core/containers/z_order.h"

namespace strata {
namespace {

constexpr std::size_t grain = 1 << 14;

/// Calls `visit(first, last)` for runs of numbers below `count`, in parallel.
template <class Visit>
void for_each_run(std::size_t count, const Visit& visit) {
  tbb::parallel_for(std::size_t{0}, (count + grain - 1) / grain,
                    [&](std::size_t n) { visit(n * grain, std::min(count, (n + 1) * grain)); });
}

/// An item and its place on a Z-curve.
struct Placed {
  std::uint32_t code, item;
};

using Centre = std::array<double, 3>;

/// Halves before adding: the sum of two doubles may overflow.
Centre centre_of(const Box& b) {
  return {b.lower[0] / 2 + b.upper[0] / 2, b.lower[1] / 2 + b.upper[1] / 2, b.lower[2] / 2 + b.upper[2] / 2};
}

/// A cube divided into 1024 cells each way, along a Z-curve.
class Cells {
 public:
  explicit Cells(const Box& bounds) : lower_(bounds.lower) {
    double extent = 0;
    for (std::size_t i = 0; i < 3; ++i) extent = std::max(extent, bounds.upper[i] / 2 - bounds.lower[i] / 2);
    per_unit_ = 512 / extent;
  }
  /// False where all cells would be one, or where the number of cells per unit is beyond all doubles.
  [[nodiscard]] bool are_useful() const { return per_unit_ < Box::infinity; }
  [[nodiscard]] std::uint32_t code(const Centre& c) const {
    std::array<std::uint32_t, 3> at{};
    for (std::size_t i = 0; i < 3; ++i)
      at[i] = static_cast<std::uint32_t>(std::clamp((c[i] - lower_[i]) * per_unit_, 0.0, 1023.0));
    return z_order(at[0], at[1], at[2]);
  }

 private:
  Centre lower_;
  double per_unit_;
};

/// Sorts by code, 10 bits at a time from the lowest; equal codes keep their order.
void sort_by_code(std::vector<Placed>& placed) {
  constexpr std::uint32_t bits = 10, mask = (1u << bits) - 1;
  std::array<std::array<std::size_t, mask + 1>, 3> first{};
  for (const Placed& p : placed)
    for (std::uint32_t k = 0; k < 3; ++k) ++first[k][p.code >> k * bits & mask];
  std::vector<Placed> other;
  resize_fresh(other, placed.size());
  for (std::uint32_t k = 0; k < 3; ++k) {
    std::size_t sum = 0;
    for (std::size_t& f : first[k]) sum += std::exchange(f, sum);
    for (const Placed& p : placed) other[first[k][p.code >> k * bits & mask]++] = p;
    placed.swap(other);
  }
}

/// Orders items along a Z-curve; those in one cell, if there are more than a pack, along one of their own.
class Ordering {
 public:
  explicit Ordering(PackedBoxes::BoxOf box_of) : box_of_(box_of) {}

  void order(std::span<Placed> placed, int depth) const {
    Box bounds;
    for (const Placed& p : placed) bounds.include(centre_of(box_of_(p.item)));
    const Cells cells(bounds);
    if (!cells.are_useful()) return;
    for (Placed& p : placed) p.code = cells.code(centre_of(box_of_(p.item)));
    std::sort(placed.begin(), placed.end(), [](const Placed& a, const Placed& b) {
      return a.code < b.code || (a.code == b.code && a.item < b.item);
    });
    order_within_cells(placed, depth);
  }

  /// Requires items sorted by code.
  void order_within_cells(std::span<Placed> placed, int depth) const {
    constexpr int most_depth = 256;  // a crowd is 1024 times smaller than what it was in: more than doubles can be
    if (depth == most_depth) return;
    for (std::size_t i = 0, end = 0; i < placed.size(); i = end) {
      while (end < placed.size() && placed[end].code == placed[i].code) ++end;
      if (end - i > crowd) order(placed.subspan(i, end - i), depth + 1);
    }
  }

 private:
  static constexpr std::size_t crowd = 4 * PackedBoxes::width;
  PackedBoxes::BoxOf box_of_;
};

// Vectors that every processor has: compilers take wider ones apart, number by number.
using TwoDoubles [[gnu::vector_size(16)]] = double;
using TwoBits [[gnu::vector_size(16)]] = std::int64_t;
using FourKeys [[gnu::vector_size(16)]] = std::uint32_t;
using FourBits [[gnu::vector_size(16)]] = std::int32_t;

}  // namespace

PackedBoxes::Pack::Pack() {
  for (auto& axis : lower) axis.fill(Box::infinity);
  for (auto& axis : upper) axis.fill(-Box::infinity);
}

void PackedBoxes::Pack::set(std::size_t k, const Box& box) {
  for (std::size_t i = 0; i < 3; ++i) {
    lower[i][k] = box.lower[i];
    upper[i][k] = box.upper[i];
  }
}

inline Box PackedBoxes::Pack::box(std::size_t k) const {
  return {{lower[0][k], lower[1][k], lower[2][k]}, {upper[0][k], upper[1][k], upper[2][k]}};
}

inline Box PackedBoxes::Pack::bounds() const {
  Box all;
  for (std::size_t k = 0; k < width; ++k) all.include(box(k));
  return all;
}

/// Bit k: box k has a point in common with this one.
inline std::uint32_t PackedBoxes::overlapping(const Pack& pack, const Box& box) {
  TwoBits all{};
  for (std::size_t k = 0; k < width; k += 2) {
    TwoBits met{std::int64_t{1} << k, std::int64_t{2} << k};
    for (std::size_t i = 0; i < 3; ++i) {
      TwoDoubles low, high;
      std::memcpy(&low, &pack.lower[i][k], sizeof low);
      std::memcpy(&high, &pack.upper[i][k], sizeof high);
      met &= (low <= box.upper[i]) & (high >= box.lower[i]);
    }
    all |= met;
  }
  return static_cast<std::uint32_t>(all[0] | all[1]);
}

/// Bit k: lane k has a key in common with a lane of other keys.
inline std::uint32_t PackedBoxes::with_common_key(const PackKeys& keys, const PackKeys& of, std::size_t lane) {
  FourBits low{}, high{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t own = of.key[i][lane];
    if (own == no_key) continue;
    for (std::size_t j = 0; j < 3; ++j) {
      FourKeys first, second;
      std::memcpy(&first, keys.key[j].data(), sizeof first);
      std::memcpy(&second, keys.key[j].data() + 4, sizeof second);
      low |= first == own;
      high |= second == own;
    }
  }
  const FourBits bits = (low & FourBits{1, 2, 4, 8}) | (high & FourBits{16, 32, 64, 128});
  return static_cast<std::uint32_t>((bits[0] | bits[1]) | (bits[2] | bits[3]));
}

inline void PackedBoxes::append_pairs(std::size_t first, std::size_t second, const Box& bounds_of_second,
                                      std::vector<Pair>& pairs) const {
  const Pack &a = levels_.front()[first], &b = levels_.front()[second];
  for (std::uint32_t own = overlapping(a, bounds_of_second); own != 0; own &= own - 1) {
    const auto i = static_cast<std::uint32_t>(std::countr_zero(own));
    std::uint32_t others = overlapping(b, a.box(i));
    if (first == second) others &= ~((std::uint32_t{2} << i) - 1);
    if (others != 0) others &= ~with_common_key(keys_[second], keys_[first], i);
    for (; others != 0; others &= others - 1)
      pairs.push_back(
          {items_[first * width + i], items_[second * width + static_cast<std::size_t>(std::countr_zero(others))]});
  }
}

void PackedBoxes::append_pairs_of(std::size_t pack, std::vector<Pair>& pairs) const {
  constexpr std::size_t most_levels = 12;  // 8^11 packs
  const Box bounds = levels_.front()[pack].bounds();
  struct Branch {
    std::size_t node = 0;
    std::uint32_t children = 0;  ///< not yet visited
  };
  std::array<Branch, most_levels> path;
  std::size_t level = levels_.size() - 1;
  if (level == 0) return append_pairs(pack, pack, bounds, pairs);
  path[level] = {0, overlapping(levels_[level].front(), bounds)};
  while (true) {
    Branch& branch = path[level];
    if (branch.children == 0) {
      if (++level == levels_.size()) return;
      continue;
    }
    const auto k = static_cast<std::size_t>(std::countr_zero(branch.children));
    branch.children &= branch.children - 1;
    const std::size_t child = branch.node * width + k;
    if (level == 1) {
      if (child >= pack) append_pairs(pack, child, levels_[1][branch.node].box(k), pairs);
      continue;
    }
    if (((child + 1) << (3 * (level - 1))) <= pack) continue;  // all of its packs come earlier
    --level;
    path[level] = {child, overlapping(levels_[level][child], bounds)};
  }
}

PackedBoxes::PackedBoxes(std::uint32_t count, BoxOf box_of, KeysOf keys_of) {
  std::vector<Placed> placed;
  resize_fresh(placed, count);
  std::vector<Box> bounds_of_run((count + grain - 1) / grain);
  for_each_run(count, [&](std::size_t first, std::size_t last) {
    Box bounds;
    for (std::size_t i = first; i < last; ++i) bounds.include(centre_of(box_of(static_cast<std::uint32_t>(i))));
    bounds_of_run[first / grain] = bounds;
  });
  Box bounds;
  for (const Box& b : bounds_of_run) bounds.include(b);
  const Cells cells(bounds);
  for_each_run(count, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const auto item = static_cast<std::uint32_t>(i);
      placed[i] = {cells.are_useful() ? cells.code(centre_of(box_of(item))) : 0, item};
    }
  });
  if (cells.are_useful()) {
    sort_by_code(placed);
    Ordering(box_of).order_within_cells(placed, 0);
  }

  resize_fresh(items_, count);
  Level& packs = levels_.emplace_back();
  resize_fresh(packs, (std::size_t{count} + width - 1) / width);
  resize_fresh(keys_, packs.size());
  for_each_run(count, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      items_[i] = placed[i].item;
      packs[i / width].set(i % width, box_of(placed[i].item));
      const Keys keys = keys_of(placed[i].item);
      for (std::size_t k = 0; k < 3; ++k) keys_[i / width].key[k][i % width] = keys[k];
    }
  });
  while (levels_.back().size() > 1) {
    const Level& below = levels_.back();
    Level above((below.size() + width - 1) / width);
    for_each_run(below.size(), [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) above[i / width].set(i % width, below[i].bounds());
    });
    levels_.push_back(std::move(above));
  }
}

}  // namespace strata
