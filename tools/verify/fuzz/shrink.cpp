#include "verify/fuzz/shrink.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "strata/rational.h"
#include "support/transform.h"

namespace fuzz {
namespace {

using strata::ExactMesh;
using strata::Rational;
using strata::RationalPoint;
using strata::Triangle;
using Fails = std::function<bool(const Question&)>;

std::vector<RationalPoint> points_of(const ExactMesh& mesh) {
  std::vector<RationalPoint> points;
  for (std::uint32_t v = 0; v < mesh.mesh.vertices.size(); ++v) points.push_back(mesh.position(v));
  return points;
}

/// A mesh of these triangles, without points that none of them has.
ExactMesh without_idle_points(const std::vector<RationalPoint>& points, std::vector<Triangle> triangles) {
  std::map<std::uint32_t, std::uint32_t> numbers;
  std::vector<RationalPoint> used;
  for (Triangle& t : triangles)
    for (std::uint32_t& v : t) {
      const auto [place, fresh] = numbers.try_emplace(v, static_cast<std::uint32_t>(used.size()));
      if (fresh) used.push_back(points[v]);
      v = place->second;
    }
  return strata::test::exact_mesh(used, triangles);
}

/// The triangles by connected parts.
std::vector<std::vector<Triangle>> parts_of(const strata::Mesh& mesh) {
  std::vector<std::uint32_t> parent(mesh.vertices.size());
  std::iota(parent.begin(), parent.end(), 0U);
  const auto root = [&](std::uint32_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (const Triangle& t : mesh.triangles)
    for (const std::uint32_t v : t) parent[root(v)] = root(t[0]);
  std::map<std::uint32_t, std::vector<Triangle>> parts;
  for (const Triangle& t : mesh.triangles) parts[root(t[0])].push_back(t);
  std::vector<std::vector<Triangle>> list;
  for (auto& [first, triangles] : parts) list.push_back(std::move(triangles));
  return list;
}

/// The mesh with one vertex moved into another: triangles that have both are gone, and so are pairs that look opposite
/// ways. Closed if the mesh was.
ExactMesh collapsed(const ExactMesh& mesh, std::uint32_t from, std::uint32_t to) {
  std::map<Triangle, int> count;
  for (Triangle t : mesh.mesh.triangles) {
    std::replace(t.begin(), t.end(), from, to);
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    const Triangle turned{t[0], t[2], t[1]};
    if (const auto other = count.find(turned); other != count.end() && other->second > 0) {
      --other->second;
    } else {
      ++count[t];
    }
  }
  std::vector<Triangle> triangles;
  for (const auto& [t, n] : count) triangles.insert(triangles.end(), static_cast<std::size_t>(n), t);
  return without_idle_points(points_of(mesh), std::move(triangles));
}

/// Tries a solid in place of another.
bool replace_solid(Question& q, std::size_t n, ExactMesh solid, const Fails& fails) {
  if (solid.mesh.triangles.empty()) return false;
  Question candidate = q;
  candidate.recipe.solids[n] = std::move(solid);
  if (!fails(candidate)) return false;
  q = std::move(candidate);
  return true;
}

bool keep_one_part(Question& q, std::size_t n, const Fails& fails) {
  const ExactMesh mesh = q.recipe.solids[n];
  const auto parts = parts_of(mesh.mesh);
  if (parts.size() < 2) return false;
  return std::any_of(parts.begin(), parts.end(), [&](const auto& part) {
    return replace_solid(q, n, without_idle_points(points_of(mesh), part), fails);
  });
}

bool collapse_an_edge(Question& q, std::size_t n, const Fails& fails) {
  const ExactMesh mesh = q.recipe.solids[n];
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const Triangle& t : mesh.mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) edges.emplace(t[i], t[(i + 1) % 3]);
  return std::any_of(edges.begin(), edges.end(), [&](const auto& edge) {
    return replace_solid(q, n, collapsed(mesh, edge.first, edge.second), fails);
  });
}

void simplify_solids(Question& q, const Fails& fails) {
  for (std::size_t n = 0; n < q.recipe.solids.size(); ++n) {
    while (keep_one_part(q, n, fails)) continue;
    while (collapse_an_edge(q, n, fails)) continue;
  }
}

/// New values of coordinates, by axis. What is not listed stays.
using NewValues = std::array<std::map<Rational, Rational>, 3>;

std::array<std::set<Rational>, 3> values_of(const Question& q) {
  std::array<std::set<Rational>, 3> values;
  for (const ExactMesh& solid : q.recipe.solids)
    for (const RationalPoint& p : points_of(solid))
      for (std::size_t k = 0; k < 3; ++k) values[k].insert(p[k]);
  return values;
}

bool replace_values(Question& q, const NewValues& values, const Fails& fails) {
  Question candidate = q;
  for (ExactMesh& solid : candidate.recipe.solids) {
    auto points = points_of(solid);
    for (RationalPoint& p : points)
      for (std::size_t k = 0; k < 3; ++k)
        if (const auto place = values[k].find(p[k]); place != values[k].end()) p[k] = place->second;
    solid = strata::test::exact_mesh(points, solid.mesh.triangles);
  }
  if (!fails(candidate)) return false;
  q = std::move(candidate);
  return true;
}

/// Every value becomes its rank: 0, 1, 2, ...
std::map<Rational, Rational> ranks(const std::set<Rational>& values) {
  std::map<Rational, Rational> result;
  for (const Rational& x : values) result.emplace(x, static_cast<std::int64_t>(result.size()));
  return result;
}

Rational nearest_integer(const Rational& x) {
  const Rational shifted = x + Rational(1, 2);
  strata::Integer floor = numerator(shifted) / denominator(shifted);
  if (shifted < 0 && Rational(floor) != shifted) --floor;
  return floor;
}

/// All axes by their ranks; else an axis; else single values to integers.
void round_coordinates(Question& q, const Fails& fails) {
  const auto all = values_of(q);
  if (replace_values(q, {ranks(all[0]), ranks(all[1]), ranks(all[2])}, fails)) return;
  for (std::size_t k = 0; k < 3; ++k) {
    NewValues values;
    values[k] = ranks(all[k]);
    if (replace_values(q, values, fails)) continue;
    for (const Rational& x : all[k]) {
      const Rational y = nearest_integer(x);
      if (y == x) continue;
      NewValues one;
      one[k].emplace(x, y);
      replace_values(q, one, fails);
    }
  }
}

void simplify_recipe(Question& q, const Fails& fails) {
  const std::string kind = q.kind;
  q.recipe = strata::test::shrunken(std::move(q.recipe), [&](const auto& recipe) { return fails({recipe, kind}); });
}

}  // namespace

Question shrunken(Question question, const Fails& fails) {
  simplify_recipe(question, fails);
  simplify_solids(question, fails);
  simplify_recipe(question, fails);
  round_coordinates(question, fails);
  simplify_solids(question, fails);
  return question;
}

}  // namespace fuzz
