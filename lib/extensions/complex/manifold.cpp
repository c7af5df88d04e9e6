#include <algorithm>
#include <array>
#include <utility>

#include "core/kernel/disjoint_sets.h"
#include "extensions/complex/face_geometry.h"
#include "strata/complex.h"

namespace strata::complex {
namespace {

using Index = std::uint32_t;

/// A side of an edge that leaves a vertex.
struct Spoke {
  Index face = 0, edge = 0;
  bool left = false;  ///< the face is on the left, looking away from the vertex from the face's upper side

  friend auto operator<=>(const Spoke&, const Spoke&) = default;
};

/// Counter-clockwise order of directions in a face, seen along an axis from its upper side.
class AngularOrder {
 public:
  AngularOrder(const Cells& cells, Index vertex, std::size_t axis)
      : cells_(cells), vertex_(vertex), i_((axis + 1) % 3), j_((axis + 2) % 3) {}

  bool operator()(const Spoke& a, const Spoke& b) const {
    const auto u = direction(a.edge), v = direction(b.edge);
    const bool lower_u = is_lower(u), lower_v = is_lower(v);
    return lower_u != lower_v ? lower_v : u[0] * v[1] > u[1] * v[0];
  }

 private:
  using Direction = std::array<Rational, 2>;
  static bool is_lower(const Direction& d) { return d[1] < 0 || (d[1] == 0 && d[0] < 0); }
  [[nodiscard]] Direction direction(Index edge) const {
    const auto [low, high] = cells_.edges[edge];
    const RationalPoint p = cells_.position(vertex_), q = cells_.position(low == vertex_ ? high : low);
    return {q[i_] - p[i_], q[j_] - p[j_]};
  }

  const Cells& cells_;
  Index vertex_;
  std::size_t i_, j_;
};

class Rings {
 public:
  explicit Rings(const Cells& cells) : cells_(cells), wings_(cells), spokes_(cells.count(0)) {
    for (const Wing& w : cells.wings) {
      spokes_[cells.edges[w.edge][0]].push_back({w.face, w.edge, w.left});
      spokes_[cells.edges[w.edge][1]].push_back({w.face, w.edge, !w.left});
    }
  }

  /// True when the corners of faces at a vertex connect all of its edges. Requires edges with two wings each.
  [[nodiscard]] bool is_one_ring(Index v, std::span<const Index> edges) {
    std::vector<Spoke>& spokes = spokes_[v];
    std::sort(spokes.begin(), spokes.end());
    DisjointSets<Index> connected(edges.size());
    const auto local = [&](Index e) {
      return static_cast<Index>(std::lower_bound(edges.begin(), edges.end(), e) - edges.begin());
    };
    for (std::size_t first = 0, last = 0; first < spokes.size(); first = last) {
      while (last < spokes.size() && spokes[last].face == spokes[first].face) ++last;
      const std::span<Spoke> of_face(&spokes[first], last - first);
      if (of_face.size() > 2)
        std::stable_sort(of_face.begin(), of_face.end(),
                         AngularOrder(cells_, v, axis_of_face(cells_, wings_[of_face.front().face])));
      for (std::size_t i = 0; i < of_face.size(); ++i)
        if (of_face[i].left) connected.unite(local(of_face[i].edge), local(next_right(of_face, i)));
    }
    for (Index e = 1; e < edges.size(); ++e)
      if (connected.find(e) != 0) return false;
    return true;
  }

 private:
  /// The corner of a face that begins left of one edge ends right of the next edge.
  static Index next_right(std::span<const Spoke> spokes, std::size_t i) {
    for (std::size_t k = 1; k <= spokes.size(); ++k)
      if (const Spoke& s = spokes[(i + k) % spokes.size()]; !s.left) return s.edge;
    return spokes[i].edge;
  }

  const Cells& cells_;
  WingsOfFaces wings_;
  std::vector<std::vector<Spoke>> spokes_;
};

}  // namespace

std::vector<Cell> non_manifold_cells(const SelectiveComplex& s) {
  const Cells& cells = s.cells();
  std::vector<std::vector<Index>> edges_at(cells.count(0));
  for (Index e = 0; e < cells.count(1); ++e)
    for (const Index v : cells.edges[e]) edges_at[v].push_back(e);
  std::vector<Cell> vertices, edges;
  if (s.dimension() == 2) {
    for (Index v = 0; v < cells.count(0); ++v)
      if (edges_at[v].size() != 2) vertices.push_back({0, v});
    return vertices;
  }
  std::vector<std::uint32_t> wings(cells.count(1), 0);
  for (const Wing& w : cells.wings) ++wings[w.edge];
  for (Index e = 0; e < cells.count(1); ++e)
    if (wings[e] != 2) edges.push_back({1, e});
  std::vector<bool> in_face(cells.count(0), false);
  for (const Isolated& i : cells.vertices_in_faces) in_face[i.cell] = true;
  Rings rings(cells);
  for (Index v = 0; v < cells.count(0); ++v) {
    const bool has_two_wings =
        std::all_of(edges_at[v].begin(), edges_at[v].end(), [&](Index e) { return wings[e] == 2; });
    const bool is_ring =
        edges_at[v].empty() ? in_face[v] : !in_face[v] && has_two_wings && rings.is_one_ring(v, edges_at[v]);
    if (!is_ring) vertices.push_back({0, v});
  }
  vertices.insert(vertices.end(), edges.begin(), edges.end());
  return vertices;
}

bool is_manifold(const SelectiveComplex& s) { return non_manifold_cells(s).empty(); }

}  // namespace strata::complex
