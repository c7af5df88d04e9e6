#include "core/io/planar_polygon.h"

#include <algorithm>
#include <cstddef>

#include "core/kernel/predicates.h"

namespace strata::io {
namespace {

bool is_collinear(const Vertex& a, const Vertex& b, const Vertex& c) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if (orient2d({a[i], a[j]}, {b[i], b[j]}, {c[i], c[j]}) != Sign::zero) return false;
  }
  return true;
}

bool lies_in_axis_plane(std::span<const Vertex> loop) {
  for (std::size_t i = 0; i < 3; ++i)
    if (std::all_of(loop.begin(), loop.end(), [&](const Vertex& p) { return p[i] == loop[0][i]; })) return true;
  return false;
}

}  // namespace

bool is_planar(std::span<const Vertex> loop) {
  if (loop.size() < 4 || lies_in_axis_plane(loop)) return true;
  const Vertex& a = loop[0];
  const auto b = std::find_if(loop.begin(), loop.end(), [&](const Vertex& p) { return p != a; });
  if (b == loop.end()) return true;
  const auto c = std::find_if(b + 1, loop.end(), [&](const Vertex& p) { return !is_collinear(a, *b, p); });
  if (c == loop.end()) return true;
  return std::all_of(b + 1, loop.end(),
                     [&](const Vertex& p) { return &p == &*c || orient3d(a, *b, *c, p) == Sign::zero; });
}

}  // namespace strata::io
