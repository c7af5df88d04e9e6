#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "extensions/convex/directions.h"
#include "extensions/convex/sum_points.h"
#include "extensions/convex/surface.h"
#include "strata/convex.h"

namespace strata::convex {
namespace {

/// A polytope with its directions, for queries of its extreme vertices in a direction.
template <class N>
class Extremes {
 public:
  Extremes(const Surface& surface, const LatticePoints& lattice, const Monitor& monitor)
      : surface_(surface), lattice_(lattice), directions_(directions_of<N>(surface, lattice, monitor)) {}

  [[nodiscard]] const Surface& surface() const { return surface_; }
  [[nodiscard]] const Directions<N>& directions() const { return directions_; }

  /// The vertices whose product with u is largest: one, two, or those of a facet, counter-clockwise about u. The search
  /// climbs from edge to edge and starts at the result of the last one.
  [[nodiscard]] std::vector<std::uint32_t> face(const Vectors<N>& u, std::size_t i) {
    while (const auto higher = step(u, i, 1)) at_ = other_end(*higher);
    const auto level = step(u, i, 0);
    if (!level) return {vertex()};
    const std::uint32_t facet = level_facet(u, i);
    if (facet != Surface::no_face) return surface_.faces[facet];
    return {vertex(), surface_.fans[other_end(*level)].vertex};
  }

  /// Lexicographic order of two vertices in two axes.
  [[nodiscard]] bool is_before(std::uint32_t v, std::uint32_t w, const std::array<std::size_t, 2>& axes) const {
    const auto &p = lattice_.points[v], &q = lattice_.points[w];
    return p[axes[0]] != q[axes[0]] ? p[axes[0]] < q[axes[0]] : p[axes[1]] < q[axes[1]];
  }
  /// From one vertex to another, in the two axes.
  [[nodiscard]] std::array<Integer, 2> difference(std::uint32_t v, std::uint32_t w,
                                                  const std::array<std::size_t, 2>& axes) const {
    const auto &p = lattice_.points[v], &q = lattice_.points[w];
    return {Integer(q[axes[0]] - p[axes[0]]), Integer(q[axes[1]] - p[axes[1]])};
  }

 private:
  [[nodiscard]] const Fan& fan() const { return surface_.fans[at_]; }
  [[nodiscard]] std::uint32_t vertex() const { return fan().vertex; }
  [[nodiscard]] std::uint32_t other_end(const Fan::Spoke& s) const {
    return surface_.edges[s.edge].fans[s.outgoing ? 1 : 0];
  }
  [[nodiscard]] int rise(const Vectors<N>& u, std::size_t i, const Fan::Spoke& s) const {
    const int sign = product_sign(u, i, directions_.edges, s.edge);
    return s.outgoing ? sign : -sign;
  }
  [[nodiscard]] const Fan::Spoke* step(const Vectors<N>& u, std::size_t i, int wanted) const {
    for (const Fan::Spoke& s : fan().spokes)
      if (rise(u, i, s) == wanted) return &s;
    return nullptr;
  }
  /// The facet, with outward direction u, between two consecutive spokes perpendicular to u.
  [[nodiscard]] std::uint32_t level_facet(const Vectors<N>& u, std::size_t i) const {
    const auto& spokes = fan().spokes;
    for (std::size_t k = 0; k < spokes.size() && spokes.size() > 1; ++k) {
      if (rise(u, i, spokes[k]) != 0 || rise(u, i, spokes[(k + 1) % spokes.size()]) != 0) continue;
      const SurfaceEdge& e = surface_.edges[spokes[k].edge];
      const std::uint32_t f = spokes[k].outgoing ? e.left : e.right;
      if (is_along(u.approximate[i], directions_.normals.approximate[f])) return f;
    }
    return Surface::no_face;
  }
  /// True if two parallel vectors are not opposite.
  static bool is_along(const std::array<double, 3>& u, const std::array<double, 3>& v) {
    for (std::size_t k = 0; k < 3; ++k)
      if (u[k] != 0) return (u[k] > 0) == (v[k] > 0);
    return false;
  }

  const Surface& surface_;
  const LatticePoints& lattice_;
  Directions<N> directions_;
  std::uint32_t at_ = 0;  ///< fan
};

template <class N>
class Summation {
 public:
  Summation(const Surface& a, const LatticePoints& on_a, const Surface& b, const LatticePoints& on_b,
            const Monitor& monitor)
      : a_(a, on_a, monitor), b_(b, on_b, monitor), sums_(a.points, b.points), monitor_(monitor) {}

