#include "extensions/complex/subdivision.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/arrange/triangulation.h"
#include "core/kernel/predicates.h"
#include "core/kernel/rational_point.h"
#include "strata/complex.h"

namespace strata::complex {
namespace {

using Index = std::uint32_t;

/// A triangle that contains all points with a margin.
std::array<Vertex, 3> corners_around(const std::vector<Vertex>& points) {
  double largest = 1;
  for (const Vertex& p : points) largest = std::max({largest, std::abs(p[0]), std::abs(p[1])});
  const double far = std::ldexp(1, std::ilogb(largest) + 4);
  if (!std::isfinite(far)) throw std::out_of_range("points of the plane are beyond 2^1018");
  return {Vertex{-far, -far, 0}, Vertex{far, -far, 0}, Vertex{0, far, 0}};
}

}  // namespace

Subdivision::Subdivision(const ExactMesh& points, std::span<const std::array<std::uint32_t, 2>> segments) {
  const std::array<Vertex, 3> around = corners_around(points.mesh.vertices);
  std::vector<Vertex> all(around.begin(), around.end());
  all.insert(all.end(), points.mesh.vertices.begin(), points.mesh.vertices.end());
  std::vector<ExactVertex> exact = points.exact;
  for (ExactVertex& e : exact) e.vertex += 3;
  const std::array<Triangle, 1> face{{{0, 1, 2}}};
  InputComplex input;
  input.add(all, face, exact);
  const PointTable table(input);
  Triangulation triangulation(input, table);
  triangulation.start(0, Triangulation::Names::any);
  std::vector<std::int32_t> local;
  for (Index p = 3; p < all.size(); ++p) local.push_back(triangulation.add_point(p));
  for (Index s = 0; s < segments.size(); ++s) {
    const auto [a, b] = segments[s];
    if (local[a] != local[b])
      triangulation.add_segment(local[a], local[b], static_cast<std::int32_t>(s),
                                ConstraintLine::along_edge(a + 3, b + 3));
  }

  const FacePoints& found = triangulation.points();
  std::vector<std::int32_t> order;
  for (std::int32_t v = 3; v < found.size(); ++v) order.push_back(v);
  std::sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
    const Sign s = compare(input, 0, found[a], found[b]);
    return (s != Sign::zero ? s : compare(input, 1, found[a], found[b])) == Sign::negative;
  });
  std::vector<Index> number(static_cast<std::size_t>(found.size()), none);
  const auto number_of = [&](std::int32_t v) -> Index& { return number[static_cast<std::size_t>(v)]; };
  for (Index i = 0; i < order.size(); ++i) {
    const Point& p = found[order[i]];
    number_of(order[i]) = i;
    Vertex rounded = nearest_doubles(input, p);
    for (double& x : rounded) x += 0.0;
    vertices.mesh.vertices.push_back(rounded);
    if (p.name.kind == SymbolicPoint::Kind::input && input.has_doubles(p.name.id[0])) continue;
    RationalPoint place = exact_position(input, p);
    if (place != to_rational(rounded)) vertices.exact.push_back({i, std::move(place)});
  }
  for (const std::int32_t v : local) vertex_of.push_back(number_of(v));
  for (const auto& t : triangulation.triangles()) {
    Part& part = parts.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      part.v[i] = number_of(t.v[i]);
      part.sides[i].neighbour = t.n[i];
      if (t.n[i] < 0) outside = static_cast<Index>(parts.size()) - 1;
      for (std::int32_t n = t.c[i]; n >= 0; n = triangulation.note(n).next)
        part.sides[i].segments.emplace_back(static_cast<Index>(triangulation.note(n).constraint),
                                            triangulation.note(n).forward);
    }
  }
}

}  // namespace strata::complex
