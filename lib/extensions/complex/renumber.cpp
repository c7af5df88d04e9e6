#include "extensions/complex/renumber.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace strata::complex {
namespace {

using Index = std::uint32_t;

/// New numbers for representatives in the order of their keys; a representative without a key is first.
template <class Key>
std::vector<Index> number_by(std::vector<std::pair<Key, Index>> first_keys, Index count) {
  std::sort(first_keys.begin(), first_keys.end());
  std::vector<Index> number(count, none);
  Index next = 0;
  for (const auto& [key, cell] : first_keys)
    if (number[cell] == none) number[cell] = next++;
  return number;
}

class Renumbering {
 public:
  Renumbering(const Cells& cells, Merged merged) : old_(cells), merged_(std::move(merged)) {
    new_.dimension = cells.dimension;
  }

  Cells run() {
    add_vertices();
    add_edges();
    add_faces();
    if (old_.dimension == 3) add_volumes();
    add_isolated();
    return std::move(new_);
  }

 private:
  void add_vertices() {
    vertex_.assign(old_.count(0), none);
    auto rational = old_.exact.begin();
    for (Index v = 0; v < old_.count(0); ++v) {
      if (!merged_.keeps_vertex[v]) continue;
      vertex_[v] = static_cast<Index>(new_.points.size());
      new_.points.push_back(old_.points[v]);
      while (rational != old_.exact.end() && rational->vertex < v) ++rational;
      if (rational != old_.exact.end() && rational->vertex == v) new_.exact.push_back({vertex_[v], rational->position});
      new_.marks[0].push_back(old_.marks[0][v]);
    }
  }

  void add_edges() {
    std::vector<std::array<Index, 2>> ends(old_.count(1), {none, none});
    for (Index e = 0; e < old_.count(1); ++e)
      for (std::size_t i = 0; i < 2 && merged_.keeps_edge[e]; ++i)
        if (const Index v = vertex_[old_.edges[e][i]]; v != none) ends[merged_.edges.find(e)][i] = v;
    std::vector<std::pair<std::array<Index, 2>, Index>> keys;
    for (Index e = 0; e < old_.count(1); ++e)
      if (merged_.keeps_edge[e] && merged_.edges.find(e) == e) keys.emplace_back(ends[e], e);
    edge_ = number_by(keys, old_.count(1));
    new_.edges.resize(keys.size());
    new_.marks[1].resize(keys.size());
    for (const auto& [key, e] : keys) {
      new_.edges[edge_[e]] = key;
      new_.marks[1][edge_[e]] = old_.marks[1][e];
    }
    for (Index e = 0; e < old_.count(1); ++e) edge_[e] = merged_.keeps_edge[e] ? edge_[merged_.edges.find(e)] : none;
  }

  [[nodiscard]] Index face_class(Index f) { return merged_.keeps_face[f] ? merged_.faces.find(f) : none; }

  /// Faces by their first wing, which belongs to one face per plane: then by the next ones. A face without wings covers
  /// the plane.
  void add_faces() {
    std::vector<std::vector<std::pair<Index, bool>>> wings(old_.count(2));
    for (const Wing& w : old_.wings)
      if (edge_[w.edge] != none && merged_.keeps_face[w.face])
        wings[merged_.faces.find(w.face)].emplace_back(edge_[w.edge], w.left);
    std::vector<std::pair<std::vector<std::pair<Index, bool>>, Index>> keys;
    const Index outer = old_.dimension == 2 ? merged_.faces.find(0) : none;
    for (Index f = 0; f < old_.count(2); ++f) {
      if (face_class(f) != f) continue;
      std::sort(wings[f].begin(), wings[f].end());
      wings[f].erase(std::unique(wings[f].begin(), wings[f].end()), wings[f].end());
      if (f != outer) keys.emplace_back(std::move(wings[f]), f);
    }
    std::sort(keys.begin(), keys.end());
    if (outer != none) keys.insert(keys.begin(), {std::move(wings[outer]), outer});
    face_.assign(old_.count(2), none);
    for (const auto& [list, f] : keys) {
      face_[f] = static_cast<Index>(new_.plane.size());
      new_.plane.push_back(old_.plane[f]);
      new_.marks[2].push_back(old_.marks[2][f]);
      for (const auto& [edge, left] : list) new_.wings.push_back({edge, face_[f], left});
    }
    std::sort(new_.wings.begin(), new_.wings.end());
    for (Index f = 0; f < old_.count(2); ++f) face_[f] = merged_.keeps_face[f] ? face_[merged_.faces.find(f)] : none;
  }

  /// Volumes by their first face and its side; the unbounded one is always first.
  void add_volumes() {
    new_.sides.assign(new_.plane.size(), {none, none});
    for (Index f = 0; f < old_.count(2); ++f)
      for (std::size_t i = 0; i < 2 && face_[f] != none; ++i)
        new_.sides[face_[f]][i] = merged_.volumes.find(old_.sides[f][i]);
    const Index outer = merged_.volumes.find(0);
    std::vector<std::pair<Index, Index>> keys{{0, outer}};
    for (Index f = 0; f < new_.sides.size(); ++f)
      for (std::size_t i = 0; i < 2; ++i) keys.emplace_back(1 + 2 * f + i, new_.sides[f][i]);
    volume_ = number_by(keys, old_.count(3));
    for (auto& sides : new_.sides)
      for (Index& v : sides) v = volume_[v];
    for (Index v = 0; v < old_.count(3); ++v) volume_[v] = volume_[merged_.volumes.find(v)];
    if (std::find(volume_.begin(), volume_.end(), none) != volume_.end())
      throw std::invalid_argument("a bounded volume has no faces, or faces that are one have different volumes");
    new_.marks[3].resize(1 + *std::max_element(volume_.begin(), volume_.end()));
    for (Index v = 0; v < old_.count(3); ++v) new_.marks[3][volume_[v]] = old_.marks[3][v];
  }

  void add_isolated() {
    for (Index e = 0; e < old_.count(1); ++e)
      if (edge_[e] != none && merged_.volume_of_edge[e] != none)
        new_.edges_in_volumes.push_back({edge_[e], volume_[merged_.volume_of_edge[e]]});
    auto& in_volumes = new_.edges_in_volumes;
    std::sort(in_volumes.begin(), in_volumes.end());
    in_volumes.erase(std::unique(in_volumes.begin(), in_volumes.end()), in_volumes.end());
    for (Index v = 0; v < old_.count(0); ++v) {
      if (vertex_[v] == none) continue;
      if (merged_.face_of_vertex[v] != none)
        new_.vertices_in_faces.push_back({vertex_[v], face_[merged_.face_of_vertex[v]]});
      if (merged_.volume_of_vertex[v] != none)
        new_.vertices_in_volumes.push_back({vertex_[v], volume_[merged_.volume_of_vertex[v]]});
    }
  }

  const Cells& old_;
  Merged merged_;
  Cells new_;
  std::vector<Index> vertex_, edge_, face_, volume_;  ///< new numbers, or none
};

}  // namespace

Cells renumbered(const Cells& cells, Merged merged) { return Renumbering(cells, std::move(merged)).run(); }

}  // namespace strata::complex
