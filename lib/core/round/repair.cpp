#include "core/round/repair.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "core/containers/point_hash.h"
#include "core/round/distances.h"
#include "core/round/flip_caps.h"

namespace strata {
namespace {

using Index = std::uint32_t;

/// Vertices that are where one with a lower number is, by increasing number, and that one.
using PlacesInCommon = std::vector<std::pair<Index, Index>>;

/// The first of the vertices in one place.
Index first_in_place(const PlacesInCommon& equal, Index vertex) {
  const auto found = std::lower_bound(equal.begin(), equal.end(), std::pair(vertex, Index{0}));
  return found != equal.end() && found->first == vertex ? found->second : vertex;
}

/// The vertices of some faces, equal ones once, by increasing number.
std::vector<Index> vertices_of(const MovingMesh& mesh, std::span<const Index> faces, const PlacesInCommon& equal) {
  std::vector<Index> vertices;
  for (const Index f : faces)
    for (const Index v : mesh.mesh().triangles[f]) vertices.push_back(first_in_place(equal, v));
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

/// Vertices that stay, in cells by their places. Each is near those that come later and are within its reach.
class Staying {
 public:
  Staying(std::span<const Vertex> points, const GridRounding& grid, double reach)
      : points_(points), grid_(grid), reach_(reach) {}

  /// The lowest number of a vertex that stays and has this one in its reach.
  [[nodiscard]] std::optional<Index> near(const Vertex& p) const {
    std::optional<Index> lowest;
    const auto [low, high] = exponents(p);
    for (int e = low; e <= high; ++e)
      for_each_cell(p, e, [&](const Cell& cell) {
        const auto found = cells_.find(cell);
        if (found == cells_.end()) return;
        for (const Index v : found->second)
          if ((!lowest || v < *lowest) && distance(points_[v], p) <= reach_of(points_[v])) lowest = v;
      });
    return lowest;
  }
  void add(Index v) {
    const int e = exponent(reach_of(points_[v]));
    lowest_exponent_ = std::min(lowest_exponent_, e);
    highest_exponent_ = std::max(highest_exponent_, e);
    cells_[cell_at(points_[v], e)].push_back(v);
  }

 private:
  /// Places in cells of 2^(exponent + 3), four times as wide at least as the reach of their vertices.
  struct Cell {
    int exponent = 0;
    Vertex place{};
    friend bool operator==(const Cell&, const Cell&) = default;
  };
  struct CellHash {
    std::size_t operator()(const Cell& c) const { return hash_of(c.place) + static_cast<std::size_t>(c.exponent); }
  };

  [[nodiscard]] double reach_of(const Vertex& p) const {
    return std::min(reach_ * grid_.unit_at(size(p)), std::numeric_limits<double>::max());
  }
  static int exponent(double reach) { return std::ilogb(reach); }
  /// Of vertices that may have p in their reach. Where this is short, they are about as large as p.
  [[nodiscard]] std::pair<int, int> exponents(const Vertex& p) const {
    constexpr double short_reach = 0x1p20;
    if (reach_ > short_reach) return {lowest_exponent_, highest_exponent_};
    return {std::max(lowest_exponent_, exponent(reach_ * grid_.unit_at(size(p) / 2))),
            std::min(highest_exponent_, exponent(reach_ * grid_.unit_at(size(p) + 2 * reach_of(p))))};
  }
  static double cell_of(double x, int e) { return std::floor(std::ldexp(x, -(e + 3))); }
  static Cell cell_at(const Vertex& p, int e) { return {e, {cell_of(p[0], e), cell_of(p[1], e), cell_of(p[2], e)}}; }
  /// Those of places that p is in the reach of, at most two in each direction.
  template <class Visit>
  static void for_each_cell(const Vertex& p, int e, const Visit& visit) {
    const double reach = std::ldexp(1.0, e + 1);
    const std::array<Vertex, 2> ends{cell_at({p[0] - reach, p[1] - reach, p[2] - reach}, e).place,
                                     cell_at({p[0] + reach, p[1] + reach, p[2] + reach}, e).place};
    const auto count = [&](std::size_t i) { return ends[0][i] == ends[1][i] ? 1U : 2U; };
    for (unsigned x = 0; x < count(0); ++x)
      for (unsigned y = 0; y < count(1); ++y)
        for (unsigned z = 0; z < count(2); ++z) visit(Cell{e, {ends[x][0], ends[y][1], ends[z][2]}});
  }

  std::span<const Vertex> points_;
  const GridRounding& grid_;
  double reach_;
  int lowest_exponent_ = std::numeric_limits<int>::max(), highest_exponent_ = std::numeric_limits<int>::min();
  std::unordered_map<Cell, std::vector<Index>, CellHash> cells_;
};

/// Vertices of wrong faces that go to near ones; of those in one place, the first. By increasing number.
std::vector<VertexMove> moves_to_near(const MovingMesh& mesh, std::span<const Index> wrong, const PlacesInCommon& equal,
                                      const GridRounding& grid, double reach) {
  const std::span<const Vertex> points = mesh.mesh().vertices;
  Staying staying(points, grid, reach);
  std::vector<VertexMove> moves;
  for (const Index v : vertices_of(mesh, wrong, equal)) {
    if (const auto stays = staying.near(points[v])) {
      moves.push_back({v, *stays, points[*stays], distance(points[*stays], points[v])});
    } else {
      staying.add(v);
    }
  }
  return moves;
}

/// Vertices in one place become one, and those of wrong faces go to near ones.
bool join_vertices(MovingMesh& mesh, const PlacesInCommon& equal, std::span<const Index> wrong,
                   const GridRounding& grid, double reach) {
  const std::vector<VertexMove> firsts = moves_to_near(mesh, wrong, equal, grid, reach);
  const auto is_before = [](const VertexMove& a, const VertexMove& b) { return a.vertex < b.vertex; };
  std::vector<VertexMove> others;
  others.reserve(equal.size());
  for (const auto& [vertex, first] : equal) {
    const auto move = std::lower_bound(firsts.begin(), firsts.end(), VertexMove{first, first, {}, 0}, is_before);
    others.push_back(move != firsts.end() && move->vertex == first
                         ? VertexMove{vertex, move->becomes, move->to, move->way}
                         : VertexMove{vertex, first, mesh.mesh().vertices[vertex], 0});
  }
  std::vector<VertexMove> moves(firsts.size() + others.size());
  std::merge(firsts.begin(), firsts.end(), others.begin(), others.end(), moves.begin(), is_before);
  mesh.move(moves);
  return !moves.empty();
}

bool cancel_opposite_faces(MovingMesh& mesh) {
  /// A changed face by its vertices, from the lowest on, in the order in which the second is lower than the third.
  struct Named {
    Triangle vertices;
    bool is_reverse = false;
    Index face = 0;
  };
  std::vector<Named> named;
  named.reserve(mesh.changed().size());
  for (const Index f : mesh.changed()) {
    if (!mesh.is_left(f)) continue;
    Triangle t = mesh.mesh().triangles[f];
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    const bool is_reverse = t[1] > t[2];
    if (is_reverse) std::swap(t[1], t[2]);
    named.push_back({t, is_reverse, f});
  }
  std::sort(named.begin(), named.end(), [](const Named& a, const Named& b) {
    return std::tie(a.vertices, a.is_reverse, a.face) < std::tie(b.vertices, b.is_reverse, b.face);
  });
  std::vector<std::pair<Index, Index>> opposites;
  for (std::size_t begin = 0, end = 0; begin < named.size(); begin = end) {
    std::size_t reverse = begin;  // the first of those that are reversed
    for (; end < named.size() && named[end].vertices == named[begin].vertices; ++end) reverse += !named[end].is_reverse;
    for (std::size_t i = 0; i < std::min(reverse - begin, end - reverse); ++i)
      opposites.emplace_back(named[begin + i].face, named[reverse + i].face);
  }
  mesh.cancel(opposites);
  return !opposites.empty();
}

}  // namespace

bool repair(MovingMesh& mesh, const ChangedRegion& region, const std::vector<std::uint32_t>& wrong,
            const GridRounding& grid, double reach, Bundles bundles) {
  bool is_changed = join_vertices(mesh, region.equal_vertices(), wrong, grid, reach);
  is_changed |= cancel_opposite_faces(mesh);
  is_changed |= flip_caps(mesh, wrong, grid, reach, bundles);
  return is_changed;
}

}  // namespace strata
