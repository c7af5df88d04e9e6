#include "core/round/flatten.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include "core/containers/collect.h"
#include "core/containers/huge_pages.h"
#include "core/exact/double_double.h"
#include "core/mesh/planar_chain.h"
#include "core/mesh/planar_levels.h"
#include "core/mesh/planar_points.h"
#include "core/mesh/polygon_sweep.h"
#include "core/round/distances.h"

namespace strata {
namespace {

using Index = std::uint32_t;

/// Numbers between two bounds.
struct Range {
  double lower = 0, upper = 0;

  void include(const Range& other) {
    lower = std::min(lower, other.lower);
    upper = std::max(upper, other.upper);
  }
};

/// A plane through a point, by doubles. The normal's largest component is 1 or -1.
struct ViewedPlane {
  Vertex at{}, normal{};
  std::size_t axis = 0;  ///< of that component: along which the plane is seen
  /// Of the triangle, about; the second is for areas too small for the first, times 2^1200.
  std::pair<double, double> area{};

  ViewedPlane() = default;
  ViewedPlane(const Vertex& a, const Vertex& b, const Vertex& c) : at(a) {
    Vertex u{b[0] - a[0], b[1] - a[1], b[2] - a[2]}, v{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    const double scale = std::max(size(u), size(v));
    if (!(scale > 0) || !std::isfinite(scale)) return;
    for (double& x : u) x /= scale;
    for (double& x : v) x /= scale;
    for (std::size_t i = 0; i < 3; ++i) normal[i] = u[(i + 1) % 3] * v[(i + 2) % 3] - u[(i + 2) % 3] * v[(i + 1) % 3];
    const double largest = size(normal);
    area = area_of(largest, scale);
    if (!(largest > 0)) return;
    for (std::size_t i = 0; i < 3; ++i) {
      normal[i] /= largest;
      if (std::abs(normal[i]) == 1) axis = i;
    }
  }

  /// How far a point is above the plane, along the axis. Products of small numbers underflow, so they are lifted.
  [[nodiscard]] Range height(const Vertex& p) const {
    constexpr double small = 0x1p-800;
    constexpr int lift = 600;
    const bool is_small = std::max(size(at), size(p)) < small;
    const auto lifted = [&](double x) { return DoubleDouble(is_small ? std::ldexp(x, lift) : x); };
    DoubleDouble h;
    for (std::size_t i = 0; i < 3; ++i) h = h + DoubleDouble(normal[i]) * (lifted(p[i]) - lifted(at[i]));
    const Bounded height = h.bounded();
    if (!is_small) return {height.lower(), height.upper()};
    Range range{std::ldexp(height.lower(), -lift), std::ldexp(height.upper(), -lift)};
    if (std::ldexp(range.lower, lift) > height.lower()) range.lower = std::nextafter(range.lower, -Box::infinity);
    if (std::ldexp(range.upper, lift) < height.upper()) range.upper = std::nextafter(range.upper, Box::infinity);
    return range;
  }

  /// False only if the height, either way, is above this. The rounding errors of the sum are below 16 units.
  [[nodiscard]] bool may_be_within(const Vertex& p, double reach) const {
    double h = 0;
    for (std::size_t i = 0; i < 3; ++i) h += normal[i] * (p[i] - at[i]);
    return !(std::abs(h) > reach + (size(p) + size(at)) * 0x1p-49 + 0x1p-1070);
  }

 private:
  static std::pair<double, double> area_of(double of_scaled, double scale) {
    constexpr double smallest = 0x1p-1000;
    if (const double area = of_scaled * scale * scale; area > smallest) return {area, 0};
    const double lifted = std::ldexp(scale, 600);
    return {0, of_scaled * lifted * lifted};
  }
};

/// Faces near one plane.
struct Pile {
  ViewedPlane plane;
  std::vector<Index> faces;
  Range heights;  ///< above the plane

