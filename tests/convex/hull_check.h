#pragma once
#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "strata/convex.h"

// Is a polytope the convex hull of some points? By definition, in rationals.
namespace strata::test {

inline RationalPoint difference(const RationalPoint& a, const RationalPoint& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Rational product(const RationalPoint& a, const RationalPoint& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline RationalPoint cross_product(const RationalPoint& a, const RationalPoint& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline bool is_zero(const RationalPoint& a) { return a[0] == 0 && a[1] == 0 && a[2] == 0; }

inline int dimension_of(const std::vector<RationalPoint>& points) {
  if (points.empty()) return -1;
  RationalPoint line{}, plane{};
  int dimension = 0;
  for (const RationalPoint& p : points) {
    const RationalPoint d = difference(p, points[0]);
    if (dimension == 0 && !is_zero(d)) {
      line = d;
      dimension = 1;
    } else if (dimension == 1 && !is_zero(cross_product(line, d))) {
      plane = cross_product(line, d);
      dimension = 2;
    }
  }
  for (const RationalPoint& p : points)
    if (dimension == 2 && product(plane, difference(p, points[0])) != 0) dimension = 3;
  return dimension;
}

/// What is wrong with a polytope as the hull of points; empty if nothing is.
inline std::string not_hull(const convex::Polytope& polytope, const std::vector<RationalPoint>& points) {
  std::vector<RationalPoint> corners;
  for (std::uint32_t v = 0; v < polytope.vertices.size(); ++v) {
    corners.push_back(polytope.position(v));
    for (std::size_t i = 0; i < 3; ++i)
      if (polytope.vertices[v][i] != to_nearest_double(corners[v][i])) return "a vertex is not rounded to nearest";
  }
  for (const ExactVertex& e : polytope.exact)
    if (to_rational(polytope.vertices[e.vertex][0]) == e.position[0] &&
        to_rational(polytope.vertices[e.vertex][1]) == e.position[1] &&
        to_rational(polytope.vertices[e.vertex][2]) == e.position[2])
      return "a double is listed as a rational";
  if (!std::is_sorted(corners.begin(), corners.end())) return "vertices out of order";
  if (std::adjacent_find(corners.begin(), corners.end()) != corners.end()) return "a vertex twice";
  const std::set<RationalPoint> given(points.begin(), points.end());
  for (const RationalPoint& c : corners)
    if (given.count(c) == 0) return "a vertex is no given point";
  const int dimension = dimension_of(points);
  if (polytope.dimension != dimension) return "dimension";
  if (dimension <= 1) {
    if (corners.size() != static_cast<std::size_t>(dimension + 1) || !polytope.facets.empty()) return "size";
    if (dimension >= 0 && (corners.front() != *given.begin() || corners.back() != *given.rbegin())) return "ends";
    return {};
  }
  if (dimension == 2 && polytope.facets.size() != 1) return "a polygon is one loop";
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
  std::set<std::uint32_t> used;
  std::vector<RationalPoint> normals;
  for (const auto& loop : polytope.facets) {
    const std::size_t n = loop.size();
    if (n < 3) return "a facet of two corners";
    used.insert(loop.begin(), loop.end());
    const auto at = [&](std::size_t i) { return corners[loop[i % n]]; };
    const RationalPoint normal = cross_product(difference(at(1), at(0)), difference(at(2), at(1)));
    for (const RationalPoint& other : normals)
      if (is_zero(cross_product(normal, other)) && product(normal, other) > 0) return "two facets in one plane";
    normals.push_back(normal);
    for (std::size_t i = 0; i < n; ++i) {
      if (product(normal, cross_product(difference(at(i + 1), at(i)), difference(at(i + 2), at(i + 1)))) <= 0)
        return "a facet is not strictly convex";
      if (product(normal, difference(at(i), at(0))) != 0) return "a facet is not planar";
      ++sides[{loop[i], loop[(i + 1) % n]}];
      const RationalPoint outwards = cross_product(difference(at(i + 1), at(i)), normal);
      for (const RationalPoint& p : points)
        if (dimension == 2 && product(outwards, difference(p, at(i))) > 0) return "a point outside of the polygon";
    }
    if (dimension == 3)
      for (const RationalPoint& p : points)
        if (product(normal, difference(p, at(0))) > 0) return "a point outside";
  }
  if (used.size() != corners.size()) return "a vertex that no facet has";
  if (dimension == 3)
    for (const auto& [side, count] : sides)
      if (count != 1 || sides.count({side.second, side.first}) == 0) return "not closed";
  return {};
}

/// All sums of vertices.
inline std::vector<RationalPoint> pair_sums(const convex::Polytope& a, const convex::Polytope& b) {
  std::vector<RationalPoint> sums;
  for (std::uint32_t v = 0; v < a.vertices.size(); ++v)
    for (std::uint32_t w = 0; w < b.vertices.size(); ++w) {
      const RationalPoint p = a.position(v), q = b.position(w);
      sums.push_back({p[0] + q[0], p[1] + q[1], p[2] + q[2]});
    }
  return sums;
}

}  // namespace strata::test
