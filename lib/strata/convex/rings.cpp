#include "strata/convex/rings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <vector>

#include "strata/kernel/box.h"
#include "strata/kernel/disjoint_sets.h"

namespace strata::convex {
namespace {

/// A face for every direction; some directions more than once, by normals of different lengths.
template <class N>
std::vector<std::uint32_t> different_normals(const Directions<N>& directions) {
  std::map<std::array<double, 3>, std::uint32_t> first;
  std::vector<std::uint32_t> result;
  for (std::uint32_t f = 0; f < directions.normals.size(); ++f) {
    std::array<double, 3> n = directions.normals.approximate[f];
    const bool is_axis = (n[0] != 0) + (n[1] != 0) + (n[2] != 0) == 1;
    if (is_axis)
      for (double& x : n) x = x == 0 ? 0 : x > 0 ? 1 : -1;
    const auto [at, is_new] = first.emplace(n, f);
    if (is_new || (!is_axis && directions.normals.exact[f] != directions.normals.exact[at->second]))
      result.push_back(f);
  }
  return result;
}

/// The edges of a surface at right angles to a normal.
template <class N>
std::vector<std::uint32_t> level_edges(const Directions<N>& directions, const Vectors<N>& normals, std::uint32_t m) {
  std::vector<std::uint32_t> level;
  for (std::uint32_t e = 0; e < directions.edges.size(); ++e)
    if (product_sign(normals, m, directions.edges, e) == 0) level.push_back(e);
  return level;
}

/// The ends of some edges, by small numbers.
class Ends {
 public:
  Ends(const Surface& surface, const std::vector<std::uint32_t>& edges) {
    for (const std::uint32_t e : edges) ends_.push_back({add(surface.edges[e].from), add(surface.edges[e].to)});
  }
  [[nodiscard]] std::size_t vertex_count() const { return number_.size(); }
  [[nodiscard]] std::uint32_t number(std::uint32_t vertex) const { return number_.at(vertex); }
  /// Of the edge of this place in the list.
  [[nodiscard]] const std::array<std::uint32_t, 2>& of(std::size_t edge) const { return ends_[edge]; }

 private:
  std::uint32_t add(std::uint32_t v) {
    return number_.emplace(v, static_cast<std::uint32_t>(number_.size())).first->second;
  }

  std::map<std::uint32_t, std::uint32_t> number_;
  std::vector<std::array<std::uint32_t, 2>> ends_;
};

Box box_of(const Surface& surface, std::uint32_t edge) {
  Box box;
  box.include(surface.points.mesh.vertices[surface.edges[edge].from]);
  box.include(surface.points.mesh.vertices[surface.edges[edge].to]);
  return box;
}

/// Boxes of the connected parts of some edges.
std::vector<Box> boxes_of_parts(const Surface& surface, const std::vector<std::uint32_t>& edges) {
  const Ends ends(surface, edges);
  DisjointSets<std::uint32_t> parts(ends.vertex_count());
  for (std::size_t i = 0; i < edges.size(); ++i) parts.unite(ends.of(i)[0], ends.of(i)[1]);
  std::vector<Box> boxes(ends.vertex_count());
  for (std::size_t i = 0; i < edges.size(); ++i) boxes[parts.find(ends.of(i)[0])].include(box_of(surface, edges[i]));
  std::erase_if(boxes, [](const Box& b) { return b.empty(); });
  return boxes;
}

/// Is what has the first box, rounded to nearest doubles, certainly longer somewhere than what has the second one?
bool is_longer(const Box& a, const Box& b) {
  const auto up = [](double x) { return std::nextafter(x, Box::infinity); };
  const auto down = [](double x) { return std::nextafter(x, -Box::infinity); };
  for (std::size_t i = 0; i < 3; ++i)
    if (down(down(a.upper[i]) - up(a.lower[i])) > up(up(b.upper[i]) - down(b.lower[i]))) return true;
  return false;
}

/// The edges and faces of a surface at right angles to a normal from which nothing near rises along it.
template <class N>
class LevelSet {
 public:
  LevelSet(const Surface& surface, const Directions<N>& own, const Vectors<N>& normals, std::uint32_t m,
           const std::vector<std::uint32_t>& level)
      : surface_(surface) {
    std::map<std::uint32_t, int> sides;
    for (const std::uint32_t e : level)
      for (const std::uint32_t f : {surface.edges[e].left, surface.edges[e].right}) ++sides[f];
    const auto is_level = [&](std::uint32_t f) {
      return sides[f] == static_cast<int>(surface.faces[f].size()) &&
             sign_number(dot(own.normals.exact[f], normals.exact[m])) > 0;
    };
    for (const std::uint32_t e : level) {
      const SurfaceEdge& edge = surface.edges[e];
      const bool left = is_level(edge.left), right = is_level(edge.right);
      const bool is_top = own.bend[e] > 0 && product_sign(normals, m, own.towards, 2 * e) <= 0 &&
                          product_sign(normals, m, own.towards, 2 * e + 1) <= 0;
      if (!left && !right && !is_top) continue;
      edges_.push_back(e);
      if (!left || !right) rims_.push_back(e);
      if (left) faces_.emplace(edge.left, edge.from);
      if (right) faces_.emplace(edge.right, edge.from);
    }
  }

