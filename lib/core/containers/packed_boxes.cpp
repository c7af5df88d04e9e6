#include "core/containers/packed_boxes.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <span>
#include <utility>

#include "core/containers/z_cells.h"

namespace strata {
namespace {

constexpr std::size_t grain = 1 << 14;

/// Calls `visit(first, last)` for runs of numbers below `count`, in parallel.
template <class Visit>
void for_each_run(std::size_t count, const Visit& visit) {
  tbb::parallel_for(std::size_t{0}, (count + grain - 1) / grain,
                    [&](std::size_t n) { visit(n * grain, std::min(count, (n + 1) * grain)); });
}

using Centre = std::array<double, 3>;

/// Halves before adding: the sum of two doubles may overflow.
Centre centre_of(const Box& b) {
  return {b.lower[0] / 2 + b.upper[0] / 2, b.lower[1] / 2 + b.upper[1] / 2, b.lower[2] / 2 + b.upper[2] / 2};
}

/// Orders items along a Z-curve; those in one cell, if there are more than a pack, along one of their own.
class Ordering {
 public:
  explicit Ordering(PackedBoxes::BoxOf box_of) : box_of_(box_of) {}

  void order(std::span<PlacedItem> placed, int depth) const {
    Box bounds;
    for (const PlacedItem& p : placed) bounds.include(centre_of(box_of_(p.item)));
    const ZCells cells(bounds);
    if (!cells.are_useful()) return;
    for (PlacedItem& p : placed) p.code = cells.code(centre_of(box_of_(p.item)));
    std::sort(placed.begin(), placed.end(), [](const PlacedItem& a, const PlacedItem& b) {
      return a.code < b.code || (a.code == b.code && a.item < b.item);
    });
    order_within_cells(placed, depth);
  }

