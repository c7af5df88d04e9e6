#include "core/arrange/validate.h"

#include <catch2/catch.hpp>
#include <utility>

#include "support/reports.h"

using namespace strata;
using test::reports;

namespace {

/// A face in the plane z = 0 with an isolated point and a segment in it, both of the other face.
struct Plate {
  std::vector<InputComplex::Coordinates> points{{0, 0, 0},   {64, 0, 0}, {0, 64, 0}, {8, 8, 0},
                                                {16, 16, 0}, {8, 8, 9},  {4, 16, 0}, {16, 4, 0}};
  std::vector<InputComplex::Indices> faces{{0, 1, 2}, {3, 4, 5}, {6, 7, 5}};
  std::vector<Constraint> constraints{
      {0, 1, ConstraintKind::crossing, ConstraintLine::along_edge(3, 4), 3, 4},
      {0, 2, ConstraintKind::point, {}, 6, 6},
  };
  InputComplex input;
  PointTable table{input};
  Triangulation t{input, table};
  std::vector<Triangulation::Triangle> triangles;
  std::vector<Triangulation::Note> notes;

  Plate() {
    input.add(points, faces);
    t.start(0, Triangulation::Names::any);
    t.add_constraints(constraints);
    triangles.assign(t.triangles().begin(), t.triangles().end());
    notes.assign(t.notes().begin(), t.notes().end());
  }
  [[nodiscard]] std::vector<std::string> violations() const {
    return validate(TriangulationParts{t.points(), triangles, notes}, constraints);
  }
  /// A triangle and a side of it with a neighbour, or without one, that carries nothing.
  [[nodiscard]] std::pair<std::size_t, std::size_t> side(bool inner) const {
    for (std::size_t n = 0; n < triangles.size(); ++n)
      for (std::size_t i = 0; i < 3; ++i)
        if ((triangles[n].n[i] >= 0) == inner && triangles[n].c[i] < 0) return {n, i};
    FAIL("there is no such side");
    return {};
  }
};

}  // namespace

// Each section breaks one invariant.
TEST_CASE("what is wrong with a triangulation is listed", "[arrange]") {
  Plate plate;
  REQUIRE(plate.triangles.size() > 4);
  REQUIRE(validate(plate.t, plate.constraints).empty());
  REQUIRE(plate.violations().empty());
  SECTION("a triangle that turns right") {
    std::swap(plate.triangles[0].v[0], plate.triangles[0].v[1]);
    CHECK(reports(plate.violations(), "face 0: triangle 0 does not turn left"));
  }
  SECTION("neighbours that share no side") {
    const auto [t, i] = plate.side(true);
    plate.triangles[t].n[i] = plate.triangles[t].n[i] == 0 ? 1 : 0;
    CHECK(reports(plate.violations(), "are neighbours and share no side"));
  }
  SECTION("a hole") {
    const auto [t, i] = plate.side(true);
    plate.triangles[t].n[i] = -1;
    CHECK(reports(plate.violations(), "has one triangle and is not on the border"));
    CHECK(reports(plate.violations(), "the border is open in vertex"));
  }
  SECTION("a border that is run through twice") {
    const auto [t, i] = plate.side(false);
    plate.triangles.push_back(plate.triangles[t]);
    CHECK(reports(plate.violations(), "the border leaves vertex"));
  }
  SECTION("corners that are not covered") {
    plate.triangles.clear();
    CHECK(reports(plate.violations(), "corner 2 is not covered"));
  }
  SECTION("a constraint that does not exist") {
    plate.constraints.clear();
    CHECK(reports(plate.violations(), "a side carries constraint 0, which does not exist"));
  }
  SECTION("an end that is no vertex") {
    plate.constraints[0].head = 7;
    CHECK(reports(plate.violations(), "constraint 0 ends in no vertex"));
  }
  SECTION("an end elsewhere") {
    plate.constraints[0].head = 6;
    CHECK(reports(plate.violations(), "the sides of constraint 0 end in vertex"));
    CHECK(reports(plate.violations(), "constraint 0 leads off its line to vertex"));
  }
  SECTION("a constraint that no side carries") {
    for (auto& t : plate.triangles) t.c = {-1, -1, -1};
    CHECK(reports(plate.violations(), "no sides carry constraint 0"));
  }
  SECTION("a side that carries a constraint the wrong way") {
    for (auto& note : plate.notes) note.forward = !note.forward;
    CHECK(reports(plate.violations(), "the sides of constraint 0 end in vertex"));
  }
}
