#include <algorithm>
#include <utility>

#include "extensions/complex/overlay.h"
#include "extensions/complex/subdivision.h"

namespace strata::complex {
namespace {

using Index = std::uint32_t;

/// All drawings as one: their points and segments, concatenated.
struct Combined {
  explicit Combined(std::span<const Drawing> drawings) {
    for (Index k = 0; k < drawings.size(); ++k) {
      const Drawing& d = drawings[k];
      const auto first = static_cast<Index>(points.mesh.vertices.size());
      first_point.push_back(first);
      points.mesh.vertices.insert(points.mesh.vertices.end(), d.points.mesh.vertices.begin(),
                                  d.points.mesh.vertices.end());
      for (const ExactVertex& e : d.points.exact) points.exact.push_back({e.vertex + first, e.position});
      for (Index s = 0; s < d.segments.size(); ++s) {
        segments.push_back({d.segments[s][0] + first, d.segments[s][1] + first});
        source.emplace_back(k, s);
      }
    }
  }

  ExactMesh points;
  std::vector<std::array<Index, 2>> segments;
  std::vector<Index> first_point;
  std::vector<std::pair<Index, Index>> source;  ///< operand and segment there
};

class PlaneOverlay {
 public:
  PlaneOverlay(std::span<const Drawing> drawings, Overlay& result)
      : drawings_(drawings), all_(drawings), subdivision_(all_.points, all_.segments), result_(result) {}

  void run() {
    Cells& cells = result_.cells;
    cells.dimension = 2;
    cells.points = subdivision_.vertices.mesh.vertices;
    cells.exact = subdivision_.vertices.exact;
    result_.labels[0].assign(cells.points.size() * drawings_.size(), none);
    spread();
    add_edges();
    label_vertices();
    cells.marks[0].resize(cells.points.size());
    cells.marks[1].resize(cells.edges.size());
    cells.marks[2].resize(cells.plane.size());
  }

 private:
  [[nodiscard]] Index& label(std::size_t d, Index cell, Index operand) {
    return result_.labels[d][std::size_t{cell} * drawings_.size() + operand];
  }

  /// Propagates faces from the outside; across a segment its operand's face changes as the segment specifies.
  void spread() {
    face_.assign(subdivision_.parts.size(), none);
    std::vector<Index> reached;  // parts, of faces that are new
    const auto enter = [&](Index part) {
      const auto face = static_cast<Index>(result_.cells.plane.size());
      result_.cells.plane.push_back(0);
      std::vector<Index> stack{part};
      face_[part] = face;
      while (!stack.empty()) {
        const Index p = stack.back();
        stack.pop_back();
        reached.push_back(p);
        for (const auto& side : subdivision_.parts[p].sides)
          if (side.neighbour >= 0 && side.segments.empty() && face_[static_cast<Index>(side.neighbour)] == none) {
            face_[static_cast<Index>(side.neighbour)] = face;
            stack.push_back(static_cast<Index>(side.neighbour));
          }
      }
    };
    for (const Drawing& d : drawings_) result_.labels[2].push_back(d.outside);
    enter(subdivision_.outside);
    for (std::size_t i = 0; i < reached.size(); ++i)
      for (const auto& side : subdivision_.parts[reached[i]].sides) {
        if (side.neighbour < 0 || face_[static_cast<Index>(side.neighbour)] != none) continue;
        const std::size_t from = face_[reached[i]] * drawings_.size();
        for (std::size_t k = 0; k < drawings_.size(); ++k) result_.labels[2].push_back(result_.labels[2][from + k]);
        const auto face = static_cast<Index>(result_.cells.plane.size());
        for (const auto& [segment, forward] : side.segments) {
          const auto [k, s] = all_.source[segment];
          label(2, face, k) =
              drawings_[k].by_parity ? 1 - label(2, face, k) : drawings_[k].face_cell[s][forward ? 1 : 0];
        }
        enter(static_cast<Index>(side.neighbour));
      }
  }

  void add_edges() {
    Cells& cells = result_.cells;
    for (Index p = 0; p < subdivision_.parts.size(); ++p)
      for (std::size_t i = 0; i < 3; ++i) {
        const auto& side = subdivision_.parts[p].sides[i];
        const Index a = subdivision_.parts[p].v[i], b = subdivision_.parts[p].v[(i + 1) % 3];
        if (side.segments.empty() || a > b) continue;
        const auto edge = static_cast<Index>(cells.edges.size());
        const Index left = face_[p], right = face_[static_cast<Index>(side.neighbour)];
        cells.edges.push_back({a, b});
        cells.wings.push_back({edge, left, true});
        cells.wings.push_back({edge, right, false});
        for (Index k = 0; k < drawings_.size(); ++k) result_.labels[1].push_back(label(2, left, k));
        for (const auto& [segment, forward] : side.segments) {
          const auto [k, s] = all_.source[segment];
          label(1, edge, k) = drawings_[k].edge_cell[s];
          for (const Index v : cells.edges[edge]) label(0, v, k) = drawings_[k].edge_cell[s];
        }
      }
    std::sort(cells.wings.begin(), cells.wings.end());
  }

  void label_vertices() {
    for (Index k = 0; k < drawings_.size(); ++k)
      for (Index v = 0; v < drawings_[k].vertex_cell.size(); ++v)
        if (drawings_[k].vertex_cell[v] != none)
          label(0, subdivision_.vertex_of[all_.first_point[k] + v], k) = drawings_[k].vertex_cell[v];
    std::vector<bool> has_edge(result_.cells.points.size(), false);
    for (const auto& ends : result_.cells.edges)
      for (const Index v : ends) has_edge[v] = true;
    std::vector<bool> is_listed(has_edge);
    for (Index p = 0; p < subdivision_.parts.size(); ++p)
      for (const Index v : subdivision_.parts[p].v) {
        if (v == none) continue;
        for (Index k = 0; k < drawings_.size(); ++k)
          if (label(0, v, k) == none) label(0, v, k) = label(2, face_[p], k);
        if (!is_listed[v]) result_.cells.vertices_in_faces.push_back({v, face_[p]});
        is_listed[v] = true;
      }
    std::sort(result_.cells.vertices_in_faces.begin(), result_.cells.vertices_in_faces.end());
  }

  std::span<const Drawing> drawings_;
  Combined all_;
  Subdivision subdivision_;
  Overlay& result_;
  std::vector<Index> face_;  ///< per part
};

}  // namespace

Overlay overlay(std::span<const Drawing> operands, const Monitor&) {
  Overlay result;
  PlaneOverlay(operands, result).run();
  return result;
}

}  // namespace strata::complex
