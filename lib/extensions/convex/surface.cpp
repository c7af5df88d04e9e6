#include "extensions/convex/surface.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace strata::convex {
namespace {

/// The sides of faces as half-edges, numbered face after face.
class HalfEdges {
 public:
  HalfEdges(const Surface& surface, const Monitor& monitor) : surface_(surface), monitor_(monitor) {
    for (std::uint32_t f = 0; f < surface.faces.size(); ++f) {
      monitor_.check();
      const auto first = static_cast<std::uint32_t>(face_.size());
      const auto count = static_cast<std::uint32_t>(surface.faces[f].size());
      for (std::uint32_t i = 0; i < count; ++i) {
        face_.push_back(f);
        next_.push_back(first + (i + 1) % count);
        before_.push_back(first + (i + count - 1) % count);
        from_.push_back(surface.faces[f][i]);
      }
    }
    partner_.assign(face_.size(), Surface::no_face);
    pair();
  }

  [[nodiscard]] std::size_t size() const { return face_.size(); }
  [[nodiscard]] std::uint32_t from(std::uint32_t h) const { return from_[h]; }
  [[nodiscard]] std::uint32_t to(std::uint32_t h) const { return from_[next_[h]]; }
  [[nodiscard]] std::uint32_t face(std::uint32_t h) const { return face_[h]; }
  [[nodiscard]] std::uint32_t partner(std::uint32_t h) const { return partner_[h]; }
  /// A corner of its face that is not on its line.
  [[nodiscard]] std::uint32_t third(std::uint32_t h) const { return from_[next_[next_[h]]]; }
  /// The next half-edge out of the same vertex, counter-clockwise.
  [[nodiscard]] std::uint32_t around(std::uint32_t h) const { return partner_[before_[h]]; }

 private:
  void pair() {
    std::vector<std::uint32_t> order(size());
    std::iota(order.begin(), order.end(), 0U);
    const auto ends = [&](std::uint32_t h) { return std::pair(std::min(from(h), to(h)), std::max(from(h), to(h))); };
    std::sort(order.begin(), order.end(), [&](std::uint32_t g, std::uint32_t h) {
      monitor_.check();
      return std::pair(ends(g), g) < std::pair(ends(h), h);
    });
    for (std::size_t i = 0, j = 0; i < order.size(); i = j) {
      monitor_.check();
      while (j < order.size() && ends(order[j]) == ends(order[i])) ++j;
      pair_about_edge(std::span(order).subspan(i, j - i));
    }
  }

  void connect(std::uint32_t g, std::uint32_t h) {
    if (from(g) == from(h)) throw std::invalid_argument("faces about an edge do not bound a solid");
    partner_[g] = h;
    partner_[h] = g;
  }

  void pair_about_edge(std::span<std::uint32_t> sides) {
    if (sides.size() % 2 != 0) throw std::invalid_argument("faces about an edge do not bound a solid");
    if (sides.size() > 2) sort_about_edge(sides);
    // A side that runs forwards has the solid clockwise of it, between itself and the previous side.
    const std::size_t first = from(sides[0]) < to(sides[0]) ? 1 : 0;
    for (std::size_t i = first; i < sides.size() + first; i += 2)
      connect(sides[i % sides.size()], sides[(i + 1) % sides.size()]);
  }