  /// Requires a.dimension >= b.dimension.
  Polytope run() {
    const int dimension = dimension_of_sum();
    std::vector<std::vector<std::uint32_t>> facets;
    if (dimension == 3) {
      facets = facets_of_solid();
    } else if (dimension == 2) {
      facets = {merged(whole(a_), whole(b_), flat_normal())};
    } else {
      const auto last = [](const Surface& s) { return static_cast<std::uint32_t>(s.points.mesh.vertices.size() - 1); };
      static_cast<void>(sums_.number(0, 0));
      if (dimension == 1) static_cast<void>(sums_.number(last(a_.surface()), last(b_.surface())));
    }
    return in_order(dimension, std::move(facets));
  }

 private:
  [[nodiscard]] int dimension_of_sum() const {
    const int of_a = a_.surface().dimension, of_b = b_.surface().dimension;
    if (of_a == 3 || of_b == 0) return of_a;
    const auto& edges = b_.directions().edges;
    for (std::size_t g = 0; g < edges.size(); ++g) {
      if (of_a == 2 && product_sign(a_.directions().normals, 0, edges, g) != 0) return 3;
      if (of_a == 1 && !is_zero(cross(a_.directions().edges.exact[0], edges.exact[g]))) return 2;
    }
    return of_a;
  }

  static bool is_zero(const Triple<N>& v) {
    return sign_number(v[0]) == 0 && sign_number(v[1]) == 0 && sign_number(v[2]) == 0;
  }

  /// The normal of the plane of a sum of dimension 2.
  [[nodiscard]] Triple<N> flat_normal() const {
    if (a_.surface().dimension == 2) return a_.directions().normals.exact[0];
    return cross(a_.directions().edges.exact[0], b_.directions().edges.exact[0]);
  }

  /// All vertices of a polytope of dimension 0 to 2; a polygon in the order of its first face.
  std::vector<std::uint32_t> whole(const Extremes<N>& x) const {
    if (x.surface().dimension == 2) {
      // Both polygons must be counter-clockwise about the normal of a.
      const auto &n = a_.directions().normals.approximate[0], &m = x.directions().normals.approximate[0];
      for (std::size_t k = 0; k < 3; ++k)
        if (n[k] != 0) return x.surface().faces[(n[k] > 0) == (m[k] > 0) ? 0 : 1];
    }
    std::vector<std::uint32_t> all(x.surface().points.mesh.vertices.size());
    std::iota(all.begin(), all.end(), 0U);
    return all;
  }

  std::vector<std::vector<std::uint32_t>> facets_of_solid() {
    std::vector<std::vector<std::uint32_t>> facets;
    const auto& of_a = a_.directions().normals;
    for (std::uint32_t f = 0; f < of_a.size(); ++f) {
      monitor_.check();
      facets.push_back(merged(a_.surface().faces[f], b_.face(of_a, f), of_a.exact[f]));
    }
    const auto& of_b = b_.directions().normals;
    for (std::uint32_t f = 0; f < of_b.size(); ++f) {
      monitor_.check();
      const auto found = a_.face(of_b, f);
      if (found.size() < 3) facets.push_back(merged(found, b_.surface().faces[f], of_b.exact[f]));
    }
    add_parallelograms(facets);
    return facets;
  }

  /// Adds the parallelograms: arcs of the two Gauss maps cross in points inside both. `signs` has the sides of the
  /// normals of a with respect to the edges of b.
  void add_parallelograms(std::vector<std::vector<std::uint32_t>>& facets) {
    const auto &a = a_.surface(), &b = b_.surface();
    const std::size_t columns = b.edges.size();
    std::vector<signed char> signs(a.faces.size() * columns);
    for (std::size_t f = 0; f < a.faces.size(); ++f) {
      monitor_.check();
      for (std::size_t g = 0; g < columns; ++g)
        signs[f * columns + g] =
            static_cast<signed char>(product_sign(a_.directions().normals, f, b_.directions().edges, g));
    }
    for (std::uint32_t e = 0; e < a.edges.size(); ++e) {
      monitor_.check();
      const signed char* left = signs.data() + a.edges[e].left * columns;
      const signed char* right = signs.data() + a.edges[e].right * columns;
      for (std::uint32_t g = 0; g < columns; ++g)
        if (left[g] * right[g] < 0 && crosses(e, g, left[g])) facets.push_back(parallelogram(e, g, left[g] > 0));
    }
  }

  [[nodiscard]] bool crosses(std::uint32_t e, std::uint32_t g, int left_of_a) const {
    const SurfaceEdge& edge = b_.surface().edges[g];
    if (edge.left == Surface::no_face) return true;
    const int left = product_sign(b_.directions().normals, edge.left, a_.directions().edges, e);
    return left == -left_of_a && product_sign(b_.directions().normals, edge.right, a_.directions().edges, e) == -left;
  }

