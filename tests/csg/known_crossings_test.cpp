#include <catch2/catch.hpp>
#include <random>

#include "core/csg/boolean.h"
#include "core/overlap/self_intersections.h"
#include "support/shapes.h"

using namespace strata;

namespace {

InputComplex complex_of(const Mesh& mesh) {
  InputComplex complex(SelfIntersections::possible);
  complex.add(mesh.vertices, mesh.triangles);
  return complex;
}

Mesh joined(const Mesh& a, const Mesh& b) {
  Mesh all = a;
  const auto first = static_cast<std::uint32_t>(a.vertices.size());
  all.vertices.insert(all.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const auto& [i, j, k] : b.triangles) all.triangles.push_back({i + first, j + first, k + first});
  return all;
}

FacePairs crossings_of(const Mesh& mesh) {
  FacePairs pairs;
  for (const SelfIntersection& s : find_self_intersections(complex_of(mesh), nullptr, Monitor()))
    pairs.emplace_back(s.face, s.other);
  return pairs;
}

/// Two spheres that cross, somewhere.
Mesh crossing_spheres(unsigned seed) {
  std::mt19937 random(seed);
  const auto some = [&] { return std::uniform_real_distribution<>(-1, 1)(random); };
  return joined(test::icosphere({0, 0, 0}, 1, 3), test::icosphere({some(), some(), 1 + some() / 2}, 1, 3));
}

}  // namespace

TEST_CASE("a mesh whose crossings are known is resolved as one in which they are found", "[csg][property]") {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Mesh mesh = crossing_spheres(seed);
    const FacePairs crossings = crossings_of(mesh);
    const BooleanResult found = resolved(complex_of(mesh), Inside::winding, Monitor());
    const BooleanResult known = resolved(complex_of(mesh), Inside::winding, Monitor(), &crossings);
    REQUIRE(known.mesh.vertices == found.mesh.vertices);
    REQUIRE(known.mesh.triangles == found.mesh.triangles);
    REQUIRE(known.sources == found.sources);
    REQUIRE(known.exact.size() == found.exact.size());
    for (std::size_t i = 0; i < known.exact.size(); ++i) REQUIRE(known.exact[i].position == found.exact[i].position);
  }
}

TEST_CASE("crossings that are known are all that count", "[csg]") {
  const Mesh mesh = crossing_spheres(0);
  const FacePairs none;
  const BooleanResult result = resolved(complex_of(mesh), Inside::winding, Monitor(), &none);
  CHECK(result.exact.empty());  // nothing was cut
}
