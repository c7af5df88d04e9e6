#include "core/cells/walk.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "core/cells/cell_tree.h"
#include "strata/mesh.h"
#include "support/random.h"
#include "support/shapes.h"

using namespace strata;

namespace {

int winding(const InputComplex& input, const InputComplex::Coordinates& from, const Point& q) {
  int w = 0;
  for (std::uint32_t f = 0; f < input.face_count(); ++f) w += crossing(input, f, from, q);
  return w;
}

}  // namespace

TEST_CASE("the winding number does not depend on the walk, through vertices and edges as well", "[cells][degenerate]") {
  const Mesh solid = test::box_with_hole();
  InputComplex input;
  input.add(solid.vertices, solid.triangles);
  test::Random random(3);
  for (int n = 0; n < 2'000; ++n) {
    // Origins and targets on a coarse lattice: most walks meet edges, vertices or run within face planes.
    const InputComplex::Coordinates far{-1.0, double(random.between(-1, 4)), double(random.between(-1, 2))};
    const Point q =
        Point::free({random.between(-1, 7) / 2.0, random.between(-1, 7) / 2.0, random.between(-1, 3) / 2.0});
    bool on_surface = false;
    const auto [x, y, z] = std::array{q.at[0].value, q.at[1].value, q.at[2].value};
    const auto in = [](double v, double a, double b) { return a < v && v < b; };
    const auto edge = [](double v, double a, double b) { return v == a || v == b; };
    const bool in_box = in(x, 0, 3) && in(y, 0, 3) && in(z, 0, 1);
    const bool in_hole = in(x, 1, 2) && in(y, 1, 2);
    const bool out = x < 0 || x > 3 || y < 0 || y > 3 || z < 0 || z > 1;
    on_surface = !out && (edge(x, 0, 3) || edge(y, 0, 3) || edge(z, 0, 1) ||
                          ((edge(x, 1, 2) && y >= 1 && y <= 2) || (edge(y, 1, 2) && x >= 1 && x <= 2)));
    if (on_surface) continue;
    CAPTURE(x, y, z, far[1], far[2]);
    REQUIRE(winding(input, far, q) == (in_box && !in_hole ? 1 : 0));
  }
}

TEST_CASE("walks along an axis agree with walks to points", "[cells][degenerate]") {
  const Mesh solid = test::octahedron({0, 0, 0}, 2);
  InputComplex input;
  input.add(solid.vertices, solid.triangles);
  test::Random random(5);
  for (int n = 0; n < 500; ++n) {
    const InputComplex::Coordinates from{double(random.between(-3, 3)), double(random.between(-2, 2)),
                                         double(random.between(-2, 2))};
    const int axis = random.between(0, 2);
    InputComplex::Coordinates to = from;
    to[static_cast<std::size_t>(axis)] = random.between(-3, 3) + 0.25;
    int along = 0;
    for (std::uint32_t f = 0; f < input.face_count(); ++f) along += crossing_along_axis(input, f, from, to, axis);
    // Winding numbers at both ends from far away; q is not perturbed, so only ends off the surface compare.
    const InputComplex::Coordinates far{-9, 0.5, 0.25};
    const auto on = [](const InputComplex::Coordinates& p) {
      return std::abs(p[0]) + std::abs(p[1]) + std::abs(p[2]) == 2;
    };
    if (on(from) || on(to)) continue;
    REQUIRE(winding(input, far, Point::free(from)) + along == winding(input, far, Point::free(to)));
  }
}

TEST_CASE("every cell's origin has the winding numbers it says", "[cells][property]") {
  const Mesh a = test::icosphere({0, 0, 0}, 1, 2), b = test::icosphere({.5, .1, .05}, 1, 2), c = test::box_with_hole();
  InputComplex input;
  for (const Mesh* m : {&a, &b, &c}) input.add(m->vertices, m->triangles);
  const CellTree tree(input, {.leaf_faces = 8});
  REQUIRE(tree.cells().size() > 20);
  int compared = 0;
  for (const Cell& cell : tree.cells()) {
    bool in_a_plane = false;  // there the perturbed origin and the origin may differ
    for (std::uint32_t f = 0; f < input.face_count(); ++f)
      in_a_plane = in_a_plane || side_of_face(input, f, Point::free(cell.origin)) == Sign::zero;
    if (in_a_plane) continue;
    ++compared;
    Windings w;
    for (std::uint32_t f = 0; f < input.face_count(); ++f)
      w.add(input.operand_of_face(f), crossing(input, f, {-100, -90, -80}, Point::free(cell.origin)));
    REQUIRE(w == *cell.windings);
  }
  CHECK(compared > 20);
}

TEST_CASE("grid coordinates are monotone at any scale", "[cells][property]") {
  test::Random random(11);
  for (const double scale : {1e-310, 1e-300, 1e-9, 1.0, 1e9, 1e300}) {
    const Grid grid({-scale, 0, scale / 2}, {scale, scale / 3, scale});
    for (int n = 0; n < 2'000; ++n) {
      const double x = (random.unit() * 3 - 1.5) * scale,
                   y = random.once_in(4) ? std::nextafter(x, 9.0) : x + random.unit() * scale;
      for (int axis = 0; axis < 3; ++axis) REQUIRE(grid.at(axis, std::min(x, y)) <= grid.at(axis, std::max(x, y)));
    }
  }
}
