#include "core/mesh/connections.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_invoke.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/exact/pace.h"
#include "core/exact/vector.h"
#include "core/kernel/disjoint_sets.h"
#include "core/kernel/input_complex.h"
#include "core/kernel/predicates.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/equal_vertices.h"
#include "core/mesh/lattice_sum.h"
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

/// A triangle at the vertex whose star is visited: its sides run from the vertex to `next`, and from `last` to it.
struct Corner {
  Index triangle, next, last;
};

/// Two triangles of one facet, with an edge in common.
using FlatPair = std::pair<Index, Index>;

/// A triangle at an edge, and its third vertex.
struct Wing {
  Index triangle, tip;
};

/// Which triangles with a common edge are of one facet: a filter in doubles for edges that are bent, and what decides
/// about the others.
class Flatness {
 public:
  /// Are two triangles of one facet? `a` has the side from v to w, `b` that from w to v.
  using Decide = FunctionRef<bool(Index v, Index w, const Wing& a, const Wing& b)>;

  /// `points`: the vertices, or their nearest doubles where `are_rounded`. These and `decide` must stay.
  Flatness(std::span<const Vertex> points, bool are_rounded, Decide decide) : points_(points), decide_(decide) {
    if (are_rounded) error_ = largest_coordinate(points_) * 0x1p-52 + 0x1p-1074;
  }

  [[nodiscard]] bool are_flat(Index v, Index w, const Wing& a, const Wing& b) const { return decide_(v, w, a, b); }

  /// For an inner vertex and the others around it, in order: which edges to these are certain to be bent? A bit each.
  ///
  /// The edge is bent unless the determinant of three differences is 0. These are off by half a unit in the last place,
  /// and by `error_` where vertices are rational. If no component is above L, the determinant is off by at most
  /// 6 L^3 times 8 units (theory.md of the kernel, "Filters") and by 18 (L + error_)^2 error_.
  [[nodiscard]] std::uint32_t bent_edges(Index center, std::span<const Corner> ring) const {
    std::array<Vertex, most_corners> spokes;
    double largest = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      spokes[i] = minus(points_[ring[i].next], points_[center]);
      for (const double x : spokes[i]) largest = std::max(largest, std::abs(x));
    }
    constexpr double too_large = 0x1p+300;
    if (!(largest < too_large)) return 0;
    const double reach = largest + error_;
    const double bound = largest * largest * largest * (48 * 0x1p-53) + reach * reach * error_ * 20 + 0x1p-1000;
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vertex &before = spokes[i == 0 ? ring.size() - 1 : i - 1],
                   &after = spokes[i + 1 == ring.size() ? 0 : i + 1];
      bits |= static_cast<std::uint32_t>(std::abs(dot(spokes[i], cross(before, after))) > bound) << i;
    }
    return bits;
  }

  static constexpr std::size_t most_corners = 12;  ///< of bent_edges

 private:
  std::span<const Vertex> points_;
  Decide decide_;
  double error_ = 0;  ///< of a difference of two coordinates
};

/// Looks at the stars of some vertices: counts what each adds, each edge at its lower vertex.
class StarCensus {
 public:
  StarCensus(const VertexStars& stars, std::span<const Triangle> triangles, const Flatness* flatness,
             const Monitor& monitor)
      : stars_(stars), triangles_(triangles), flatness_(flatness), monitor_(monitor) {}
  StarCensus(StarCensus& other, tbb::split)
      : StarCensus(other.stars_, other.triangles_, other.flatness_, other.monitor_) {}

  void operator()(const tbb::blocked_range<Index>& range) {
    monitor_.check();
    for (Index v = range.begin(); v != range.end(); ++v) {
      if (v + ahead < stars_.vertex_count()) fetch(stars_.at(v + ahead));
      if (!stars_.at(v).empty()) visit(v, stars_.at(v));
    }
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
  static constexpr Index ahead = 8;  ///< so many vertices before a star is visited its triangles are fetched

  void fetch(std::span<const Index> star) const {
    for (const Index t : star) __builtin_prefetch(&triangles_[t]);
  }

  void visit(Index v, std::span<const Index> star) {
    ++vertices;
    if (!visit_inner(v, star)) visit_any(v, star);
  }

  /// Small stars that are one closed fan: each triangle is followed by the only one whose `next` is its `last`. Returns
  /// false, with nothing counted, for others.
  bool visit_inner(Index v, std::span<const Index> star) {
    const std::size_t degree = star.size();
    if (degree > Flatness::most_corners) return false;
    std::array<Corner, Flatness::most_corners> corners;
    std::array<Index, Flatness::most_corners> nexts;
    nexts.fill(std::numeric_limits<Index>::max());
    for (std::size_t i = 0; i < degree; ++i) {
      corners[i] = corner_of(star[i], v);
      nexts[i] = corners[i].next;
    }
    std::array<std::uint8_t, Flatness::most_corners> following;
    Index lower = 0;
    for (std::size_t i = 0; i < degree; ++i) {
      const std::uint32_t places = places_of(corners[i].last, nexts);
      if (places == 0 || (places & (places - 1)) != 0) return false;  // none, or several
      following[i] = static_cast<std::uint8_t>(std::countr_zero(places));
      lower += v < corners[i].next;
    }
    std::array<Corner, Flatness::most_corners> ring;
    std::size_t at = 0, length = 0;
    do {
      ring[length++] = corners[at];
      at = following[at];
    } while (at != 0 && length != degree);
    if (at != 0 || length != degree) return false;
    edges += lower;
    if (flatness_ != nullptr) list_flat_pairs(v, std::span(ring).first(degree));
    return true;
  }

  /// A bit for each place of the vertex in the list.
  static std::uint32_t places_of(Index vertex, const std::array<Index, Flatness::most_corners>& list) {
    using FourVertices [[gnu::vector_size(16)]] = Index;
    using FourBits [[gnu::vector_size(16)]] = std::int32_t;
    std::array<FourVertices, 3> fours;
    static_assert(sizeof fours == sizeof list);
    std::memcpy(&fours, &list, sizeof fours);
    const FourBits bits = ((fours[0] == vertex) & FourBits{1, 2, 4, 8}) |
                          ((fours[1] == vertex) & FourBits{16, 32, 64, 128}) |
                          ((fours[2] == vertex) & FourBits{256, 512, 1024, 2048});
    return static_cast<std::uint32_t>((bits[0] | bits[1]) | (bits[2] | bits[3]));
  }

  void list_flat_pairs(Index v, std::span<const Corner> ring) {
    const std::uint32_t bent = flatness_->bent_edges(v, ring);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      if (v > ring[i].next || (bent >> i & 1u) != 0) continue;
      const Corner &after = ring[i], &before = ring[i == 0 ? ring.size() - 1 : i - 1];
      add_if_flat(v, after.next, {after.triangle, after.last}, {before.triangle, before.next});
    }
  }

