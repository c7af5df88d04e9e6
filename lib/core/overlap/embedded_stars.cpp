#include "core/overlap/embedded_stars.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <array>
#include <atomic>
#include <cmath>

#include "core/containers/huge_pages.h"

namespace strata {
namespace {

constexpr std::uint32_t uncertain = 0b111'111;

/// Per axis: is a triangle not certain to be seen from above (bits 0 to 2), from below (3 to 5)? Bounds: each component
/// of the normal is a difference of two products of differences; theory.md, "Filters", of the kernel.
std::uint32_t sides_hidden(const std::array<const Vertex*, 3>& corners) {
  const auto& [a, b, c] = corners;
  std::array<double, 3> u{}, v{};
  for (std::size_t i = 0; i < 3; ++i) {
    u[i] = (*b)[i] - (*a)[i];
    v[i] = (*c)[i] - (*a)[i];
  }
  std::uint32_t bits = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t i = axis == 2 ? 0 : axis + 1, j = axis == 0 ? 2 : axis - 1;
    const double left = u[i] * v[j], right = u[j] * v[i];
    const double bound = (std::abs(left) + std::abs(right)) * (5 * 0x1p-53) + 0x1p-1060;
    bits |= static_cast<std::uint32_t>(!(left - right > bound)) << axis;
    bits |= static_cast<std::uint32_t>(!(right - left > bound)) << (axis + 3);
  }
  return bits;
}

/// Per axis: does the angle at `apex`, from one point to another, contain the ray in the direction of the next axis,
/// seen along this one? Exact: comparisons of coordinates, half open.
std::uint32_t rays_met(const Vertex& apex, const Vertex& from, const Vertex& to) {
  std::uint32_t bits = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t j = axis == 0 ? 2 : axis - 1;
    bits |= static_cast<std::uint32_t>((from[j] < apex[j]) & (to[j] >= apex[j])) << axis;
  }
  return bits;
}

}  // namespace

EmbeddedStars::EmbeddedStars(const InputComplex& input, const Monitor& monitor) {
  const auto points = input.points(0);
  const auto faces = input.faces(0);
  resize_fresh(found_, points.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, faces.size(), 1 << 12), [&](const auto& range) {
    monitor.check();
    for (std::size_t f = range.begin(); f != range.end(); ++f) {
      const auto& t = faces[f];
      const std::array<const Vertex*, 3> corners{&points[t[0]], &points[t[1]], &points[t[2]]};
      const std::uint32_t hidden = input.has_doubles(t) ? sides_hidden(corners) : uncertain;
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t met = rays_met(*corners[i], *corners[(i + 1) % 3], *corners[(i + 2) % 3]) << 6;
        std::atomic_ref<std::uint32_t> found(found_[t[i]]);
        const std::uint32_t before = found.fetch_or(hidden | met, std::memory_order_relaxed);
        if ((before & met) != 0) found.fetch_or((before & met) << 3, std::memory_order_relaxed);
      }
    }
  });
}

}  // namespace strata
