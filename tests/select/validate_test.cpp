#include "core/select/validate.h"

#include <catch2/catch.hpp>
#include <optional>
#include <utility>

#include "support/reports.h"
#include "support/shapes.h"

using namespace strata;
using test::reports;

namespace {

/// A tetrahedron, and a constructed point inside its first face.
struct Solid {
  Mesh mesh = test::tetrahedron({0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4});
  InputComplex input;
  std::optional<PointTable> points;
  PointId inside = 0;  ///< of face 0

  Solid() {
    input.add(mesh.vertices, mesh.triangles);
    points.emplace(input);
    const std::vector<SymbolicPoint> names{SymbolicPoint::weighted(0, 1)};
    inside = points->add(names, {}).front();
  }
};

/// Face 0, divided by a point inside; of its three pieces two are there.
struct Pieces : Solid {
  std::vector<PointId> ids;
  std::vector<PieceTriangle> triangles{{{0, 1, 3}, 0b001, 0, false}, {{1, 2, 3}, 0b001, 0, false}};
  Subdivision subdivision{{}, {}, PointTable(input)};
  std::vector<SubdividedFace>& faces = subdivision.faces;
  std::vector<Verdict> whole;

  Pieces() {
    const auto v = input.face(0);
    ids = {v[0], v[1], v[2], inside};
    triangles[0].boundary |= 0b100;  // the third piece is not there
    triangles[1].boundary |= 0b010;
    faces.push_back({0, true, ids, triangles, {}});
    subdivision.points = *points;
    whole.assign(input.face_count(), Verdict::keep);
    whole[0] = Verdict::drop;
  }
  [[nodiscard]] std::vector<std::string> violations() const { return validate(input, subdivision); }
};

/// The boundary of the tetrahedron.
struct Whole : Solid {
  Boundary boundary{{}, {}, {}, {}, {}, *points};

  Whole() {
    boundary.inputs = {0, 1, 2, 3};
    for (std::uint32_t f = 0; f < input.face_count(); ++f) {
      boundary.triangles.push_back(input.face(f));
      boundary.sources.push_back({0, f});
    }
  }
  [[nodiscard]] std::vector<std::string> violations() const { return validate(input, boundary); }
};

}  // namespace

// Each section breaks one invariant.
TEST_CASE("what is wrong with pieces of faces is listed", "[select]") {
  Pieces p;
  REQUIRE(p.violations().empty());
  SECTION("a face that does not exist") {
    p.faces[0].face = 4;
    CHECK(reports(p.violations(), "face 4 does not exist"));
  }
  SECTION("order") {
    p.faces.push_back(p.faces[0]);
    CHECK(reports(p.violations(), "face 0 is listed after face 0"));
  }
  SECTION("a point that another one represents") {
    const std::vector<SymbolicPoint> names{SymbolicPoint::weighted(0, 2)};
    p.ids[3] = p.subdivision.points.add(names, {}).front();
    const std::vector<std::pair<PointId, PointId>> equal{{p.inside, p.ids[3]}};
    p.subdivision.points.identify(equal);
    CHECK(reports(p.violations(), "does not represent itself"));
  }
  SECTION("a piece without three corners") {
    p.triangles[0].v[2] = 0;
    CHECK(reports(p.violations(), "face 0 has a piece without three corners"));
    p.triangles[0].v[2] = 4;
    CHECK(reports(p.violations(), "face 0 has a piece without three corners"));
  }
  SECTION("sides that are not marked, and sides marked for nothing") {
    p.triangles[0].boundary = 0b111;
    CHECK(reports(p.violations(), "is marked as boundary and lies between pieces"));
    p.triangles[0].boundary = 0;
    CHECK(reports(p.violations(), "is boundary and not marked"));
  }
  SECTION("a piece that turns the wrong way") {
    for (auto& t : p.triangles) t.reversed = true;
    CHECK(reports(p.violations(), "face 0: piece 0 turns the wrong way"));
  }
  SECTION("a piece of no area") {
    p.mesh.vertices[p.ids[1]] = p.mesh.vertices[p.ids[0]];  // behind everybody's back
    CHECK(reports(p.violations(), "face 0: piece 0"));
  }
  SECTION("a point off the plane") {
    p.ids[3] = 6 - p.ids[0] - p.ids[1] - p.ids[2];
    CHECK(reports(p.violations(), "leaves the plane in point"));
  }
}

TEST_CASE("faces that are subdivided do not stay whole", "[select]") {
  Pieces p;
  REQUIRE(validate(p.input, p.whole, p.subdivision).empty());
  p.whole[0] = Verdict::keep_reversed;
  CHECK(reports(validate(p.input, p.whole, p.subdivision), "face 0 stays whole and is subdivided"));
  p.whole.pop_back();
  CHECK(reports(validate(p.input, p.whole, p.subdivision), "4 faces have 3 verdicts"));
}

TEST_CASE("what is wrong with a boundary is listed", "[select]") {
  Whole w;
  REQUIRE(w.violations().empty());
  SECTION("order of the vertices") {
    std::swap(w.boundary.inputs[0], w.boundary.inputs[1]);
    CHECK(reports(w.violations(), "vertices are not listed by increasing number"));
  }
  SECTION("constructed points among the given ones") {
    w.boundary.inputs.push_back(w.inside);
    CHECK(reports(w.violations(), "vertices are not listed by increasing number"));
  }
  SECTION("a vertex that another one represents") {
    const std::vector<std::pair<PointId, PointId>> equal{{0, 1}};
    w.boundary.points.identify(equal);
    CHECK(reports(w.violations(), "vertex 1 does not represent itself"));
  }
  SECTION("triangles without a source") {
    w.boundary.sources.pop_back();
    CHECK(reports(w.violations(), "4 triangles have 3 sources"));
  }
  SECTION("a source that does not exist") {
    w.boundary.sources[1].face = 4;
    CHECK(reports(w.violations(), "triangle 1 comes from face 4 of operand 0, which does not exist"));
  }
  SECTION("no triangle") {
    w.boundary.triangles[2][0] = w.boundary.triangles[2][1];
    CHECK(reports(w.violations(), "triangle 2 has not three corners"));
  }
  SECTION("another source") {
    std::swap(w.boundary.sources[0], w.boundary.sources[1]);
    CHECK(reports(w.violations(), "triangle 0 leaves the plane of its source"));
  }
  SECTION("no area") {
    w.mesh.vertices[3] = w.mesh.vertices[2];  // behind everybody's back
    CHECK(reports(w.violations(), "has no area"));
  }
}
