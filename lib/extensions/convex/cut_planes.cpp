#include "extensions/convex/cut_planes.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace strata::convex {
namespace {

constexpr std::size_t most_partners = 4;  ///< planes through an edge and another one
constexpr std::size_t nearest_parallel = 2;
constexpr double nearly = 0x1p-30;  ///< for an estimate; exact signs decide whether edges are parallel

class CutPlanes {
 public:
  CutPlanes(bsp::MeshPlanes& mesh_planes, std::span<const bsp::Facet<3>> facets, std::span<const Wedge> wedges,
            const Monitor& monitor)
      : monitor_(monitor), mesh_planes_(mesh_planes), facets_(facets), wedges_(wedges), through_(wedges.size()) {
    for (std::uint32_t w = 0; w < wedges.size(); ++w)
      if (wedges[w].is_reflex) reflex_.push_back(w);
  }

  std::vector<std::vector<std::uint32_t>> all() {
    for (const std::uint32_t w : reflex_)
      for (const std::uint32_t f : wedges_[w].faces) note(w, facets_[f].piece.hyperplane);
    pair_at_ends();
    pair_parallel();
    return std::move(through_);
  }

 private:
  void note(std::uint32_t wedge, std::uint32_t plane) {
    std::vector<std::uint32_t>& planes = through_[wedge];
    if (std::find(planes.begin(), planes.end(), plane) == planes.end()) planes.push_back(plane);
  }

  /// Adds the plane through edge v and a vertex of edge w to the candidates of both, unless one has enough or the
  /// vertex is on v's line.
  void pair(std::uint32_t v, std::uint32_t w, std::uint32_t apex) {
    if (through_[v].size() >= 2 + most_partners || through_[w].size() >= 2 + most_partners) return;
    const auto [p, q] = wedges_[v].vertices;
    const auto plane = mesh_planes_.through({p, q, apex});
    if (!plane) return;
    for (const std::uint32_t end : wedges_[w].vertices) mesh_planes_.note(plane->number, end);
    note(v, plane->number);
    note(w, plane->number);
  }

  /// In lexicographic order of the vertices, so that the result depends little on their numbering.
  void pair_at_ends() {
    struct End {
      std::uint32_t vertex, other, wedge;
    };
    std::vector<End> ends;
    for (const std::uint32_t w : reflex_) {
      const auto [p, q] = wedges_[w].vertices;
      ends.push_back({p, q, w});
      ends.push_back({q, p, w});
    }
    const auto vertices = mesh_planes_.mesh().mesh.vertices;
    std::stable_sort(ends.begin(), ends.end(), [&](const End& a, const End& b) {
      return std::tie(vertices[a.vertex], a.vertex) < std::tie(vertices[b.vertex], b.vertex);
    });
    for (std::size_t first = 0, i = 0; i < ends.size(); ++i) {
      if (ends[i].vertex != ends[first].vertex) first = i;
      for (std::size_t j = first; j < i; ++j) pair(ends[i].wedge, ends[j].wedge, ends[j].other);
    }
  }

  /// Edges by estimated direction; each with those whose midpoints are nearest.
  void pair_parallel() {
    struct Line {
      std::uint32_t wedge;
      Vertex direction, middle;
    };
    std::vector<Line> lines;
    for (const std::uint32_t w : reflex_) {
      Line line{w, {}, {}};
      double length = 0;
      std::size_t longest = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        const double a = wedges_[w].ends[0].at[i].value, b = wedges_[w].ends[1].at[i].value;
        line.direction[i] = b / 2 - a / 2;
        line.middle[i] = a / 2 + b / 2;
        length = std::max(length, std::abs(line.direction[i]));
      }
      while (std::abs(line.direction[longest]) != length) ++longest;
      const double unit = line.direction[longest];
      for (double& x : line.direction) x /= unit;
      lines.push_back(line);
    }
    for (const Line& line : lines) {
      monitor_.check();
      std::vector<std::pair<double, std::uint32_t>> parallel;
      for (const Line& other : lines) {
        double apart = 0, distance = 0;
        for (std::size_t i = 0; i < 3; ++i) {
          apart = std::max(apart, std::abs(line.direction[i] - other.direction[i]));
          const double d = line.middle[i] - other.middle[i];
          distance += d * d;
        }
        if (other.wedge != line.wedge && apart < nearly) parallel.emplace_back(distance, other.wedge);
      }
      const std::size_t count = std::min(parallel.size(), nearest_parallel);
      std::partial_sort(parallel.begin(), parallel.begin() + static_cast<std::ptrdiff_t>(count), parallel.end());
      for (std::size_t i = 0; i < count; ++i) {
        const Wedge &of_line = wedges_[line.wedge], &other = wedges_[parallel[i].second];
        if (mesh_planes_.are_parallel(of_line.vertices, other.vertices))
          pair(line.wedge, parallel[i].second, other.vertices[0]);
      }
    }
  }

  const Monitor& monitor_;
  bsp::MeshPlanes& mesh_planes_;
  std::span<const bsp::Facet<3>> facets_;
  std::span<const Wedge> wedges_;
  std::vector<std::vector<std::uint32_t>> through_;
  std::vector<std::uint32_t> reflex_;
};

}  // namespace

std::vector<std::vector<std::uint32_t>> cut_planes(bsp::MeshPlanes& mesh_planes, std::span<const bsp::Facet<3>> facets,
                                                   std::span<const Wedge> wedges, const Monitor& monitor) {
  return CutPlanes(mesh_planes, facets, wedges, monitor).all();
}

}  // namespace strata::convex
