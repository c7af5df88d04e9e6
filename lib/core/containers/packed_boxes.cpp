#include "core/containers/packed_boxes.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <span>

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
    constexpr int most_depth =
        256;  // each level divides the extent by 1024 at least once in two: more than all doubles
    if (depth == most_depth) return;
    for (std::size_t i = 0, end = 0; i < placed.size(); i = end) {
      while (end < placed.size() && placed[end].code == placed[i].code) ++end;
      if (end - i > crowd) order(placed.subspan(i, end - i), depth + 1);
    }
  }

 private:
  static constexpr std::size_t crowd = 4 * BoxPack::width;
  PackedBoxes::BoxOf box_of_;
};

}  // namespace

PackedBoxes::PackedBoxes(std::uint32_t count, BoxOf box_of) {
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

  constexpr std::size_t width = BoxPack::width;
  resize_fresh(items_, count);
  Level& packs = levels_.emplace_back();
  resize_fresh(packs, (std::size_t{count} + width - 1) / width);
  for_each_run(count, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      items_[i] = placed[i].item;
      packs[i / width].set(i % width, box_of(placed[i].item));
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
