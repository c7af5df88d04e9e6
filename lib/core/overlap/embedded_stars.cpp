#include "core/overlap/embedded_stars.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <array>
#include <atomic>
#include <cmath>

#include "core/containers/huge_pages.h"

namespace strata {

namespace {

/// What one face contributes to the star of one of its vertices, joined by or: a bit per direction, set where it is not
/// certain to be seen from above; the same for below; then per axis, if its angle contains the half-plane in which that
/// coordinate is the vertex's (half open, one of the two there are), and if another face's does.
class StarFinder {
 public:
  /// Of projection: the three axes, then per axis the two diagonals of the others.
  static constexpr std::uint32_t directions = 9;
  static constexpr std::uint32_t once = 2 * directions, twice = once + 3;
  static constexpr std::uint32_t uncertain = (1u << 2 * directions) - 1;
  static constexpr std::uint32_t diagonals_across(std::uint32_t axis) { return 3 + 2 * axis; }

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
      look(diagonals_across(axis), normal[i] + normal[j], bound[i] + bound[j]);
      look(diagonals_across(axis) + 1, normal[i] - normal[j], bound[i] + bound[j]);
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
    return bits << once;
  }

  static bool is_embedded(std::uint32_t found) {
    const std::uint32_t met_once = found >> once & ~(found >> twice) & 7u;
    const std::uint32_t one_side = ~(found & found >> directions) & ((1u << directions) - 1);  // not seen from both
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
      if ((one_side >> axis & 1u) != 0 && (met_once & ~(1u << axis)) != 0) return true;
      if ((one_side >> diagonals_across(axis) & 3u) != 0 && (met_once >> axis & 1u) != 0) return true;
    }
    return false;
  }
};

/// Bits that were set before. Most are, and a look is cheaper than an exchange.
std::uint32_t add(std::atomic_ref<std::uint32_t> to, std::uint32_t bits) {
  const std::uint32_t before = to.load(std::memory_order_relaxed);
  return (bits & ~before) == 0 ? before : to.fetch_or(bits, std::memory_order_relaxed);
}

}  // namespace

EmbeddedStars::EmbeddedStars(const InputComplex& input, const Monitor& monitor) {
  const auto points = input.points(0);
  const auto faces = input.faces(0);
  std::vector<std::uint32_t> found_of;  // per vertex
  resize_fresh(found_of, points.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, faces.size(), 1 << 12), [&](const auto& range) {
    monitor.check();
    for (std::size_t f = range.begin(); f != range.end(); ++f) {
      const auto& t = faces[f];
      const std::array<const Vertex*, 3> corners{&points[t[0]], &points[t[1]], &points[t[2]]};
      const std::uint32_t hidden = input.has_doubles(t) ? StarFinder::sides_hidden(corners) : StarFinder::uncertain;
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t met = StarFinder::rays_met(*corners[i], *corners[(i + 1) % 3], *corners[(i + 2) % 3]);
        std::atomic_ref<std::uint32_t> found(found_of[t[i]]);
        const std::uint32_t before = add(found, hidden | met);
        add(found, (before & met) << (StarFinder::twice - StarFinder::once));
      }
    }
  });
  resize_fresh(is_embedded_, points.size());
  tbb::parallel_for(std::size_t{0}, points.size(),
                    [&](std::size_t v) { is_embedded_[v] = StarFinder::is_embedded(found_of[v]) ? 1 : 0; });
}

EmbeddedStars EmbeddedStars::of_part(std::span<const std::uint32_t> vertices) const {
  EmbeddedStars part;
  part.is_embedded_.reserve(vertices.size());
  for (const std::uint32_t v : vertices) part.is_embedded_.push_back(is_embedded_[v]);
  return part;
}

EmbeddedStars EmbeddedStars::of_whole(std::size_t count, std::span<const std::uint32_t> vertices,
                                      std::span<const std::pair<std::uint32_t, std::uint32_t>> equal) const {
  EmbeddedStars whole;
  resize_fresh(whole.is_embedded_, count);
  for (std::size_t v = 0; v < vertices.size(); ++v) whole.is_embedded_[vertices[v]] = is_embedded_[v];
  for (const auto& [vertex, first] : equal) whole.is_embedded_[vertex] = whole.is_embedded_[first];
  return whole;
}

}  // namespace strata
