#include "strata/convex/point_list.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <compare>
#include <numeric>
#include <optional>
#include <utility>

namespace strata::convex {
namespace {

struct Place {
  Vertex nearest{};
  std::optional<RationalPoint> exact;  ///< where these doubles are not exact
};

Place place_of(const HyperplaneTable<3>& table, const Corner<3>& corner) {
  Place place;
  if (corner.is_given()) {
    for (std::size_t i = 0; i < 3; ++i) place.nearest[i] = corner.at[i].value + 0.0;  // -0 is 0
    return place;
  }
  RationalPoint p = table.position(corner);
  bool is_exact = true;
  for (std::size_t i = 0; i < 3; ++i) {
    place.nearest[i] = to_nearest_double(p[i]);
    is_exact &= to_rational(place.nearest[i]) == p[i];
  }
  if (!is_exact) place.exact = std::move(p);
  return place;
}

/// By exact places. Rounding to nearest keeps the order, so rationals decide only between equal doubles.
std::strong_ordering compare(const Place& a, const Place& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (a.nearest[i] != b.nearest[i])
      return a.nearest[i] < b.nearest[i] ? std::strong_ordering::less : std::strong_ordering::greater;
    if (!a.exact && !b.exact) continue;
    const Rational x = a.exact ? (*a.exact)[i] : to_rational(a.nearest[i]);
    const Rational y = b.exact ? (*b.exact)[i] : to_rational(b.nearest[i]);
    if (x != y) return x < y ? std::strong_ordering::less : std::strong_ordering::greater;
  }
  return std::strong_ordering::equal;
}

}  // namespace

std::uint32_t PointList::number_of(std::uint32_t corner) {
  const std::uint32_t root = maker_.representative(corner);
  const auto [known, is_new] = of_corner_.try_emplace(root, static_cast<std::uint32_t>(corners_.size()));
  if (is_new) corners_.push_back(root);
  return known->second;
}

std::vector<std::uint32_t> PointList::sorted(std::vector<Vertex>& points, std::vector<ExactVertex>& exact) const {
  std::vector<Place> places(corners_.size());
  tbb::parallel_for(std::size_t{0}, places.size(),
                    [&](std::size_t k) { places[k] = place_of(table_, maker_.corner(corners_[k])); });
  std::vector<std::uint32_t> order(places.size()), point_of(places.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return compare(places[a], places[b]) == std::strong_ordering::less;
  });
  for (std::size_t k = 0; k < order.size(); ++k) {
    Place& place = places[order[k]];
    if (k == 0 || compare(places[order[k - 1]], place) != std::strong_ordering::equal) {
      points.push_back(place.nearest);
      if (place.exact) exact.push_back({static_cast<std::uint32_t>(points.size() - 1), *place.exact});
    }
    point_of[order[k]] = static_cast<std::uint32_t>(points.size() - 1);
  }
  return point_of;
}

}  // namespace strata::convex