  /// Sorts by angle about the edge, counter-clockwise as seen against its direction from the lower vertex to the
  /// higher. Coincident faces touch from outside: the one with the solid before it is first.
  void sort_about_edge(std::span<std::uint32_t> sides) const {
    const std::uint32_t low = std::min(from(sides[0]), to(sides[0])), high = std::max(from(sides[0]), to(sides[0]));
    const RationalPoint p = surface_.points.position(low), q = surface_.points.position(high);
    const auto minus = [](const RationalPoint& a, const RationalPoint& b) {
      return RationalPoint{a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    };
    const auto dot = [](const RationalPoint& a, const RationalPoint& b) {
      return Rational(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
    };
    const auto cross = [](const RationalPoint& a, const RationalPoint& b) {
      return RationalPoint{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    };
    const RationalPoint axis = minus(q, p);
    const RationalPoint zero = minus(surface_.points.position(third(sides[0])), p);
    const RationalPoint x = cross(cross(axis, zero), axis), y = cross(axis, zero);
    struct Direction {
      Rational x, y;
      bool backwards;
      std::uint32_t side;
    };
    std::vector<Direction> all;
    for (const std::uint32_t h : sides) {
      const RationalPoint u = minus(surface_.points.position(third(h)), p);
      all.push_back({dot(u, x), dot(u, y), from(h) > to(h), h});
    }
    const auto half = [](const Direction& d) { return d.y > 0 || (d.y == 0 && d.x > 0) ? 0 : 1; };
    // x and y have different lengths. This stretches the plane, which preserves the order of directions.
    std::stable_sort(all.begin(), all.end(), [&](const Direction& a, const Direction& b) {
      if (half(a) != half(b)) return half(a) < half(b);
      const Rational orientation = a.x * b.y - a.y * b.x;
      if (orientation != 0) return orientation > 0;
      return a.backwards < b.backwards;
    });
    for (std::size_t i = 0; i < sides.size(); ++i) sides[i] = all[i].side;
    for (std::size_t i = 0; i < sides.size(); ++i)
      if (all[i].backwards == all[(i + 1) % sides.size()].backwards)
        throw std::invalid_argument("faces about an edge do not bound a solid");
  }

  const Surface& surface_;
  const Monitor& monitor_;
  std::vector<std::uint32_t> face_, next_, before_, from_, partner_;
};

/// Adds edges, and fans about vertices, to a surface that has its faces.
void add_neighbourhoods(Surface& surface, const Monitor& monitor) {
  const HalfEdges sides(surface, monitor);
  std::vector<std::uint32_t> edge_of(sides.size(), Surface::no_face);
  for (std::uint32_t h = 0; h < sides.size(); ++h) {
    monitor.check();
    if (edge_of[h] != Surface::no_face) continue;
    const std::uint32_t g = sides.partner(h);
    edge_of[h] = edge_of[g] = static_cast<std::uint32_t>(surface.edges.size());
    surface.edges.push_back(
        {sides.from(h), sides.to(h), sides.face(h), sides.face(g), {}, {sides.third(h), sides.third(g)}});
  }
  std::vector<bool> done(sides.size(), false);
  for (std::uint32_t start = 0; start < sides.size(); ++start) {
    monitor.check();
    if (done[start]) continue;
    Fan fan{sides.from(start), {}};
    for (std::uint32_t h = start; !done[h]; h = sides.around(h)) {
      done[h] = true;
      SurfaceEdge& e = surface.edges[edge_of[h]];
      const bool outgoing = sides.from(h) == e.from;
      fan.spokes.push_back({edge_of[h], outgoing});
      e.fans[outgoing ? 0 : 1] = static_cast<std::uint32_t>(surface.fans.size());
    }
    surface.fans.push_back(std::move(fan));
  }
}

}  // namespace

Surface surface_of(const ExactMesh& solid, const Monitor& monitor) {
  Surface surface;
  surface.points = {{solid.mesh.vertices, {}}, solid.exact};
  for (const Triangle& t : solid.mesh.triangles) surface.faces.emplace_back(t.begin(), t.end());
  add_neighbourhoods(surface, monitor);
  return surface;
}

Surface surface_of(const Polytope& polytope, const Monitor& monitor) {
  Surface surface;
  surface.points = {{polytope.vertices, {}}, polytope.exact};
  surface.is_convex = true;
  surface.dimension = polytope.dimension;
  switch (polytope.dimension) {
    case 3:
      surface.faces = polytope.facets;
      break;
    case 2:
      surface.faces = {polytope.facets[0], {polytope.facets[0].rbegin(), polytope.facets[0].rend()}};
      break;
    case 1:
      surface.edges = {{0, 1, Surface::no_face, Surface::no_face, {0, 1}, {}}};
      surface.fans = {{0, {{0, true}}}, {1, {{0, false}}}};
      return surface;
    default:
      surface.fans = {{0, {}}};
      return surface;
  }
  add_neighbourhoods(surface, monitor);
  return surface;
}

}  // namespace strata::convex