  std::vector<std::uint32_t> parallelogram(std::uint32_t e, std::uint32_t g, bool along_cross) {
    const SurfaceEdge &x = a_.surface().edges[e], &y = b_.surface().edges[g];
    std::vector<std::uint32_t> loop{sums_.number(x.from, y.from), sums_.number(x.to, y.from), sums_.number(x.to, y.to),
                                    sums_.number(x.from, y.to)};
    if (!along_cross) std::reverse(loop.begin(), loop.end());
    return loop;
  }

  /// The sum of two convex polygons in parallel planes, each counter-clockwise about u: their sides merged by angle. A
  /// polygon may be a side or a point. Orientations are those in two axes along which the plane is not projected to a
  /// line.
  std::vector<std::uint32_t> merged(std::vector<std::uint32_t> p, std::vector<std::uint32_t> q, const Triple<N>& u) {
    std::size_t k = 0;
    while (sign_number(u[k]) == 0) ++k;
    std::array<std::size_t, 2> axes{(k + 1) % 3, (k + 2) % 3};
    if (sign_number(u[k]) < 0) std::swap(axes[0], axes[1]);
    const auto start = [&](const Extremes<N>& x, std::vector<std::uint32_t>& loop) {
      std::rotate(loop.begin(),
                  std::min_element(loop.begin(), loop.end(),
                                   [&](std::uint32_t v, std::uint32_t w) { return x.is_before(v, w, axes); }),
                  loop.end());
      if (loop.size() > 1) loop.push_back(loop.front());
    };
    start(a_, p);
    start(b_, q);
    std::vector<std::uint32_t> loop;
    for (std::size_t i = 0, j = 0; i + 1 < p.size() || j + 1 < q.size();) {
      loop.push_back(sums_.number(p[i], q[j]));
      int orientation = i + 1 == p.size() ? -1 : 1;
      if (i + 1 < p.size() && j + 1 < q.size()) {
        const auto d = a_.difference(p[i], p[i + 1], axes), e = b_.difference(q[j], q[j + 1], axes);
        orientation = Integer(d[0] * e[1] - d[1] * e[0]).sign();
      }
      i += orientation >= 0;
      j += orientation <= 0;
    }
    return loop;
  }

  /// The polytope with vertices in lexicographic order of their exact positions.
  Polytope in_order(int dimension, std::vector<std::vector<std::uint32_t>> facets) {
    ExactMesh& points = sums_.points();
    std::vector<std::uint32_t> order(points.mesh.vertices.size()), number(order.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(), [&](std::uint32_t v, std::uint32_t w) {
      monitor_.check();
      const Vertex &p = points.mesh.vertices[v], &q = points.mesh.vertices[w];
      if (points.exact.empty()) return p < q;
      for (std::size_t i = 0; i < 3; ++i) {
        if (p[i] != q[i]) return p[i] < q[i];
        const Rational x = points.position(v)[i], y = points.position(w)[i];
        if (x != y) return x < y;
      }
      return false;
    });
    Polytope result;
    result.dimension = dimension;
    for (std::uint32_t i = 0; i < order.size(); ++i) {
      number[order[i]] = i;
      result.vertices.push_back(points.mesh.vertices[order[i]]);
    }
    for (ExactVertex& e : points.exact) {
      e.vertex = number[e.vertex];
      result.exact.push_back(std::move(e));
    }
    std::sort(result.exact.begin(), result.exact.end(),
              [](const ExactVertex& x, const ExactVertex& y) { return x.vertex < y.vertex; });
    for (auto& loop : facets) {
      for (std::uint32_t& v : loop) v = number[v];
      std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
    }
    std::sort(facets.begin(), facets.end());
    result.facets = std::move(facets);
    return result;
  }

  Extremes<N> a_, b_;
  SumPoints sums_;
  const Monitor& monitor_;
};

}  // namespace

Polytope sum(const Polytope& a, const Polytope& b, const Monitor& monitor) {
  if (a.dimension < b.dimension) return sum(b, a, monitor);
  if (b.dimension < 0) return {};
  const Surface of_a = surface_of(a, monitor), of_b = surface_of(b, monitor);
  const LatticePoints on_a = lattice_points(of_a.points, monitor), on_b = lattice_points(of_b.points, monitor);
  const int bits = 3 * std::max(on_a.bits, on_b.bits) + 7;
  if (bits <= 128) return Summation<__int128>(of_a, on_a, of_b, on_b, monitor).run();
  if (bits <= 256) return Summation<WideInt<4>>(of_a, on_a, of_b, on_b, monitor).run();
  return Summation<Integer>(of_a, on_a, of_b, on_b, monitor).run();
}

}  // namespace strata::convex
