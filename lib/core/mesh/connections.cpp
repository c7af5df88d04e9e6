#include "core/mesh/connections.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_invoke.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "core/exact/pace.h"
#include "core/kernel/disjoint_sets.h"
#include "core/kernel/input_complex.h"
#include "core/kernel/predicates.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/equal_vertices.h"
#include "core/mesh/vertex_stars.h"

namespace strata {
namespace {

using Index = std::uint32_t;

/// A use of an edge at the vertex whose star is visited.
struct Spoke {
  Index other;     ///< the vertex at the other end
  Index member;    ///< of the star
  Index opposite;  ///< the third vertex of the triangle
  bool leaves;     ///< the triangle's side starts at the vertex
};

/// Two triangles of one facet, with an edge in common.
using FlatPair = std::pair<Index, Index>;

/// Looks at the stars of some vertices: counts what each adds, each edge at its lower vertex.
class StarCensus {
 public:
  StarCensus(const VertexStars& stars, std::span<const Triangle> triangles, const InputComplex* flat,
             const Monitor& monitor)
      : stars_(stars), triangles_(triangles), flat_(flat), monitor_(monitor) {}
  StarCensus(StarCensus& other, tbb::split) : StarCensus(other.stars_, other.triangles_, other.flat_, other.monitor_) {}

  void operator()(const tbb::blocked_range<Index>& range) {
    monitor_.check();
    for (Index v = range.begin(); v != range.end(); ++v)
      if (!stars_.at(v).empty()) visit(v);
  }
  void join(const StarCensus& other) {
    vertices += other.vertices;
    edges += other.edges;
    non_manifold_edges += other.non_manifold_edges;
    non_manifold_vertices += other.non_manifold_vertices;
    open_edges += other.open_edges;
    flat_pairs.insert(flat_pairs.end(), other.flat_pairs.begin(), other.flat_pairs.end());
  }

  std::uint64_t vertices = 0, edges = 0, non_manifold_edges = 0, non_manifold_vertices = 0, open_edges = 0;
  std::vector<FlatPair> flat_pairs;

 private:
  void visit(Index v) {
    const std::span<const Index> star = stars_.at(v);
    ++vertices;
    list_spokes(v, star);
    if (!visit_closed(v, star)) visit_any(v, star);
  }

  /// Small stars in which every edge has two triangles, which run against each other: triangle m is followed, around
  /// the vertex, by the one that leaves where m comes in. Returns false, with nothing counted, for other stars.
  bool visit_closed(Index v, std::span<const Index> star) {
    constexpr Index most = 8;
    const auto degree = static_cast<Index>(star.size());
    if (degree > most) return false;
    std::array<Index, most> following{};
    for (Index m = 0; m < degree; ++m) {
      Index followers = 0, followed = 0;
      for (Index j = 0; j < degree; ++j) {
        followed += coming(j).other == leaving(m).other;
        if (leaving(j).other != coming(m).other) continue;
        ++followers;
        following[m] = j;
      }
      if (followers != 1 || followed != 1) return false;
    }
    std::array<bool, most> seen{};
    Index fans = 0;
    for (Index first = 0; first < degree; ++first) {
      fans += !seen[first];
      for (Index m = first; !seen[m]; m = following[m]) seen[m] = true;
    }
    non_manifold_vertices += fans > 1;
    for (Index m = 0; m < degree; ++m)
      if (v < coming(m).other) {
        ++edges;
        if (flat_ != nullptr) add_if_flat(v, star, leaving(following[m]), coming(m));
      }
    return true;
  }
  [[nodiscard]] const Spoke& leaving(Index member) const { return spokes_[2 * member]; }
  [[nodiscard]] const Spoke& coming(Index member) const { return spokes_[2 * member + 1]; }

  void visit_any(Index v, std::span<const Index> star) {
    std::sort(spokes_.begin(), spokes_.end(), [](const Spoke& a, const Spoke& b) { return a.other < b.other; });
    fans_.assign(star.size());
    for (std::size_t begin = 0, end = 0; begin < spokes_.size(); begin = end) {
      while (end < spokes_.size() && spokes_[end].other == spokes_[begin].other) ++end;
      const auto uses = std::span<const Spoke>(spokes_).subspan(begin, end - begin);
      if (uses.size() == 2) fans_.unite(uses[0].member, uses[1].member);
      if (v < uses[0].other) visit_edge(v, star, uses);
    }
    non_manifold_vertices += fans_.count() > 1;
  }

  /// Two for each triangle: that of the side that leaves the vertex, and that of the side that comes in.
  void list_spokes(Index v, std::span<const Index> star) {
    spokes_.clear();
    for (Index m = 0; m < star.size(); ++m) {
      const Triangle& t = triangles_[star[m]];
      const std::size_t corner = t[0] == v ? 0 : t[1] == v ? 1 : 2;
      const Index next = t[(corner + 1) % 3], last = t[(corner + 2) % 3];
      spokes_.push_back({next, m, last, true});
      spokes_.push_back({last, m, next, false});
    }
  }

