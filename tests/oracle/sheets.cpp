#include "oracle/sheets.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

namespace strata::oracle {
namespace {

/// The boundary with equal points made one vertex.
struct Welded {
  std::vector<RationalPoint> points;
  std::vector<Triangle> triangles;
};

Welded weld(const ExactMesh& mesh) {
  Welded welded;
  std::map<RationalPoint, std::uint32_t> numbers;
  std::vector<std::uint32_t> renamed;
  for (std::uint32_t v = 0; v < mesh.mesh.vertices.size(); ++v) {
    const auto [place, fresh] = numbers.try_emplace(mesh.position(v), static_cast<std::uint32_t>(welded.points.size()));
    if (fresh) welded.points.push_back(place->first);
    renamed.push_back(place->second);
  }
  for (const Triangle& t : mesh.mesh.triangles) {
    welded.triangles.push_back({renamed[t[0]], renamed[t[1]], renamed[t[2]]});
  }
  return welded;
}

/// Six times the signed volume of the tetrahedron o, a, b, c.
Rational six_volumes(const RationalPoint& o, const RationalPoint& a, const RationalPoint& b, const RationalPoint& c) {
  std::array<RationalPoint, 3> r{a, b, c};
  for (RationalPoint& p : r) {
    for (int k = 0; k < 3; ++k) p[k] -= o[k];
  }
  return r[0][0] * (r[1][1] * r[2][2] - r[1][2] * r[2][1]) + r[0][1] * (r[1][2] * r[2][0] - r[1][0] * r[2][2]) +
         r[0][2] * (r[1][0] * r[2][1] - r[1][1] * r[2][0]);
}

void orient_outwards(Sheet& sheet) {
  Rational sum = 0;
  for (const Triangle& t : sheet.triangles) {
    sum += six_volumes(sheet.points[0], sheet.points[t[0]], sheet.points[t[1]], sheet.points[t[2]]);
  }
  if (sum < 0) {
    for (Triangle& t : sheet.triangles) std::swap(t[1], t[2]);
  }
}

std::size_t root(std::vector<std::size_t>& parent, std::size_t i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

void join(std::vector<std::size_t>& parent, std::size_t a, std::size_t b) { parent[root(parent, a)] = root(parent, b); }

using EdgeSides = std::map<std::pair<std::uint32_t, std::uint32_t>, std::array<std::vector<std::size_t>, 2>>;

/// For every undirected edge the triangles that run along it upwards and downwards.
EdgeSides edge_sides(const std::vector<Triangle>& triangles) {
  EdgeSides sides;
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t a = triangles[f][i];
      const std::uint32_t b = triangles[f][(i + 1) % 3];
      sides[{std::min(a, b), std::max(a, b)}][a < b ? 0 : 1].push_back(f);
    }
  }
  return sides;
}

/// Corners (triangle, position) that are one vertex of a sheet once the triangles of every edge are paired.
struct Paired {
  std::vector<std::size_t> corner_class;
  std::vector<std::size_t> triangle_class;
};

std::size_t corner_of(const std::vector<Triangle>& triangles, std::size_t f, std::uint32_t vertex) {
  const auto& t = triangles[f];
  return 3 * f + static_cast<std::size_t>(std::find(t.begin(), t.end(), vertex) - t.begin());
}

/// Pairs the k-th upward triangle of every edge with the (k + shift)-th downward one.
std::optional<Paired> pair_triangles(const std::vector<Triangle>& triangles, const EdgeSides& sides,
                                     std::size_t shift) {
  Paired paired;
  paired.corner_class.resize(3 * triangles.size());
  paired.triangle_class.resize(triangles.size());
  std::iota(paired.corner_class.begin(), paired.corner_class.end(), 0);
  std::iota(paired.triangle_class.begin(), paired.triangle_class.end(), 0);
  for (const auto& [edge, side] : sides) {
    const auto& [up, down] = side;
    if (up.size() != down.size()) return std::nullopt;
    for (std::size_t k = 0; k < up.size(); ++k) {
      const std::size_t other = down[(k + shift) % down.size()];
      join(paired.triangle_class, up[k], other);
      for (const std::uint32_t v : {edge.first, edge.second}) {
        join(paired.corner_class, corner_of(triangles, up[k], v), corner_of(triangles, other, v));
      }
    }
  }
  return paired;
}

/// True when some edge lies in more than two triangles.
bool repeats_edge(const Sheet& sheet) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> directed;
  for (const auto& [a, b, c] : sheet.triangles) {
    for (const auto& edge : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
      if (!directed.insert(edge).second) return true;
    }
  }
  return false;
}

/// The sheet of the triangles in one class; nothing when two of its vertices or edges are at one place.
std::optional<Sheet> collect(const Welded& welded, Paired& paired, std::size_t triangle_class) {
  Sheet sheet;
  std::map<std::uint32_t, std::pair<std::size_t, std::uint32_t>> known;  // point -> corner class, number
  for (std::size_t f = 0; f < welded.triangles.size(); ++f) {
    if (root(paired.triangle_class, f) != triangle_class) continue;
    Triangle t{};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t point = welded.triangles[f][i];
      const std::size_t corner = root(paired.corner_class, 3 * f + i);
      const auto number = static_cast<std::uint32_t>(sheet.points.size());
      const auto [place, fresh] = known.try_emplace(point, corner, number);
      if (fresh) sheet.points.push_back(welded.points[point]);
      if (place->second.first != corner) return std::nullopt;
      t[i] = place->second.second;
    }
    sheet.triangles.push_back(t);
  }
  if (repeats_edge(sheet)) return std::nullopt;
  orient_outwards(sheet);
  return sheet;
}

std::optional<std::vector<Sheet>> sheets_of_pairing(const Welded& welded, Paired& paired) {
  std::vector<Sheet> sheets;
  for (std::size_t f = 0; f < welded.triangles.size(); ++f) {
    if (root(paired.triangle_class, f) != f) continue;
    auto sheet = collect(welded, paired, f);
    if (!sheet) return std::nullopt;
    sheets.push_back(std::move(*sheet));
  }
  return sheets;
}

}  // namespace

std::optional<std::vector<Sheet>> manifold_sheets(const ExactMesh& mesh) {
  const Welded welded = weld(mesh);
  const EdgeSides sides = edge_sides(welded.triangles);
  for (std::size_t shift = 0; shift < 2; ++shift) {
    auto paired = pair_triangles(welded.triangles, sides, shift);
    if (!paired) return std::nullopt;
    if (auto sheets = sheets_of_pairing(welded, *paired)) return sheets;
  }
  return std::nullopt;
}

std::vector<Sheet> tetrahedra_over_faces(const ExactMesh& mesh) {
  const Welded welded = weld(mesh);
  std::vector<std::size_t> uses(welded.points.size(), 0);
  for (const Triangle& t : welded.triangles) {
    for (const std::uint32_t v : t) ++uses[v];
  }
  const auto apex = std::max_element(uses.begin(), uses.end()) - uses.begin();
  std::vector<Sheet> sheets;
  for (const Triangle& t : welded.triangles) {
    Sheet sheet{{welded.points[apex], welded.points[t[0]], welded.points[t[1]], welded.points[t[2]]},
                {{1, 2, 3}, {0, 2, 1}, {0, 3, 2}, {0, 1, 3}}};
    if (six_volumes(sheet.points[0], sheet.points[1], sheet.points[2], sheet.points[3]) == 0) continue;
    orient_outwards(sheet);
    sheets.push_back(std::move(sheet));
  }
  return sheets;
}

}  // namespace strata::oracle
