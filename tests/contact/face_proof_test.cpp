#include "extensions/contact/face_proof.h"

#include <catch2/catch.hpp>

#include "core/overlap/meeting.h"

namespace strata::contact {
namespace {

using Corners = std::array<Vertex, 3>;

/// Faces that must be alone for a face in the plane z = 0, seen from above, and another one to prove interference,
/// whichever of them comes first; nothing if they do not.
std::optional<SoleFaces> proof(const Corners& g) {
  const std::vector<Vertex> points[] = {{{-4, -4, 0}, {8, -4, 0}, {-4, 8, 0}}, {g[0], g[1], g[2]}};
  const std::vector<Triangle> face{{0, 1, 2}};
  const auto sole = [&](std::size_t first) {
    InputComplex input;
    input.add(points[first], face);
    input.add(points[1 - first], face);
    const FilteredFace one(input, 0), other(input, 1);
    PairIntersections intersections;
    REQUIRE(meet_faces(input, one, other, intersections));
    return prove_interference(input, one, other, intersections);
  };
  const std::optional<SoleFaces> found = sole(0), turned = sole(1);
  REQUIRE(found.has_value() == turned.has_value());
  if (found) CHECK(*turned == SoleFaces{found->second, found->first, found->either});
  return found;
}
bool prove(const Corners& g) { return proof(g).has_value(); }

// The long side of the face in z = 0 goes from (8, -4) to (-4, 8). Catches: hanging taken for standing.
TEST_CASE("a face that reaches below another inside of it proves interference", "[contact][degenerate]") {
  CHECK(prove({{{0, 0, -1}, {1, 0, 1}, {0, 1, 1}}}));  // crosses
  CHECK(prove({{{0, 0, 0}, {2, 1, 0}, {1, 1, -3}}}));  // hangs by an edge
  CHECK(prove({{{2, 1, 0}, {0, 0, 0}, {1, 1, -3}}}));
  CHECK(prove({{{0, 0, 0}, {9, 0, 0}, {1, 1, -3}}}));       // by an edge that goes beyond
  CHECK_FALSE(prove({{{0, 0, 0}, {2, 1, 0}, {1, 1, 3}}}));  // stands upon an edge
  CHECK_FALSE(prove({{{2, 1, 0}, {0, 0, 0}, {1, 1, 3}}}));
}

TEST_CASE("a face that reaches below another along an edge of it, or in a point, proves nothing",
          "[contact][degenerate]") {
  CHECK_FALSE(prove({{{-2, -4, 0}, {2, -4, 0}, {0, -4, -3}}}));  // along an edge of both
  CHECK_FALSE(prove({{{-2, -4, 0}, {2, -4, 0}, {0, -3, -3}}}));
  CHECK_FALSE(prove({{{2, -4, 0}, {-2, -4, 0}, {0, -3, -3}}}));
  CHECK_FALSE(prove({{{-2, -4, 0}, {2, -4, 0}, {0, -5, 3}}}));
  CHECK_FALSE(prove({{{0, 0, 0}, {1, 0, -1}, {0, 1, -1}}}));  // in a point
  CHECK_FALSE(prove({{{-9, -4, 0}, {-4, -4, 0}, {0, -4, -3}}}));
}

TEST_CASE("coplanar faces prove interference where they share an area and look the same way", "[contact]") {
  CHECK(prove({{{0, 0, 0}, {9, 0, 0}, {0, 9, 0}}}));
  CHECK_FALSE(prove({{{0, 0, 0}, {0, 9, 0}, {9, 0, 0}}}));
  CHECK(prove({{{-4, -4, 0}, {8, -4, 0}, {-4, 8, 0}}}));
  CHECK_FALSE(prove({{{-4, -4, 0}, {0, -9, 0}, {8, -4, 0}}}));  // an edge in common
  CHECK_FALSE(prove({{{2, 2, 0}, {9, 9, 0}, {2, 9, 0}}}));      // a vertex on an edge
}

TEST_CASE("the part of a face that another one reaches below must have no other face there", "[contact]") {
  CHECK(proof({{{0, 0, -1}, {1, 0, 1}, {0, 1, 1}}}) == SoleFaces{true, true, true});    // crosses: either
  CHECK(proof({{{0, 0, 0}, {2, 1, 0}, {1, 1, -3}}}) == SoleFaces{true, false, false});  // hangs by an edge: the upper
  CHECK(proof({{{0, 0, 0}, {9, 0, 0}, {0, 9, 0}}}) == SoleFaces{true, true, false});    // coplanar: both
}

}  // namespace
}  // namespace strata::contact
