#include "core/round/flatten.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <utility>

#include "core/containers/collect.h"
#include "core/containers/huge_pages.h"
#include "core/round/distances.h"
#include "core/round/pile_filling.h"
#include "core/round/viewed_plane.h"

namespace strata {
namespace {

using Index = std::uint32_t;

/// Faces near one plane.
struct Pile {
  ViewedPlane plane;
  std::vector<Index> faces;
  Range heights;  ///< above the plane

  [[nodiscard]] double thickness() const { return std::nextafter(heights.upper - heights.lower, Box::infinity); }
};

/// Finds piles among some faces, which are connected by some pairs and at common vertices: there, each with those whose
/// numbers are next to its own among the faces of the vertex.
class Piles {
 public:
  Piles(const MovingMesh& mesh, const std::vector<Index>& faces, const std::vector<std::pair<Index, Index>>& pairs)
      : mesh_(mesh) {
    for (const Index f : faces)
      if (mesh.is_left(f)) faces_.push_back(f);
    connect(pairs);
  }

  /// The pile about the plane of a face, without faces of the list `taken`, to which its faces are added.
  [[nodiscard]] Pile pile_of(Index face, const ViewedPlane& plane, double reach, std::vector<bool>& taken) const {
    Pile pile{plane, {}, {}};
    const auto seed = number(face);
    if (!seed) return pile;
    std::vector<std::size_t> waiting{*seed};
    taken[face] = true;
    while (!waiting.empty()) {
      const std::size_t n = waiting.back();
      waiting.pop_back();
      Range heights;
      for (const Index v : mesh_.mesh().triangles[faces_[n]]) heights.include(plane.height(point(v)));
      if (!(std::max(-heights.lower, heights.upper) <= reach)) {
        far_.push_back(faces_[n]);
        continue;
      }
      pile.heights.include(heights);
      pile.faces.push_back(faces_[n]);
      for (const std::size_t m : neighbours_[n]) {
        if (taken[faces_[m]]) continue;
        taken[faces_[m]] = true;
        waiting.push_back(m);
      }
    }
    for (const Index f : far_) taken[f] = false;
    far_.clear();
    std::sort(pile.faces.begin(), pile.faces.end());
    return pile;
  }

 private:
  [[nodiscard]] const Vertex& point(Index v) const { return mesh_.mesh().vertices[v]; }

  [[nodiscard]] std::optional<std::size_t> number(Index face) const {
    const auto found = std::lower_bound(faces_.begin(), faces_.end(), face);
    if (found == faces_.end() || *found != face) return {};
    return static_cast<std::size_t>(found - faces_.begin());
  }
  void connect(const std::vector<std::pair<Index, Index>>& pairs) {
    neighbours_.resize(faces_.size());
    std::vector<std::pair<Index, std::size_t>> corners;
    for (std::size_t n = 0; n < faces_.size(); ++n)
      for (const Index v : mesh_.mesh().triangles[faces_[n]]) corners.emplace_back(v, n);
    std::sort(corners.begin(), corners.end());
    for (std::size_t i = 1; i < corners.size(); ++i)
      if (corners[i - 1].first == corners[i].first) connect(corners[i - 1].second, corners[i].second);
    for (const auto& [f, g] : pairs)
      if (const auto a = number(f), b = number(g); a && b) connect(*a, *b);
  }
  void connect(std::size_t a, std::size_t b) {
    neighbours_[a].push_back(b);
    neighbours_[b].push_back(a);
  }

