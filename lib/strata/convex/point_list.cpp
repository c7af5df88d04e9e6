#include "strata/convex/point_list.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "strata/mesh/corner_hash.h"

namespace strata::convex {

PointList::Place PointList::place_of(const RationalPoint& p) {
  Place place;
  bool is_exact = true;
  for (std::size_t i = 0; i < 3; ++i) {
    place.nearest[i] = to_nearest_double(p[i]);
    is_exact &= to_rational(place.nearest[i]) == p[i];
  }
  if (!is_exact) place.exact = p;
  return place;
}

bool PointList::is_same(const Place& a, const Place& b) { return a.nearest == b.nearest && a.exact == b.exact; }

std::uint32_t PointList::number_of(std::uint32_t corner) {
  const std::uint32_t root = maker_.representative(corner);
  const auto [known, is_new] = of_corner_.try_emplace(root, static_cast<std::uint32_t>(places_.size()));
  if (!is_new) return known->second;
  const Corner<3>& c = maker_.corner(root);
  Place place = c.is_given() ? Place{{c.at[0].value, c.at[1].value, c.at[2].value}, {}} : place_of(table_.position(c));
  for (double& x : place.nearest) x += 0.0;  // -0 is 0
  const std::size_t hash = hash_of(place.nearest);
  const auto [begin, end] = of_hash_.equal_range(hash);
  const auto same = std::find_if(begin, end, [&](const auto& h) { return is_same(places_[h.second], place); });
  if (same != end) return known->second = same->second;
  of_hash_.emplace(hash, known->second);
  places_.push_back(std::move(place));
  return known->second;
}

// Rounding to nearest keeps the order, so exact places decide only between equal doubles.
bool PointList::is_before(const Place& a, const Place& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (a.nearest[i] != b.nearest[i]) return a.nearest[i] < b.nearest[i];
    if (!a.exact && !b.exact) continue;
    const Rational x = a.exact ? (*a.exact)[i] : to_rational(a.nearest[i]);
    const Rational y = b.exact ? (*b.exact)[i] : to_rational(b.nearest[i]);
    if (x != y) return x < y;
  }
  return false;
}

std::vector<std::uint32_t> PointList::sorted(std::vector<Vertex>& points, std::vector<ExactVertex>& exact) const {
  std::vector<std::uint32_t> order(places_.size()), rank(places_.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return is_before(places_[a], places_[b]); });
  for (std::uint32_t k = 0; k < order.size(); ++k) {
    const Place& place = places_[order[k]];
    rank[order[k]] = k;
    points.push_back(place.nearest);
    if (place.exact) exact.push_back({k, *place.exact});
  }
  return rank;
}

}  // namespace strata::convex
