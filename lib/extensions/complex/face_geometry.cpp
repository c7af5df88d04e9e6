#include "extensions/complex/face_geometry.h"

#include <algorithm>

#include "core/exact/bounded.h"

namespace strata::complex {
namespace {

Rational area_along(const Cells& cells, std::span<const Wing> wings, std::size_t axis) {
  const std::size_t i = (axis + 1) % 3, j = (axis + 2) % 3;
  Rational sum = 0;
  for (const Wing& w : wings) {
    const auto [low, high] = cells.edges[w.edge];
    const RationalPoint u = cells.position(w.left ? low : high), v = cells.position(w.left ? high : low);
    sum += u[i] * v[j] - u[j] * v[i];
  }
  return sum;
}

/// True when the area along an axis is certainly not zero. Rational coordinates are within an ulp of their doubles.
bool surely_has_area(const Cells& cells, std::span<const Wing> wings, std::size_t axis) {
  const std::size_t i = (axis + 1) % 3, j = (axis + 2) % 3;
  const auto bounded = [&](std::uint32_t v, std::size_t k) {
    const double x = cells.points[v][k], origin = cells.points[cells.edges[wings.front().edge][0]][k];
    return Bounded(x, cells.exact.empty() ? 0 : std::abs(x) * Bounded::rounding + Bounded::underflow) - Bounded(origin);
  };
  Bounded sum;
  for (const Wing& w : wings) {
    const auto [low, high] = cells.edges[w.edge];
    const std::uint32_t u = w.left ? low : high, v = w.left ? high : low;
    sum = sum + (bounded(u, i) * bounded(v, j) - bounded(u, j) * bounded(v, i));
  }
  return sum.sign() == Sign::positive;
}

}  // namespace

WingsOfFaces::WingsOfFaces(const Cells& cells) : wings_(cells.wings), first_(cells.count(2) + 1) {
  std::sort(wings_.begin(), wings_.end(),
            [](const Wing& a, const Wing& b) { return a.face != b.face ? a.face < b.face : a < b; });
  for (const Wing& w : wings_) ++first_[w.face + 1];
  for (std::size_t f = 0; f + 1 < first_.size(); ++f) first_[f + 1] += first_[f];
}

RationalPoint area_vector(const Cells& cells, std::span<const Wing> wings) {
  return {area_along(cells, wings, 0), area_along(cells, wings, 1), area_along(cells, wings, 2)};
}

std::size_t axis_of_face(const Cells& cells, std::span<const Wing> wings) {
  for (std::size_t axis = 0; axis < 2; ++axis)
    if (surely_has_area(cells, wings, axis) || area_along(cells, wings, axis) != 0) return axis;
  return 2;
}

}  // namespace strata::complex
