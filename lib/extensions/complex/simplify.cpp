#include "extensions/complex/simplify.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "core/kernel/disjoint_sets.h"
#include "extensions/complex/collinear.h"
#include "extensions/complex/renumber.h"

namespace strata::complex {
namespace {

using Index = std::uint32_t;

/// Finds the cells to be merged, from volumes down to vertices.
class Merger {
 public:
  explicit Merger(const Cells& cells)
      : cells_(cells), merged_(cells), first_wing_(first_wings(cells)), volume_of_edge_(cells.edges.size(), none) {
    for (const Isolated& i : cells.edges_in_volumes) volume_of_edge_[i.cell] = i.in;
    for (const Isolated& i : cells.vertices_in_volumes) merged_.volume_of_vertex[i.cell] = i.in;
    for (const Isolated& i : cells.vertices_in_faces) merged_.face_of_vertex[i.cell] = i.in;
  }

  Merged run() {
    if (cells_.dimension == 3) merge_volumes();
    merge_faces();
    list_edges_at_vertices();
    for (Index v = 0; v < cells_.count(0); ++v) merge_at(v);
    return std::move(merged_);
  }

 private:
  static std::vector<Index> first_wings(const Cells& cells) {
    std::vector<Index> first(cells.edges.size() + 1);
    for (const Wing& w : cells.wings) ++first[w.edge + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    return first;
  }
  [[nodiscard]] std::span<const Wing> wings_of(Index edge) const {
    return std::span(cells_.wings).subspan(first_wing_[edge], first_wing_[edge + 1] - first_wing_[edge]);
  }
  [[nodiscard]] std::uint8_t mark(int d, Index i) const { return cells_.marks[static_cast<std::size_t>(d)][i]; }

  void merge_volumes() {
    for (Index f = 0; f < cells_.sides.size(); ++f) {
      const auto [above, below] = cells_.sides[f];
      merged_.keeps_face[f] = mark(3, above) != mark(2, f) || mark(3, below) != mark(2, f);
      if (merged_.keeps_face[f]) continue;
      merged_.changes = true;
      merged_.volumes.unite(above, below);
    }
  }

  void merge_faces() {
    for (Index e = 0; e < cells_.edges.size(); ++e) {
      std::array<Index, 2> faces{};
      std::size_t count = 0;
      for (const Wing& w : wings_of(e))
        if (merged_.keeps_face[w.face]) {
          if (count < 2) faces[count] = w.face;
          ++count;
        } else {
          volume_of_edge_[e] = cells_.sides[w.face][0];
        }
      if (count == 0) {
        const Index volume = merged_.volumes.find(volume_of_edge_[e]);
        merged_.keeps_edge[e] = mark(3, volume) != mark(1, e);
        merged_.changes = merged_.changes || !merged_.keeps_edge[e];
        merged_.volume_of_edge[e] = volume;
      } else if (count == 2 && cells_.plane[faces[0]] == cells_.plane[faces[1]] && mark(2, faces[0]) == mark(1, e) &&
                 mark(2, faces[1]) == mark(1, e)) {
        merged_.keeps_edge[e] = false;
        merged_.changes = true;
        merged_.faces.unite(faces[0], faces[1]);
      }
    }
  }

  void list_edges_at_vertices() {
    first_edge_.assign(std::size_t{cells_.count(0)} + 1, 0);
    for (const auto& ends : cells_.edges)
      for (const Index v : ends) ++first_edge_[v + 1];
    std::partial_sum(first_edge_.begin(), first_edge_.end(), first_edge_.begin());
    edges_at_.resize(first_edge_.back());
    std::vector<Index> next(first_edge_.begin(), first_edge_.end() - 1);
    for (Index e = 0; e < cells_.edges.size(); ++e)
      for (const Index v : cells_.edges[e]) edges_at_[next[v]++] = e;
  }
  [[nodiscard]] std::span<const Index> edges_at(Index v) const {
    return std::span(edges_at_).subspan(first_edge_[v], first_edge_[v + 1] - first_edge_[v]);
  }

  void merge_at(Index v) {
    std::array<Index, 2> edges{};
    std::size_t count = 0;
    for (const Index e : edges_at(v))
      if (merged_.keeps_edge[e]) {
        if (count < 2) edges[count] = e;
        ++count;
      }
    if (count == 0) return merge_in_face_or_volume(v);
    merged_.face_of_vertex[v] = pierced_face(v);
    if (count == 2 && merged_.face_of_vertex[v] == none && mark(1, edges[0]) == mark(0, v) &&
        mark(1, edges[1]) == mark(0, v) && is_straight(v, edges)) {
      merged_.keeps_vertex[v] = false;
      merged_.changes = true;
      merged_.edges.unite(edges[0], edges[1]);
    }
  }

  /// Merges a vertex on no edge, which lies in one face or in a volume.
  void merge_in_face_or_volume(Index v) {
    Index face = merged_.face_of_vertex[v], volume = merged_.volume_of_vertex[v];
    if (face != none && !merged_.keeps_face[face]) {
      volume = cells_.sides[face][0];
      face = none;
    }
    for (const Index e : edges_at(v)) {
      if (volume_of_edge_[e] != none) volume = volume_of_edge_[e];
      for (const Wing& w : wings_of(e))
        if (merged_.keeps_face[w.face]) face = w.face;
    }
    if (face != none) {
      merged_.face_of_vertex[v] = merged_.faces.find(face);
      merged_.volume_of_vertex[v] = none;
      merged_.keeps_vertex[v] = mark(2, face) != mark(0, v);
    } else {
      merged_.face_of_vertex[v] = none;
      merged_.volume_of_vertex[v] = merged_.volumes.find(volume);
      merged_.keeps_vertex[v] = mark(3, merged_.volume_of_vertex[v]) != mark(0, v);
    }
    merged_.changes = merged_.changes || !merged_.keeps_vertex[v];
  }

  [[nodiscard]] bool is_straight(Index v, const std::array<Index, 2>& edges) const {
    const auto other = [&](Index e) { return cells_.edges[e][cells_.edges[e][0] == v ? 1 : 0]; };
    const Index a = other(edges[0]), b = other(edges[1]);
    return (a < v) != (b < v) && are_collinear(cells_, a, v, b);
  }

  /// The face that surrounds a vertex of edges which are not its own, or none: two such faces would meet in edges.
  [[nodiscard]] Index pierced_face(Index v) {
    bordered_.clear();
    for (const Index e : edges_at(v))
      for (const Wing& w : wings_of(e))
        if (merged_.keeps_edge[e] && merged_.keeps_face[w.face]) bordered_.push_back(merged_.faces.find(w.face));
    const auto is_pierced = [&](Index face) {
      return merged_.keeps_face[face] &&
             std::find(bordered_.begin(), bordered_.end(), merged_.faces.find(face)) == bordered_.end();
    };
    if (const Index face = merged_.face_of_vertex[v]; face != none && is_pierced(face)) return face;
    for (const Index e : edges_at(v))
      for (const Wing& w : wings_of(e))
        if (is_pierced(w.face)) return w.face;
    return none;
  }

  const Cells& cells_;
  Merged merged_;
  std::vector<Index> first_wing_, volume_of_edge_;  ///< some volume at each edge without faces
  std::vector<Index> first_edge_, edges_at_, bordered_;
};

}  // namespace

Cells simplified(const Cells& cells) { return renumbered(cells, Merger(cells).run()); }

std::optional<Cells> simplified_if_needed(const Cells& cells) {
  Merged merged = Merger(cells).run();
  if (!merged.changes) return std::nullopt;
  return renumbered(cells, std::move(merged));
}

}  // namespace strata::complex
