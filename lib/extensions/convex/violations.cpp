#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "strata/convex.h"

namespace strata::convex {
namespace {

/// Checks all properties in rationals, one point after the other: slow, and sharing no code with the algorithms it
/// checks.
class Checker {
 public:
  explicit Checker(const Polytope& polytope) : polytope_(polytope) {}

  std::vector<std::string> check() {
    check_vertices();
    if (!found_.empty()) return found_;  // there are no valid positions
    for (std::uint32_t v = 0; v < polytope_.vertices.size(); ++v) places_.push_back(polytope_.position(v));
    check_order();
    check_counts();
    check_loops();
    if (!found_.empty()) return found_;
    if (polytope_.dimension == 2) check_polygon();
    if (polytope_.dimension == 3) check_solid();
    return found_;
  }

 private:
  using Loop = std::vector<std::uint32_t>;

  void report(std::string what) { found_.push_back(std::move(what)); }
  static std::string text(const char* what, std::size_t number) { return what + (" " + std::to_string(number)); }

  void check_vertices() {
    for (std::size_t v = 0; v < polytope_.vertices.size(); ++v)
      for (const double x : polytope_.vertices[v])
        if (!std::isfinite(x)) return report(text("a coordinate is not finite: vertex", v));
    std::size_t after = 0;
    for (const ExactVertex& e : polytope_.exact) {
      if (e.vertex < after || e.vertex >= polytope_.vertices.size())
        return report(text("exact places are not by increasing index: vertex", e.vertex));
      after = std::size_t{e.vertex} + 1;
      bool is_changed = false;
      for (std::size_t i = 0; i < 3; ++i) {
        const double x = polytope_.vertices[e.vertex][i];
        if (to_nearest_double(e.position[i]) != x) report(text("not the nearest doubles: vertex", e.vertex));
        is_changed |= e.position[i] != to_rational(x);
      }
      if (!is_changed) report(text("an exact place that is three doubles: vertex", e.vertex));
    }
  }

  void check_order() {
    for (std::size_t v = 1; v < places_.size(); ++v)
      if (!(places_[v - 1] < places_[v])) report(text("not in lexicographic order: vertex", v));
  }

  void check_counts() {
    const std::size_t vertices = places_.size(), facets = polytope_.facets.size();
    switch (polytope_.dimension) {
      case -1:
      case 0:
      case 1:
        if (vertices != static_cast<std::size_t>(polytope_.dimension + 1))
          report(text("dimension does not fit the vertices, which are", vertices));
        if (facets != 0) report("facets below dimension 2");
        return;
      case 2:
        if (facets != 1) report(text("a polygon is one loop, but there are", facets));
        return;
      case 3:
        if (facets < 4) report(text("a solid has four facets or more, but there are", facets));
        return;
      default:
        report("dimension is none of -1, 0, 1, 2, 3");
    }
  }

  void check_loops() {
    for (std::size_t f = 0; f < polytope_.facets.size(); ++f) {
      const Loop& loop = polytope_.facets[f];
      if (loop.size() < 3) report(text("fewer than three corners: facet", f));
      for (const std::uint32_t v : loop)
        if (v >= places_.size()) report(text("no such vertex: facet", f));
      if (std::set<std::uint32_t>(loop.begin(), loop.end()).size() != loop.size())
        report(text("a corner twice: facet", f));
    }
  }

  static RationalPoint difference(const RationalPoint& p, const RationalPoint& q) {
    return {Rational(p[0] - q[0]), Rational(p[1] - q[1]), Rational(p[2] - q[2])};
  }
  static RationalPoint cross(const RationalPoint& u, const RationalPoint& v) {
    return {Rational(u[1] * v[2] - u[2] * v[1]), Rational(u[2] * v[0] - u[0] * v[2]),
            Rational(u[0] * v[1] - u[1] * v[0])};
  }
  static int sign_of_dot(const RationalPoint& u, const RationalPoint& v) {
    return Rational(u[0] * v[0] + u[1] * v[1] + u[2] * v[2]).sign();
  }

  [[nodiscard]] RationalPoint normal_of(const Loop& loop) const {
    const RationalPoint& from = places_[loop[0]];
    return cross(difference(places_[loop[1]], from), difference(places_[loop[2]], from));
  }

  /// Checks loops whose first corner is counter-clockwise about the normal.
  void check_convexity(std::size_t f, const Loop& loop, const RationalPoint& normal) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const std::uint32_t a = loop[i], b = loop[(i + 1) % loop.size()];
      const RationalPoint inwards = cross(normal, difference(places_[b], places_[a]));
      for (const std::uint32_t v : loop)
        if (v != a && v != b && sign_of_dot(inwards, difference(places_[v], places_[a])) <= 0)
          return report(text("not strictly convex: facet", f));
    }
  }

  void check_polygon() {
    const Loop& loop = polytope_.facets[0];
    if (loop.size() != places_.size()) report("vertices that are no corners of the polygon");
    const RationalPoint normal = normal_of(loop);
    for (std::size_t v = 0; v < places_.size(); ++v)
      if (sign_of_dot(normal, difference(places_[v], places_[loop[0]])) != 0)
        report(text("not in the plane of the polygon: vertex", v));
    check_convexity(0, loop, normal);
  }

  /// Every facet must contain all vertices of the polytope in its plane, all others must be below, and every edge must
  /// have a facet on either side. Such facets are the hull of the vertices, and their corners are extreme.
  void check_solid() {
    std::set<std::array<std::uint32_t, 2>> edges;
    std::vector<bool> is_corner(places_.size(), false);
    for (std::size_t f = 0; f < polytope_.facets.size(); ++f) {
      const Loop& loop = polytope_.facets[f];
      check_facet(f, loop);
      for (std::size_t i = 0; i < loop.size(); ++i) {
        is_corner[loop[i]] = true;
        if (!edges.insert({loop[i], loop[(i + 1) % loop.size()]}).second)
          report(text("an edge twice in one direction: facet", f));
      }
    }
    for (const auto& [a, b] : edges)
      if (!edges.contains({b, a})) report(text("an edge with one facet only: from vertex", a));
    for (std::size_t v = 0; v < is_corner.size(); ++v)
      if (!is_corner[v]) report(text("no corner of a facet: vertex", v));
  }

  void check_facet(std::size_t f, const Loop& loop) {
    const RationalPoint normal = normal_of(loop);
    const std::set<std::uint32_t> corners(loop.begin(), loop.end());
    for (std::uint32_t v = 0; v < places_.size(); ++v) {
      const int side = sign_of_dot(normal, difference(places_[v], places_[loop[0]]));
      if (side > 0) return report(text("a vertex is above: facet", f));
      if (side != 0 && corners.contains(v)) return report(text("not planar: facet", f));
      if (side == 0 && !corners.contains(v)) return report(text("a vertex of its plane is no corner: facet", f));
    }
    check_convexity(f, loop, normal);
  }

  const Polytope& polytope_;
  std::vector<RationalPoint> places_;
  std::vector<std::string> found_;
};

}  // namespace

std::vector<std::string> violations(const Polytope& polytope) { return Checker(polytope).check(); }

}  // namespace strata::convex