  const MovingMesh& mesh_;
  std::vector<Index> faces_;
  std::vector<std::vector<std::size_t>> neighbours_;
  mutable std::vector<Index> far_;
};

/// A face about whose plane a pile is looked for.
struct Seed {
  Index face;
  ViewedPlane plane;
  double reach;
};

/// Of some faces, those that may be of a pile about one of the planes, and all that have a vertex of these: what
/// decides on piles, and on how they are connected. All of them where there are many planes.
std::vector<Index> faces_about(MeshView mesh, const std::vector<Index>& faces, std::span<const Seed> seeds) {
  constexpr std::size_t many = 32;
  if (seeds.size() > many) return faces;
  const auto is_near = [&](const Triangle& t, const Seed& seed) {
    return std::all_of(t.begin(), t.end(),
                       [&](Index v) { return seed.plane.may_be_within(mesh.vertices[v], seed.reach); });
  };
  std::vector<char> has_near_face;  // per vertex
  resize_fresh(has_near_face, mesh.vertices.size());
  tbb::parallel_for(std::size_t{0}, faces.size(), [&](std::size_t n) {
    const Triangle& t = mesh.triangles[faces[n]];
    if (std::any_of(seeds.begin(), seeds.end(), [&](const Seed& seed) { return is_near(t, seed); }))
      for (const Index v : t) std::atomic_ref(has_near_face[v]).store(1, std::memory_order_relaxed);
  });
  std::vector<Index> about = collect(faces.size(), [&](std::uint32_t n) {
    const auto [a, b, c] = mesh.triangles[faces[n]];
    return (has_near_face[a] | has_near_face[b] | has_near_face[c]) != 0;
  });
  for (Index& n : about) n = faces[n];
  return about;
}

/// Wrong faces with an area, the largest first.
std::vector<Seed> seeds_of(const MovingMesh& mesh, const std::vector<Index>& wrong, const GridRounding& grid,
                           double reach) {
  std::vector<Seed> seeds;
  for (const Index f : wrong) {
    if (!mesh.is_left(f)) continue;
    const auto& [a, b, c] = mesh.mesh().triangles[f];
    const std::span<const Vertex> points = mesh.mesh().vertices;
    const ViewedPlane plane(points[a], points[b], points[c]);
    if (plane.is_valid()) seeds.push_back({f, plane, reach * grid.unit_at(size(plane.corner()))});
  }
  std::stable_sort(seeds.begin(), seeds.end(),
                   [](const Seed& a, const Seed& b) { return a.plane.has_more_area_than(b.plane); });
  return seeds;
}

/// Vertices that are to be joined, of several piles: no vertex goes to one that goes elsewhere.
class Joins {
 public:
  /// False if these do not go with those before.
  [[nodiscard]] bool can_add(const std::vector<VertexMove>& moves) const {
    return std::none_of(moves.begin(), moves.end(), [&](const VertexMove& m) {
      return becomes_.contains(m.vertex) || stays_.contains(m.vertex) || becomes_.contains(m.becomes);
    });
  }
  void add(const std::vector<VertexMove>& moves) {
    for (const VertexMove& m : moves) {
      becomes_.emplace(m.vertex, m);
      stays_.insert(m.becomes);
    }
  }
  /// By increasing vertex.
  [[nodiscard]] std::vector<VertexMove> moves() const {
    std::vector<VertexMove> moves;
    for (const auto& [vertex, move] : becomes_) moves.push_back(move);
    return moves;
  }

 private:
  std::map<Index, VertexMove> becomes_;
  std::set<Index> stays_;
};

}  // namespace

bool flatten(MovingMesh& mesh, const ChangedRegion& region, const std::vector<Index>& wrong, const GridRounding& grid,
             double reach, bool may_divide_all) {
  const std::vector<Seed> seeds = seeds_of(mesh, wrong, grid, reach);
  const std::vector<Index> about = faces_about(mesh.mesh(), region.faces(), seeds);
  struct Attempt {
    const std::vector<Index>& among;
    std::size_t growth;  ///< how many triangles there may be for each face if the boundary is divided
  };
  std::vector<Attempt> attempts{{wrong, 0}, {about, 0}, {wrong, 2}};
  if (may_divide_all) attempts.push_back({about, 1});
  bool is_changed = false;
  for (const auto& [among, growth] : attempts) {
    Joins joins;
    const Piles piles(mesh, among, region.wrong_pairs());
    std::vector<bool> taken(mesh.mesh().triangles.size(), false);
    for (const Seed& seed : seeds) {
      if (taken[seed.face] || !mesh.is_left(seed.face)) continue;
      const Pile pile = piles.pile_of(seed.face, seed.plane, seed.reach, taken);
      const auto filling = filling_of(mesh.mesh(), pile.faces, pile.plane, grid, growth * pile.faces.size());
      if (!filling || !joins.can_add(filling->joined)) continue;
      joins.add(filling->joined);
      double rounding = 0;  // of the place that is seen, of the height there, and to the grid: half a unit each
      for (const Vertex& v : filling->added) {
        (void)mesh.add_vertex(v);
        rounding = std::max(rounding, 2 * grid.unit_at(size(v)));
      }
      mesh.replace(pile.faces, filling->triangles, pile.thickness() + rounding);
      is_changed = true;
    }
    mesh.move(joins.moves());
  }
  return is_changed;
}

}  // namespace strata
