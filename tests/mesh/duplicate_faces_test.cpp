#include <algorithm>
#include <catch2/catch.hpp>
#include <random>
#include <utility>
#include <vector>

#include "core/mesh/edge_table.h"
#include "core/mesh/prepare.h"

using namespace strata;

namespace {

Triangle with_lowest_first(Triangle t) {
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

/// Neighbours among all triangles in their order.
std::vector<std::vector<std::uint32_t>> by_comparison(const Mesh& mesh) {
  std::vector<std::pair<Triangle, std::uint32_t>> sorted;
  for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f)
    if (!repeats_vertex(mesh.triangles[f])) sorted.emplace_back(with_lowest_first(mesh.triangles[f]), f);
  std::sort(sorted.begin(), sorted.end());
  std::vector<std::vector<std::uint32_t>> pairs;
  for (std::size_t i = 1; i < sorted.size(); ++i)
    if (sorted[i].first == sorted[i - 1].first) pairs.push_back({sorted[i - 1].second, sorted[i].second});
  return pairs;
}

}  // namespace

TEST_CASE("faces that repeat others are found, in the order of their vertices", "[mesh][property]") {
  std::mt19937 random(1);
  for (int round = 0; round < 300; ++round) {
    const std::uint32_t vertices = 3 + random() % 9;
    Mesh mesh;
    for (std::uint32_t v = 0; v < vertices; ++v)
      mesh.vertices.push_back({double(v), double(v * v % 7), double(v * v * v % 11)});
    for (std::uint32_t f = random() % 60; f-- > 0;) {
      Triangle t;
      for (std::uint32_t& v : t) v = random() % vertices;
      mesh.triangles.push_back(t);
    }
    // A closed chain, so that equal vertices are not made one: each triangle and its reverse.
    for (std::size_t f = mesh.triangles.size(); f-- > 0;) {
      const auto [a, b, c] = mesh.triangles[f];
      mesh.triangles.push_back({a, c, b});
    }
    std::vector<std::vector<std::uint32_t>> found;
    for (const Defect& d : diagnose(mesh, 1000))
      if (d.kind == DefectKind::duplicate_face) found.push_back(d.faces);
    REQUIRE(found == by_comparison(mesh));
  }
}
