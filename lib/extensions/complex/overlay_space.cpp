#include <algorithm>
#include <utility>

#include "core/kernel/rational_point.h"
#include "extensions/complex/arrangement.h"
#include "extensions/complex/overlay.h"
#include "extensions/complex/shells.h"

namespace strata::complex {
namespace {

using Index = std::uint32_t;

/// Converts pieces, their sides and corners to cells.
Cells cells_of(const Arrangement& arrangement) {
  Cells cells;
  for (Index v = 0; v < arrangement.vertices.size(); ++v) {
    const PointId id = arrangement.vertices[v];
    const Point p = arrangement.points.point(id);
    cells.points.push_back(nearest_doubles(arrangement.input, p));
    if (arrangement.points.is_input(id) && arrangement.input.has_doubles(id)) continue;
    RationalPoint exact = exact_position(arrangement.input, p);
    const Vertex& d = cells.points.back();
    if (exact != to_rational(d)) cells.exact.push_back({v, std::move(exact)});
  }
  for (const Piece& p : arrangement.pieces)
    for (std::size_t i = 0; i < 3; ++i)
      cells.edges.push_back({std::min(p.v[i], p.v[(i + 1) % 3]), std::max(p.v[i], p.v[(i + 1) % 3])});
  std::sort(cells.edges.begin(), cells.edges.end());
  cells.edges.erase(std::unique(cells.edges.begin(), cells.edges.end()), cells.edges.end());
  return cells;
}

Index edge_between(const Cells& cells, Index a, Index b) {
  const std::array<Index, 2> ends{std::min(a, b), std::max(a, b)};
  return static_cast<Index>(std::lower_bound(cells.edges.begin(), cells.edges.end(), ends) - cells.edges.begin());
}

void add_wings(Cells& cells, const Arrangement& arrangement) {
  for (Index p = 0; p < arrangement.pieces.size(); ++p) {
    const auto& v = arrangement.pieces[p].v;
    for (std::size_t i = 0; i < 3; ++i)
      cells.wings.push_back({edge_between(cells, v[i], v[(i + 1) % 3]), p, v[i] < v[(i + 1) % 3]});
  }
  std::sort(cells.wings.begin(), cells.wings.end());
}

/// Finds for each cell the operands' cells that contain it: first from triangles, then for volumes, and from these for
/// all remaining cells.
class Labelling {
 public:
  Labelling(std::span<const Soup> operands, const GivenFaces& given, const Arrangement& arrangement, Overlay& overlay)
      : operands_(operands), given_(given), arrangement_(arrangement), cells_(overlay.cells), labels_(overlay.labels) {
    for (int d = 0; d < 4; ++d)
      labels_[static_cast<std::size_t>(d)].assign(std::size_t{cells_.count(d)} * operands.size(), none);
  }

  void run() {
    for (Index p = 0; p < cells_.count(2); ++p) label_piece(p);
    spread_through_volumes();
    label_sides();
    label_vertices();
    fill();
  }

 private:
  [[nodiscard]] Index& label(int d, Index cell, Index operand) {
    return labels_[static_cast<std::size_t>(d)][std::size_t{cell} * operands_.size() + operand];
  }

  void label_piece(Index p) {
    const Piece& piece = arrangement_.pieces[p];
    label_by(p, piece.face);
    for (Index i = 0; i < piece.covers; ++i) label_by(p, arrangement_.covers[piece.first + i]);
  }

  void label_by(Index p, Index face) {
    const Index k = given_.operand[face], f = face - given_.first[k];
    if (operands_[k].face_cell[f] == none) return;
    label(2, p, k) = operands_[k].face_cell[f];
    auto [above, below] = operands_[k].volume_cell[f];
    if (arrangement_.is_reversed[face] != 0) std::swap(above, below);
    label(3, cells_.sides[p][0], k) = above;
    label(3, cells_.sides[p][1], k) = below;
  }

