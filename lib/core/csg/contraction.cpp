#include "core/csg/contraction.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace strata {
namespace {

/// The faces of some pairs, by increasing number.
std::vector<std::uint32_t> faces_of(std::span<const SelfIntersection> pairs) {
  std::vector<std::uint32_t> faces;
  for (const SelfIntersection& p : pairs) faces.insert(faces.end(), {p.face, p.other});
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

double size(const Vertex& v) { return std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])}); }

}  // namespace

std::vector<double> contract_short_sides(Mesh& mesh, std::span<const SelfIntersection> pairs, const GridRounding& grid,
                                         double reach) {
  enum class State : std::uint8_t { free, stays, goes };
  std::vector<State> state(mesh.vertices.size(), State::free);
  std::vector<std::uint32_t> becomes(mesh.vertices.size());
  std::iota(becomes.begin(), becomes.end(), 0U);
  std::vector<double> way(mesh.vertices.size(), 0);
  const auto contract = [&](std::uint32_t stays, std::uint32_t goes) {
    if (state[stays] == State::goes || state[goes] != State::free) return;
    const Vertex &p = mesh.vertices[stays], &q = mesh.vertices[goes];
    const double length = size({p[0] - q[0], p[1] - q[1], p[2] - q[2]});
    if (length > reach * grid.unit_at(size(p))) return;
    state[stays] = State::stays;
    state[goes] = State::goes;
    becomes[goes] = stays;
    way[goes] = length;
  };
  for (const std::uint32_t f : faces_of(pairs)) {
    const Triangle& t = mesh.triangles[f];
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(t[k], t[(k + 1) % 3]);
      contract(low, high);
      contract(high, low);
    }
  }
  std::vector<double> moved;
  moved.reserve(mesh.triangles.size());
  for (Triangle& t : mesh.triangles) {
    moved.push_back(std::max({way[t[0]], way[t[1]], way[t[2]]}));
    for (std::uint32_t& v : t) v = becomes[v];
  }
  return moved;
}

}  // namespace strata
