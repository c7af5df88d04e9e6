#include "core/io/triangulate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/io/ear_clipper.h"
#include "core/io/planar_polygon.h"
#include "core/kernel/predicates.h"

namespace strata::io {
namespace {

/// Areas of the polygon projected along x, y and z. Rounded: they only decide which axis is tried first.
std::array<double, 3> seen_areas(std::span<const Vertex> loop) {
  std::array<double, 3> area{};
  for (std::size_t i = 1; i + 1 < loop.size(); ++i)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
      area[axis] += (loop[i][u] - loop[0][u]) * (loop[i + 1][v] - loop[0][v]) -
                    (loop[i][v] - loop[0][v]) * (loop[i + 1][u] - loop[0][u]);
    }
  for (double& a : area) a = std::isnan(a) ? 0 : std::abs(a);
  return area;
}

/// The polygon projected along an axis such that it is counter-clockwise. Empty when it has no area.
std::vector<PlanePoint> seen_counter_clockwise(std::span<const Vertex> loop) {
  const auto area = seen_areas(loop);
  std::array<std::size_t, 3> axes{0, 1, 2};
  std::sort(axes.begin(), axes.end(),
            [&](std::size_t i, std::size_t j) { return area[i] != area[j] ? area[i] > area[j] : i < j; });
  std::vector<PlanePoint> points(loop.size());
  for (const std::size_t axis : axes) {
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    std::transform(loop.begin(), loop.end(), points.begin(), [&](const Vertex& p) { return PlanePoint{p[u], p[v]}; });
    const Sign sign = area_sign(points);
    if (sign == Sign::negative)
      for (auto& p : points) std::swap(p[0], p[1]);
    if (sign != Sign::zero) return points;
  }
  return {};
}

/// Convex at every corner and going around once: along a convex polygon the sides that point left (or straight down)
/// are consecutive.
bool is_strictly_convex(std::span<const PlanePoint> p) {
  const std::size_t n = p.size();
  const auto points_left = [&](std::size_t i) { return p[(i + 1) % n] < p[i]; };
  int runs = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (orient2d(p[i], p[(i + 1) % n], p[(i + 2) % n]) != Sign::positive) return false;
    runs += !points_left(i) && points_left((i + 1) % n);
  }
  return runs == 1;
}

/// Triangulates the corners first..last by halving: no corner has more than O(log n) triangles.
void halve(std::uint32_t first, std::uint32_t last, std::span<Triangle> triangles) {
  if (triangles.empty()) return;
  const std::uint32_t middle = last - (last - first) / 2;
  const std::uint32_t before = middle - first - 1;
  halve(first, middle, triangles.first(before));
  triangles[before] = {first, middle, last};
  halve(middle, last, triangles.subspan(before + 1));
}

void fan(std::span<Triangle> triangles) {
  for (std::uint32_t i = 0; i < triangles.size(); ++i) triangles[i] = {0, i + 1, i + 2};
}

}  // namespace

PolygonShape triangulate(std::span<const Vertex> loop, std::span<Triangle> triangles) {
  PolygonShape shape;
  if (loop.size() == 3) {
    triangles[0] = {0, 1, 2};
    return shape;
  }
  shape.planar = is_planar(loop);
  const auto points = seen_counter_clockwise(loop);
  if (points.empty()) {
    fan(triangles);
    shape.simple = false;
  } else if (is_strictly_convex(points)) {
    halve(0, static_cast<std::uint32_t>(loop.size() - 1), triangles);
  } else {
    shape.simple = EarClipper(points).clip(triangles);
  }
  return shape;
}

}  // namespace strata::io
