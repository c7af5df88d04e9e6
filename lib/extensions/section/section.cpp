#include "strata/section.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "core/csg/arena.h"
#include "core/csg/plane_rectangle.h"
#include "core/exact/bounded.h"
#include "extensions/section/axis_plane.h"
#include "extensions/section/cut.h"
#include "extensions/section/general_position.h"
#include "extensions/section/positions.h"

namespace strata {
namespace {

using Index = std::uint32_t;

/// Any plane.
class AnyPlane {
 public:
  AnyPlane(const Plane& plane, const ExactMesh& mesh) : plane_(plane), axes_(axes_of(plane)), at_(mesh) {
    for (std::size_t i = 0; i < 3; ++i) normal_[i] = bounded(plane.normal[i]);
    offset_ = bounded(plane.offset);
    is_in_front_.resize(mesh.mesh.vertices.size());
    std::vector<bool> is_used(is_in_front_.size(), false);
    for (const Triangle& t : mesh.mesh.triangles)
      for (const Index v : t) is_used[v] = true;
    for (Index v = 0; v < is_in_front_.size(); ++v) is_in_front_[v] = is_used[v] && side(v) > 0;
  }

  [[nodiscard]] bool is_in_front(Index v) const { return is_in_front_[v]; }
  void add_crossing(Index behind, Index front, planar::LoopsBuilder& loops) const {
    const RationalPoint p = at_.exact(behind), q = at_.exact(front);
    const Rational below = plane_.offset - product(p), above = product(q) - plane_.offset, whole = below + above;
    const auto between = [&](std::size_t i) { return (p[i] * above + q[i] * below) / whole; };
    loops.add_vertex(planar::RationalPlacement{between(axes_.u), between(axes_.v)});
  }

 private:
  static Bounded bounded(const Rational& x) {
    const double nearest = to_nearest_double(x);
    return {nearest, std::abs(nearest) * Bounded::rounding + Bounded::underflow};
  }
  [[nodiscard]] Rational product(const RationalPoint& p) const {
    return plane_.normal[0] * p[0] + plane_.normal[1] * p[1] + plane_.normal[2] * p[2];
  }
  [[nodiscard]] int side(Index v) const {
    if (at_.rational(v) == nullptr) {
      const Vertex& p = at_.rounded(v);
      const Bounded value =
          normal_[0] * Bounded{p[0]} + normal_[1] * Bounded{p[1]} + normal_[2] * Bounded{p[2]} - offset_;
      if (const auto sign = value.sign()) return to_int(*sign);
    }
    return plane_.side(at_.exact(v));
  }

  const Plane& plane_;
  PlaneAxes axes_;
  Positions at_;
  std::array<Bounded, 3> normal_;
  Bounded offset_;
  std::vector<bool> is_in_front_;
};

/// Finds planes by their coordinates: at once where they are evenly spaced, as mostly, and else by halving.
class PlaneSearch {
 public:
  explicit PlaneSearch(std::span<const double> heights) : heights_(heights) {
    if (heights.size() < 2) return;
    const double range = heights.back() - heights.front(), per_unit = static_cast<double>(heights.size() - 1) / range;
    if (std::isfinite(range) && std::isfinite(per_unit)) per_unit_ = per_unit;
  }
  /// The first plane at a height or above it.
  [[nodiscard]] std::size_t first_from(double height) const {
    if (heights_.empty() || height <= heights_.front()) return 0;
    if (height > heights_.back()) return heights_.size();
    std::size_t k = 0;
    if (per_unit_ != 0)
      k = std::min(static_cast<std::size_t>((height - heights_.front()) * per_unit_), heights_.size() - 1);
    for (int step = 0; step < 3; ++step) {
      if (heights_[k] < height) {
        ++k;
      } else if (heights_[k - 1] >= height) {
        --k;
      } else {
        return k;
      }
    }
    return static_cast<std::size_t>(std::lower_bound(heights_.begin(), heights_.end(), height) - heights_.begin());
  }

 private:
  std::span<const double> heights_;
  double per_unit_ = 0;  ///< planes; 0 where it is not known
};

/// The triangles that planes may cross, for batches of planes in order.
class CrossedTriangles {
 public:
  CrossedTriangles(const Mesh& mesh, std::size_t axis, std::span<const double> heights)
      : range_(mesh.triangles.size()), first_(heights.size() + 1, 0) {
    const PlaneSearch search(heights);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, range_.size(), 4096), [&](const auto& block) {
      for (std::size_t t = block.begin(); t != block.end(); ++t) {
        const auto [low, high] =
            std::minmax({mesh.vertices[mesh.triangles[t][0]][axis], mesh.vertices[mesh.triangles[t][1]][axis],
                         mesh.vertices[mesh.triangles[t][2]][axis]});
        const std::size_t begin = search.first_from(low);
        std::size_t end = begin;  // mostly few planes farther on
        while (end < heights.size() && end - begin < 8 && heights[end] <= high) ++end;
        if (end - begin == 8)
          end = static_cast<std::size_t>(std::upper_bound(heights.begin(), heights.end(), high) - heights.begin());
        range_[t] = {static_cast<Index>(begin), static_cast<Index>(end)};
      }
    });
    for (const auto& [begin, end] : range_)
      if (begin < end) ++first_[begin + 1];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    starting_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (Index t = 0; t < range_.size(); ++t)
      if (range_[t].first < range_[t].second) starting_[next[range_[t].first]++] = t;
  }

