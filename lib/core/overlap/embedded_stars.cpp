#include "core/overlap/embedded_stars.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <array>
#include <atomic>
#include <cmath>

#include "core/containers/huge_pages.h"

namespace strata {

/// What one face contributes to the stars of its vertices.
class StarFinder {
 public:
  static constexpr std::uint32_t directions = EmbeddedStars::directions;
  static constexpr std::uint32_t uncertain = (1u << 2 * directions) - 1;

  /// From which directions is a triangle not certain to be seen from above, and from below?
  ///
  /// A component of the normal is a difference of products of differences, with an error of at most 4 units of the sum
  /// of the products' sizes (theory.md of the kernel, "Filters"). The sum of two adds a rounding error below a unit of
  /// that.
  static std::uint32_t sides_hidden(const std::array<const Vertex*, 3>& corners) {
    const auto& [a, b, c] = corners;
    std::array<double, 3> u{}, v{}, normal{}, bound{};
    for (std::size_t i = 0; i < 3; ++i) {
      u[i] = (*b)[i] - (*a)[i];
      v[i] = (*c)[i] - (*a)[i];
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t i = axis == 2 ? 0 : axis + 1, j = axis == 0 ? 2 : axis - 1;
      const double left = u[i] * v[j], right = u[j] * v[i];
      normal[axis] = left - right;
      bound[axis] = (std::abs(left) + std::abs(right)) * (6 * 0x1p-53) + 0x1p-1060;
    }
    std::uint32_t bits = 0;
    const auto look = [&bits](std::uint32_t direction, double value, double error) {
      bits |= static_cast<std::uint32_t>(!(value > error)) << direction;
      bits |= static_cast<std::uint32_t>(!(-value > error)) << (direction + directions);
    };
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
      const std::size_t i = axis == 2 ? 0 : axis + 1, j = axis == 0 ? 2 : axis - 1;
      look(axis, normal[axis], bound[axis]);
      look(EmbeddedStars::diagonals_across(axis), normal[i] + normal[j], bound[i] + bound[j]);
      look(EmbeddedStars::diagonals_across(axis) + 1, normal[i] - normal[j], bound[i] + bound[j]);
    }
    return bits;
  }

  /// Per axis: does the angle at `apex` cross the plane of its coordinate upwards? Projected along a direction in that
  /// plane, the plane is a line, and an angle below 180 degrees that crosses it contains one of its two rays: always
  /// the same one for angles of one orientation. Exact: comparisons of coordinates, half open.
  static std::uint32_t rays_met(const Vertex& apex, const Vertex& from, const Vertex& to) {
    std::uint32_t bits = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      bits |= (static_cast<std::uint32_t>(from[axis] < apex[axis]) & static_cast<std::uint32_t>(to[axis] >= apex[axis]))
              << axis;
    return bits << EmbeddedStars::once;
  }
};

EmbeddedStars::EmbeddedStars(const InputComplex& input, const Monitor& monitor) {
  const auto points = input.points(0);
  const auto faces = input.faces(0);
  resize_fresh(found_, points.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, faces.size(), 1 << 12), [&](const auto& range) {
    monitor.check();
    for (std::size_t f = range.begin(); f != range.end(); ++f) {
      const auto& t = faces[f];
      const std::array<const Vertex*, 3> corners{&points[t[0]], &points[t[1]], &points[t[2]]};
      const std::uint32_t hidden = input.has_doubles(t) ? StarFinder::sides_hidden(corners) : StarFinder::uncertain;
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t met = StarFinder::rays_met(*corners[i], *corners[(i + 1) % 3], *corners[(i + 2) % 3]);
        std::atomic_ref<std::uint32_t> found(found_[t[i]]);
        const std::uint32_t before = found.fetch_or(hidden | met, std::memory_order_relaxed);
        if ((before & met) != 0) found.fetch_or((before & met) << (twice - once), std::memory_order_relaxed);
      }
    }
  });
}

}  // namespace strata