  [[nodiscard]] Corner corner_of(Index triangle, Index v) const {
    static constexpr std::array<std::uint8_t, 5> cyclic{0, 1, 2, 0, 1};
    const Triangle& t = triangles_[triangle];
    const std::size_t at = static_cast<std::size_t>(t[1] == v) + 2 * static_cast<std::size_t>(t[2] == v);  // no branch
    return {triangle, t[cyclic[at + 1]], t[cyclic[at + 2]]};
  }

  void visit_any(Index v, std::span<const Index> star) {
    list_spokes(v, star);
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
      const Corner c = corner_of(star[m], v);
      spokes_.push_back({c.next, m, c.last, true});
      spokes_.push_back({c.last, m, c.next, false});
    }
  }

  void visit_edge(Index v, std::span<const Index> star, std::span<const Spoke> uses) {
    const auto leaving = std::count_if(uses.begin(), uses.end(), [](const Spoke& s) { return s.leaves; });
    ++edges;
    non_manifold_edges += uses.size() > 2;
    open_edges += 2 * static_cast<std::size_t>(leaving) != uses.size();
    if (flatness_ == nullptr) return;
    for (const Spoke& a : uses)
      for (const Spoke& b : uses)
        if (a.leaves && !b.leaves) add_if_flat(v, a.other, {star[a.member], a.opposite}, {star[b.member], b.opposite});
  }

  void add_if_flat(Index v, Index w, const Wing& a, const Wing& b) {
    if (flatness_->are_flat(v, w, a, b)) flat_pairs.emplace_back(a.triangle, b.triangle);
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
  const Flatness* flatness_;  ///< if facets are counted
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

/// Of triangles on the first of their equal vertices. Facets are counted where flatness is given.
Connections connections(std::span<const Triangle> triangles, std::size_t vertex_count, const Flatness* flatness,
                        const Monitor& monitor) {
  const VertexStars stars(triangles, vertex_count, monitor);
  StarCensus census(stars, triangles, flatness, monitor);
  std::uint64_t spanning = 0;
  tbb::parallel_invoke(
      [&] { tbb::parallel_reduce(tbb::blocked_range<Index>(0, static_cast<Index>(vertex_count), 1 << 12), census); },
      [&] { spanning = spanning_edges(triangles, vertex_count, monitor); });
  const std::uint64_t proper = stars.triangle_count();
  Connections result;
  result.topology = {census.vertices - spanning,
                     static_cast<std::int64_t>(census.vertices + proper) - static_cast<std::int64_t>(census.edges),
                     census.non_manifold_edges, census.non_manifold_vertices, census.open_edges};
  if (flatness == nullptr) return result;
  result.facets = proper;
  if (census.flat_pairs.empty()) return result;
  DisjointSets<Index> connected(triangles.size());
  for (const auto& [f, g] : census.flat_pairs) result.facets -= connected.unite(f, g);
  return result;
}

}  // namespace

Connections connections(ExactMeshView mesh, Facets facets, const Monitor& monitor) {
  const OnFirstVertices welded(mesh, monitor);
  const std::size_t vertices = mesh.mesh.vertices.size();
  if (facets == Facets::skip) return connections(welded.triangles(), vertices, nullptr, monitor);
  InputComplex complex;
  complex.add(mesh.mesh.vertices, welded.triangles(), mesh.exact);
  const auto are_flat = [&](Index v, Index w, const Wing& a, const Wing& b) {
    return orient3d(complex, v, w, a.tip, b.tip) == Sign::zero &&
           same_orientation(complex, a.triangle, b.triangle) == Sign::positive;
  };
  const Flatness flatness(mesh.mesh.vertices, !mesh.exact.empty(), are_flat);
  return connections(welded.triangles(), vertices, &flatness, monitor);
}

Connections connections(const NearestMesh& mesh, FunctionRef<bool(Index, Index)> are_coplanar, const Monitor& monitor) {
  const OnFirstVertices welded(mesh);
  const auto are_flat = [&](Index, Index, const Wing& a, const Wing& b) {
    return are_coplanar(a.triangle, b.triangle);
  };
  const Flatness flatness(mesh.mesh.vertices, !mesh.rounded.empty(), are_flat);
  return connections(welded.triangles(), mesh.mesh.vertices.size(), &flatness, monitor);
}

Topology topology_of(const NearestMesh& mesh) {
  return connections(OnFirstVertices(mesh).triangles(), mesh.mesh.vertices.size(), nullptr, {}).topology;
}

Topology topology(const ExactMesh& mesh) { return connections(mesh, Facets::skip).topology; }

}  // namespace strata
