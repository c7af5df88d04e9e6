#include "strata/layers/local_layers.h"

#include <catch2/catch.hpp>

#include "strata/mesh/mesh.h"
#include "support/random.h"
#include "support/shapes.h"

using namespace strata;

TEST_CASE("winding numbers of a scene are those of its boxes", "[layers][property]") {
  test::Random random(2);
  std::vector<Mesh> boxes;
  std::vector<std::array<int, 6>> bounds;
  for (int i = 0; i < 40; ++i) {
    std::array<int, 6> b;
    for (std::size_t k = 0; k < 3; ++k) {
      b[k] = random.between(0, 8);
      b[k + 3] = b[k] + random.between(1, 4);
    }
    bounds.push_back(b);
    boxes.push_back(test::box({double(b[0]), double(b[1]), double(b[2])}, {double(b[3]), double(b[4]), double(b[5])}));
  }
  Carriers carriers;
  for (const Mesh& m : boxes) carriers.add(m.vertices, m.triangles);
  const CellTree cells(carriers, {});
  const LocalLayers layers(carriers, cells);
  constexpr std::uint32_t nobody = 1000;
  for (int n = 0; n < 3'000; ++n) {
    const Carriers::Coordinates q{random.between(-1, 12) + 0.5, random.between(-1, 12) + 0.5, random.between(-1, 12) + 0.5};
    const Windings w = layers.around(Point::free(q), nobody);
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      bool in = true;
      for (std::size_t k = 0; k < 3; ++k) in = in && bounds[i][k] < q[k] && q[k] < bounds[i][k + 3];
      REQUIRE(w[i] == (in ? 1 : 0));
    }
  }
}

TEST_CASE("just above every face of a solid is outside", "[layers][degenerate]") {
  const std::vector<Mesh> solids{test::box_with_hole(), test::box_with_cavity(2), test::octahedron({0, 0, 0}, 2),
                                 test::edge_sharing_cells(), test::l_shape()};
  for (const Mesh& m : solids) {
    Carriers carriers;
    carriers.add(m.vertices, m.triangles);
    const CellTree cells(carriers, {.self = true, .leaf_faces = 4});
    const LocalLayers layers(carriers, cells);
    for (std::uint32_t f = 0; f < carriers.face_count(); ++f)
      REQUIRE(layers.above(f, make_point(carriers, PointName::weighted(f, 1)), {&f, 1})[0] == 0);
  }
}

TEST_CASE("faces that dominate one another in a ring are no obstacle", "[layers][degenerate]") {
  // Three bars around a corner, each over the next: no order by depth exists from (9, 9, 9).
  const std::vector<Mesh> bars{test::box({0, 0, 2}, {6, 1, 3}), test::box({2, 0, 0}, {3, 6, 1}), test::box({0, 2, 0}, {1, 3, 6})};
  Carriers carriers;
  for (const Mesh& m : bars) carriers.add(m.vertices, m.triangles);
  const CellTree cells(carriers, {});
  const LocalLayers layers(carriers, cells);
  CHECK(layers.around(Point::free({5.5, .5, 2.5}), 99)[0] == 1);
  CHECK(layers.around(Point::free({2.5, 5.5, .5}), 99)[1] == 1);
  CHECK(layers.around(Point::free({.5, 2.5, 5.5}), 99)[2] == 1);
  CHECK(layers.around(Point::free({1.5, 1.5, 1.5}), 99) == Windings{});
}
