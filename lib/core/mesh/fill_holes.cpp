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
std::vector<MissingEdge> missing_edges(std::span<const Vertex> vertices, const SourcedTriangles& faces) {
  std::vector<MissingEdge> missing;
  for_each_edge(edge_table(faces.triangles, vertices.size()), [&](std::span<const EdgeUse> uses) {
    const std::int64_t net = net_uses(uses);
    for (std::int64_t k = 0; k < std::abs(net); ++k) {
      const EdgeUse& use = uses.front();
      const Index beside = faces.sources[use.triangle];
      missing.push_back(net > 0 ? MissingEdge{use.high, use.low, beside} : MissingEdge{use.low, use.high, beside});
    }
  });
  std::stable_sort(missing.begin(), missing.end(),
                   [](const MissingEdge& a, const MissingEdge& b) { return a.from < b.from; });
  return missing;
}

struct Loop {
  std::vector<Index> vertices;
  Index beside = 0;
};

/// The loops of missing edges, in which no vertex comes twice: three edges or more, since those between two vertices
/// all have one direction. As many edges go out from each vertex as come in.
class Loops {
 public:
  explicit Loops(std::vector<MissingEdge> missing) : missing_(std::move(missing)) {
    for (std::size_t i = 0; i < missing_.size(); ++i)
      if (i == 0 || missing_[i].from != missing_[i - 1].from) next_.emplace(missing_[i].from, i);
  }

  std::vector<Loop> find() {
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
      Loop loop{{}, way[seen->second].beside};
      for (std::size_t i = seen->second; i < way.size(); ++i) {
        loop.vertices.push_back(way[i].from);
        if (way[i].from != at) place.erase(way[i].from);
      }
      way.resize(seen->second);
      loops_.push_back(std::move(loop));
    }
  }

  std::vector<MissingEdge> missing_;
  std::unordered_map<Index, std::size_t> next_;  ///< per vertex, the next edge that goes out and was not taken
  std::vector<Loop> loops_;
};

double twice_area(const Vertex& a, const Vertex& b, const Vertex& c) {
  const double ux = b[0] - a[0], uy = b[1] - a[1], uz = b[2] - a[2];
  const double vx = c[0] - a[0], vy = c[1] - a[1], vz = c[2] - a[2];
  const double x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
  const double area = std::sqrt(x * x + y * y + z * z);
  return std::isfinite(area) ? area : std::numeric_limits<double>::max();
}

/// Fills one loop.
class Filling {
 public:
  Filling(std::span<const Vertex> vertices, std::vector<Index> loop) : vertices_(vertices), loop_(std::move(loop)) {}

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

  /// least[i][j] is the least area that fills the part of the loop from i to j and back.
  void triangulate() {
    const std::size_t n = loop_.size();
    std::vector<double> least(n * n, 0);
    std::vector<Index> middle(n * n, 0);
    for (std::size_t length = 2; length < n; ++length)
      for (std::size_t i = 0; i + length < n; ++i) {
        const std::size_t j = i + length;
        double best = std::numeric_limits<double>::infinity();
        for (std::size_t k = i + 1; k < j; ++k) {
          const double sum = least[i * n + k] + least[k * n + j] + area(loop_[i], loop_[k], loop_[j]);
          if (sum >= best) continue;
          best = sum;
          middle[i * n + j] = static_cast<Index>(k);
        }
        if (best == std::numeric_limits<double>::infinity()) middle[i * n + j] = static_cast<Index>(i + 1);
        least[i * n + j] = best;
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
  std::vector<Index> loop_;
  std::vector<Triangle> triangles_;
};

}  // namespace

std::uint64_t open_uses(std::span<const Vertex> vertices, std::span<const Triangle> triangles) {
  std::uint64_t sum = 0;
  for_each_edge(edge_table(triangles, vertices.size()),
                [&](std::span<const EdgeUse> uses) { sum += static_cast<std::uint64_t>(std::abs(net_uses(uses))); });
  return sum;
}

std::vector<FilledHole> fill_holes(std::span<const Vertex> vertices, SourcedTriangles& faces) {
  std::vector<Loop> loops = Loops(missing_edges(vertices, faces)).find();
  std::vector<std::vector<Triangle>> fillings(loops.size());
  tbb::parallel_for(std::size_t{0}, loops.size(),
                    [&](std::size_t i) { fillings[i] = Filling(vertices, loops[i].vertices).triangles(); });
  std::vector<FilledHole> holes;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const auto first = static_cast<Index>(faces.triangles.size());
    for (const Triangle& t : fillings[i]) faces.add(t, loops[i].beside);
    holes.push_back({std::move(loops[i].vertices), first, loops[i].beside});
  }
  return holes;
}

}  // namespace strata
