#include "extensions/convex/directions.h"

#include <algorithm>

namespace strata::convex {
namespace {

int bits_of(const std::vector<Triple<Integer>>& points) {
  std::size_t bits = 1;
  for (const auto& p : points)
    for (const Integer& x : p) bits = std::max(bits, bit_length(x));
  return static_cast<int>(bits);
}

/// Rationals over their common denominator.
LatticePoints by_denominator(ExactMeshView view, const Monitor& monitor) {
  std::vector<RationalPoint> places;
  Integer unit = 1;
  for (std::uint32_t v = 0; v < view.mesh.vertices.size(); ++v) {
    monitor.check();
    places.push_back(view.position(v));
    for (const Rational& x : places.back()) unit = lcm(unit, denominator(x));
  }
  LatticePoints result;
  for (const RationalPoint& p : places) {
    monitor.check();
    Triple<Integer> q;
    for (std::size_t i = 0; i < 3; ++i) q[i] = numerator(p[i]) * (unit / denominator(p[i]));
    result.points.push_back(std::move(q));
  }
  result.bits = bits_of(result.points);
  return result;
}

void narrow(const Integer& x, Integer& to) { to = x; }
void narrow(const Integer& x, __int128& to) {
  const std::span<const std::uint64_t> limbs = limbs_of(x);
  const auto size =
      static_cast<__int128>(static_cast<unsigned __int128>(limb_or_zero(limbs, 1)) << 64 | limb_or_zero(limbs, 0));
  to = x.sign() < 0 ? -size : size;
}
template <int Limbs>
void narrow(const Integer& x, WideInt<Limbs>& to) {
  const std::span<const std::uint64_t> limbs = limbs_of(x);
  to = {};
  for (std::size_t i = 0; i < limbs.size(); ++i)
    if (limbs[i] != 0) to = to + WideInt<Limbs>::shifted(limbs[i], static_cast<int>(64 * i), false);
  if (x.sign() < 0) to = -to;
}

template <class N>
std::vector<Triple<N>> narrowed_points(const LatticePoints& lattice) {
  std::vector<Triple<N>> points(lattice.points.size());
  for (std::size_t v = 0; v < points.size(); ++v)
    for (std::size_t i = 0; i < 3; ++i) narrow(lattice.points[v][i], points[v][i]);
  return points;
}

}  // namespace

LatticePoints lattice_points(ExactMeshView view, const Monitor& monitor) {
  if (!view.exact.empty()) return by_denominator(view, monitor);
  Lattice lattice;
  for (const Vertex& v : view.mesh.vertices)
    for (const double x : v) lattice.add(x);
  LatticePoints result;
  for (const Vertex& v : view.mesh.vertices) {
    monitor.check();
    result.points.push_back(
        {lattice.integer<Integer>(v[0]), lattice.integer<Integer>(v[1]), lattice.integer<Integer>(v[2])});
  }
  result.bits = lattice.bits();
  return result;
}

template <class N>
Directions<N> directions_of(const Surface& surface, const LatticePoints& lattice, const Monitor& monitor) {
  const std::vector<Triple<N>> points = narrowed_points<N>(lattice);
  Directions<N> result;
  for (const auto& loop : surface.faces) {
    monitor.check();
    result.normals.add(cross(minus(points[loop[1]], points[loop[0]]), minus(points[loop[2]], points[loop[0]])));
  }
  for (const SurfaceEdge& e : surface.edges) {
    monitor.check();
    result.edges.add(minus(points[e.to], points[e.from]));
    if (e.left == Surface::no_face) {
      result.bend.push_back(1);
      continue;
    }
    for (const std::uint32_t third : e.third) result.towards.add(minus(points[third], points[e.from]));
    result.bend.push_back(surface.is_convex ? 1
                                            : static_cast<signed char>(-product_sign(
                                                  result.normals, e.left, result.towards, result.towards.size() - 1)));
  }
  return result;
}

template Directions<__int128> directions_of(const Surface&, const LatticePoints&, const Monitor&);
template Directions<WideInt<4>> directions_of(const Surface&, const LatticePoints&, const Monitor&);
template Directions<Integer> directions_of(const Surface&, const LatticePoints&, const Monitor&);

}  // namespace strata::convex
