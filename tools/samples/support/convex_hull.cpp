#include <algorithm>
#include <map>
#include <set>

#include "strata/rational.h"
#include "support/shapes.h"

namespace strata::test {
namespace {

using Indices = std::vector<std::uint32_t>;

RationalPoint difference(const RationalPoint& a, const RationalPoint& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

RationalPoint cross(const RationalPoint& a, const RationalPoint& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Rational dot(const RationalPoint& a, const RationalPoint& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Where the points lie about the oriented plane through three of them.
struct Sides {
  RationalPoint normal;
  Indices on;
  bool above = false;
  bool below = false;
};

Sides sides_of_plane(const std::vector<RationalPoint>& points, std::size_t a, std::size_t b, std::size_t c) {
  Sides sides;
  sides.normal = cross(difference(points[b], points[a]), difference(points[c], points[a]));
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const int side = dot(sides.normal, difference(points[i], points[a])).sign();
    if (side > 0) sides.above = true;
    if (side < 0) sides.below = true;
    if (side == 0) sides.on.push_back(i);
  }
  return sides;
}

/// Corners of the convex hull of coplanar points, counter-clockwise seen against the normal (gift wrapping).
Indices planar_hull(const std::vector<RationalPoint>& points, const Indices& on, const RationalPoint& normal) {
  const std::uint32_t first =
      *std::min_element(on.begin(), on.end(), [&](auto i, auto j) { return points[i] < points[j]; });
  Indices hull;
  std::uint32_t corner = first;
  do {
    hull.push_back(corner);
    std::uint32_t next = corner;
    for (const std::uint32_t i : on) {
      if (points[i] == points[corner]) continue;
      if (next == corner) {
        next = i;
        continue;
      }
      const RationalPoint to_next = difference(points[next], points[corner]);
      const RationalPoint to_i = difference(points[i], points[corner]);
      const int orientation = dot(normal, cross(to_next, to_i)).sign();
      if (orientation < 0 || (orientation == 0 && dot(to_i, to_i) > dot(to_next, to_next))) next = i;
    }
    corner = next;
  } while (corner != first);
  return hull;
}

std::vector<Indices> hull_facets(const std::vector<RationalPoint>& points) {
  std::set<Indices> seen;
  std::vector<Indices> facets;
  for (std::size_t a = 0; a < points.size(); ++a) {
    for (std::size_t b = a + 1; b < points.size(); ++b) {
      for (std::size_t c = b + 1; c < points.size(); ++c) {
        Sides sides = sides_of_plane(points, a, b, c);
        if (sides.above == sides.below || sides.normal == RationalPoint{0, 0, 0}) continue;
        if (!seen.insert(sides.on).second) continue;
        if (sides.above) sides.normal = difference({0, 0, 0}, sides.normal);
        facets.push_back(planar_hull(points, sides.on, sides.normal));
      }
    }
  }
  return facets;
}

}  // namespace

Mesh convex_hull(std::span<const Vertex> given) {
  std::vector<Vertex> distinct(given.begin(), given.end());
  std::sort(distinct.begin(), distinct.end());
  distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
  std::vector<RationalPoint> points;
  for (const Vertex& v : distinct) points.push_back({to_rational(v[0]), to_rational(v[1]), to_rational(v[2])});
  Mesh mesh;
  std::map<std::uint32_t, std::uint32_t> numbers;
  for (const Indices& facet : hull_facets(points)) {
    Indices corner;
    for (const std::uint32_t i : facet) {
      const auto [place, fresh] = numbers.try_emplace(i, static_cast<std::uint32_t>(mesh.vertices.size()));
      if (fresh) mesh.vertices.push_back(distinct[i]);
      corner.push_back(place->second);
    }
    for (std::size_t i = 1; i + 1 < corner.size(); ++i) mesh.triangles.push_back({corner[0], corner[i], corner[i + 1]});
  }
  return mesh;
}

}  // namespace strata::test