  /// A volume of an operand is connected through pieces that do not belong to the operand.
  void spread_through_volumes() {
    std::vector<std::pair<Index, Index>> adjacent;  // volume, piece
    for (Index p = 0; p < cells_.count(2); ++p)
      for (const Index v : cells_.sides[p]) adjacent.emplace_back(v, p);
    std::sort(adjacent.begin(), adjacent.end());
    std::vector<std::size_t> first(cells_.count(3) + 1, adjacent.size());
    for (std::size_t i = adjacent.size(); i-- > 0;) first[adjacent[i].first] = i;
    for (std::size_t v = first.size() - 1; v-- > 0;) first[v] = std::min(first[v], first[v + 1]);
    std::vector<Index> stack;
    for (Index k = 0; k < operands_.size(); ++k) {
      for (Index v = 0; v < cells_.count(3); ++v)
        if (label(3, v, k) != none) stack.push_back(v);
      if (stack.empty()) {
        label(3, 0, k) = operands_[k].everywhere;
        stack.push_back(0);
      }
      while (!stack.empty()) {
        const Index v = stack.back();
        stack.pop_back();
        for (std::size_t i = first[v]; i < first[v + 1]; ++i) {
          const Index p = adjacent[i].second;
          if (label(2, p, k) != none) continue;
          for (const Index n : cells_.sides[p])
            if (label(3, n, k) == none) {
              label(3, n, k) = label(3, v, k);
              stack.push_back(n);
            }
        }
      }
    }
  }

  void label_sides() {
    for (const SidePart& s : arrangement_.side_parts) {
      const Index k = given_.operand[s.face];
      const Index cell = operands_[k].edge_cell[s.face - given_.first[k]][static_cast<std::size_t>(s.side)];
      if (cell != none) label(1, edge_between(cells_, s.v[0], s.v[1]), k) = cell;
    }
  }

  void label_vertices() {
    for (Index k = 0; k < operands_.size(); ++k)
      for (Index v = 0; v < given_.mesh.mesh.vertices.size(); ++v)
        if (given_.vertex_cell[k][v] != none && arrangement_.vertex_of[v] != none)
          label(0, arrangement_.vertex_of[v], k) = given_.vertex_cell[k][v];
  }

  /// Unknown labels of a cell are taken from the cells around it, the lowest first.
  void fill() {
    for (Index k = 0; k < operands_.size(); ++k) {
      for (Index e = 0; e < cells_.count(1); ++e)
        for (const Index v : cells_.edges[e])
          if (label(1, e, k) != none && label(0, v, k) == none) label(0, v, k) = label(1, e, k);
      for (const Wing& w : cells_.wings)
        if (label(2, w.face, k) != none) tell(w, k, label(2, w.face, k));
      for (const Wing& w : cells_.wings) tell(w, k, label(3, cells_.sides[w.face][0], k));
      for (Index p = 0; p < cells_.count(2); ++p)
        if (label(2, p, k) == none) label(2, p, k) = label(3, cells_.sides[p][0], k);
    }
  }

  void tell(const Wing& w, Index k, Index cell) {
    if (label(1, w.edge, k) == none) label(1, w.edge, k) = cell;
    for (const Index v : cells_.edges[w.edge])
      if (label(0, v, k) == none) label(0, v, k) = cell;
  }

  std::span<const Soup> operands_;
  const GivenFaces& given_;
  const Arrangement& arrangement_;
  const Cells& cells_;
  std::array<std::vector<Index>, 4>& labels_;
};

}  // namespace

Overlay overlay(std::span<const Soup> operands, const Monitor& monitor) {
  const GivenFaces given(operands);
  const Arrangement arrangement(given, monitor);
  Overlay result;
  Cells& cells = result.cells;
  cells = cells_of(arrangement);
  add_wings(cells, arrangement);
  Volumes volumes = find_volumes(arrangement, cells);
  cells.sides = std::move(volumes.sides);
  cells.plane = std::move(volumes.plane);
  cells.marks[0].resize(cells.points.size());
  cells.marks[1].resize(cells.edges.size());
  cells.marks[2].resize(arrangement.pieces.size());
  cells.marks[3].resize(volumes.count);
  Labelling(operands, given, arrangement, result).run();
  return result;
}

}  // namespace strata::complex
