#include "core/round/flip_caps.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <utility>

#include "core/round/distances.h"

using namespace strata;

namespace {

constexpr double unit = 0x1p-53;  // between 1/2 and 1

/// The two sides of a strip lower than a unit, each a fan of needles about one of its ends.
Mesh bundle_of_needles(std::uint32_t count, unsigned seed) {
  std::mt19937 random(seed);
  Mesh mesh;
  for (std::uint32_t n = 0; n < count; ++n)
    mesh.vertices.push_back({0.5 + 0.5 * n / count, 0.5 + unit * static_cast<double>(random() % 2), 0.5});
  for (std::uint32_t n = 1; n + 1 < count; ++n) {
    mesh.triangles.push_back({0, n, n + 1});
    mesh.triangles.push_back({count - 1, n, n - 1});
  }
  return mesh;
}

/// No directed edge is left, each against its reverse.
bool is_closed(MeshView mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
  for (const Triangle& t : mesh.triangles) {
    if (repeats_vertex(t)) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = t[i], b = t[(i + 1) % 3];
      sides[std::minmax(a, b)] += a < b ? 1 : -1;
    }
  }
  return std::all_of(sides.begin(), sides.end(), [](const auto& side) { return side.second == 0; });
}

double length_of_sides(MeshView mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) sum += distance(mesh.vertices[t[i]], mesh.vertices[t[(i + 1) % 3]]);
  return sum;
}

struct Flipped {
  bool is_closed = false;
  double length = 0, moved = 0;
};

Flipped flipped(const Mesh& mesh, Bundles bundles) {
  std::vector<std::uint32_t> all(mesh.triangles.size());
  std::iota(all.begin(), all.end(), 0U);
  MovingMesh moving(mesh, all, std::vector<double>(all.size(), 0));
  CHECK(flip_caps(moving, all, GridRounding({CoordinateGrid::Format::float64, 1}), 2, bundles));
  const MovingMesh::Parts parts = std::move(moving).take();
  return {is_closed(parts.mesh), length_of_sides(parts.mesh),
          *std::max_element(parts.moved.begin(), parts.moved.end())};
}

}  // namespace

TEST_CASE("a bundle of needles is put in order by flips that make edges shorter", "[round]") {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const Mesh mesh = bundle_of_needles(100, seed);
    REQUIRE(is_closed(mesh));
    const Flipped as_it_was = flipped(mesh, Bundles::as_they_are);
    const Flipped in_order = flipped(mesh, Bundles::put_in_order);
    INFO("seed " << seed << ": " << length_of_sides(mesh) << " " << as_it_was.length << " " << in_order.length
                 << " units " << in_order.moved / unit);
    CHECK((as_it_was.is_closed && in_order.is_closed));
    CHECK(in_order.length < 0.5 * as_it_was.length);
    CHECK(in_order.moved < 36 * unit);
  }
}
