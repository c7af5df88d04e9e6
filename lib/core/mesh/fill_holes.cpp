#include "core/mesh/fill_holes.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <set>
#include <unordered_map>
#include <utility>

#include "core/mesh/edge_table.h"

namespace strata {
namespace {

using Index = std::uint32_t;

/// A directed edge that is missing, and a face that has it the other way round.
struct MissingEdge {
  Index from = 0, to = 0, beside = 0;
};

/// By vertex from which they go out, then in the order of edges.
std::vector<MissingEdge> missing_edges(std::span<const Vertex> vertices, const SourcedTriangles& faces,
                                       const Monitor& monitor) {
  std::vector<MissingEdge> missing;
  const auto add_missing = [&](std::span<const EdgeUse> uses) {
    const std::int64_t net = net_uses(uses);
    for (std::int64_t k = 0; k < std::abs(net); ++k) {
      const EdgeUse& use = uses.front();
      const Index beside = faces.sources[use.triangle];
      missing.push_back(net > 0 ? MissingEdge{use.high, use.low, beside} : MissingEdge{use.low, use.high, beside});
    }
  };
  for_each_edge(edge_table(faces.triangles, vertices.size(), monitor), add_missing, monitor);
  std::stable_sort(missing.begin(), missing.end(),
                   [](const MissingEdge& a, const MissingEdge& b) { return a.from < b.from; });
  return missing;
}

/// The loops of missing edges: three edges or more, since those between two vertices all have one direction. As many
/// edges go out from each vertex as come in.
class Loops {
 public:
  explicit Loops(std::vector<MissingEdge> missing) : missing_(std::move(missing)) {
    for (std::size_t i = 0; i < missing_.size(); ++i)
      if (i == 0 || missing_[i].from != missing_[i - 1].from) next_.emplace(missing_[i].from, i);
  }

  std::vector<Hole> find() {
    for (std::size_t first = 0; first < missing_.size(); ++first)
      while (next_[missing_[first].from] <= first && has_next(missing_[first].from)) walk(missing_[first].from);
    return std::move(loops_);
  }

 private:
  [[nodiscard]] bool has_next(Index vertex) {
    const std::size_t i = next_.at(vertex);
    return i < missing_.size() && missing_[i].from == vertex;
  }

  /// Walks from a vertex until it can go no further, which is where it began; each time it comes to a vertex on its
  /// way, what lies between is a loop.
  void walk(Index from) {
    std::vector<MissingEdge> way;
    std::unordered_map<Index, std::size_t> place{{from, 0}};
    for (Index at = from; has_next(at);) {
      way.push_back(missing_[next_.at(at)++]);
      at = way.back().to;
      const auto [seen, is_new] = place.try_emplace(at, way.size());
      if (is_new) continue;
      Hole hole{{}, way[seen->second].beside};
      for (std::size_t i = seen->second; i < way.size(); ++i) {
        hole.loop.push_back(way[i].from);
        if (way[i].from != at) place.erase(way[i].from);
      }
      way.resize(seen->second);
      loops_.push_back(std::move(hole));
    }
  }