  /// The edges around the parts that have holes: of Euler characteristic 0 or less.
  [[nodiscard]] std::vector<std::uint32_t> rims_of_rings() const {
    const Ends ends(surface_, edges_);
    DisjointSets<std::uint32_t> parts(ends.vertex_count());
    for (std::size_t i = 0; i < edges_.size(); ++i) parts.unite(ends.of(i)[0], ends.of(i)[1]);
    std::vector<int> characteristic(ends.vertex_count());
    for (std::uint32_t v = 0; v < ends.vertex_count(); ++v) ++characteristic[parts.find(v)];
    for (std::size_t i = 0; i < edges_.size(); ++i) --characteristic[parts.find(ends.of(i)[0])];
    for (const auto& [f, v] : faces_) ++characteristic[parts.find(ends.number(v))];
    std::vector<std::uint32_t> rims;
    for (const std::uint32_t e : rims_)
      if (characteristic[parts.find(ends.number(surface_.edges[e].from))] <= 0) rims.push_back(e);
    return rims;
  }

 private:
  const Surface& surface_;
  std::vector<std::uint32_t> edges_, rims_;
  std::map<std::uint32_t, std::uint32_t> faces_;  ///< with a vertex
};

/// The edges around rings. Where no more than two of them meet they go on as a chain; so a hole is surrounded by whole
/// chains.
class Rims {
 public:
  Rims(const Surface& surface, const std::vector<std::uint32_t>& edges)
      : ends_(surface, edges), chain_of_(edges.size()), box_(edges.size()) {
    std::vector<std::vector<std::uint32_t>> at(ends_.vertex_count());
    for (std::uint32_t i = 0; i < edges.size(); ++i)
      for (const std::uint32_t v : ends_.of(i)) at[v].push_back(i);
    DisjointSets<std::uint32_t> chains(edges.size());
    for (const auto& two : at)
      if (two.size() == 2) chains.unite(two[0], two[1]);
    for (std::uint32_t i = 0; i < edges.size(); ++i) {
      chain_of_[i] = chains.find(i);
      box_[chain_of_[i]].include(box_of(surface, edges[i]));
    }
  }

  /// May a hole fit into a set? Not if chains that may fit make no cycle.
  [[nodiscard]] bool may_fit(const Box& set) const {
    DisjointSets<std::uint32_t> parts(ends_.vertex_count());
    for (std::size_t i = 0; i < chain_of_.size(); ++i) {
      const auto& [v, w] = ends_.of(i);
      if (is_longer(box_[chain_of_[i]], set)) continue;
      if (parts.find(v) == parts.find(w)) return true;
      parts.unite(v, w);
    }
    return false;
  }

 private:
  Ends ends_;
  std::vector<std::uint32_t> chain_of_;  ///< per edge one of the chain's
  std::vector<Box> box_;                 ///< of chains
};

}  // namespace

template <class N>
bool has_rings(const Surface& surface, const Directions<N>& directions, const Surface& other,
               const Directions<N>& of_other) {
  for (const std::uint32_t m : different_normals(of_other)) {
    const std::vector<std::uint32_t> level = level_edges(directions, of_other.normals, m);
    if (level.size() < 3) continue;
    const LevelSet<N> set(surface, directions, of_other.normals, m, level);
    const std::vector<std::uint32_t> around_rings = set.rims_of_rings();
    if (around_rings.empty()) continue;
    const Rims rims(surface, around_rings);
    for (const Box& part : boxes_of_parts(other, level_edges(of_other, of_other.normals, m)))
      if (rims.may_fit(part)) return true;
  }
  return false;
}

template bool has_rings(const Surface&, const Directions<__int128>&, const Surface&, const Directions<__int128>&);
template bool has_rings(const Surface&, const Directions<WideInt<4>>&, const Surface&, const Directions<WideInt<4>>&);
template bool has_rings(const Surface&, const Directions<Integer>&, const Surface&, const Directions<Integer>&);

}  // namespace strata::convex
