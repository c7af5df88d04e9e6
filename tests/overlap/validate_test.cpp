#include "core/overlap/validate.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "core/kernel/predicates.h"
#include "core/overlap/candidates.h"
#include "core/overlap/intersect.h"
#include "support/reports.h"
#include "support/shapes.h"

using namespace strata;
using test::reports;

namespace {

/// Two boxes that cross in the middle of their faces.
struct Crossing {
  Mesh a = test::box({0, 0, 0}, {4, 4, 4}), b = test::box({1, 1, 2}, {3, 3, 6});
  Candidates candidates = find_candidates(complex(), {});
  const InputComplex& input = candidates.input();
  Intersections found = intersect(candidates, {});
  PointTable& points = found.points;

  [[nodiscard]] InputComplex complex() const {
    InputComplex all;
    all.add(a.vertices, a.triangles);
    all.add(b.vertices, b.triangles);
    return all;
  }
  [[nodiscard]] std::vector<std::string> violations() const { return validate(input, found); }
};

bool is_segment(const Constraint& c) { return c.tail != c.head; }

}  // namespace

// Each section breaks one invariant.
TEST_CASE("what is wrong with intersections is listed", "[overlap]") {
  Crossing x;
  REQUIRE(x.violations().empty());
  auto& constraints = x.found.constraints;
  const auto some = std::find_if(constraints.begin(), constraints.end(), is_segment);
  REQUIRE(some != constraints.end());
  SECTION("faces that do not exist") {
    some->other = x.input.face_count();
    CHECK(reports(x.violations(), " is of face "));
  }
  SECTION("a face that meets itself") {
    some->other = some->face;
    CHECK(reports(x.violations(), " is of face "));
  }
  SECTION("points without a number") {
    some->head = x.points.end();
    CHECK(reports(x.violations(), "ends in a point without a number"));
  }
  SECTION("a segment of no length") {
    some->head = some->tail;
    CHECK(reports(x.violations(), "is a segment of no length"));
  }
  SECTION("two ends of a point") {
    some->kind = ConstraintKind::point;
    CHECK(reports(x.violations(), "is no segment and has two ends"));
  }
  SECTION("a line of neither face") {
    some->line = ConstraintLine::trace_of(some->face);
    CHECK(reports(x.violations(), "is carried by a line of neither face"));
  }
  SECTION("order") {
    std::reverse(constraints.begin(), constraints.end());
    CHECK(reports(x.violations(), "stands after face"));
  }
  SECTION("no counterpart") {
    const auto [face, other] = std::pair(some->face, some->other);
    std::erase_if(constraints, [&](const Constraint& c) { return c.face == other && c.other == face; });
    CHECK(reports(x.violations(), ", which has none by it"));
  }
  SECTION("ends elsewhere") {
    some->head = 0;
    CHECK(reports(x.violations(), "ends in point 0, which is not on face"));
  }
  SECTION("vertices that are not equal") {
    x.found.equal.push_back({0, 8});
    CHECK(reports(x.violations(), "vertices 0 and 8 are listed as equal"));
  }
}

TEST_CASE("what is wrong with a table of points is listed", "[overlap]") {
  Crossing x;
  REQUIRE(validate(x.input, x.points).empty());
  SECTION("points of one name") {
    std::vector<Point> points(x.points.constructed().begin(), x.points.constructed().end());
    points.push_back(points.front());
    CHECK(reports(validate(x.input, points, 16), "have one name"));
  }
  SECTION("bounds") {
    for (Vertex& v : x.b.vertices) v[0] += 0.125;  // behind the table's back
    CHECK(reports(validate(x.input, x.points), "is not within its bound"));
  }
  SECTION("points that are identified and apart") {
    const std::vector<std::pair<PointId, PointId>> equal{{x.points.first(), x.points.first() + 1}};
    x.points.identify(equal);
    CHECK(reports(validate(x.input, x.points), "are identified and have different positions"));
  }
}

TEST_CASE("points at one place are to be identified", "[overlap]") {
  Crossing x;
  std::vector<PointId> ids;
  for (PointId id = x.points.first(); id < x.points.end(); ++id) ids.push_back(id);
  REQUIRE(validate_distinct(x.input, x.points, ids).empty());
  // The corner 0 by another name: three planes of a.
  std::vector<std::uint32_t> at_corner;
  for (std::uint32_t f = 0; f < x.input.face_count(0); ++f) {
    const auto v = x.input.face(f);
    const bool has = std::find(v.begin(), v.end(), 0u) != v.end();
    const auto parallel = [&](std::uint32_t g) {
      for (int axis = 0; axis < 3; ++axis)
        if (normal_component(x.input, f, axis) != Sign::zero) return normal_component(x.input, g, axis) != Sign::zero;
      return false;
    };
    if (has && std::none_of(at_corner.begin(), at_corner.end(), parallel)) at_corner.push_back(f);
  }
  REQUIRE(at_corner.size() == 3);
  const std::vector<SymbolicPoint> corner{SymbolicPoint::three_faces(at_corner[0], at_corner[1], at_corner[2])};
  const PointId same = x.points.add(corner, {}).front();
  CHECK(reports(validate_distinct(x.input, x.points, {0, 1, same}), "have one position and are not identified"));
  const std::vector<std::pair<PointId, PointId>> equal{{0, same}};
  x.points.identify(equal);
  CHECK(validate_distinct(x.input, x.points, {0, 1, same}).empty());
}
