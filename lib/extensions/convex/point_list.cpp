#include "extensions/convex/point_list.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <compare>
#include <numeric>
#include <optional>
#include <span>

namespace strata::convex {
namespace {

/// Orders corners by their exact positions.
class Places {
 public:
  Places(const HyperplaneTable<3>& table, const CellMaker& maker, std::span<const std::uint32_t> corners)
      : table_(table), maker_(maker), corners_(corners), rounded_(corners.size()), exact_(corners.size()) {
    constexpr std::size_t at_once = 128;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, corners.size(), at_once), [&](const auto& range) {
      for (std::size_t k = range.begin(); k < range.end(); ++k) rounded_[k] = table_.rounded(corner(k));
    });
  }

  [[nodiscard]] const RoundedPoint<3>& operator[](std::size_t k) const { return rounded_[k]; }
  [[nodiscard]] const HyperplaneMeet<3>& corner(std::size_t k) const { return maker_.corner(corners_[k]); }

  /// Rounding is monotone, so exact positions are compared only for equal doubles with equal signs of the rounding
  /// error.
  [[nodiscard]] std::strong_ordering compare(std::size_t a, std::size_t b) {
    const RoundedPoint<3>&p = rounded_[a], &q = rounded_[b];
    for (std::size_t i = 0; i < 3; ++i) {
      if (p.nearest[i] != q.nearest[i]) return less_if(p.nearest[i] < q.nearest[i]);
      if (p.rest[i] != q.rest[i]) return less_if(p.rest[i] < q.rest[i]);
      if (p.rest[i] == Sign::zero) continue;
      if (p.nearest == q.nearest && p.rest == q.rest && are_equal(a, b)) return std::strong_ordering::equal;
      const Rational &x = exact(a)[i], &y = exact(b)[i];
      if (x != y) return less_if(x < y);
    }
    return std::strong_ordering::equal;
  }

 private:
  static std::strong_ordering less_if(bool is_less) {
    return is_less ? std::strong_ordering::less : std::strong_ordering::greater;
  }
  [[nodiscard]] bool are_equal(std::size_t a, std::size_t b) const {
    const std::array<std::uint32_t, 3>& names = corner(b).names;
    return std::all_of(names.begin(), names.end(),
                       [&](std::uint32_t plane) { return table_.side(plane, corner(a)) == Sign::zero; });
  }
  const RationalPoint& exact(std::size_t k) {
    if (!exact_[k]) exact_[k] = table_.position(corner(k));
    return *exact_[k];
  }

  const HyperplaneTable<3>& table_;
  const CellMaker& maker_;
  std::span<const std::uint32_t> corners_;
  std::vector<RoundedPoint<3>> rounded_;
  std::vector<std::optional<RationalPoint>> exact_;  ///< those that were needed
};

}  // namespace

std::uint32_t PointList::number_of(std::uint32_t corner) {
  const std::uint32_t root = maker_.representative(corner);
  const auto [known, is_new] = of_corner_.try_emplace(root, static_cast<std::uint32_t>(corners_.size()));
  if (is_new) corners_.push_back(root);
  return known->second;
}

std::vector<std::uint32_t> PointList::sorted(std::vector<Vertex>& points, std::vector<MeetOfThree>& meets) const {
  Places places(table_, maker_, corners_);
  std::vector<std::uint32_t> order(corners_.size()), point_of(corners_.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return places.compare(a, b) == std::strong_ordering::less; });
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (k == 0 || places.compare(order[k - 1], order[k]) != std::strong_ordering::equal) {
      const RoundedPoint<3>& place = places[order[k]];
      if (!place.is_exact())
        meets.push_back({static_cast<std::uint32_t>(points.size()), places.corner(order[k]).names});
      points.push_back(place.nearest);
    }
    point_of[order[k]] = static_cast<std::uint32_t>(points.size() - 1);
  }
  return point_of;
}

}  // namespace strata::convex