  std::vector<MissingEdge> missing_;
  std::unordered_map<Index, std::size_t> next_;  ///< per vertex, the next edge that goes out and was not taken
  std::vector<Hole> loops_;
};

double twice_area(const Vertex& a, const Vertex& b, const Vertex& c) {
  const double ux = b[0] - a[0], uy = b[1] - a[1], uz = b[2] - a[2];
  const double vx = c[0] - a[0], vy = c[1] - a[1], vz = c[2] - a[2];
  const double x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
  const double area = std::sqrt(x * x + y * y + z * z);
  return std::isfinite(area) ? area : std::numeric_limits<double>::max();
}

using Edge = std::pair<Index, Index>;  ///< the lower vertex first

/// The edges of faces that run between vertices of loops, sorted.
std::vector<Edge> edges_between(std::span<const Hole> holes, std::span<const Triangle> triangles,
                                std::size_t vertex_count) {
  std::vector<bool> on_loop(vertex_count, false);
  for (const Hole& hole : holes)
    for (const Index v : hole.loop) on_loop[v] = true;
  std::vector<Edge> edges;
  for (const Triangle& t : triangles)
    for (std::size_t i = 0; i < 3; ++i)
      if (const Index a = t[i], b = t[(i + 1) % 3]; on_loop[a] && on_loop[b]) edges.emplace_back(std::minmax(a, b));
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// What a filling is measured by.
struct Cost {
  std::size_t repeated_edges = 0;  ///< edges within it that are to be avoided
  double area = 0;

  friend Cost operator+(const Cost& a, const Cost& b) { return {a.repeated_edges + b.repeated_edges, a.area + b.area}; }
  friend bool operator<(const Cost& a, const Cost& b) {
    return a.repeated_edges != b.repeated_edges ? a.repeated_edges < b.repeated_edges : a.area < b.area;
  }
};

/// Fills one loop.
class Filling {
 public:
  Filling(std::span<const Vertex> vertices, std::span<const Edge> edges, std::vector<Index> loop)
      : vertices_(vertices), edges_(edges), loop_(std::move(loop)) {}

  std::vector<Triangle> triangles() {
    if (loop_.size() > most_optimal) cut_ears();
    triangulate();
    return std::move(triangles_);
  }

 private:
  [[nodiscard]] double area(Index a, Index b, Index c) const {
    return twice_area(vertices_[a], vertices_[b], vertices_[c]);
  }

  /// Cuts off the corner whose triangle has the least area, again and again.
  void cut_ears() {
    const std::size_t n = loop_.size();
    std::vector<std::size_t> before(n), after(n);
    for (std::size_t i = 0; i < n; ++i) {
      before[i] = (i + n - 1) % n;
      after[i] = (i + 1) % n;
    }
    std::vector<double> of(n);
    std::set<std::pair<double, std::size_t>> ears;
    const auto weigh = [&](std::size_t i) {
      of[i] = area(loop_[before[i]], loop_[i], loop_[after[i]]);
      ears.emplace(of[i], i);
    };
    for (std::size_t i = 0; i < n; ++i) weigh(i);
    while (ears.size() > most_optimal) {
      const std::size_t i = ears.begin()->second, b = before[i], a = after[i];
      ears.erase(ears.begin());
      triangles_.push_back({loop_[b], loop_[i], loop_[a]});
      after[b] = a;
      before[a] = b;
      for (const std::size_t j : {b, a}) {
        ears.erase({of[j], j});
        weigh(j);
      }
    }
    std::vector<Index> rest;
    std::size_t i = ears.begin()->second;
    for (std::size_t k = 0; k < ears.size(); ++k, i = after[i]) rest.push_back(loop_[i]);
    loop_ = std::move(rest);
  }

  /// 1 for an edge to be avoided.
  [[nodiscard]] std::size_t repeats(Index a, Index b) const {
    return std::binary_search(edges_.begin(), edges_.end(), Edge(std::minmax(a, b))) ? 1 : 0;
  }

  /// least[i][j] is the least cost of filling the part of the loop from i to j and back.
  void triangulate() {
    const std::size_t n = loop_.size();
    std::vector<Cost> least(n * n);
    std::vector<Index> middle(n * n, 0);
    for (std::size_t length = 2; length < n; ++length)
      for (std::size_t i = 0; i + length < n; ++i) {
        const std::size_t j = i + length;
        Cost& best = least[i * n + j];
        for (std::size_t k = i + 1; k < j; ++k) {
          const Cost sum = least[i * n + k] + least[k * n + j] + Cost{0, area(loop_[i], loop_[k], loop_[j])};
          if (k != i + 1 && !(sum < best)) continue;
          best = sum;
          middle[i * n + j] = static_cast<Index>(k);
        }
        if (length + 1 < n) best.repeated_edges += repeats(loop_[i], loop_[j]);
      }
    std::vector<std::pair<std::size_t, std::size_t>> parts{{0, n - 1}};
    while (!parts.empty()) {
      const auto [i, j] = parts.back();
      parts.pop_back();
      if (j < i + 2) continue;
      const std::size_t k = middle[i * n + j];
      triangles_.push_back({loop_[i], loop_[k], loop_[j]});
      parts.emplace_back(i, k);
      parts.emplace_back(k, j);
    }
  }

  std::span<const Vertex> vertices_;
  std::span<const Edge> edges_;
  std::vector<Index> loop_;
  std::vector<Triangle> triangles_;
};

}  // namespace

std::uint64_t open_uses(std::span<const Vertex> vertices, std::span<const Triangle> triangles, const Monitor& monitor) {
  std::uint64_t sum = 0;
  const auto add = [&](std::span<const EdgeUse> uses) { sum += static_cast<std::uint64_t>(std::abs(net_uses(uses))); };
  for_each_edge(edge_table(triangles, vertices.size(), monitor), add, monitor);
  return sum;
}

std::vector<Hole> find_holes(std::span<const Vertex> vertices, const SourcedTriangles& faces, const Monitor& monitor) {
  return Loops(missing_edges(vertices, faces, monitor)).find();
}

void fill_holes(std::span<const Vertex> vertices, std::span<const Hole> holes, SourcedTriangles& faces,
                RepeatedEdges repeated_edges, const Monitor& monitor) {
  std::vector<Edge> edges;
  if (repeated_edges == RepeatedEdges::avoided) edges = edges_between(holes, faces.triangles, vertices.size());
  std::vector<std::vector<Triangle>> fillings(holes.size());
  tbb::parallel_for(std::size_t{0}, holes.size(), [&](std::size_t i) {
    monitor.check();
    fillings[i] = Filling(vertices, edges, holes[i].loop).triangles();
  });
  for (std::size_t i = 0; i < holes.size(); ++i)
    for (const Triangle& t : fillings[i]) faces.add(t, holes[i].face_beside);
}

}  // namespace strata
