#pragma once
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/kernel/box.h"
#include "strata/function.h"

namespace strata {

/// Eight boxes, for one comparison with all of them. Empty boxes fill up those that are missing.
struct BoxPack {
  static constexpr std::size_t width = 8;
  std::array<std::array<double, width>, 3> lower, upper;

  BoxPack() {
    for (auto& axis : lower) axis.fill(Box::infinity);
    for (auto& axis : upper) axis.fill(-Box::infinity);
  }
  void set(std::size_t k, const Box& box) {
    for (std::size_t i = 0; i < 3; ++i) {
      lower[i][k] = box.lower[i];
      upper[i][k] = box.upper[i];
    }
  }
  [[nodiscard]] Box box(std::size_t k) const {
    return {{lower[0][k], lower[1][k], lower[2][k]}, {upper[0][k], upper[1][k], upper[2][k]}};
  }
  /// Of all eight.
  [[nodiscard]] Box bounds() const {
    Box all;
    for (std::size_t k = 0; k < width; ++k) all.include(box(k));
    return all;
  }
  /// Bit k: box k has a point in common with this one.
  [[nodiscard]] std::uint32_t overlapping(const Box& b) const {
    // Two at a time: vectors that every processor has, where the compiler finds none by itself.
    using Lanes [[gnu::vector_size(16)]] = double;
    using Bits [[gnu::vector_size(16)]] = std::int64_t;
    Bits all{};
    for (std::size_t k = 0; k < width; k += 2) {
      Bits met{std::int64_t{1} << k, std::int64_t{2} << k};
      for (std::size_t i = 0; i < 3; ++i) {
        const Lanes low{lower[i][k], lower[i][k + 1]}, high{upper[i][k], upper[i][k + 1]};
        met &= (low <= b.upper[i]) & (high >= b.lower[i]);
      }
      all |= met;
    }
    return static_cast<std::uint32_t>(all[0] | all[1]);
  }
};

/// The boxes of numbered items in packs of eight along a Z-curve, and a tree of packs above them: for all pairs of many
/// boxes of similar size. It is quicker to build and to ask about all of its items than a BoxTree. An immutable value,
/// the same for any number of threads. About 70 bytes per item.
class PackedBoxes {
 public:
  using BoxOf = FunctionRef<Box(std::uint32_t item)>;

  /// Over items 0, ..., count - 1, whose boxes are asked for several times, from several threads at once. Empty boxes
  /// meet nothing. O(n) for items of even density, O(n log n) times the binary orders of magnitude of the distances at
  /// worst. In parallel.
  PackedBoxes(std::uint32_t count, BoxOf box_of);

  [[nodiscard]] std::size_t pack_count() const { return levels_.front().size(); }

  /// Calls `visit(item, other)` for the pairs of overlapping boxes whose first member, in the order of the packs, is in
  /// this pack. Over all packs, every pair once. Always in the same order. Thread-safe.
  template <class Visit>
  void for_each_pair_of(std::size_t pack, const Visit& visit) const;

 private:
  using Level = std::vector<BoxPack>;
  template <class Visit>
  void for_each_pair(std::size_t first, std::size_t second, const Box& bounds_of_second, const Visit& visit) const;

  std::vector<std::uint32_t> items_;  ///< in the order of the packs
  std::vector<Level> levels_;         ///< the items' boxes; the bounds of these packs; and so on, up to one pack
};

template <class Visit>
void PackedBoxes::for_each_pair_of(std::size_t pack, const Visit& visit) const {
  constexpr std::size_t most_levels = 12;  // 8^11 packs
  const Box bounds = levels_.front()[pack].bounds();
  struct Branch {
    std::size_t node = 0;
    std::uint32_t children = 0;  ///< not yet visited
  };
  std::array<Branch, most_levels> path;
  std::size_t level = levels_.size() - 1;
  if (level == 0) return for_each_pair(pack, pack, bounds, visit);
  path[level] = {0, levels_[level].front().overlapping(bounds)};
  while (true) {
    Branch& branch = path[level];
    if (branch.children == 0) {
      if (++level == levels_.size()) return;
      continue;
    }
    const auto k = static_cast<std::size_t>(std::countr_zero(branch.children));
    branch.children &= branch.children - 1;
    const std::size_t child = branch.node * BoxPack::width + k;
    if (level == 1) {
      if (child >= pack) for_each_pair(pack, child, levels_[1][branch.node].box(k), visit);
      continue;
    }
    if (((child + 1) << (3 * (level - 1))) <= pack) continue;  // all of its packs come earlier
    --level;
    path[level] = {child, levels_[level][child].overlapping(bounds)};
  }
}

template <class Visit>
void PackedBoxes::for_each_pair(std::size_t first, std::size_t second, const Box& bounds_of_second,
                                const Visit& visit) const {
  const BoxPack &a = levels_.front()[first], &b = levels_.front()[second];
  for (std::uint32_t own = a.overlapping(bounds_of_second); own != 0; own &= own - 1) {
    const auto i = static_cast<std::uint32_t>(std::countr_zero(own));
    std::uint32_t others = b.overlapping(a.box(i));
    if (first == second) others &= ~((std::uint32_t{2} << i) - 1);
    for (; others != 0; others &= others - 1)
      visit(items_[first * BoxPack::width + i],
            items_[second * BoxPack::width + static_cast<std::size_t>(std::countr_zero(others))]);
  }
}

}  // namespace strata
