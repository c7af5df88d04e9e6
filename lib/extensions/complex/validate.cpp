#include "extensions/complex/validate.h"

#include <algorithm>
#include <map>
#include <span>
#include <vector>

#include "core/exact/failure.h"
#include "extensions/complex/face_geometry.h"
#include "strata/complex.h"
#include "strata/formula.h"

namespace strata::complex {
namespace {

using Index = std::uint32_t;

void require(bool holds, Cell where, const char* what) {
  if (!holds) throw ComplexError(where, what);
}

void check_sizes(const Cells& c) {
  require(c.dimension == 2 || c.dimension == 3, {}, "the dimension is neither 2 nor 3");
  const int top = c.dimension;
  require(c.count(top) > 0, {top, 0}, "there is no unbounded cell");
  require(top == 3 || c.count(3) == 0, {3, 0}, "a complex of the plane has no volumes");
  require(c.points.size() == c.count(0) && c.edges.size() == c.count(1), {}, "not every cell has a mark");
  require(c.sides.size() == (top == 3 ? c.count(2) : 0), {2, 0}, "faces have volumes above and below in space only");
}

void check_vertices(const Cells& c) {
  for (Index v = 0; v + 1 < c.count(0); ++v)
    require(c.position(v) < c.position(v + 1), {0, v + 1}, "vertices are not in lexicographic order");
  for (Index v = 0; v < c.count(0) && c.dimension == 2; ++v)
    require(c.position(v)[2] == 0, {0, v}, "a vertex in the plane has z other than 0");
}

void check_edges(const Cells& c) {
  for (Index e = 0; e < c.count(1); ++e) {
    require(c.edges[e][0] < c.edges[e][1] && c.edges[e][1] < c.count(0), {1, e},
            "an edge needs a lower and a higher vertex");
    require(e == 0 || c.edges[e - 1] < c.edges[e], {1, e},
            "edges are not in the order of their vertices, or are the same");
  }
}

void check_incidences(const Cells& c) {
  for (const auto& sides : c.sides)
    for (const Index v : sides)
      require(v < c.count(3), {2, static_cast<Index>(&sides - c.sides.data())}, "there is no such volume");
  for (std::size_t i = 0; i < c.wings.size(); ++i) {
    const Wing& w = c.wings[i];
    require(w.edge < c.count(1) && w.face < c.count(2), {2, w.face}, "there is no such edge");
    require(i == 0 || c.wings[i - 1] < w, {2, w.face}, "a face has a wing twice");
  }
  const auto check = [&](const std::vector<Isolated>& list, int low, int high) {
    for (const Isolated& i : list)
      require(i.cell < c.count(low) && i.in < c.count(high), {low, i.cell}, "there is no such cell to be isolated");
    for (std::size_t k = 1; k < list.size(); ++k)
      require(list[k - 1].cell < list[k].cell, {low, list[k].cell}, "a cell is isolated twice");
  };
  check(c.vertices_in_faces, 0, 2);
  check(c.vertices_in_volumes, 0, 3);
  check(c.edges_in_volumes, 1, 3);
}

/// Vertices without edges, and edges without faces, must lie in one cell; other vertices and edges in none.
void check_isolated(const Cells& c) {
  std::vector<int> uses(c.count(0)), places(c.count(0)), wings(c.count(1)), left(c.count(1)), volumes(c.count(1));
  for (const auto& edge : c.edges)
    for (const Index v : edge) ++uses[v];
  for (const Wing& w : c.wings) {
    ++wings[w.edge];
    left[w.edge] += w.left ? 1 : 0;
  }
  for (const Isolated& i : c.edges_in_volumes) ++volumes[i.cell];
  for (const auto* list : {&c.vertices_in_faces, &c.vertices_in_volumes})
    for (const Isolated& i : *list) ++places[i.cell];
  for (Index e = 0; e < c.count(1); ++e) {
    if (c.dimension == 2)
      require(wings[e] == 2 && left[e] == 1, {1, e}, "an edge of the plane has one face on either side");
    else
      require((wings[e] > 0) == (volumes[e] == 0), {1, e}, "an edge bounds faces, or lies in one volume");
  }
  for (Index v = 0; v < c.count(0); ++v)
    require(uses[v] > 0 || places[v] == 1, {0, v}, "a vertex without edges lies in one face or volume");
  for (const Isolated& i : c.vertices_in_volumes)
    require(uses[i.cell] == 0, {0, i.cell}, "a vertex with edges does not lie in a volume");
  for (const Isolated& i : c.vertices_in_faces)
    require(c.dimension == 3 || uses[i.cell] == 0, {0, i.cell},
            "a vertex with edges does not lie in a face of the plane");
}

void check_volumes(const Cells& c) {
  std::vector<std::uint8_t> has_face(c.count(3));
  for (const auto& sides : c.sides)
    for (const Index v : sides) has_face[v] = 1;
  for (Index v = 1; v < c.count(3); ++v) require(has_face[v] != 0, {3, v}, "a bounded volume has no faces");
}

/// Each vertex of a face must have as many incoming as outgoing edges.
void check_closed(const Cells& c, Index face, std::span<const Wing> wings) {
  std::map<Index, int> balance;
  for (const Wing& w : wings) {
    balance[c.edges[w.edge][0]] += w.left ? 1 : -1;
    balance[c.edges[w.edge][1]] -= w.left ? 1 : -1;
  }
  for (const auto& [vertex, sum] : balance) require(sum == 0, {2, face}, "the wings of a face do not close");
}

void check_faces(const Cells& c) {
  const WingsOfFaces wings(c);
  for (Index f = c.dimension == 2 ? 1 : 0; f < c.count(2); ++f) {
    require(!wings[f].empty(), {2, f}, "a bounded face has no wings");
    check_closed(c, f, wings[f]);
    const RationalPoint n = area_vector(c, wings[f]), p = c.position(c.edges[wings[f].front().edge][0]);
    require(n > RationalPoint{0, 0, 0}, {2, f}, "a face is not to the left of its edges as seen from its upper side");
    for (const Wing& w : wings[f])
      for (const Index v : c.edges[w.edge]) {
        const RationalPoint q = c.position(v);
        require(n[0] * (q[0] - p[0]) + n[1] * (q[1] - p[1]) + n[2] * (q[2] - p[2]) == 0, {2, f}, "a face is not flat");
      }
  }
  if (c.dimension == 2 && c.count(2) > 0) check_closed(c, 0, wings[0]);
}

/// The arrangement of the same cells.
SelectiveComplex arranged(const SelectiveComplex& s) {
  Formula same(1);
  same.close(same.operand(0));
  return combine(same, std::span(&s, 1));
}

}  // namespace

ComplexError::ComplexError(Cell where, const std::string& what) : std::runtime_error(what), where_(where) {}

void number_planes(Cells& cells) {
  cells.plane.assign(cells.count(2), 0);
  if (cells.dimension == 2) return;
  std::map<std::array<Rational, 4>, Index> numbers;
  const WingsOfFaces wings(cells);
  for (Index f = 0; f < cells.count(2); ++f) {
    const RationalPoint n = area_vector(cells, wings[f]), p = cells.position(cells.edges[wings[f].front().edge][0]);
    const Rational unit = n[0] != 0 ? n[0] : n[1] != 0 ? n[1] : n[2];
    const Rational offset = n[0] * p[0] + n[1] * p[1] + n[2] * p[2];
    const std::array<Rational, 4> plane{n[0] / unit, n[1] / unit, n[2] / unit, offset / unit};
    cells.plane[f] = numbers.try_emplace(plane, static_cast<Index>(numbers.size())).first->second;
  }
}

SelectiveComplex validated(Cells cells) {
  std::sort(cells.wings.begin(), cells.wings.end());
  for (auto* list : {&cells.vertices_in_faces, &cells.vertices_in_volumes, &cells.edges_in_volumes})
    std::sort(list->begin(), list->end());
  check_sizes(cells);
  check_vertices(cells);
  check_edges(cells);
  check_incidences(cells);
  check_isolated(cells);
  check_volumes(cells);
  check_faces(cells);
  number_planes(cells);
  const char* const mismatch = "cells meet otherwise than they say, or do not bound the cells that they should";
  try {
    SelectiveComplex s = SelectiveComplex::of(cells);
    check_faces(s.cells());  // contradictory cells may be merged to invalid faces
    if (arranged(s) == s) return s;
  } catch (const std::exception&) {
    // Simplification and arrangement require valid input; their exceptions mean that the cells are no complex.
  }
  throw ComplexError({cells.dimension, 0}, mismatch);
}

}  // namespace strata::complex
