#include <algorithm>
#include <catch2/catch.hpp>
#include <sstream>

#include "corpus/corpus.h"
#include "support/transform.h"

namespace strata::test {
namespace {

/// "x y z ; x y z ; ..." as exact points, sorted.
std::vector<RationalPoint> points_of(const std::string& text) {
  std::vector<RationalPoint> points;
  std::istringstream words(text);
  for (std::string x, y, z, semicolon; words >> x >> y >> z; words >> semicolon) {
    points.push_back({*exact_number(x), *exact_number(y), *exact_number(z)});
  }
  std::sort(points.begin(), points.end());
  return points;
}

std::string vertices_of_row(const std::filesystem::path& table, const std::string& file) {
  for (const Row& row : read_csv(table)) {
    if (row.at("file").ends_with(file)) return row.at("exact_vertices_hx/hw hy/hw hz/hw");
  }
  return {};
}

}  // namespace

// Catches: intersection points that are rounded, and vertices lost where octahedra touch edge on edge.
TEST_CASE("octahedron xor octahedron shifted by (3,4,5)/9 has the 24 rational vertices of the Nef reference",
          "[corpus][octahedra]") {
  const auto root = corpus_or_skip();
  if (!root) return;
  const ExactMesh octahedron = exact(load(*root, "csg/cgal-tests/Nef_3/test/Nef_3/data/octa.off"));
  const RationalPoint by{Rational(3, 9), Rational(4, 9), Rational(5, 9)};
  const Solid result = Solid(octahedron) ^ Solid(translated(octahedron, by));
  const auto expected =
      points_of(vertices_of_row(*root / "expected/cgal_nef3_reference_files.csv", "octa_ref.nef3.SH"));
  REQUIRE(expected.size() == 24);
  CHECK(result.canonical().vertices == expected);
}

}  // namespace strata::test
