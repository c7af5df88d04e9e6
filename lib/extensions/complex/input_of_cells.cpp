#include "extensions/complex/input_of_cells.h"

#include <algorithm>
#include <cmath>

#include "core/kernel/rational_point.h"

namespace strata::complex {
namespace {

using Index = std::uint32_t;

/// A double other than x, at about this distance from it; towards zero for large x, so that it is finite.
double beside(double x, double distance) {
  const double there = x > 0 ? x - distance : x + distance;
  if (there != x && std::isfinite(there)) return there;
  return std::nextafter(x, x > 0 ? -HUGE_VAL : HUGE_VAL);
}

/// Appends a vertex that is no cell: vertex v, translated along one axis.
Index add_moved(Soup& soup, Index v, std::size_t axis, double distance) {
  Vertex p = soup.mesh.mesh.vertices[v];
  p[axis] = beside(p[axis], distance);
  const auto number = static_cast<Index>(soup.mesh.mesh.vertices.size());
  const auto at = std::lower_bound(soup.mesh.exact.begin(), soup.mesh.exact.end(), v,
                                   [](const ExactVertex& e, Index w) { return e.vertex < w; });
  if (at != soup.mesh.exact.end() && at->vertex == v) {
    ExactVertex moved{number, at->position};
    moved.position[axis] = to_rational(p[axis]);
    const bool is_rational = moved.position != to_rational(p);
    if (is_rational) soup.mesh.exact.push_back(std::move(moved));
  }
  soup.mesh.mesh.vertices.push_back(p);
  soup.vertex_cell.push_back(none);
  return number;
}

void add(Soup& soup, const Triangle& t, Index edge_cell) {
  soup.mesh.mesh.triangles.push_back(t);
  soup.face_cell.push_back(none);
  soup.volume_cell.push_back({none, none});
  soup.edge_cell.push_back({edge_cell, none, none});
}

}  // namespace

void add_triangle_at_edge(Soup& soup, Index a, Index b, Index edge_cell) {
  const RationalPoint p = soup.mesh.position(a), q = soup.mesh.position(b);
  double length = 0;
  for (std::size_t i = 0; i < 3; ++i)
    length = std::max(length, std::abs(soup.mesh.mesh.vertices[a][i] / 2 - soup.mesh.mesh.vertices[b][i] / 2));
  const std::size_t axis = p[1] != q[1] || p[2] != q[2] ? 0 : 1;  // the edge is not parallel to it
  const Index c = add_moved(soup, a, axis, length);
  add(soup, {a, b, c}, edge_cell);
}

void add_triangle_at_vertex(Soup& soup, Index v) {
  const Vertex p = soup.mesh.mesh.vertices[v];
  const double size = std::max({std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
  const double distance = size == 0 ? 1 : std::ldexp(size, -10);
  const Index b = add_moved(soup, v, 0, distance), c = add_moved(soup, v, 1, distance);
  add(soup, {v, b, c}, none);
}

}  // namespace strata::complex
