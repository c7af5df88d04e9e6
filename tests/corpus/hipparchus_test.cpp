#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>
#include <sstream>

#include "corpus/corpus.h"
#include "strata/bsp.h"
#include "strata/check.h"
#include "strata/io.h"
#include "support/random.h"

namespace strata::test {
namespace {

const std::filesystem::path folder =
    "csg/hipparchus/hipparchus-geometry/src/test/resources/org/hipparchus/geometry/euclidean/threed";

std::string text_of(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

bool has(const std::vector<Defect>& defects, DefectKind kind) {
  return std::any_of(defects.begin(), defects.end(), [&](const Defect& d) { return d.kind == kind; });
}

}  // namespace

// Their test of issue 1211: what a ray from inside first meets lies before it.
TEST_CASE("the dumped cube of Hipparchus is met before every ray from its middle, once", "[corpus][bsp]") {
  const auto root = corpus_or_skip();
  if (!root) return;
  const bsp::Partition<3> cube = bsp::read_polyhedrons_set(text_of(*root / folder / "issue-1211.bsp"));
  CHECK(bsp::size(cube) == Rational(8));
  CHECK(bsp::boundary_size(cube) == 24);
  Random random(1211);
  for (int k = 0; k < 1000; ++k) {
    bsp::RationalVector<3> d;
    for (Rational& x : d) x = to_rational(random.unit() - 0.5);
    const std::vector<bsp::Interval> inside = bsp::ray_intersection<3>(cube, {{0, 0, 0}, d});
    REQUIRE(inside.size() == 1);
    REQUIRE(inside[0].upper.has_value());
    CHECK(*inside[0].upper > 0);
    bsp::RationalVector<3> exit;
    for (std::size_t i = 0; i < 3; ++i) exit[i] = *inside[0].upper * d[i];
    CHECK(cube.classify_exact(exit) == Where::on);
  }
}

// They refuse all but the first, the fourth for tolerance alone and the fifth for points nearer than that.
TEST_CASE("the pentominoes of Hipparchus are read, or refused for what is wrong with them", "[corpus][bsp]") {
  const auto root = corpus_or_skip();
  if (!root) return;
  const auto mesh = [&](const char* name) { return read_mesh(*root / folder / name).mesh; };
  const bsp::Partition<3> n = bsp::partition_of(ExactMesh{mesh("pentomino-N.ply"), {}});
  CHECK(bsp::size(n) == Rational(5));
  CHECK(bsp::boundary_size(n) == Approx(22));
  CHECK(has(check(mesh("pentomino-N-hole.ply")), DefectKind::open_edge));
  CHECK(has(check(mesh("pentomino-N-bad-orientation.ply")), DefectKind::inconsistent_orientation));
  const MeshFile bent = read_mesh(*root / folder / "pentomino-N-out-of-plane.ply");
  CHECK_FALSE(bent.notes.empty());  // a face that is not planar is divided, and said to be
  CHECK(bsp::size(bsp::partition_of(ExactMesh{bent.mesh, {}})) == Rational(29, 6));
  CHECK(has(check(mesh("pentomino-N-too-close.ply")), DefectKind::inside_out));
  CHECK_FALSE(bsp::partition_of(ExactMesh{mesh("pentomino-N-too-close.ply"), {}}).is_bounded());
}

}  // namespace strata::test
