#include "core/mesh/zero_area.h"

#include <array>
#include <unordered_map>
#include <utility>

#include "core/exact/pace.h"
#include "core/kernel/disjoint_sets.h"
#include "core/mesh/edge_table.h"

// Why the boundary remains closed, and why one pass suffices.
//
// 1. Identifying vertices maps a closed chain to a closed chain. All vertices of zero-area triangles that have equal
//    coordinates are identified. Triangles that now repeat a vertex have no boundary and are dropped.
// 2. Each zero-area triangle left has three different points on a line. Those connected over shared edges, a group,
//    lie on one line, since an edge has positive length. Each edge belongs to one group at most.
// 3. Replace every edge of a group, wherever it occurs, by its path through the vertices of the group that lie
//    strictly inside it, in their order on the line (lexicographic order is monotone there). This maps the boundary
//    of the whole chain, zero, to zero, and the boundary of a zero-area triangle p, q, r with q between to
//    path(p,q) + path(q,r) - path(p,r) = 0. So the paths of the other triangles cancel among themselves: zero-area
//    triangles can be dropped when the others are divided along those paths.
// 4. A triangle of positive area divided at points inside its sides is cut into triangles of positive area: no three
//    points of different sides, and no side point with the opposite corner, are collinear. Two of its sides are never
//    in one group. The cuts are used once in each direction. So no zero-area triangle is left or made.

namespace strata {
namespace {

using Key = std::uint64_t;

Key edge_key(std::uint32_t a, std::uint32_t b) { return Key{std::min(a, b)} << 32 | std::max(a, b); }

/// Identifies the vertices of the given triangles that have equal coordinates, in all triangles.
void identify(std::span<const Vertex> vertices, SourcedTriangles& faces, const std::vector<std::uint32_t>& flat) {
  std::vector<std::uint32_t> used;
  for (const std::uint32_t f : flat) used.insert(used.end(), faces.triangles[f].begin(), faces.triangles[f].end());
  std::sort(used.begin(), used.end(), [&](std::uint32_t a, std::uint32_t b) {
    return vertices[a] != vertices[b] ? vertices[a] < vertices[b] : a < b;
  });
  std::unordered_map<std::uint32_t, std::uint32_t> first_of;
  for (std::size_t i = 1, first = 0; i < used.size(); ++i) {
    if (vertices[used[i]] != vertices[used[first]]) first = i;
    if (used[i] != used[first]) first_of[used[i]] = used[first];
  }
  if (first_of.empty()) return;
  for (Triangle& t : faces.triangles) {
    for (std::uint32_t& v : t) {
      if (const auto found = first_of.find(v); found != first_of.end()) v = found->second;
    }
  }
}

/// The edges of zero-area triangles, each with its group, and the vertices of each group in order along its line.
class Groups {
 public:
  Groups(std::span<const Vertex> vertices, const std::vector<Triangle>& flat) {
    DisjointSets<std::size_t> sets(flat.size());
    for (std::size_t i = 0; i < flat.size(); ++i) {
      for (int k = 0; k < 3; ++k) {
        const auto [entry, is_new] = group_of_.try_emplace(edge_key(flat[i][k], flat[i][(k + 1) % 3]), i);
        if (!is_new) sets.unite(entry->second, i);
      }
    }
    for (auto& [key, triangle] : group_of_) triangle = sets.find(triangle);
    for (std::size_t i = 0; i < flat.size(); ++i) {
      auto& members = members_[sets.find(i)];
      members.insert(members.end(), flat[i].begin(), flat[i].end());
    }
    for (auto& [group, members] : members_) {
      std::sort(members.begin(), members.end(),
                [&](std::uint32_t a, std::uint32_t b) { return vertices[a] < vertices[b]; });
      members.erase(std::unique(members.begin(), members.end()), members.end());
    }
  }

