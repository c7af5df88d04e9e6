#include "extensions/complex/operands.h"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "extensions/complex/face_geometry.h"
#include "extensions/complex/input_of_cells.h"
#include "extensions/complex/subdivision.h"

namespace strata::complex {
namespace {

using Index = std::uint32_t;

/// Appends the triangles of faces to a soup with the complex's vertices.
class FaceTriangulator {
 public:
  FaceTriangulator(const Cells& cells, Soup& soup)
      : cells_(cells),
        soup_(soup),
        wings_(cells),
        first_edge_(cells.count(0)),
        first_face_(first_edge_ + cells.count(1)),
        first_volume_(first_face_ + cells.count(2)) {
    for (const Isolated& i : cells.vertices_in_faces) isolated_.emplace(i.in, i.cell);
  }

  void add(Index face) {
    const auto wings = wings_[face];
    if (wings.size() == 3 && isolated_.count(face) == 0) {
      add_triangle(face, wings);
    } else {
      add_parts(face, wings);
    }
  }

 private:
  void append(Index face, const Triangle& t, const std::array<Index, 3>& edges) {
    soup_.mesh.mesh.triangles.push_back(t);
    soup_.face_cell.push_back(first_face_ + face);
    soup_.volume_cell.push_back({first_volume_ + cells_.sides[face][0], first_volume_ + cells_.sides[face][1]});
    soup_.edge_cell.push_back(edges);
  }

  /// Three wings are a triangle: each edge starts at the end of another.
  void add_triangle(Index face, std::span<const Wing> wings) {
    const auto from = [&](const Wing& w) { return cells_.edges[w.edge][w.left ? 0 : 1]; };
    const auto to = [&](const Wing& w) { return cells_.edges[w.edge][w.left ? 1 : 0]; };
    const bool in_order = to(wings[0]) == from(wings[1]);
    const Wing &second = wings[in_order ? 1 : 2], &third = wings[in_order ? 2 : 1];
    append(face, {from(wings[0]), from(second), from(third)},
           {first_edge_ + wings[0].edge, first_edge_ + second.edge, first_edge_ + third.edge});
  }

  /// Projects along an axis, subdivides the plane by the face's edges and keeps the parts on the face's sides of them.
  void add_parts(Index face, std::span<const Wing> wings) {
    const std::size_t axis = axis_of_face(cells_, wings);
    std::vector<Index> vertices;
    for (const Wing& w : wings)
      for (const Index v : cells_.edges[w.edge]) vertices.push_back(v);
    const auto [first, last] = isolated_.equal_range(face);
    for (auto i = first; i != last; ++i) vertices.push_back(i->second);
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    const auto local = [&](Index v) {
      return static_cast<Index>(std::lower_bound(vertices.begin(), vertices.end(), v) - vertices.begin());
    };
    ExactMesh points = seen_along(axis, vertices);
    std::vector<std::array<Index, 2>> segments;
    for (const Wing& w : wings) segments.push_back({local(cells_.edges[w.edge][0]), local(cells_.edges[w.edge][1])});
    const Subdivision subdivision(points, segments);
    std::vector<Index> vertex(subdivision.vertices.mesh.vertices.size(), none);
    for (Index i = 0; i < vertices.size(); ++i) vertex[subdivision.vertex_of[i]] = vertices[i];
    for (const Index p : inner_parts(subdivision, wings)) {
      const auto& part = subdivision.parts[p];
      const auto is_corner = [&](Index v) { return v < vertex.size() && vertex[v] != none; };
      if (!std::all_of(part.v.begin(), part.v.end(), is_corner))
        throw std::invalid_argument("the edges of a face cross, or do not enclose it");
      std::array<Index, 3> edges{none, none, none};
      for (std::size_t i = 0; i < 3; ++i)
        if (!part.sides[i].segments.empty()) edges[i] = first_edge_ + wings[part.sides[i].segments.front().first].edge;
      append(face, {vertex[part.v[0]], vertex[part.v[1]], vertex[part.v[2]]}, edges);
    }
  }

  [[nodiscard]] ExactMesh seen_along(std::size_t axis, const std::vector<Index>& vertices) const {
    ExactMesh points;
    auto rational = cells_.exact.begin();
    for (Index i = 0; i < vertices.size(); ++i) {
      const Vertex& p = cells_.points[vertices[i]];
      points.mesh.vertices.push_back({p[(axis + 1) % 3], p[(axis + 2) % 3], 0});
      rational = std::lower_bound(rational, cells_.exact.end(), vertices[i],
                                  [](const ExactVertex& e, Index w) { return e.vertex < w; });
      if (rational == cells_.exact.end() || rational->vertex != vertices[i]) continue;
      const RationalPoint& q = rational->position;
      points.exact.push_back({i, {q[(axis + 1) % 3], q[(axis + 2) % 3], 0}});
    }
    return points;
  }

  static std::vector<Index> inner_parts(const Subdivision& subdivision, std::span<const Wing> wings) {
    std::vector<bool> is_inner(subdivision.parts.size(), false);
    std::vector<Index> inner;
    for (Index p = 0; p < subdivision.parts.size(); ++p)
      for (const auto& side : subdivision.parts[p].sides)
        for (const auto& [s, forward] : side.segments)
          if (wings[s].left == forward && !is_inner[p]) {
            is_inner[p] = true;
            inner.push_back(p);
          }
    for (std::size_t i = 0; i < inner.size(); ++i)
      for (const auto& side : subdivision.parts[inner[i]].sides) {
        if (side.neighbour < 0 || !side.segments.empty() || is_inner[static_cast<Index>(side.neighbour)]) continue;
        is_inner[static_cast<Index>(side.neighbour)] = true;
        inner.push_back(static_cast<Index>(side.neighbour));
      }
    return inner;
  }

  const Cells& cells_;
  Soup& soup_;
  WingsOfFaces wings_;
  Index first_edge_, first_face_, first_volume_;
  std::multimap<Index, Index> isolated_;  ///< face, vertex
};

}  // namespace

Soup soup_of(const Cells& cells) {
  Soup soup;
  soup.mesh.mesh.vertices = cells.points;
  soup.mesh.exact = cells.exact;
  for (Index v = 0; v < cells.count(0); ++v) soup.vertex_cell.push_back(v);
  soup.everywhere = cells.count(0) + cells.count(1) + cells.count(2);
  FaceTriangulator triangulator(cells, soup);
  for (Index f = 0; f < cells.count(2); ++f) triangulator.add(f);
  for (const Isolated& e : cells.edges_in_volumes)
    add_triangle_at_edge(soup, cells.edges[e.cell][0], cells.edges[e.cell][1], cells.count(0) + e.cell);
  for (const Isolated& v : cells.vertices_in_volumes) add_triangle_at_vertex(soup, v.cell);
  return soup;
}

Drawing drawing_of(const Cells& cells) {
  Drawing drawing;
  const Index first_edge = cells.count(0), first_face = first_edge + cells.count(1);
  drawing.points.mesh.vertices = cells.points;
  drawing.points.exact = cells.exact;
  for (Index v = 0; v < cells.count(0); ++v) drawing.vertex_cell.push_back(v);
  drawing.segments = cells.edges;
  for (Index e = 0; e < cells.count(1); ++e) drawing.edge_cell.push_back(first_edge + e);
  drawing.face_cell.assign(cells.count(1), {none, none});
  for (const Wing& w : cells.wings) drawing.face_cell[w.edge][w.left ? 0 : 1] = first_face + w.face;
  drawing.outside = first_face;
  return drawing;
}

}  // namespace strata::complex