  /// Requires items sorted by code.
  void order_within_cells(std::span<PlacedItem> placed, int depth) const {
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

/// The last of the packs for `count` boxes may have lanes beyond them.
void clear_last_lanes(FreshArray<BoxPack>& packs, std::size_t count) {
  for (std::size_t k = count % BoxPack::width; k != 0 && k < BoxPack::width; ++k) packs[packs.size() - 1].set_empty(k);
}

}  // namespace

inline void PackedBoxes::append_pairs(std::size_t first, std::size_t second, const Box& bounds_of_second,
                                      std::vector<Pair>& pairs) const {
  BoxPackTests::Masks masks;
  std::uint32_t own = tests_->pairs(levels_.front()[first], keys_[first], levels_.front()[second], keys_[second],
                                    bounds_of_second, masks);
  for (; own != 0; own &= own - 1) {
    const auto i = static_cast<std::uint32_t>(std::countr_zero(own));
    std::uint32_t others = masks[i];
    if (first == second) others &= ~((std::uint32_t{2} << i) - 1);
    for (; others != 0; others &= others - 1)
      pairs.push_back(
          {items_[first * width + i], items_[second * width + static_cast<std::size_t>(std::countr_zero(others))]});
  }
}

/// Descends to the nodes of packs that meet these bounds, but for those before `first`: calls visit(node, packs), with
/// a bit for each of its packs.
template <class Visit>
void PackedBoxes::for_each_near(const Box& bounds, std::size_t first, const Visit& visit) const {
  constexpr std::size_t most_levels = 12;  // 8^11 packs
  struct Branch {
    std::size_t node = 0;
    std::uint32_t children = 0;  ///< not yet visited
  };
  std::array<Branch, most_levels> path;
  const std::size_t top = levels_.size() - 1;
  std::size_t level = top;
  path[level] = {0, tests_->overlapping(levels_[level][0], bounds)};
  while (level <= top) {
    Branch& branch = path[level];
    if (level == 1) {
      if (branch.node >= first) visit(branch.node, branch.children);
      ++level;
      continue;
    }
    if (branch.children == 0) {
      ++level;
      continue;
    }
    const std::size_t child = branch.node * width + static_cast<std::size_t>(std::countr_zero(branch.children));
    branch.children &= branch.children - 1;
    if (((child + 1) << (3 * (level - 2))) <= first) continue;  // all of its nodes come earlier
    --level;
    path[level] = {child, tests_->overlapping(levels_[level][child], bounds)};
  }
}

std::span<const std::uint32_t> PackedBoxes::items_of(std::size_t group) const {
  constexpr std::size_t size = width * width;
  const std::size_t first = group * size;
  return {items_.begin() + first, items_.begin() + std::min(first + size, items_.size())};
}

void PackedBoxes::append_pairs_of(std::size_t group, std::vector<Pair>& pairs) const {
  append_pairs_of(group, pairs, [](auto, auto) { return false; });
}

void PackedBoxes::append_pairs_of(std::size_t group, std::vector<Pair>& pairs, AreApart are_apart) const {
  if (levels_.size() == 1) return append_pairs(0, 0, levels_.front()[0].bounds(), pairs);
  constexpr std::size_t many = width * width / 4;  // pairs of one pack: a quarter of those there can be with one group
  struct Node {
    std::size_t number;
    std::uint32_t packs;
    bool is_asked;
  };
  std::vector<Node> near;
  for_each_near(levels_[1][group].bounds(), group, [&](std::size_t node, std::uint32_t packs) {
    if (packs != 0) near.push_back({node, packs, node == group});
  });
  for (std::size_t pack = group * width; pack < std::min(pack_count(), (group + 1) * width); ++pack) {
    const Box bounds = levels_[1][group].box(pack % width);
    for (Node& node : near) {
      const std::size_t before = pairs.size();
      for (std::uint32_t packs = tests_->overlapping(levels_[1][node.number], bounds) & node.packs; packs != 0;
           packs &= packs - 1) {
        const auto k = static_cast<std::size_t>(std::countr_zero(packs));
        if (const std::size_t other = node.number * width + k; other >= pack)
          append_pairs(pack, other, levels_[1][node.number].box(k), pairs);
      }
      if (node.is_asked || pairs.size() - before < many) continue;
      node.is_asked = true;
      if (!are_apart(items_of(group), items_of(node.number))) continue;
      node.packs = 0;
      pairs.resize(before);
    }
  }
}

PackedBoxes::PackedBoxes(std::uint32_t count, const Box& bounds, BoxOf box_of, KeysOf keys_of,
                         const BoxPackTests& tests)
    : tests_(&tests) {
  FreshArray<PlacedItem> placed(count);
  const ZCells cells(bounds);
  for_each_run(count, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const auto item = static_cast<std::uint32_t>(i);
      placed[i] = {cells.are_useful() ? cells.code(centre_of(box_of(item))) : 0, item};
    }
  });
  if (cells.are_useful()) {
    sort_by_code(placed);
    Ordering(box_of).order_within_cells({placed.begin(), placed.end()}, 0);
  }

  items_ = FreshArray<std::uint32_t>(count);
  Level& packs = levels_.emplace_back((std::size_t{count} + width - 1) / width);
  keys_ = FreshArray<KeyPack>(packs.size());
  for_each_run(count, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      items_[i] = placed[i].item;
      packs[i / width].set(i % width, box_of(placed[i].item));
      const Keys keys = keys_of(placed[i].item);
      for (std::size_t k = 0; k < 3; ++k) keys_[i / width].key[k][i % width] = keys[k];
    }
  });
  clear_last_lanes(packs, count);
  for (std::size_t k = count % width; k != 0 && k < width; ++k)
    for (auto& key : keys_[packs.size() - 1].key) key[k] = KeyPack::no_key;
  while (levels_.back().size() > 1) {
    const Level& below = levels_.back();
    Level above((below.size() + width - 1) / width);
    for_each_run(below.size(), [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) above[i / width].set(i % width, below[i].bounds());
    });
    clear_last_lanes(above, below.size());
    levels_.push_back(std::move(above));
  }
}

}  // namespace strata