  /// The vertices strictly inside the edge from a to b, in that direction.
  [[nodiscard]] std::vector<std::uint32_t> inside(std::span<const Vertex> vertices, std::uint32_t a,
                                                  std::uint32_t b) const {
    const auto found = group_of_.find(edge_key(a, b));
    if (found == group_of_.end()) return {};
    const auto& members = members_.at(found->second);
    const bool ascending = vertices[a] < vertices[b];
    const std::uint32_t low = ascending ? a : b;
    const std::uint32_t high = ascending ? b : a;
    const auto after = [&](std::uint32_t v, std::uint32_t m) { return vertices[v] < vertices[m]; };
    const auto before = [&](std::uint32_t m, std::uint32_t v) { return vertices[m] < vertices[v]; };
    std::vector<std::uint32_t> result(std::upper_bound(members.begin(), members.end(), low, after),
                                      std::lower_bound(members.begin(), members.end(), high, before));
    if (!ascending) std::reverse(result.begin(), result.end());
    return result;
  }

 private:
  std::unordered_map<Key, std::size_t> group_of_;
  std::unordered_map<std::size_t, std::vector<std::uint32_t>> members_;
};

/// A fan of triangles from an apex over a path.
void fan(std::uint32_t apex, const std::vector<std::uint32_t>& path, std::uint32_t source, SourcedTriangles& out) {
  for (std::size_t i = 0; i + 1 < path.size(); ++i) out.add({apex, path[i], path[i + 1]}, source);
}

using Sides = std::array<std::vector<std::uint32_t>, 3>;

/// Divides a triangle whose side k, from corner k on, contains the vertices inside[k]; inside[0] is not empty. The
/// result is a fan from the corner opposite to side 0, whose first and last triangles are fans themselves over the
/// other two sides.
void divide(const Triangle& t, const Sides& inside, std::uint32_t source, SourcedTriangles& out) {
  const auto [a, b, c] = t;
  const auto path = [](std::uint32_t from, const std::vector<std::uint32_t>& middle, std::uint32_t to) {
    std::vector<std::uint32_t> result{from};
    result.insert(result.end(), middle.begin(), middle.end());
    result.push_back(to);
    return result;
  };
  fan(inside[0].front(), path(c, inside[2], a), source, out);
  fan(c, inside[0], source, out);
  fan(inside[0].back(), path(b, inside[1], c), source, out);
}

/// Adds a triangle of positive area, divided where groups require it. Returns whether it was divided.
bool add_divided(std::span<const Vertex> vertices, const Groups& groups, const Triangle& t, std::uint32_t source,
                 SourcedTriangles& out) {
  Sides inside;
  for (int k = 0; k < 3; ++k) inside[k] = groups.inside(vertices, t[k], t[(k + 1) % 3]);
  for (int k = 0; k < 3; ++k) {
    if (inside[k].empty()) continue;
    const int l = (k + 1) % 3, m = (k + 2) % 3;
    divide({t[k], t[l], t[m]}, {inside[k], inside[l], inside[m]}, source, out);
    return true;
  }
  out.add(t, source);
  return false;
}

}  // namespace

Removal remove_zero_area(std::span<const Vertex> vertices, SourcedTriangles& faces, const Monitor& monitor) {
  std::vector<std::uint32_t> flat;
  const ZeroAreaTest is_zero(MeshView(vertices, faces.triangles));
  Pace pace(monitor);
  for (std::uint32_t f = 0; f < faces.triangles.size(); ++f) {
    pace.step();
    if (is_zero(f)) flat.push_back(f);
  }
  Removal result;
  if (flat.empty()) return result;
  identify(vertices, faces, flat);
  std::vector<Triangle> lines;  // zero-area triangles with three different vertices
  for (const std::uint32_t f : flat) {
    result.removed.push_back(faces.sources[f]);
    if (!repeats_vertex(faces.triangles[f])) lines.push_back(faces.triangles[f]);
  }
  const Groups groups(vertices, lines);
  SourcedTriangles out;
  auto next_flat = flat.begin();
  for (std::uint32_t f = 0; f < faces.triangles.size(); ++f) {
    pace.step();
    if (next_flat != flat.end() && *next_flat == f) {
      ++next_flat;
    } else {
      result.divided += add_divided(vertices, groups, faces.triangles[f], faces.sources[f], out);
    }
  }
  faces = std::move(out);
  return result;
}

}  // namespace strata
