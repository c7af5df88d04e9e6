#include "extensions/contact/region.h"

#include <catch2/catch.hpp>

#include "contact/parts.h"
#include "support/touching.h"

namespace strata::contact {
namespace {

using namespace test_parts;
using Counts = std::vector<std::size_t>;

TEST_CASE("boxes touch in a rectangle, a segment, a point: exactly", "[contact]") {
  const Solid a = box({0, 0, 0}, {2, 3, 4});
  const ContactRegion face = region(a, box({2, 1, 1}, {3, 5, 2}));
  REQUIRE(counts(face) == Counts{1, 0, 0});
  CHECK(face.facets[0].squared_area == 4);
  CHECK(face.area() == 2);
  CHECK(face.facets[0].area_vector == RationalPoint{2, 0, 0});
  CHECK(face.facets[0].loops == std::vector<std::vector<std::uint32_t>>{{0, 2, 3, 1}});
  const ContactRegion edge = region(a, box({2, 3, -7}, {5, 5, 1}));
  REQUIRE(counts(edge) == Counts{0, 1, 0});
  CHECK(edge.edges[0].squared_length == 1);
  CHECK(edge.points == std::vector<RationalPoint>{{2, 3, 0}, {2, 3, 1}});
  const ContactRegion vertex = region(a, box({2, 3, 4}, {5, 5, 5}));
  REQUIRE(counts(vertex) == Counts{0, 0, 1});
  CHECK(vertex.points == std::vector<RationalPoint>{{2, 3, 4}});
}

TEST_CASE("sides of facets are seen from outside of the first part", "[contact]") {
  const Solid a = box({0, 0, 0}, {1, 1, 1}), b = box({1, 0, 0}, {2, 1, 1});
  CHECK(region(a, b).facets[0].area_vector == RationalPoint{1, 0, 0});
  CHECK(region(b, a).facets[0].area_vector == RationalPoint{-1, 0, 0});
}

TEST_CASE("facets do not depend on triangles", "[contact]") {
  const Solid fine(test::cube_grid(6)), plate = box({0.5, 0.25, 6}, {5.75, 4, 7});
  const ContactRegion r = region(fine, plate);
  REQUIRE(counts(r) == Counts{1, 0, 0});
  CHECK(r.facets[0].loops[0].size() == 4);
  CHECK(r.area() == 5.25 * 3.75);
  CHECK(counts(region(fine, Solid(test::translated(test::cube_grid(6), {6, 0, 0})))) == Counts{1, 0, 0});
  CHECK(region(fine, Solid(test::translated(test::cube_grid(6), {6, 0.5, 0.25}))).area() == 5.5 * 5.75);
}

TEST_CASE("a contact has a hole where a part has one", "[contact]") {
  const Solid ring(test::box_with_hole());  // [0, 3]^2 x [0, 1], the middle cell is missing
  const ContactRegion r = region(ring, box({-1, -1, 1}, {4, 4, 2}));
  REQUIRE(counts(r) == Counts{1, 0, 0});
  CHECK(r.facets[0].loops.size() == 2);
  CHECK(r.area() == 8);
  SECTION("with an island in it") {
    const Mesh both[] = {test::box_with_hole(), test::box({1.25, 1.25, 0}, {1.75, 1.75, 1})};
    const ContactRegion two = region(Solid(test::merged(both)), box({-1, -1, 1}, {4, 4, 2}));
    REQUIRE(counts(two) == Counts{2, 0, 0});
    CHECK(two.area() == 8.25);
    CHECK(two.facets[0].loops.size() + two.facets[1].loops.size() == 3);
  }
}

TEST_CASE("edges cross edges in points and lie in faces in segments", "[contact]") {
  const Solid below(test::tetrahedron({-1, 0, 0}, {1, 0, 0}, {0, 1, -1}, {0, -1, -1}));  // its edge is on top
  const Solid above(test::tetrahedron({0, -1, 0}, {0, 1, 0}, {1, 0, 1}, {-1, 0, 1}));
  const ContactRegion cross = region(below, above);
  REQUIRE(counts(cross) == Counts{0, 0, 1});
  CHECK(cross.points[0] == RationalPoint{0, 0, 0});
  const ContactRegion lying = region(box({-0.5, -2, -1}, {3, 2, 0}), above);
  REQUIRE(counts(lying) == Counts{0, 1, 0});
  CHECK(lying.edges[0].squared_length == 4);
  const ContactRegion collinear = region(below, Solid(test::tetrahedron({0, 0, 0}, {3, 0, 0}, {1, 1, 1}, {1, -1, 1})));
  REQUIRE(counts(collinear) == Counts{0, 1, 0});
  CHECK(collinear.edges[0].squared_length == 1);
}

TEST_CASE("vertices touch faces, edges and vertices", "[contact]") {
  const std::array<double, 2> square[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const Solid tip(test::pyramid(square, 1, {0.5, 0.25, 0}));  // points down
  for (const Vertex& corner : {Vertex{0, 0, 0}, Vertex{0.5, 0, 0}, Vertex{0.5, 0.25, 0}}) {
    const Solid a = box({corner[0] - 2, corner[1] - 2, -1}, corner);
    CAPTURE(corner[0], corner[1]);
    const bool touches = corner[0] >= 0.5 && corner[1] >= 0.25;
    CHECK(counts(region(a, tip)) == Counts{0, 0, touches ? 1u : 0u});
  }
  CHECK(counts(region(box({-1, -1, -1}, {2, 2, 0}), tip)) == Counts{0, 0, 1});
}

// Catches: edges and points told again that a facet has already; pieces of an edge told apart.
TEST_CASE("what facets bound is not told again", "[contact]") {
  // A step over a step: two facets, and an edge that runs on beyond one of them.
  const Solid a = box({0, 0, 0}, {1, 1, 1});
  const Mesh both[] = {test::box({1, 0, 0}, {2, 0.5, 1}), test::box({1, 1, -1}, {2, 2, 2})};
  const ContactRegion r = region(a, Solid(test::merged(both)));
  REQUIRE(counts(r) == Counts{1, 1, 0});
  CHECK(r.area() == 0.5);
  CHECK(r.edges[0].squared_length == 1);
}

TEST_CASE("parts that touch themselves have contacts in which nothing is told twice", "[contact]") {
  const Solid edges(test::edge_sharing_cells());
  const ContactRegion r = region(edges, box({-3, -3, 1}, {4, 4, 2}));
  REQUIRE(r.edges.empty());
  CHECK(r.vertices.empty());
  CHECK(r.area() == 2);
  // Two cells that share an edge by place but not by number, with T-junctions.
  const Mesh both[] = {test::box({0, 0, 0}, {1, 1, 1}), test::box({1, 1, -1}, {2, 2, 0.5})};
  const ContactRegion self = region(Solid(test::merged(both)), box({1, 0, 0}, {2, 1, 1}));
  CHECK(counts(self) == Counts{2, 0, 0});
  CHECK(self.area() == 1.5);
}

// Catches: points of one component that are told beside an edge or a facet of another one which they lie on.
TEST_CASE("a tip in the middle of an edge or a side of a contact is not told", "[contact]") {
  const Solid a = box({0, 0, 0}, {1, 1, 1});
  const Mesh tip = test::tetrahedron({1, 1, 0.5}, {2, 0.25, 0.375}, {2, 0.25, 0.625}, {2, 0.5, 0.5});
  const Mesh beside_edge[] = {test::box({1, 1, 0}, {2, 2, 1}), tip};
  CHECK(counts(region(a, Solid(test::merged(beside_edge)))) == Counts{0, 1, 0});
  const Mesh beside_side[] = {test::box({0, 1, 0}, {1, 2, 1}), tip};
  CHECK(counts(region(a, Solid(test::merged(beside_side)))) == Counts{1, 0, 0});
  CHECK(counts(region(a, Solid(tip))) == Counts{0, 0, 1});
}

// Catches: sides of facets that are not taken from edges with other ends.
TEST_CASE("an edge of one component on a side of another's facet is not told", "[contact]") {
  const Mesh both[] = {test::box({1, 0, 0}, {2, 1, 1}), test::box({1, 1, 0.25}, {2, 2, 1.75})};
  const ContactRegion r = region(box({0, 0, 0}, {1, 1, 1}), Solid(test::merged(both)));
  CHECK(counts(r) == Counts{1, 0, 0});
  const ContactRegion beyond = region(box({0, 0, 0}, {1, 1, 1.5}), Solid(test::merged(both)));
  REQUIRE(counts(beyond) == Counts{1, 1, 0});
  CHECK(beyond.edges[0].squared_length == Rational(1) / 4);
}

// Catches: a hole that is given to a facet around the one that has it.
TEST_CASE("rings within rings have holes of their own", "[contact]") {
  const Mesh rings[] = {test::scaled(test::box_with_hole(), 3),
                        test::translated(test::box_with_hole(), {10.5, 10.5, 0})};
  const ContactRegion r = region(Solid(test::merged(rings)), box({-1, -1, -1}, {30, 30, 0}));
  REQUIRE(counts(r) == Counts{2, 0, 0});
  CHECK(r.facets[0].loops.size() == 2);
  CHECK(r.facets[1].loops.size() == 2);
  CHECK(std::min(r.facets[0].area, r.facets[1].area) == 8);
  CHECK(std::max(r.facets[0].area, r.facets[1].area) == 512);
}

TEST_CASE("rational parts touch where they do exactly", "[contact]") {
  const Rational third = Rational(1) / 3;
  const Solid a(test::exact_box({0, 0, 0}, {third, third, third}));
  const Solid b(test::exact_box({third, 0, 0}, {1, third / 2, 1}));
  CHECK(relation(a, b) == Relation::contact);
  const ContactRegion r = region(a, b);
  REQUIRE(counts(r) == Counts{1, 0, 0});
  CHECK(r.facets[0].squared_area == Rational(1) / 324);
  CHECK(r.points[0][0] == third);
  const Rational little = Rational(1) / Integer("1000000000000000000000000000000000000000000");
  CHECK(relation(a, Solid(test::exact_box({third + little, 0, 0}, {1, 1, 1}))) == Relation::apart);
  CHECK(relation(a, Solid(test::exact_box({third - little, 0, 0}, {1, 1, 1}))) == Relation::interfering);
  CHECK(nearest(a, Solid(test::exact_box({third + little, 0, 0}, {1, 1, 1}))).squared == little * little);
}

TEST_CASE("areas and lengths are rounded last, at any scale", "[contact]") {
  for (const int exponent : {-900, 0, 900}) {
    const auto scaled = [&](const Mesh& m) { return Solid(test::scaled(m, exponent)); };
    const ContactRegion r = region(scaled(test::box({0, 0, 0}, {1, 1, 1})), scaled(test::box({1, 1, -5}, {2, 2, 5})));
    REQUIRE(counts(r) == Counts{0, 1, 0});
    CHECK(r.length() == std::ldexp(1.0, exponent));
  }
  const Solid ramp(test::tetrahedron({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}));
  const ContactRegion slanted = region(ramp, box({-1, -1, -1}, {2, 2, 2}) - ramp);
  CHECK(slanted.facets.size() == 4);
  CHECK(slanted.area() == Approx(1.5 + std::sqrt(3) / 2).epsilon(1e-15));
}

// area(A u B) = area(A) + area(B) - 2 area(contact) for solids that do not interfere: here as area vectors per plane,
// which are rational, by canonical forms.
Rational facets_in_axis_planes(const CanonicalForm& form) {
  Rational sum;
  for (const CanonicalFacets& plane : form.planes) {
    std::size_t axis = 0, zeros = 0;
    for (std::size_t i = 0; i < 3; ++i) plane.plane.coefficients[i] == 0 ? ++zeros : axis = i;
    if (zeros != 2) continue;
    Rational twice;
    for (const auto& loop : plane.loops)
      for (std::size_t k = 0; k < loop.size(); ++k) {
        const auto &p = form.vertices[loop[k]], &q = form.vertices[loop[(k + 1) % loop.size()]];
        twice += p[(axis + 1) % 3] * q[(axis + 2) % 3] - p[(axis + 2) % 3] * q[(axis + 1) % 3];
      }
    sum += abs(twice) / 2;
  }
  return sum;
}

Rational facets_in_axis_planes(const ContactRegion& region) {
  Rational sum;
  for (const ContactFacet& f : region.facets) {
    const auto& v = f.area_vector;
    if ((v[0].is_zero() + v[1].is_zero() + v[2].is_zero()) == 2) sum += abs(v[0]) + abs(v[1]) + abs(v[2]);
  }
  return sum;
}

TEST_CASE("a union has the areas of its parts without twice those of their contact", "[contact][property]") {
  std::size_t with_area = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    CAPTURE(seed);
    const test::Operands two = test::touching_pair(seed);
    const Solid a{two.meshes[0]}, b{two.meshes[1]};
    const Solid rest = b - a;  // never interferes
    if (rest.is_empty()) continue;
    CHECK(relation(a, rest) != Relation::interfering);
    const ContactRegion r = region(a, rest), turned = region(rest, a);
    with_area += !r.facets.empty();
    const Rational separate = facets_in_axis_planes(a.canonical()) + facets_in_axis_planes(rest.canonical());
    CHECK(facets_in_axis_planes((a | rest).canonical()) == separate - 2 * facets_in_axis_planes(r));
    CHECK(r.points == turned.points);
    CHECK(counts(r) == counts(turned));
    CHECK(r.vertices == turned.vertices);
    const ContactRegion again = region(Solid(test::relisted(two.meshes[0])), rest);
    CHECK(again.points == r.points);
    CHECK(counts(again) == counts(r));
  }
  CHECK(with_area > 100);
}

}  // namespace
}  // namespace strata::contact
