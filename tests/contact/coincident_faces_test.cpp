#include "extensions/contact/coincident_faces.h"

#include <catch2/catch.hpp>

#include "contact/parts.h"

namespace strata::contact {
namespace {

/// A tetrahedron below the triangle (0, 0), (8, 0), (0, 8), and one above it beside another that has the corner (0, 0)
/// in common with it, by number, and two more.
Parts parts_with(const Vertex& v, const Vertex& w) {
  const Mesh below{{{0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {1, 1, -8}}, {{0, 1, 2}, {0, 2, 3}, {2, 1, 3}, {1, 0, 3}}};
  Mesh above{{{0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {1, 1, 8}, v, w, {-4, -4, -4}},
             {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  for (const Triangle& t : {Triangle{0, 4, 5}, Triangle{0, 5, 6}, Triangle{0, 6, 4}, Triangle{5, 4, 6}})
    above.triangles.push_back(t);
  const Solid both[] = {Solid(below, InputClass::solid), Solid(above, InputClass::solid)};
  return Parts(both);
}

TEST_CASE("twins tell of neighbours that have corners in common with them and nothing else", "[contact]") {
  const auto tell = [](const Vertex& v, const Vertex& w) {
    const Parts parts = parts_with(v, w);
    const Twins coincident(parts, 0, 1);
    REQUIRE(coincident.pairs().size() == 1);
    CHECK_FALSE(coincident.pairs()[0].look_the_same_way);
    CHECK(coincident.tell(0, 4));                                             // themselves
    for (const std::uint32_t g : {5u, 6u, 7u}) CHECK(coincident.tell(0, g));  // faces of the same tetrahedron
    return coincident.tell(0, 8);
  };
  CHECK(tell({-3, -1, 2}, {-1, -3, 2}));
  CHECK(tell({-3, -1, 0}, {-1, -3, 0}));       // in its plane
  CHECK_FALSE(tell({1, 1, 0}, {-1, -3, -2}));  // with a vertex inside of it
  CHECK_FALSE(tell({1, 1, 0}, {3, 1, -2}));    // with an edge inside of it
  CHECK_FALSE(tell({4, 0, 0}, {1, -3, -2}));   // with a vertex on an edge
  CHECK_FALSE(tell({9, 9, 0}, {3, 1, -2}));    // with a part of an edge inside of it
  CHECK_FALSE(tell({1, 1, -2}, {1, 2, 3}));    // through it
}

}  // namespace
}  // namespace strata::contact