  [[nodiscard]] double thickness() const { return heights.upper - heights.lower; }
};

/// Finds piles among some faces, which are connected by common vertices and by some pairs.
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

bool is_same(const facets::Chain& a, const facets::Chain& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const facets::NetEdge& e, const facets::NetEdge& f) {
    return e.low == f.low && e.high == f.high && e.count == f.count;
  });
}

constexpr Projection axes{0, 1};

/// What a pile is replaced by. Corners are numbers of vertices or, from the count of all vertices on, of new ones.
struct Filling {
  bool is_divided = false;  ///< the boundary has other vertices than before
  std::vector<Triangle> triangles;
  std::vector<Vertex> added;
};

/// A pile as it is seen along the axis of its plane. Its corners are named by their places there.
class View {
 public:
  View(MeshView mesh, const Pile& pile) : mesh_(mesh), plane_(pile.plane) {
    for (const Index f : pile.faces)
      corners_.insert(corners_.end(), mesh.triangles[f].begin(), mesh.triangles[f].end());
    std::sort(corners_.begin(), corners_.end());
    corners_.erase(std::unique(corners_.begin(), corners_.end()), corners_.end());
    std::vector<Vertex> seen;
    for (const Index c : corners_) seen.push_back({mesh.vertices[c][first()], mesh.vertices[c][second()], 0});
    std::vector<Index> names;
    points_.emplace(homogeneous(seen), names);
    vertex_of_name_.resize(points_->size());
    for (std::size_t n = 0; n < corners_.size(); ++n) vertex_of_name_[names[n]] = corners_[n];
    std::vector<facets::Side> sides;
    const auto name = [&](Index v) {
      return names[static_cast<std::size_t>(std::lower_bound(corners_.begin(), corners_.end(), v) - corners_.begin())];
    };
    for (const Index f : pile.faces)
      for (std::size_t k = 0; k < 3; ++k)
        sides.push_back({name(mesh.triangles[f][k]), name(mesh.triangles[f][(k + 1) % 3])});
    boundary_ = facets::net_chain(*points_, sides);
  }

  /// What fills the boundary; none if that would need other vertices, which are made if `may_divide`.
  [[nodiscard]] std::optional<Filling> filling(const GridRounding& grid, bool may_divide) {
    if (points_->size() != corners_.size()) return {};  // two vertices are seen as one
    Filling filling;
    if (boundary_.empty()) return filling;
    facets::Chain divided = facets::cut_at_contacts(*points_, axes, boundary_);
    divided = facets::cut_at_crossings(*points_, axes, divided);
    if (!is_same(divided, boundary_)) {
      constexpr std::size_t most_tests = 1 << 20;
      if (!may_divide || boundary_.size() * points_->size() > most_tests) return {};
      filling.is_divided = true;
      const std::size_t corner_count = vertex_of_name_.size();
      add_vertices(grid, filling.added);
      add_flat_triangles(division_points(corner_count), filling.triangles);
    }
    fill(divided, filling.triangles);
    return filling;
  }

 private:
  [[nodiscard]] std::size_t first() const { return (plane_.axis + 1) % 3; }
  [[nodiscard]] std::size_t second() const { return (plane_.axis + 2) % 3; }

  /// The crossings, on the plane, rounded.
  void add_vertices(const GridRounding& grid, std::vector<Vertex>& added) {
    for (auto n = static_cast<Index>(vertex_of_name_.size()); n < points_->size(); ++n) {
      const HPoint<Integer>& p = (*points_)[n];
      Vertex at{};
      at[first()] = to_nearest_double(Rational(p.x) / Rational(p.w));
      at[second()] = to_nearest_double(Rational(p.y) / Rational(p.w));
      at[plane_.axis] = plane_.at[plane_.axis] - (plane_.normal[first()] * (at[first()] - plane_.at[first()]) +
                                                  plane_.normal[second()] * (at[second()] - plane_.at[second()])) /
                                                     plane_.normal[plane_.axis];
      vertex_of_name_.push_back(static_cast<Index>(mesh_.vertices.size() + added.size()));
      added.push_back(grid(at, 0));
    }
  }

  /// The points at which the boundary is divided, by place, each once: ends of its sides, and where these cross. A
  /// corner inside of the pile may be seen where they cross, and is none.
  [[nodiscard]] std::vector<Index> division_points(std::size_t corner_count) const {
    std::vector<bool> divides(points_->size(), false);
    for (const facets::NetEdge& e : boundary_) divides[e.low] = divides[e.high] = true;
    for (std::size_t n = corner_count; n < divides.size(); ++n) divides[n] = true;
    std::vector<Index> by_place(points_->size());
    for (Index n = 0; n < by_place.size(); ++n) by_place[n] = n;
    std::sort(by_place.begin(), by_place.end(), [&](Index a, Index b) {
      const int order = points_->compare(a, b);
      return order != 0 ? order < 0 : a < b;
    });
    std::vector<Index> found;
    for (std::size_t begin = 0, end = 0; begin < by_place.size(); begin = end) {
      while (end < by_place.size() && points_->compare(by_place[begin], by_place[end]) == 0) ++end;
      const auto lowest =
          std::find_if(by_place.begin() + begin, by_place.begin() + end, [&](Index n) { return divides[n]; });
      if (lowest != by_place.begin() + end) found.push_back(*lowest);
    }
    return found;
  }

