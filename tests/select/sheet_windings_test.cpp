#include "core/select/sheet_windings.h"

#include <catch2/catch.hpp>

#include "core/overlap/intersect.h"
#include "core/overlap/self_intersections.h"
#include "core/winding/ray_windings.h"
#include "support/random.h"
#include "support/shapes.h"

using namespace strata;

namespace {

/// Octahedra with small integers as coordinates, one mesh: corners of some are on faces and edges of others.
Mesh random_pile(test::Random& random) {
  Mesh pile;
  const auto at = [&] { return static_cast<double>(random.between(0, 6)); };
  for (int n = 0; n < 8; ++n) {
    const Mesh part = test::octahedron({at(), at(), at()}, random.between(1, 4));
    const auto first = static_cast<std::uint32_t>(pile.vertices.size());
    pile.vertices.insert(pile.vertices.end(), part.vertices.begin(), part.vertices.end());
    for (const Triangle& t : part.triangles) {
      const std::size_t k = random.below(3);  // any corner may be the last
      pile.triangles.push_back({t[k] + first, t[(k + 1) % 3] + first, t[(k + 2) % 3] + first});
    }
  }
  return pile;
}

}  // namespace

TEST_CASE("faces with constraints have the winding number of a patch at free corners", "[select][property]") {
  test::Random random(21);
  int compared = 0;
  for (int round = 0; round < 200; ++round) {
    const Mesh pile = random_pile(random);
    const InputComplex input = complex_of(pile);
    const EmbeddedStars stars(input, {});
    std::vector<PairIntersections> met;
    std::vector<bool> crossing(input.face_count(), false);
    for (const SelfIntersection& s : find_self_intersections(input, &stars, {}, SelfIntersectionSearch::all, &met))
      crossing[s.face] = crossing[s.other] = true;
    const Intersections intersections = intersect(input, met, {});
    const Shells patches = find_patches(input, stars, crossing);
    Sheets sheets(input, stars, patches, intersections.constraints);
    const RayWindings rays(input, sheets.asked(input));
    const SheetWindings windings(input, std::move(sheets), rays, {});

    for (std::uint32_t f = 0; f < input.face_count(); ++f) {
      const std::uint32_t vertex = input.face(f)[2];
      if (!windings.sheets().is_free(vertex) || !windings.above_vertex(vertex)) continue;
      const Point near = make_point(input, SymbolicPoint::weighted(f, SymbolicPoint::weight_limit));
      CHECK(rays.above(f, near, {&f, 1})[0] == *windings.above_vertex(vertex));
      compared += windings.sheets().is_subdivided(f) ? 1 : 0;
    }
  }
  CHECK(compared > 1000);
}