  void visit_edge(Index v, std::span<const Index> star, std::span<const Spoke> uses) {
    const auto leaving = std::count_if(uses.begin(), uses.end(), [](const Spoke& s) { return s.leaves; });
    ++edges;
    non_manifold_edges += uses.size() > 2;
    open_edges += 2 * static_cast<std::size_t>(leaving) != uses.size();
    if (flat_ == nullptr) return;
    for (const Spoke& a : uses)
      for (const Spoke& b : uses)
        if (a.leaves && !b.leaves) add_if_flat(v, star, a, b);
  }

  void add_if_flat(Index v, std::span<const Index> star, const Spoke& a, const Spoke& b) {
    if (are_one_facet(v, star[a.member], a, star[b.member], b)) flat_pairs.emplace_back(star[a.member], star[b.member]);
  }

  [[nodiscard]] bool are_one_facet(Index v, Index f, const Spoke& a, Index g, const Spoke& b) const {
    return orient3d(*flat_, v, a.other, a.opposite, b.opposite) == Sign::zero &&
           same_orientation(*flat_, f, g) == Sign::positive;
  }

  /// Sets of a star's members.
  class Fans {
   public:
    void assign(std::size_t count) {
      parent_.resize(count);
      for (Index i = 0; i < count; ++i) parent_[i] = i;
      count_ = count;
    }
    void unite(Index a, Index b) {
      a = find(a);
      b = find(b);
      count_ -= a != b;
      parent_[a] = b;
    }
    [[nodiscard]] std::size_t count() const { return count_; }

   private:
    Index find(Index x) {
      while (parent_[x] != x) x = parent_[x] = parent_[parent_[x]];
      return x;
    }
    std::vector<Index> parent_;
    std::size_t count_ = 0;
  };

  const VertexStars& stars_;
  std::span<const Triangle> triangles_;
  const InputComplex* flat_;  ///< the mesh, if facets are counted
  const Monitor& monitor_;
  std::vector<Spoke> spokes_;
  Fans fans_;
};

/// Used vertices minus components.
std::uint64_t spanning_edges(std::span<const Triangle> triangles, std::size_t vertex_count, const Monitor& monitor) {
  DisjointSets<Index> connected(vertex_count);
  std::uint64_t count = 0;
  Pace pace(monitor);
  for (const Triangle& t : triangles) {
    pace.step();
    if (repeats_vertex(t)) continue;
    count += connected.unite(t[0], t[1]);
    count += connected.unite(t[0], t[2]);
  }
  return count;
}

/// Of triangles on the first of their equal vertices. Facets are counted where there is a complex.
Connections connections(std::span<const Triangle> triangles, std::size_t vertex_count, const InputComplex* complex,
                        const Monitor& monitor) {
  const auto proper = static_cast<std::uint64_t>(
      std::count_if(triangles.begin(), triangles.end(), [](const Triangle& t) { return !repeats_vertex(t); }));
  const VertexStars stars(triangles, vertex_count, monitor);
  StarCensus census(stars, triangles, complex, monitor);
  std::uint64_t spanning = 0;
  tbb::parallel_invoke(
      [&] { tbb::parallel_reduce(tbb::blocked_range<Index>(0, static_cast<Index>(vertex_count), 1 << 12), census); },
      [&] { spanning = spanning_edges(triangles, vertex_count, monitor); });
  Connections result;
  result.topology = {census.vertices - spanning,
                     static_cast<std::int64_t>(census.vertices + proper) - static_cast<std::int64_t>(census.edges),
                     census.non_manifold_edges, census.non_manifold_vertices, census.open_edges};
  if (complex != nullptr) {
    DisjointSets<Index> connected(triangles.size());
    result.facets = proper;
    for (const auto& [f, g] : census.flat_pairs) result.facets -= connected.unite(f, g);
  }
  return result;
}

}  // namespace

Connections connections(ExactMeshView mesh, Facets facets, const Monitor& monitor) {
  const std::vector<Triangle> triangles = on_first_vertices(mesh, monitor);
  InputComplex complex;
  if (facets == Facets::count) complex.add(mesh.mesh.vertices, triangles, mesh.exact);
  return connections(triangles, mesh.mesh.vertices.size(), facets == Facets::count ? &complex : nullptr, monitor);
}

Topology topology_of(const NearestMesh& mesh) {
  return connections(on_first_vertices(mesh), mesh.mesh.vertices.size(), nullptr, {}).topology;
}

Topology topology(const ExactMesh& mesh) { return connections(mesh, Facets::skip).topology; }

}  // namespace strata