  /// Between each side of the boundary and the parts into which others divide it. Seen along the axis, they have no
  /// area.
  void add_flat_triangles(const std::vector<Index>& division, std::vector<Triangle>& triangles) const {
    for (const facets::NetEdge& e : boundary_) {
      std::vector<Index> on;
      for (const Index n : division)
        if (points_->compare(e.low, n) < 0 && points_->compare(n, e.high) < 0 &&
            facets::orientation(*points_, axes, e.low, e.high, n) == 0)
          on.push_back(n);
      on.push_back(e.high);
      for (std::size_t i = 1; i < on.size(); ++i)
        for (std::int64_t k = 0; k < std::abs(e.count); ++k) {
          Triangle t{vertex_of_name_[e.low], vertex_of_name_[on[i]], vertex_of_name_[on[i - 1]]};
          if (e.count < 0) std::swap(t[1], t[2]);
          triangles.push_back(t);
        }
    }
  }

  void fill(const facets::Chain& chain, std::vector<Triangle>& triangles) const {
    std::vector<Index> by_place(points_->size()), rank(points_->size());
    for (Index n = 0; n < by_place.size(); ++n) by_place[n] = n;
    std::sort(by_place.begin(), by_place.end(), [&](Index a, Index b) { return points_->compare(a, b) < 0; });
    for (Index n = 0; n < by_place.size(); ++n) rank[by_place[n]] = n;
    for (const facets::Region& region : facets::covered_regions(*points_, axes, chain)) {
      const bool is_front = region.facing == facets::Facing::front;
      std::vector<PolygonSide> sides;
      for (const facets::Side& s : region.sides)
        sides.push_back(is_front ? PolygonSide{rank[s.from], rank[s.to]} : PolygonSide{rank[s.to], rank[s.from]});
      PolygonSweep sweep(sides, [&](Index a, Index b, Index c) {
        return static_cast<Sign>(facets::orientation(*points_, axes, by_place[a], by_place[b], by_place[c]));
      });
      for (Triangle t : sweep.divide()) {
        for (Index& v : t) v = vertex_of_name_[by_place[v]];
        if (!is_front) std::swap(t[1], t[2]);
        triangles.push_back(t);
      }
    }
  }

  MeshView mesh_;
  const ViewedPlane& plane_;
  std::vector<Index> corners_;  ///< vertices
  std::optional<facets::PointTable> points_;
  std::vector<Index> vertex_of_name_;
  facets::Chain boundary_;
};

std::optional<Filling> filling_of(MeshView mesh, const Pile& pile, const GridRounding& grid, bool may_divide) {
  if (pile.faces.size() < 2) return {};
  try {
    std::optional<Filling> filling = View(mesh, pile).filling(grid, may_divide);
    const std::size_t most = filling && filling->is_divided ? 2 * pile.faces.size() : pile.faces.size() - 1;
    if (filling && filling->triangles.size() > most) return {};
    return filling;
  } catch (const NoRegion&) {
    return {};  // its boundary overlaps itself
  }
}

}  // namespace

bool flatten(MovingMesh& mesh, const ChangedRegion& region, const std::vector<Index>& wrong, const GridRounding& grid,
             double reach) {
  std::vector<Seed> seeds;
  for (const Index f : wrong) {
    const auto& [a, b, c] = mesh.mesh().triangles[f];
    const std::span<const Vertex> points = mesh.mesh().vertices;
    if (!mesh.is_left(f)) continue;
    const ViewedPlane plane(points[a], points[b], points[c]);
    if (plane.area != std::pair(0.0, 0.0)) seeds.push_back({f, plane, reach * grid.unit_at(size(plane.at))});
  }
  std::stable_sort(seeds.begin(), seeds.end(),
                   [](const Seed& a, const Seed& b) { return a.plane.area > b.plane.area; });

  struct Attempt {
    const std::vector<Index>& among;
    bool may_divide;
  };
  const std::vector<Index> about = faces_about(mesh.mesh(), region.faces(), seeds);
  bool is_changed = false;
  for (const auto& [among, may_divide] : {Attempt{wrong, false}, Attempt{about, false}, Attempt{wrong, true}}) {
    const Piles piles(mesh, among, region.wrong_pairs());
    std::vector<bool> taken(mesh.mesh().triangles.size(), false);
    for (const Seed& seed : seeds) {
      if (taken[seed.face] || !mesh.is_left(seed.face)) continue;
      const Pile pile = piles.pile_of(seed.face, seed.plane, seed.reach, taken);
      const auto filling = filling_of(mesh.mesh(), pile, grid, may_divide);
      if (!filling) continue;
      for (const Vertex& v : filling->added) (void)mesh.add_vertex(v);
      const double rounding = filling->added.empty() ? 0 : grid.unit_at(size(seed.plane.at));
      mesh.replace(pile.faces, filling->triangles, pile.thickness() + rounding);
      is_changed = true;
    }
  }
  return is_changed;
}

}  // namespace strata
