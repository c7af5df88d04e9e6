#include <catch2/catch.hpp>
#include <cmath>

#include "core/kernel/input_complex.h"
#include "extensions/scene/pieces.h"
#include "extensions/scene/signed_covering.h"
#include "scene/scenes.h"
#include "strata/errors.h"
#include "strata/query.h"

using namespace strata;

namespace {

/// The defect of the second of two solids, the first of which is none.
Defect defect_of(const Mesh& broken) {
  try {
    static_cast<void>(test::scene_of({test::box({0, 0, 0}, {1, 1, 1}), broken}));
  } catch (const InputError& e) {
    CHECK(e.operand() == 1);
    REQUIRE(e.defects().size() == 1);
    return e.defects()[0];
  }
  FAIL("a scene was made of it");
  return {};
}

}  // namespace

TEST_CASE("a scene refuses what is no solid and says which and where", "[layers]") {
  Mesh mesh = test::box({2, 0, 0}, {3, 1, 1});
  mesh.vertices[3][1] = NAN;
  CHECK(defect_of(mesh).kind == DefectKind::non_finite_coordinate);

  mesh = test::box({2, 0, 0}, {3, 1, 1});
  mesh.triangles[5][2] = 8;
  CHECK(defect_of(mesh).kind == DefectKind::index_out_of_range);
  CHECK(defect_of(mesh).faces == std::vector<std::uint32_t>{5});

  mesh = test::box({2, 0, 0}, {3, 1, 1});
  for (const std::uint32_t f : {9u, 4u, 7u}) mesh.triangles.insert(mesh.triangles.begin() + f, {0, 0, 1});
  CHECK(defect_of(mesh).kind == DefectKind::degenerate_triangle);
  CHECK(defect_of(mesh).faces == std::vector<std::uint32_t>{4});
}
