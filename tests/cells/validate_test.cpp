#include "core/cells/validate.h"

#include <catch2/catch.hpp>

#include "strata/mesh.h"
#include "support/reports.h"
#include "support/shapes.h"

using namespace strata;
using test::reports;

TEST_CASE("what a cell's list says of itself is checked", "[cells]") {
  const Mesh box = test::box({0, 0, 0}, {1, 1, 1});
  InputComplex input;
  input.add(box.vertices, box.triangles);
  std::vector<Cell> cells(1);
  Cell& cell = cells.front();
  cell.box = {{0, 0, 0}, {8, 8, 8}};
  cell.mixed = true;
  cell.faces = FaceList(3);
  const GridBox near{{0, 0, 0}, {4, 4, 4}};
  const auto violations = [&] { return validate(input, std::span<const Cell>(cells)); };
  SECTION("nothing is wrong") {
    cell.faces.push_back({near, 2, false});
    cell.faces.push_back({near, 7, false});
    CHECK(violations().empty());
  }
  SECTION("a cell that is not mixed") {
    cell.faces.push_back({near, 2, false});
    cell.mixed = false;
    CHECK(reports(violations(), "cell 0 is not mixed and lists faces"));
  }
  SECTION("a face that does not exist") {
    cell.faces.push_back({near, 12, false});
    CHECK(reports(violations(), "cell 0 lists face 12, which does not exist"));
  }
  SECTION("order") {
    cell.faces.push_back({near, 7, false});
    cell.faces.push_back({near, 7, false});
    CHECK(reports(violations(), "cell 0 lists faces out of order"));
  }
  SECTION("numbers without boxes") {
    const std::vector<std::uint32_t> numbers{7, 2};
    cell.numbers = numbers;
    CHECK(reports(violations(), "cell 0 is not apart and lists faces by number alone"));
    CHECK(reports(violations(), "cell 0 lists faces by number out of order"));
  }
  SECTION("a face elsewhere: cells are half-open") {
    cell.faces.push_back({{{8, 0, 0}, {9, 4, 4}}, 7, false});
    CHECK(reports(violations(), "cell 0 lists face 7, which is not near"));
  }
}

// Vertices are moved behind the subdivision's back, so that what it lists is no longer true.
TEST_CASE("faces are where cells list them, and cells own the pairs that overlap", "[cells]") {
  Mesh a = test::icosphere({0, 0, 0}, 1, 2), b = test::icosphere({.3, .1, .05}, 1, 2);
  InputComplex input;
  input.add(a.vertices, a.triangles);
  input.add(b.vertices, b.triangles);
  const CellTree tree(input, {.leaf_faces = 8});
  REQUIRE(tree.cells().size() > 8);
  REQUIRE(validate(input, tree).empty());
  for (Vertex& v : a.vertices) v[0] = -v[0];
  const auto violations = validate(input, tree);
  CHECK(reports(violations, "is listed with another box than that of its corners"));
  CHECK(reports(violations, "is not listed in the cell in which its corner"));
}
