#include "core/select/sheet_windings.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/overlap/intersect.h"
#include "core/overlap/self_intersections.h"
#include "core/winding/ray_windings.h"
#include "support/append.h"
#include "support/random.h"
#include "support/shapes.h"

using namespace strata;

namespace {

/// Octahedra with small integers as coordinates, one mesh: corners of some are on faces and edges of others.
Mesh random_pile(test::Random& random) {
  Mesh pile;
  const auto at = [&] { return static_cast<double>(random.between(0, 6)); };
  for (int n = 0; n < 8; ++n) {
    Mesh part = test::octahedron({at(), at(), at()}, random.between(1, 4));
    for (Triangle& t : part.triangles)  // any corner may be the last
      std::rotate(t.begin(), t.begin() + static_cast<std::ptrdiff_t>(random.below(3)), t.end());
    test::append(pile, part);
  }
  return pile;
}

}  // namespace

TEST_CASE("all faces of a free vertex have one winding number there, that of a patch if one has it",
          "[select][property]") {
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

    std::vector<std::optional<std::int32_t>> above(input.vertex_count());
    for (std::uint32_t f = 0; f < input.face_count(); ++f) {
      const std::uint32_t vertex = input.face(f)[2];
      if (!windings.sheets().is_free(vertex)) continue;
      const Point near = make_point(input, SymbolicPoint::weighted(f, SymbolicPoint::weight_limit));
      const std::int32_t found = rays.above(f, near, {&f, 1})[0];
      if (!above[vertex]) above[vertex] = windings.above_vertex(vertex).value_or(found);
      CHECK(found == *above[vertex]);
      compared += windings.sheets().is_subdivided(f) ? 1 : 0;
    }
  }
  CHECK(compared > 1000);
}
