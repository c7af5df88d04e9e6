#include "extensions/convex/polygon_hull.h"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <numeric>

namespace strata::convex {
namespace {

/// An axis that is not parallel to the plane: projected along it, different points are different.
std::size_t axis_of_view(const PointCloud& cloud, const std::array<std::uint32_t, 3>& t) {
  for (std::size_t axis = 0; axis < 2; ++axis)
    if (cloud.orientation(t[0], t[1], t[2], axis) != Sign::zero) return axis;
  return 2;
}

/// The chain of counter-clockwise turns through sorted points; the last point belongs to the chain back.
template <class Iterator>
void append_chain(const PointCloud& cloud, std::size_t axis, Iterator begin, Iterator end,
                  std::vector<std::uint32_t>& corners) {
  const std::size_t least = corners.size() + 2;
  for (; begin != end; ++begin) {
    while (corners.size() >= least &&
           cloud.orientation(corners[corners.size() - 2], corners.back(), *begin, axis) != Sign::positive)
      corners.pop_back();
    corners.push_back(*begin);
  }
  corners.pop_back();
}

}  // namespace

std::vector<std::uint32_t> polygon_hull(const PointCloud& cloud, const std::array<std::uint32_t, 3>& triangle) {
  const std::size_t axis = axis_of_view(cloud, triangle);
  const auto compare = [&](std::uint32_t p, std::uint32_t q) {
    const Sign s = cloud.compare(p, q, (axis + 1) % 3);
    return s != Sign::zero ? s : cloud.compare(p, q, (axis + 2) % 3);
  };
  std::vector<std::uint32_t> order(cloud.size());
  std::iota(order.begin(), order.end(), 0);
  tbb::parallel_sort(order, [&](std::uint32_t p, std::uint32_t q) { return compare(p, q) == Sign::negative; });
  order.erase(std::unique(order.begin(), order.end(),
                          [&](std::uint32_t p, std::uint32_t q) { return compare(p, q) == Sign::zero; }),
              order.end());
  std::vector<std::uint32_t> corners;
  append_chain(cloud, axis, order.begin(), order.end(), corners);
  append_chain(cloud, axis, order.rbegin(), order.rend(), corners);
  return corners;
}

}  // namespace strata::convex
