#include "core/overlap/meeting.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "core/kernel/predicates.h"
#include "support/random.h"

using namespace strata;

namespace {

/// Two triangles, one operand each.
struct Pair {
  std::array<std::array<double, 3>, 3> f, g;
  std::array<InputComplex::Indices, 1> face{{{0, 1, 2}}};
  InputComplex input;
  PairIntersections intersections;
  bool meet = false;

  Pair(const std::array<std::array<double, 3>, 3>& a, const std::array<std::array<double, 3>, 3>& b) : f(a), g(b) {
    input.add(f, face);
    input.add(g, face);
    meet = meet_faces(input, FilteredFace(input, 0), FilteredFace(input, 1), intersections);
  }
  [[nodiscard]] SymbolicPoint name(PointId id) const {
    const std::uint32_t vertices = input.vertex_count();
    return id < vertices ? SymbolicPoint::input(id) : intersections.constructed[id - vertices];
  }
  [[nodiscard]] std::vector<Constraint> on(std::uint32_t x) const {
    std::vector<Constraint> r;
    for (const Constraint& c : intersections.constraints)
      if (c.face == x) r.push_back(c);
    return r;
  }
};

constexpr std::array<std::array<double, 3>, 3> floor_face{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}};

}  // namespace

TEST_CASE("faces on one side of each other's plane are apart", "[overlap]") {
  CHECK_FALSE(Pair(floor_face, {{{0, 0, 1}, {1, 0, 1}, {0, 1, 2}}}).meet);
  CHECK_FALSE(Pair(floor_face, {{{5, 5, -1}, {5, 5, 1}, {6, 5, 0}}}).meet);
  CHECK_FALSE(Pair(floor_face, {{{3, 3, -1}, {3, 3, 1}, {4, 4, 1}}}).meet);
}

TEST_CASE("a face that pierces another: a segment, with the deeper side on its left", "[overlap]") {
  // The wall x = 1 looks towards +x; behind it, x < 1, is inside.
  const Pair p(floor_face, {{{1, 1, -1}, {1, 2, -1}, {1, 1, 1}}});
  const auto on_f = p.on(0), on_g = p.on(1);
  REQUIRE(on_f.size() == 1);
  REQUIRE(on_g.size() == 1);
  CHECK(on_f[0].kind == ConstraintKind::crossing);
  CHECK(p.name(on_f[0].tail).kind == SymbolicPoint::Kind::edge_face);
  const Point tail = make_point(p.input, p.name(on_f[0].tail)), head = make_point(p.input, p.name(on_f[0].head));
  // Left of the segment, seen from above, is x < 1: it runs towards +y.
  CHECK(compare(p.input, 1, head, tail) == Sign::positive);
  CHECK(on_g[0].tail == on_f[0].head);  // seen from the wall, inside the floor's operand is below
  CHECK(on_g[0].head == on_f[0].tail);
}

TEST_CASE("the cases of the table", "[overlap][degenerate]") {
  SECTION("a vertex on a face") {
    const Pair p(floor_face, {{{1, 1, 0}, {1, 2, 1}, {2, 1, 1}}});
    REQUIRE(p.on(0).size() == 1);
    CHECK(p.on(0)[0].kind == ConstraintKind::point);
    CHECK(p.on(0)[0].tail == 3);
  }
  SECTION("a vertex beside a face") { CHECK_FALSE(Pair(floor_face, {{{3, 3, 0}, {1, 2, 1}, {2, 1, 1}}}).meet); }
  SECTION("an edge on a face, the rest above: a crossing") {
    const Pair p(floor_face, {{{1, 1, 0}, {2, 1, 0}, {1, 1, 1}}});
    REQUIRE(p.on(0).size() == 1);
    CHECK(p.on(0)[0].kind == ConstraintKind::crossing);
    CHECK(p.on(0)[0].line == ConstraintLine::along_edge(3, 4));
  }
  SECTION("an edge on a face, the rest below: a touch") {
    const Pair p(floor_face, {{{1, 1, 0}, {2, 1, 0}, {1, 1, -1}}});
    REQUIRE(p.on(0).size() == 1);
    CHECK(p.on(0)[0].kind == ConstraintKind::touch);
  }
  SECTION("edge through edge") {
    const Pair p(floor_face, {{{1, 0, -1}, {1, 0, 1}, {1, -2, 0}}});
    REQUIRE(p.on(0).size() == 1);
    CHECK(p.on(0)[0].kind == ConstraintKind::point);
    CHECK(p.name(p.on(0)[0].tail).kind == SymbolicPoint::Kind::edge_edge);
    CHECK(p.on(0)[0].tail == p.on(1)[0].tail);
  }
  SECTION("equal vertices are noted") {
    const Pair p(floor_face, {{{0, 0, 0}, {-1, 0, 1}, {0, -1, 1}}});
    REQUIRE(p.intersections.equal.size() >= 1);
    CHECK(p.intersections.equal[0].a == 0);
    CHECK(p.intersections.equal[0].b == 3);
    CHECK(p.on(0)[0].tail == 0);
    CHECK(p.on(1)[0].tail == 3);
  }
  SECTION("coplanar faces, one inside the other") {
    const Pair p(floor_face, {{{1, 1, 0}, {2, 1, 0}, {1, 2, 0}}});
    const auto on_f = p.on(0), on_g = p.on(1);
    CHECK(std::count_if(on_f.begin(), on_f.end(), [](auto& c) { return c.kind == ConstraintKind::cover_left; }) == 3);
    CHECK(std::count_if(on_g.begin(), on_g.end(), [](auto& c) { return c.kind == ConstraintKind::coplanar; }) == 1);
  }
  SECTION("coplanar faces of opposite orientation") {
    const Pair p(floor_face, {{{1, 1, 0}, {1, 2, 0}, {2, 1, 0}}});
    const auto on_f = p.on(0);
    CHECK(std::count_if(on_f.begin(), on_f.end(), [](auto& c) { return c.kind == ConstraintKind::cover_right; }) == 3);
  }
  SECTION("coplanar faces apart") { CHECK_FALSE(Pair(floor_face, {{{5, 5, 0}, {6, 5, 0}, {5, 6, 0}}}).meet); }
}

TEST_CASE("meeting is symmetric, and its points lie on both faces", "[overlap][property]") {
  test::Random random(7);
  int intersections = 0;
  for (int n = 0; n < 20'000; ++n) {
    std::array<std::array<double, 3>, 3> f, g;
    for (auto* t : {&f, &g})
      for (auto& v : *t)
        for (double& x : v) x = random.between(0, 3);
    const Pair p(f, g), q(g, f);
    if (is_degenerate(p.input, 0) || is_degenerate(p.input, 1)) continue;
    CAPTURE(n);
    REQUIRE(p.meet == q.meet);
    REQUIRE(p.on(0).size() == q.on(1).size());
    intersections += p.meet;
    for (const Constraint& c : p.intersections.constraints)
      for (const PointId id : {c.tail, c.head}) {
        const Point x = make_point(p.input, p.name(id));
        REQUIRE(side_of_face(p.input, c.face, x) == Sign::zero);
        if (c.kind != ConstraintKind::coplanar) REQUIRE(side_of_face(p.input, c.other, x) == Sign::zero);
      }
  }
  CHECK(intersections > 2'000);
}
