#include "core/kernel/validate.h"

#include <catch2/catch.hpp>
#include <limits>

#include "support/reports.h"

using namespace strata;
using test::reports;

namespace {

/// A tetrahedron.
struct Solid {
  std::vector<InputComplex::Coordinates> points{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}};
  std::vector<InputComplex::Indices> faces{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  std::vector<ExactVertex> exact;
  std::optional<Box> bounds;

  [[nodiscard]] std::vector<std::string> violations() const {
    InputComplex input;
    input.add(points, faces, exact, bounds);
    return validate(input);
  }
};

}  // namespace

// Each section breaks one invariant.
TEST_CASE("what is wrong with an input complex is listed", "[kernel]") {
  Solid solid;
  SECTION("nothing") {
    solid.exact.push_back({3, {0, 0, Rational(4)}});
    solid.bounds = Box{{0, 0, 0}, {4, 4, 4}};
    CHECK(solid.violations().empty());
  }
  SECTION("a corner that does not exist") {
    solid.faces[2][1] = 4;
    CHECK(reports(solid.violations(), "face 2 of operand 0 has a corner that does not exist"));
  }
  SECTION("a corner twice") {
    solid.faces[2][1] = 1;
    CHECK(reports(solid.violations(), "face 2 of operand 0 has one corner twice"));
  }
  SECTION("a coordinate that is not finite") {
    solid.points[3][1] = std::numeric_limits<double>::infinity();
    CHECK(reports(solid.violations(), "vertex 3 of operand 0 has a coordinate that is not finite"));
  }
  SECTION("a box that is too small") {
    solid.bounds = Box{{0, 0, 0}, {4, 4, 3}};
    CHECK(reports(solid.violations(), "vertex 3 of operand 0 is outside of the box"));
  }
  SECTION("no area") {
    solid.points[2] = {2, 0, 0};
    CHECK(reports(solid.violations(), "face 0 has no area"));
  }
}

TEST_CASE("vertices that are identified and apart are listed", "[kernel]") {
  const Solid a, b;
  InputComplex input;
  input.add(a.points, a.faces);
  input.add(b.points, b.faces);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> equal{{0, 4}, {1, 5}};
  input.identify(equal);
  CHECK(validate(input).empty());
  equal.assign(1, {2, 7});
  input.identify(equal);
  CHECK(reports(validate(input), "vertices 2 and 7 are identified and not at one place"));
}
