#include "core/mesh/planar_points.h"

#include <algorithm>
#include <numeric>

namespace strata::facets {
namespace {

int sign_of(std::strong_ordering comparison) { return (comparison > 0) - (comparison < 0); }

int compare_coordinate(const HPoint<Integer>& a, const HPoint<Integer>& b, int axis) {
  if (a.w == b.w) return sign_of(a[axis].compare(b[axis]));
  const Integer left = a[axis] * b.w;
  const Integer right = b[axis] * a.w;
  return sign_of(left.compare(right));
}

int compare_points(const HPoint<Integer>& a, const HPoint<Integer>& b) {
  for (int axis = 0; axis < 3; ++axis) {
    if (const int order = compare_coordinate(a, b, axis); order != 0) return order;
  }
  return 0;
}

std::vector<std::uint32_t> coordinate_ranks(const std::vector<HPoint<Integer>>& points, int axis,
                                            const Monitor& monitor) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    monitor.check();
    return compare_coordinate(points[a], points[b], axis) < 0;
  });
  std::vector<std::uint32_t> ranks(points.size(), 0);
  for (std::size_t i = 1; i < order.size(); ++i) {
    const bool larger = compare_coordinate(points[order[i - 1]], points[order[i]], axis) < 0;
    ranks[order[i]] = ranks[order[i - 1]] + larger;
  }
  return ranks;
}

}  // namespace

PointTable::PointTable(std::vector<HPoint<Integer>> points, std::vector<std::uint32_t>& name_of,
                       const Monitor& monitor) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    monitor.check();
    return compare_points(points[a], points[b]) < 0;
  });
  name_of.assign(points.size(), 0);
  for (const std::uint32_t i : order) {
    if (points_.empty() || compare_points(points_.back(), points[i]) != 0) points_.push_back(std::move(points[i]));
    name_of[i] = static_cast<std::uint32_t>(points_.size() - 1);
  }
  sorted_ = points_.size();
  for (int axis = 1; axis < 3; ++axis) ranks_[axis - 1] = coordinate_ranks(points_, axis, monitor);
}

std::uint32_t PointTable::add(HPoint<Integer> p) {
  points_.push_back(std::move(p));
  return static_cast<std::uint32_t>(points_.size() - 1);
}

int PointTable::compare(std::uint32_t a, std::uint32_t b) const {
  if (a == b) return 0;
  if (a < sorted_ && b < sorted_) return a < b ? -1 : 1;
  return compare_points(points_[a], points_[b]);
}

int orientation(const PointTable& points, Projection axes, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  const HPoint<Integer>& p = points[a];
  const HPoint<Integer>& q = points[b];
  const HPoint<Integer>& r = points[c];
  const auto difference = [&p](const HPoint<Integer>& s, int axis) -> Integer {  // (s - p) w_s w_p
    if (s.w == p.w) return s[axis] - p[axis];                                    // times w_p less: the sign is the same
    return s[axis] * p.w - p[axis] * s.w;
  };
  const Integer left = difference(q, axes.u) * difference(r, axes.v);
  const Integer right = difference(q, axes.v) * difference(r, axes.u);
  return sign_of(left.compare(right));
}

}  // namespace strata::facets
