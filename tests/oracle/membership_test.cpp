#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <iostream>

#include "extensions/scene/signed_covering.h"
#include "oracle/side_of_mesh.h"
#include "scene/rational_rays.h"
#include "scene/scenes.h"
#include "strata/io.h"
#include "strata/query.h"

namespace strata::oracle {
namespace {

struct NamedMesh {
  std::string name;
  Mesh mesh;
};

/// Ten solids: those that come with the sources, generated ones, and larger ones where the corpus is at hand.
std::vector<NamedMesh> ten_solids() {
  std::vector<NamedMesh> solids;
  for (const char* file : {"spot.obj", "gear.off", "torus.off", "sphere.off", "bracket.off", "drill.off", "cube.off"})
    solids.push_back({file, read_mesh(std::string(STRATA_DATA_DIR "/") + file).mesh});
  const char* corpus = std::getenv("STRATA_CORPUS");
  if (corpus == nullptr) {
    std::cout << "SKIPPED: membership in solids of the corpus (STRATA_CORPUS is not set)\n";
    solids.push_back({"cells", test::box_with_hole()});
    solids.push_back({"cavity", test::box_with_cavity(2)});
    solids.push_back({"ball", test::icosphere({.1, .2, .3}, 1.5, 5)});
    return solids;
  }
  for (const char* file : {"libigl-tutorial-data/armadillo.obj", "common-3d-test-models/data/rocker-arm.obj",
                           "common-3d-test-models/data/nefertiti.obj"})
    solids.push_back({file, read_mesh(std::string(corpus) + "/meshes/" + file).mesh});
  return solids;
}

struct Bounds {
  Vertex lower, upper;
};

Bounds bounds_of(const Mesh& mesh) {
  Bounds b{mesh.vertices[0], mesh.vertices[0]};
  for (const Vertex& v : mesh.vertices)
    for (std::size_t i = 0; i < 3; ++i) {
      b.lower[i] = std::min(b.lower[i], v[i]);
      b.upper[i] = std::max(b.upper[i], v[i]);
    }
  return b;
}

std::vector<Vertex> random_points(const Bounds& b, std::size_t count, test::Random& random) {
  std::vector<Vertex> points(count);
  for (Vertex& p : points)
    for (std::size_t i = 0; i < 3; ++i) p[i] = b.lower[i] + (b.upper[i] - b.lower[i]) * random.unit();
  return points;
}

void compare(const NamedMesh& solid, const Origin& origin, std::span<const Vertex> points) {
  const std::vector<int> sides = sides_of_mesh(solid.mesh, points);
  const auto check = [&](const auto& structure) {
    std::vector<Where> answers(points.size());
    structure.membership(points, answers);
    std::size_t different = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
      different += static_cast<int>(answers[i]) - 1 != sides[i];  // out, on, in
    CAPTURE(solid.name, points.size());
    REQUIRE(different == 0);
  };
  const Scene scene = test::scene_of({solid.mesh});
  check(SignedCovering(scene, origin));
  check(Locator(scene));
}

}  // namespace

// Catches: faces missing from a list of the index, degenerate rays counted twice or not at all.
TEST_CASE("membership is CGAL's in ten solids, at random and awkward points", "[oracle][membership]") {
  for (const NamedMesh& solid : ten_solids()) {
    test::Random random(solid.mesh.triangles.size());
    const Bounds b = bounds_of(solid.mesh);
    Vertex middle;
    for (std::size_t i = 0; i < 3; ++i) middle[i] = b.lower[i] / 2 + b.upper[i] / 2;
    const Origin inside = Origin::point(middle);
    compare(solid, inside, random_points(b, 100'000, random));
    std::vector<Vertex> awkward;
    for (int n = 0; n < 10'000; ++n) awkward.push_back(test::awkward_point({solid.mesh}, middle, random));
    compare(solid, inside, awkward);
    compare(solid, Origin::point(solid.mesh.vertices[0]), awkward);
    compare(solid, Origin::direction({0, 0, 1}), awkward);
  }
}

// Catches: solids of a scene mixed up.
TEST_CASE("location in a scene of 50 solids is CGAL's for each of them", "[oracle][membership]") {
  test::Random random(50);
  std::vector<Mesh> meshes;
  while (meshes.size() < 50) {
    const Vertex at{random.between(0, 60) / 8.0, random.between(0, 60) / 8.0, random.between(0, 60) / 8.0};
    const double size = random.between(4, 16) / 8.0;
    meshes.push_back(meshes.size() % 3 == 0   ? test::octahedron(at, size)
                     : meshes.size() % 3 == 1 ? test::box(at, {at[0] + size, at[1] + size, at[2] + size})
                                              : test::icosphere(at, size, 2));
  }
  std::vector<Vertex> points = random_points({{-1, -1, -1}, {10, 10, 10}}, 20'000, random);
  for (int n = 0; n < 10'000; ++n) points.push_back(test::awkward_point(meshes, {4, 4, 4}, random));
  const Scene scene = test::scene_of(meshes);
  const auto check = [&](const auto& structure) {
    const std::vector<Location> locations = structure.locate(points);
    for (std::uint32_t s = 0; s < meshes.size(); ++s) {
      const std::vector<int> sides = sides_of_mesh(meshes[s], points);
      std::size_t different = 0;
      for (std::size_t i = 0; i < points.size(); ++i) {
        const auto& contacts = locations[i].contacts;
        const bool on = std::any_of(contacts.begin(), contacts.end(), [&](const Contact& c) { return c.solid == s; });
        different += (on ? 0 : locations[i].windings[s] == 1 ? 1 : -1) != sides[i];
      }
      CAPTURE(s);
      REQUIRE(different == 0);
    }
  };
  check(SignedCovering(scene, Origin::point({4, 4, 4})));
  check(Locator(scene));
}

}  // namespace strata::oracle
