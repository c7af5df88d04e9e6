// Arrangements of surfaces beside CGAL's Nef polyhedra: the same cells, with the same boundaries, beside the same
// walls.
#include <algorithm>
#include <catch2/catch.hpp>
#include <iostream>
#include <map>
#include <optional>

#include "oracle/comparison.h"
#include "oracle/isolated.h"
#include "oracle/nef.h"
#include "oracle/nef_cells.h"
#include "oracle/random_surfaces.h"
#include "strata/surface.h"
#include "support/mesh_text.h"

namespace strata::oracle {
namespace {

RationalPoint minus(const RationalPoint& a, const RationalPoint& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
RationalPoint cross(const RationalPoint& a, const RationalPoint& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Rational dot(const RationalPoint& a, const RationalPoint& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Twice the area times the unit normal.
RationalPoint area_vector(const ExactFacet& facet) {
  RationalPoint sum{0, 0, 0};
  for (const auto& loop : facet)
    for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
      const RationalPoint twice = cross(minus(loop[i], loop[0]), minus(loop[i + 1], loop[0]));
      for (std::size_t k = 0; k < 3; ++k) sum[k] += twice[k];
    }
  return sum;
}

ExactFacet reversed(ExactFacet facet) {
  for (auto& loop : facet) std::reverse(loop.begin(), loop.end());
  return facet;
}

/// Our walls as facets with a cell on each side.
std::vector<NefFacet> walls_of(const Arrangement& a) {
  std::vector<NefFacet> walls;
  for (std::size_t w = 0; w < a.cells.size(); ++w) {
    const auto& [p, q, r] = a.mesh.mesh.triangles[w];
    walls.push_back({{{a.mesh.position(p), a.mesh.position(q), a.mesh.position(r)}}, a.cells[w][0], a.cells[w][1]});
  }
  return walls;
}

/// What bounds a cell, seen from outside of it. Facets within the cell are left out.
std::vector<ExactFacet> boundary_of(std::uint32_t cell, const std::vector<NefFacet>& facets) {
  std::vector<ExactFacet> boundary;
  for (const NefFacet& f : facets) {
    if (f.in_front == f.behind) continue;
    if (f.behind == cell) boundary.push_back(f.loops);
    if (f.in_front == cell) boundary.push_back(reversed(f.loops));
  }
  return boundary;
}

/// The areas of all facets, projected along each axis: equal if nothing is lost and nothing counted twice.
RationalPoint projected_areas(const std::vector<NefFacet>& facets) {
  RationalPoint sum{0, 0, 0};
  for (const NefFacet& f : facets) {
    const RationalPoint twice = area_vector(f.loops);
    for (std::size_t k = 0; k < 3; ++k) sum[k] += abs(twice[k]);
  }
  return sum;
}

/// True if a point of the facet's plane is within it: it has an odd number of edges to one side.
bool covers(const ExactFacet& facet, const RationalPoint& normal, const RationalPoint& p) {
  const std::size_t left_out = normal[0] != 0 ? 0 : normal[1] != 0 ? 1 : 2;
  const std::size_t u = (left_out + 1) % 3, v = (left_out + 2) % 3;
  bool is_in = false;
  for (const auto& loop : facet)
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const RationalPoint &a = loop[i], &b = loop[(i + 1) % loop.size()];
      if ((a[v] <= p[v]) == (b[v] <= p[v])) continue;
      is_in ^= a[u] + (p[v] - a[v]) / (b[v] - a[v]) * (b[u] - a[u]) > p[u];
    }
  return is_in;
}

/// CGAL's facet that contains the middle of a wall.
class Facets {
 public:
  explicit Facets(const std::vector<NefFacet>& facets) : facets_(facets) {
    for (const NefFacet& f : facets) normals_.push_back(area_vector(f.loops));
  }

  /// The cells in front of a wall and behind it.
  [[nodiscard]] std::optional<std::array<std::uint32_t, 2>> cells_beside(const NefFacet& wall) const {
    const auto& corners = wall.loops.front();
    RationalPoint middle;
    for (std::size_t k = 0; k < 3; ++k) middle[k] = (corners[0][k] + corners[1][k] + corners[2][k]) / 3;
    const RationalPoint normal = area_vector(wall.loops);
    for (std::size_t i = 0; i < facets_.size(); ++i) {
      const NefFacet& f = facets_[i];
      if (cross(normals_[i], normal) != RationalPoint{0, 0, 0}) continue;
      if (dot(normal, minus(f.loops.front().front(), middle)) != 0 || !covers(f.loops, normal, middle)) continue;
      if (dot(normals_[i], normal) > 0) return std::array{f.in_front, f.behind};
      return std::array{f.behind, f.in_front};
    }
    return std::nullopt;
  }

 private:
  const std::vector<NefFacet>& facets_;
  std::vector<RationalPoint> normals_;
};

std::string text(const std::vector<Rational>& list) {
  std::string text;
  for (const Rational& x : list) text += ' ' + x.str();
  return text;
}

/// The volumes of the bounded cells, increasing. Every cell is bounded but number 0.
std::vector<Rational> volumes(std::uint32_t count, const std::vector<NefFacet>& facets) {
  std::vector<Rational> list;
  for (std::uint32_t c = 1; c < count; ++c) list.push_back(facet_volume(boundary_of(c, facets)));
  std::sort(list.begin(), list.end());
  return list;
}

std::vector<Rational> volumes(const std::vector<Solid>& solids) {
  std::vector<Rational> list;
  for (const Solid& s : solids) list.push_back(s.volume());
  std::sort(list.begin(), list.end());
  return list;
}

/// What tells the two apart, or nothing: as many cells, of the same volumes, with the same boundaries; walls of the
/// same areas; and every wall between the same cells, also those that end inside one.
std::string difference(const Arrangement& ours, const std::vector<Solid>& solids, const NefCells& theirs) {
  if (ours.cell_count != theirs.count)
    return "cells: " + std::to_string(ours.cell_count) + ", not " + std::to_string(theirs.count);
  const std::vector<NefFacet> walls = walls_of(ours);
  if (const auto expected = volumes(theirs.count, theirs.facets), found = volumes(solids); found != expected)
    return "volumes:" + text(found) + ", not" + text(expected);
  if (projected_areas(walls) != projected_areas(theirs.facets)) return "areas of walls differ";
  std::map<std::string, std::uint32_t> cell_bounded_by;  // ours
  for (std::uint32_t c = 1; c < ours.cell_count; ++c) cell_bounded_by[solids[c - 1].canonical().text()] = c;
  std::vector<std::uint32_t> our_number(theirs.count, 0);
  for (std::uint32_t c = 1; c < theirs.count; ++c) {
    const auto found = cell_bounded_by.find(canonical_form(boundary_of(c, theirs.facets)).text());
    if (found == cell_bounded_by.end()) return "boundaries of cells differ";
    our_number[c] = found->second;
  }
  const Facets facets(theirs.facets);
  for (std::size_t w = 0; w < walls.size(); ++w) {
    const auto beside = facets.cells_beside(walls[w]);
    if (!beside) return "wall " + std::to_string(w) + " is on no facet";
    if (our_number[(*beside)[0]] != walls[w].in_front || our_number[(*beside)[1]] != walls[w].behind)
      return "wall " + std::to_string(w) + " is between other cells";
  }
  return {};
}

enum class Verdict { equal, different, oracle_failed };

/// Asks CGAL one way; and when it fails or contradicts the engine, the other ways. The engine is wrong only when no way
/// that has an answer has the engine's; CGAL has failed when its ways contradict one another.
Verdict judge(const RandomScene& scene, const Arrangement& ours, const std::vector<Solid>& solids,
              std::string& problem) {
  bool contradicted = false;
  for (const UnionWay way : {UnionWay::surfaces, UnionWay::backwards, UnionWay::polygons}) {
    try {
      const std::string found = in_child([&] { return difference(ours, solids, nef_cells(scene.parts, way)); });
      if (found.empty()) return contradicted ? Verdict::oracle_failed : Verdict::equal;
      contradicted = true;
      problem = found;
    } catch (const OracleFailed& e) {
      std::cout << "oracle: " << e.what() << '\n';
    }
  }
  return contradicted ? Verdict::different : Verdict::oracle_failed;
}

/// How many scenes of each kind there were: that they are what they are meant to be is seen in the output.
struct Sizes {
  std::size_t walls = 0, cells = 0, most_cells = 0, without_cells = 0, dangling = 0, hollow = 0;

  void add(const Arrangement& a, const std::vector<Solid>& solids) {
    for (const Solid& s : solids) hollow += s.without_cavities() == s ? 0 : 1;
    walls += a.cells.size();
    cells += a.cell_count - 1;
    most_cells = std::max<std::size_t>(most_cells, a.cell_count - 1);
    without_cells += a.cell_count == 1 ? 1 : 0;
    dangling += static_cast<std::size_t>(
        std::count_if(a.cells.begin(), a.cells.end(), [](const auto& c) { return c[0] == c[1] && c[0] != 0; }));
  }
};

std::ostream& operator<<(std::ostream& out, const Sizes& s) {
  return out << s.walls << " walls, " << s.dangling << " of them inside cells, " << s.cells << " cells, " << s.hollow
             << " of them with cavities, up to " << s.most_cells << " in one scene, none in " << s.without_cells;
}

void report(const RandomScene& scene, std::uint64_t seed, const std::string& problem) {
  std::string meshes;
  for (const Mesh& mesh : scene.meshes()) meshes += '\n' + test::off_text(mesh);
  FAIL_CHECK("seed " << seed << ": " << problem << meshes);
}

Verdict compare_scene(const RandomScene& scene, std::uint64_t seed, Sizes& sizes) {
  std::vector<Surface> surfaces;
  for (const Mesh& mesh : scene.meshes()) surfaces.emplace_back(mesh);
  std::string problem;
  try {
    const Arrangement ours = arrange(surfaces);
    const std::vector<Solid> solids = cells_of(surfaces);
    sizes.add(ours, solids);
    if (solids.size() + 1 == ours.cell_count) {
      const Verdict verdict = judge(scene, ours, solids, problem);
      if (verdict != Verdict::different) return verdict;
    } else {
      problem = "cells_of and arrange have different numbers of cells";
    }
  } catch (const std::exception& e) {
    problem = std::string("thrown: ") + e.what();
  }
  report(scene, seed, problem);
  return Verdict::different;
}

void compare_scenes(SeedRange range) {
  Tally tally;
  Sizes sizes;
  for (std::uint64_t seed = range.first; seed < range.last; ++seed) {
    const Verdict verdict = compare_scene(RandomScene(seed), seed, sizes);
    if (verdict == Verdict::oracle_failed) std::cout << "oracle failed: scene of seed " << seed << '\n';
    ++(verdict == Verdict::equal ? tally.equal : verdict == Verdict::different ? tally.different : tally.oracle_failed);
  }
  print("arrangements of random surfaces " + std::to_string(range.first) + "-" + std::to_string(range.last), tally);
  std::cout << sizes << '\n';
  CHECK(tally.oracle_failed * 100 <= tally.equal + tally.different + tally.oracle_failed);
}

}  // namespace

// Catches: the two sides of a wall mixed up, cells joined or divided around an edge, a set of walls in the wrong cell,
// walls lost where faces coincide.
TEST_CASE("cells of 1,500 scenes of random surfaces are those of Nef polyhedra", "[oracle][cells]") {
  compare_scenes(seeds({0, 1500}));
}

TEST_CASE("cells of 10,000 more scenes of random surfaces are those of Nef polyhedra", "[oracle][cells][slow]") {
  compare_scenes(seeds({1500, 11500}));
}

}  // namespace strata::oracle
