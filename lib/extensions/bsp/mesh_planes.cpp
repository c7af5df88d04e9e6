#include "extensions/bsp/mesh_planes.h"

#include <algorithm>
#include <cstdlib>
#include <type_traits>
#include <utility>

namespace strata::bsp {
namespace {

template <class Int>
bool is_zero(const Int& x) {
  return sign_of_integer(x) == Sign::zero;
}

template <class Int>
std::array<Int, 3> difference(const HPoint<Int>& p, const HPoint<Int>& q) {
  std::array<Int, 3> d;
  for (int i = 0; i < 3; ++i) d[static_cast<std::size_t>(i)] = weighed(q[i], p) - weighed(p[i], q);
  return d;
}

}  // namespace

MeshPlanes::MeshPlanes(HyperplaneTable<3>& table, ExactMeshView mesh) : table_(table), mesh_(mesh) {
  Lattice lattice;
  for (const Vertex& v : mesh.mesh.vertices)
    for (const double x : v) lattice.add(x);
  unit_ = lattice.unit();
  if (mesh.exact.empty() && lattice.bits() <= most_bits_of_narrow) {
    narrow_ = on_lattice<Narrow>(lattice);
    return;
  }
  wide_ = on_lattice<Integer>(lattice);
  for (const ExactVertex& e : mesh.exact) wide_[e.vertex] = place_of(e.position);
}

/// Converts from units of the lattice to units of the mesh. This makes narrow forms at most 1,100 bits longer, which
/// fits into a LongInt.
template <class Int>
OrientedHyperplane<3> MeshPlanes::oriented(const HPlane<Int>& plane) const {
  using Form = std::conditional_t<std::is_same_v<Int, Narrow>, LongInt, Int>;
  std::array<Form, 4> form{Form(plane.a), Form(plane.b), Form(plane.c), Form(plane.d)};
  const int shift = std::abs(unit_);
  if (unit_ > 0) form[3] = Form(form[3] << shift);
  if (unit_ < 0)
    for (std::size_t i = 0; i < 3; ++i) form[i] = Form(form[i] << shift);
  return oriented_hyperplane<3>(form);
}

std::optional<MeshPlanes::Plane> MeshPlanes::through(const Triangle& vertices) {
  std::optional<OrientedHyperplane<3>> plane = found([&](const auto& at) -> std::optional<OrientedHyperplane<3>> {
    const auto p = strata::plane_through(at[vertices[0]], at[vertices[1]], at[vertices[2]]);
    if (is_zero(p.a) && is_zero(p.b) && is_zero(p.c)) return std::nullopt;
    return oriented(p);
  });
  if (!plane) return std::nullopt;
  const std::uint32_t number = table_.add(std::move(plane->hyperplane));
  for (const std::uint32_t v : vertices) note(number, v);
  return Plane{number, plane->is_reversed};
}

std::uint32_t MeshPlanes::along_axis(std::uint32_t p, std::uint32_t q, int axis) {
  const auto [low, high] = std::minmax(p, q);
  const auto [known, is_new] = along_[static_cast<std::size_t>(axis)].try_emplace(std::uint64_t{low} << 32U | high);
  if (is_new) {
    known->second =
        table_.add(found([&](const auto& at) { return oriented(plane_along_axis(at[p], at[q], axis)); }).hyperplane);
    for (const std::uint32_t v : {p, q}) note(known->second, v);
  }
  return known->second;
}

bool MeshPlanes::are_parallel(std::array<std::uint32_t, 2> p, std::array<std::uint32_t, 2> q) const {
  return found([&](const auto& at) {
    const auto u = difference(at[p[0]], at[p[1]]), v = difference(at[q[0]], at[q[1]]);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      if (!is_zero<std::remove_cvref_t<decltype(u[0])>>(u[i] * v[j] - u[j] * v[i])) return false;
    }
    return true;
  });
}

bool MeshPlanes::is_given(std::uint32_t vertex) const {
  const auto at = std::lower_bound(mesh_.exact.begin(), mesh_.exact.end(), vertex,
                                   [](const ExactVertex& e, std::uint32_t v) { return e.vertex < v; });
  return at == mesh_.exact.end() || at->vertex != vertex;
}

template <class Int>
std::vector<HPoint<Int>> MeshPlanes::on_lattice(const Lattice& lattice) const {
  std::vector<HPoint<Int>> places;
  places.reserve(mesh_.mesh.vertices.size());
  for (const auto& [x, y, z] : mesh_.mesh.vertices)
    places.push_back({lattice.integer<Int>(x), lattice.integer<Int>(y), lattice.integer<Int>(z), Int(1), true});
  return places;
}

HPoint<Integer> MeshPlanes::place_of(const RationalPoint& p) const {
  Integer w = 1;
  for (const Rational& x : p) w = lcm(w, denominator(x));
  std::array<Integer, 3> n;
  for (std::size_t i = 0; i < 3; ++i) n[i] = numerator(p[i]) * (w / denominator(p[i]));
  const auto shift = static_cast<unsigned>(std::abs(unit_));
  if (unit_ > 0) w <<= shift;
  if (unit_ < 0)
    for (Integer& x : n) x <<= shift;
  return {n[0], n[1], n[2], w, w == 1};
}

void MeshPlanes::note(std::uint32_t plane, std::uint32_t vertex) {
  if (is_given(vertex)) table_.note(plane, mesh_.mesh.vertices[vertex]);
}

}  // namespace strata::bsp