  /// The triangles of each of the next planes: as many planes as have `most` crossings together, and one at least.
  std::vector<std::vector<Index>> take(std::size_t most_planes, std::size_t most_crossings) {
    std::vector<std::vector<Index>> lists;
    for (std::size_t crossings = 0; lists.size() < most_planes && next_ + 1 < first_.size(); ++next_) {
      active_.insert(active_.end(), starting_.begin() + static_cast<std::ptrdiff_t>(first_[next_]),
                     starting_.begin() + static_cast<std::ptrdiff_t>(first_[next_ + 1]));
      crossings += active_.size();
      if (!lists.empty() && crossings > most_crossings) {
        active_.resize(active_.size() - (first_[next_ + 1] - first_[next_]));
        break;
      }
      lists.push_back(active_);
      std::erase_if(active_, [&](Index t) { return range_[t].second <= next_ + 1; });
    }
    return lists;
  }

 private:
  std::vector<std::pair<Index, Index>> range_;  ///< per triangle: the first plane and the one behind the last
  std::vector<std::size_t> first_;              ///< per plane, in `starting_`
  std::vector<Index> starting_;                 ///< triangles by their first planes
  std::vector<Index> active_;                   ///< those that started before and go on
  std::size_t next_ = 0;
};

template <class PlaneOf>
planar::Region region_of(const Mesh& mesh, std::span<const Index> numbers, const PlaneOf& plane,
                         const Monitor& monitor) {
  const planar::Loops loops = cut(mesh.triangles, numbers, plane);
  const planar::Operand filled(loops, planar::FillRule::positive);
  return planar::combine({&filled, 1}, Operation::union_, monitor);
}

void check(std::size_t axis, std::span<const double> heights) {
  if (axis > 2) throw std::invalid_argument("an axis is 0, 1 or 2");
  for (std::size_t k = 0; k < heights.size(); ++k)
    if (!std::isfinite(heights[k]) || (k > 0 && heights[k] < heights[k - 1]))
      throw std::invalid_argument("planes are given by finite coordinates that do not decrease");
}

}  // namespace

PlaneAxes axes_of(const Plane& plane) {
  const std::size_t axis = main_axis(plane);
  const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
  return plane.normal[axis] > 0 ? PlaneAxes{u, v, axis} : PlaneAxes{v, u, axis};
}

RationalPoint point_in(const Plane& plane, const planar::RationalPlacement& p) {
  const PlaneAxes axes = axes_of(plane);
  RationalPoint r;
  r[axes.u] = p[0];
  r[axes.v] = p[1];
  r[axes.left_out] =
      (plane.offset - plane.normal[axes.u] * p[0] - plane.normal[axes.v] * p[1]) / plane.normal[axes.left_out];
  return r;
}

double true_area(const Plane& plane, const Rational& projected) {
  const Rational& n = plane.normal[axes_of(plane).left_out];
  Rational squares = 0;
  for (const Rational& x : plane.normal) squares += x * x;
  return to_nearest_double(projected) * std::sqrt(to_nearest_double(squares / (n * n)));
}

planar::Region section(const Solid& solid, const Plane& plane, const Options& options) {
  const Monitor monitor(options.cancel, &options.progress);
  monitor.check();
  const AnyPlane sides(plane, solid.exact_mesh());
  std::vector<Index> all(solid.mesh().triangles.size());
  std::iota(all.begin(), all.end(), 0U);
  return region_of(solid.mesh(), all, sides, monitor);
}

void slice(const Solid& solid, std::size_t axis, std::span<const double> coordinates,
           FunctionRef<void(std::size_t, planar::Region)> visit, const Options& options) {
  check(axis, coordinates);
  const Monitor monitor(options.cancel, &options.progress);
  const Monitor cancelled(options.cancel);
  monitor.check();
  const Mesh& mesh = solid.mesh();
  const Arena arena = arena_for(options, mesh.triangles.size() + coordinates.size());
  arena.execute([&] {
    CrossedTriangles crossed(mesh, axis, coordinates);
    constexpr std::size_t most_planes = 64, most_crossings = 1 << 24;
    for (std::size_t first = 0; first < coordinates.size();) {
      const std::vector<std::vector<Index>> triangles = crossed.take(most_planes, most_crossings);
      const std::size_t count = triangles.size();
      std::vector<planar::Region> regions(count);
      tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
        cancelled.check();
        const AxisPlane plane(axis, coordinates[first + i], solid.exact_mesh());
        auto region = section_in_general_position(mesh.triangles, triangles[i], plane);
        regions[i] = region ? std::move(*region) : region_of(mesh, triangles[i], plane, cancelled);
      });
      for (std::size_t i = 0; i < regions.size(); ++i) visit(first + i, std::move(regions[i]));
      first += count;
      monitor.report(static_cast<double>(first) / static_cast<double>(coordinates.size()));
    }
  });
  if (coordinates.empty()) monitor.report(1);
}

std::vector<planar::Region> slice(const Solid& solid, std::size_t axis, std::span<const double> coordinates,
                                  const Options& options) {
  std::vector<planar::Region> regions;
  slice(
      solid, axis, coordinates, [&](std::size_t, planar::Region region) { regions.push_back(std::move(region)); },
      options);
  return regions;
}

}  // namespace strata
