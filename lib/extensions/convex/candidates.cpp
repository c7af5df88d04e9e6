#include "extensions/convex/candidates.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>

#include "core/containers/z_order.h"
#include "extensions/convex/quickhull.h"

namespace strata::convex {
namespace {

constexpr std::uint32_t block = 512;

/// The points of a sample that are farthest along the axes, the space diagonals and the diagonals of coordinate planes.
std::vector<std::uint32_t> far_points(const PointCloud& cloud) {
  constexpr std::uint32_t sample = 1 << 16;
  constexpr std::array<Vertex, 13> directions{{{1, 0, 0},
                                               {0, 1, 0},
                                               {0, 0, 1},
                                               {1, 1, 0},
                                               {1, -1, 0},
                                               {1, 0, 1},
                                               {1, 0, -1},
                                               {0, 1, 1},
                                               {0, 1, -1},
                                               {1, 1, 1},
                                               {1, 1, -1},
                                               {1, -1, 1},
                                               {1, -1, -1}}};
  const std::uint32_t step = std::max(1u, cloud.size() / sample);
  std::array<std::uint32_t, 2 * directions.size()> far{};
  std::array<double, 2 * directions.size()> reach;
  reach.fill(-HUGE_VAL);
  for (std::uint32_t p = 0; p < cloud.size(); p += step) {
    const Vertex& at = cloud.at(p);
    for (std::size_t d = 0; d < far.size(); ++d) {
      const Vertex& n = directions[d / 2];
      const double along = n[0] * at[0] + n[1] * at[1] + n[2] * at[2], r = d % 2 == 0 ? along : -along;
      if (!(r > reach[d])) continue;
      reach[d] = r;
      far[d] = p;
    }
  }
  std::sort(far.begin(), far.end());
  return {far.begin(), std::unique(far.begin(), far.end())};
}

/// The points of a block that are not certainly in the hull with these planes.
class Sieve {
 public:
  explicit Sieve(const PointCloud& cloud, std::vector<Quickhull::Plane> planes)
      : cloud_(cloud), planes_(std::move(planes)) {}

  void append_outside(std::uint32_t begin, std::uint32_t end, std::vector<std::uint32_t>& outside) const {
    std::array<std::array<double, block>, 3> at;
    std::array<double, block> is_outside{};  // 0 or 1, as doubles, to be computed several at a time
    const std::uint32_t count = end - begin;
    for (std::uint32_t i = 0; i < count; ++i)
      for (std::size_t axis = 0; axis < 3; ++axis) at[axis][i] = cloud_.at(begin + i)[axis];
    for (const Quickhull::Plane& plane : planes_)
      for (std::uint32_t i = 0; i < count; ++i)
        is_outside[i] = plane.height({at[0][i], at[1][i], at[2][i]}) < -plane.bound ? is_outside[i] : 1;
    for (std::uint32_t i = 0; i < count; ++i)
      if (is_outside[i] != 0) outside.push_back(begin + i);
  }

 private:
  const PointCloud& cloud_;
  std::vector<Quickhull::Plane> planes_;
};

/// Sorts points along a Z-curve, within a cell by number.
void sort_by_place(const PointCloud& cloud, std::vector<std::uint32_t>& points) {
  Vertex scale;
  for (std::size_t i = 0; i < 3; ++i) scale[i] = 1023 / cloud.extent()[i].value;
  const auto cell = [&](std::uint32_t p, std::size_t axis) {
    const double x = (cloud.at(p)[axis] - cloud.lowest()[axis]) * scale[axis];
    return x > 0 ? static_cast<std::uint32_t>(std::min(x, 1023.0)) : 0U;  // of NaN, where this overflows, 0
  };
  std::vector<std::uint64_t> keys(points.size());
  tbb::parallel_for(std::size_t{0}, keys.size(), [&](std::size_t i) {
    const std::uint32_t p = points[i];
    keys[i] = std::uint64_t{z_order(cell(p, 0), cell(p, 1), cell(p, 2))} << 32 | p;
  });
  tbb::parallel_sort(keys);
  std::transform(keys.begin(), keys.end(), points.begin(),
                 [](std::uint64_t key) { return static_cast<std::uint32_t>(key); });
}

}  // namespace

std::vector<std::uint32_t> candidates(const PointCloud& cloud, const std::array<std::uint32_t, 4>& simplex,
                                      const Monitor& monitor) {
  Quickhull inner(cloud, simplex);
  inner.add(far_points(cloud), monitor);
  const Sieve sieve(cloud, inner.planes());
  std::vector<std::vector<std::uint32_t>> outside((cloud.size() + block - 1) / block);
  tbb::parallel_for(std::size_t{0}, outside.size(), [&](std::size_t i) {
    monitor.check();
    const auto begin = static_cast<std::uint32_t>(i) * block;
    sieve.append_outside(begin, std::min(begin + block, cloud.size()), outside[i]);
  });
  std::vector<std::uint32_t> rest;
  for (const auto& part : outside) rest.insert(rest.end(), part.begin(), part.end());
  sort_by_place(cloud, rest);
  std::vector<std::uint32_t> result(simplex.begin(), simplex.end());
  result.insert(result.end(), rest.begin(), rest.end());
  return result;
}

}  // namespace strata::convex
