#include <catch2/catch.hpp>

#include "core/kernel/filtered_orientation.h"
#include "planar/shapes.h"
#include "strata/planar.h"

namespace strata::planar {
namespace {

using namespace test;

Region parity(const Loop& loop) { return fill({loops({loop}), FillRule::even_odd}); }

Region boxes(const std::vector<Loop>& all) { return fill(loops(all)); }

std::vector<SelfMeetingKind> kinds(const Loop& loop) {
  std::vector<SelfMeetingKind> found;
  for (const SelfMeeting& m : self_intersections(loops({loop}))) found.push_back(m.kind);
  return found;
}

}  // namespace

TEST_CASE("polyloops that are not clean are told how and where", "[planar][polyloop]") {
  using K = SelfMeetingKind;
  CHECK(kinds(box(0, 0, 1, 1)).empty());
  CHECK(is_clean(square(0, 0)));
  CHECK_FALSE(is_clean(loops({{{0, 0}, {1, 1}}})));
  CHECK(kinds({{0, 0}, {1, 1}}) == std::vector{K::edges_overlapping});
  CHECK(kinds({{5, 7}}) == std::vector{K::lone_vertex});
  CHECK_FALSE(is_clean(loops({{{5, 7}}})));

  const Loop bow{{0, 0}, {3, 3}, {3, 0}, {0, 3}};
  CHECK(kinds(bow) == std::vector{K::edges_crossing});
  const SelfMeeting crossing = self_intersections(loops({bow})).front();
  CHECK(crossing.where == RationalPlacement{Rational(3, 2), Rational(3, 2)});
  CHECK(crossing.edges == std::vector<std::uint32_t>{0, 2});
  CHECK(parity(bow).polygons() == 2);

  const Loop pinched{{0, 0}, {2, 0}, {1, 1}, {2, 2}, {0, 2}, {1, 1}};
  CHECK(kinds(pinched) == std::vector{K::vertex_on_vertex});
  CHECK(self_intersections(loops({pinched})).front().vertices == std::vector<std::uint32_t>{2, 5});
  CHECK(parity(pinched).polygons() == 2);

  const Loop touching{{0, 0}, {4, 0}, {4, 2}, {2, 0}, {0, 2}};
  CHECK(kinds(touching) == std::vector{K::vertex_on_edge});
  CHECK(parity(touching).polygons() == 2);

  const Loop spike{{0, 0}, {2, 0}, {2, 1}, {4, 1}, {2, 1}, {2, 2}, {0, 2}};
  CHECK(kinds(spike) == std::vector{K::vertex_on_vertex, K::edges_overlapping});
  CHECK(canonical_form(parity(spike)) == canonical_form(parity(box(0, 0, 2, 2))));
}

TEST_CASE("a loop without right turns need not be convex", "[planar][polyloop]") {
  // A star of five points turns left everywhere, and winds twice; its interior by parity is five triangles.
  const Loop star{{0, 3}, {-2, -3}, {3, 1}, {-3, 1}, {2, -3}};
  for (std::size_t i = 0; i < 5; ++i) CHECK(filtered_orientation(star[i], star[(i + 1) % 5], star[(i + 2) % 5]) > 0);
  CHECK(parity(star).polygons() == 5);
  CHECK(fill(loops({star})).polygons() == 1);
}

TEST_CASE("membership is in, on or out, also beside vertices", "[planar][locator]") {
  const Region r = parity({{0, 0}, {4, 0}, {4, 4}, {2, 2}, {0, 4}});
  const Locator locator(r);
  CHECK(locator.locate(PlanePoint{1, 1}) == Membership::in);
  CHECK(locator.locate(PlanePoint{2, 2}) == Membership::on);
  CHECK(locator.locate(PlanePoint{2, 2.5}) == Membership::out);
  CHECK(locator.locate(PlanePoint{1, 2}) == Membership::in);   // level with a vertex
  CHECK(locator.locate(PlanePoint{5, 0}) == Membership::out);  // level with an edge
  CHECK(locator.locate(PlanePoint{3, 0}) == Membership::on);
  CHECK(locator.locate(PlanePoint{3, 0x1p-1074}) == Membership::in);
  CHECK(locator.locate(PlanePoint{3, -0x1p-1074}) == Membership::out);
  CHECK(locator.locate(RationalPlacement{Rational(10, 3), Rational(10, 3)}) == Membership::on);
  CHECK(locator.locate(RationalPlacement{Rational(10, 3), Rational(10, 3) - Rational(1, 1000000007)}) ==
        Membership::in);
}

TEST_CASE("an intersection of four components, one of which touches itself", "[planar][combine][degenerate]") {
  const Region a =
      difference(boxes({box(0, 0, 3, 3), box(0, -1, 10, 0), box(5, 0, 6, 3), box(8, 0, 10, 1), box(9, 1, 10, 2)}),
                 loops({box(1, 1, 2, 2)}));
  const Region b =
      difference(boxes({box(0, 0, 3, 3), box(0, 3, 10, 4), box(5, 0, 6, 3), box(8, 0, 9, 3), box(9, 1, 10, 2)}),
                 loops({box(2, 2, 3, 3)}));
  REQUIRE(a.polygons() == 1);
  REQUIRE(b.polygons() == 1);
  CHECK(kind_of(a, 0).is_manifold);
  CHECK(kind_of(b, 0).is_manifold);
  const Region common = intersection(a, b);
  REQUIRE(common.polygons() == 4);
  CHECK_FALSE(kind_of(common, 0).is_manifold);  // around the square hole of a, to its corner
  CHECK(kind_of(common, 0).is_simply_connected);
  for (std::uint32_t p = 1; p < 4; ++p) CHECK(kind_of(common, p).is_simple());
  // Two touch in a vertex. They are not one polygon: sets that are open and regular have an open and regular
  // intersection.
  CHECK(contact_of(polygon_of(common, 2), polygon_of(common, 3)).points == std::vector<RationalPlacement>{{9, 1}});
  CHECK(contact_of(polygon_of(common, 1), polygon_of(common, 2)).relation == Relation::apart);
}

TEST_CASE("the canonical decomposition has the polygon's corners and where it touches itself",
          "[planar][decomposition]") {
  const Region r = boxes({box(0, 0, 1, 1), box(1, 0, 2, 1), box(2, 1, 3, 2)});
  REQUIRE(r.polygons() == 2);
  const CanonicalDecomposition d = canonical_decomposition(r, 0);
  CHECK(d.vertices.size() == 4);
  CHECK(d.edges.size() == 4);
  CHECK(d.exterior_faces == 1);
  CHECK(d.is_manifold());
  const Region pinched = difference(loops({box(0, 0, 2, 2)}), loops({{{0, 1}, {1, 0.5}, {1, 1.5}}}));
  const CanonicalDecomposition e = canonical_decomposition(pinched, 0);
  CHECK(e.vertices.size() == 7);
  CHECK_FALSE(e.is_manifold());
  CHECK(e.exterior_faces == 2);
}

TEST_CASE("contact regions are edges and isolated points, exactly", "[planar][contact]") {
  const Region a = boxes({box(0, 0, 3, 1)});
  const Contact beside = contact_of(a, boxes({box(1, 1, 2, 2), box(2, 1, 2.5, 2), box(3, 1, 4, 2)}));
  CHECK(beside.relation == Relation::contact);
  REQUIRE(beside.edges.size() == 1);
  CHECK(beside.edges[0] == std::array<RationalPlacement, 2>{{{1, 1}, {Rational(5, 2), 1}}});
  CHECK(beside.points == std::vector<RationalPlacement>{{3, 1}});
  CHECK(contact_of(a, boxes({box(2, 0.5, 4, 2)})).relation == Relation::interfering);
  CHECK(contact_of(a, boxes({box(3 + 0x1p-51, 0, 4, 2)})).relation == Relation::apart);
  CHECK(contact_of(a, a).relation == Relation::interfering);
}

TEST_CASE("rounding that makes loops meet is told", "[planar][clean]") {
  LoopsBuilder builder;
  builder.add_vertex(RationalPlacement{1 + Rational(1) / (Integer(1) << 60), 0});
  builder.add_vertex(PlanePoint{2, -1});
  builder.add_vertex(PlanePoint{2, 1});
  builder.end_loop();
  const Loops triangle = builder.finish();
  const Region r = union_(triangle, loops({box(0, -1, 1, 1)}));
  REQUIRE(rounding_conflicts(r).size() == 1);
  CHECK(rounding_conflicts(r).front().kind == SelfMeetingKind::vertex_on_edge);
  CHECK(rounding_conflicts(fill(triangle)).empty());
}

// Catches: bridges that miss what they should see, and polygons that are merged or split wrongly.
TEST_CASE("polygons are one loop with bridges and back, and touch one another in points",
          "[planar][bridges][property]") {
  const auto seed = GENERATE(range(0u, seeds(300)));
  CAPTURE(seed);
  Random random(seed);
  std::vector<Loop> frames = random_grid_loops(random, 9);
  frames.push_back(box(-1, -1, 10, 10));
  const Loops all = seed % 3 == 0 ? in_thirds(frames) : loops(frames);
  const Region r = fill({all, FillRule::even_odd});
  std::vector<Region> polygons;
  for (std::uint32_t p = 0; p < r.polygons(); ++p) {
    polygons.push_back(polygon_of(r, p));
    const Loops one = bridged(r, p);
    CHECK(one.size() == 1);
    CHECK(canonical_form(fill({one, FillRule::even_odd})) == canonical_form(polygons.back()));
    for (const SelfMeeting& m : self_intersections(one)) CHECK(m.kind != SelfMeetingKind::edges_crossing);
  }
  for (std::size_t p = 0; p < polygons.size(); ++p)
    for (std::size_t q = 0; q < p; ++q) {
      const Contact contact = contact_of(polygons[p], polygons[q]);
      CHECK(contact.relation != Relation::interfering);
      CHECK(contact.edges.empty());
    }
}

}  // namespace strata::planar
