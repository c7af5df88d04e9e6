#include "core/round/resolve_in_place.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>
#include <optional>

#include "core/csg/boolean.h"
#include "core/overlap/self_intersections.h"
#include "support/random.h"
#include "support/shapes.h"

using namespace strata;

namespace {

MovingMesh moving(Mesh mesh) {
  std::vector<std::uint32_t> source(mesh.triangles.size());
  std::iota(source.begin(), source.end(), 0U);
  std::vector<double> moved(source.size(), 0);
  return {std::move(mesh), std::move(source), std::move(moved)};
}

double volume(const Mesh& mesh) {
  double sum = 0;
  for (const auto& [i, j, k] : mesh.triangles) {
    const Vertex &a = mesh.vertices[i], &b = mesh.vertices[j], &c = mesh.vertices[k];
    sum += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return sum / 6;
}

/// A cube with a bubble inside, and a small cube before one of its sides.
Mesh cube_with_parts() {
  Mesh mesh = test::cube_grid(12);
  const auto add = [&](Mesh part, bool is_bubble) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), part.vertices.begin(), part.vertices.end());
    for (auto [a, b, c] : part.triangles) {
      if (is_bubble) std::swap(b, c);
      mesh.triangles.push_back({a + first, b + first, c + first});
    }
  };
  add(test::box({5.25, 5.25, 11.125}, {5.5, 5.5, 11.375}), true);
  add(test::box({5.25, 5.25, 12.125}, {5.5, 5.5, 12.375}), false);
  return mesh;
}

/// Resolves it in place where vertices have moved. Returns the number of faces that were known to stay; none if there
/// was nothing to do.
std::optional<std::size_t> check_against_whole(const Mesh& mesh, std::span<const VertexMove> moves) {
  MovingMesh changed = moving(mesh);
  changed.move(moves);
  REQUIRE(changed.swept());
  const Mesh crossed{{changed.mesh().vertices.begin(), changed.mesh().vertices.end()},
                     {changed.mesh().triangles.begin(), changed.mesh().triangles.end()}};
  ChangedRegion region(changed, {});
  const std::vector<std::uint32_t> wrong = region.wrong_faces({});
  if (!region.has_area_everywhere() || !region.equal_vertices().empty()) return std::nullopt;
  const FacePatches patches = region.patches(wrong);
  const GridRounding grid({CoordinateGrid::Format::float64});
  REQUIRE(resolve_in_place(changed, region.wrong_pairs(), patches, grid, {}));
  const Mesh in_place = std::move(changed).take().mesh;

  const BooleanResult whole = resolved(complex_of(crossed), Inside::winding, {});
  CHECK(in_place.triangles.size() == whole.mesh.triangles.size());
  CHECK(std::abs(volume(in_place) - volume(whole.mesh)) < 1e-9);
  std::size_t known = 0;
  for (const std::uint32_t p : patches.patch) known += patches.is_known[p] ? 1 : 0;
  return known;
}

}  // namespace

TEST_CASE("what crosses is resolved in place as it is as a whole", "[round][property]") {
  const Mesh mesh = cube_with_parts();
  test::Random random(31);
  int resolves = 0, with_known = 0;
  for (int n = 0; n < 60; ++n) {
    std::vector<VertexMove> moves;
    const std::int64_t every = random.between(20, 200);
    for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
      if (!random.once_in(static_cast<int>(every))) continue;
      Vertex to = mesh.vertices[v];
      for (double& x : to) x += random.unit() * 8 - 4;
      moves.push_back({v, v, to, 8});
    }
    const auto known = check_against_whole(mesh, moves);
    resolves += known ? 1 : 0;
    with_known += known && *known > 0 ? 1 : 0;
  }
  CHECK(resolves > 40);
  CHECK(with_known > 20);
}

TEST_CASE("parts that a face passed over are taken out", "[round]") {
  const Mesh mesh = cube_with_parts();
  for (const double height : {9.0, 15.0}) {  // over the bubble, or over the small cube
    std::vector<VertexMove> moves;
    for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
      const Vertex& p = mesh.vertices[v];
      if (p[2] == 12 && p[0] >= 4 && p[0] <= 7 && p[1] >= 4 && p[1] <= 7)
        moves.push_back({v, v, {p[0], p[1], height}, 3});
    }
    moves.push_back({0, 0, {mesh.vertices[0][0] + 0.25, mesh.vertices[0][1] + 0.25, mesh.vertices[0][2] + 3}, 3});
    CHECK(check_against_whole(mesh, moves));
  }
}
