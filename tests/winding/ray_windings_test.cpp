#include "core/winding/ray_windings.h"

#include <catch2/catch.hpp>

#include "core/kernel/predicates.h"
#include "core/overlap/candidates.h"
#include "core/winding/local_windings.h"
#include "support/append.h"
#include "support/random.h"
#include "support/shapes.h"

using namespace strata;

namespace {

/// Boxes, octahedra and balls with small integers as coordinates of many vertices, one mesh.
Mesh random_pile(test::Random& random) {
  Mesh pile;
  const auto at = [&] { return static_cast<double>(random.between(0, 6)); };
  for (int n = 0; n < 6; ++n) {
    const Vertex p{at(), at(), at()};
    const double size = random.between(1, 3);
    const Mesh part = n % 3 == 0   ? test::box(p, {p[0] + size, p[1] + size, p[2] + size})
                      : n % 3 == 1 ? test::octahedron(p, size)
                                   : test::icosphere(p, size, 1);
    test::append(pile, part);
  }
  return pile;
}

}  // namespace

TEST_CASE("rays and local origins tell the same winding numbers above faces", "[winding][property]") {
  test::Random random(9);
  for (int round = 0; round < 40; ++round) {
    const Mesh pile = random_pile(random);
    InputComplex complex(SelfIntersections::possible);
    complex.add(pile.vertices, pile.triangles);
    const Candidates candidates = find_candidates(std::move(complex), {});
    const InputComplex& input = candidates.input();
    const LocalWindings local(input, candidates.cells());
    std::vector<std::uint32_t> asked;
    for (std::uint32_t f = 0; f < input.face_count(); ++f)
      if (random.once_in(2)) asked.push_back(f);
    const RayWindings rays(input, asked);  // points of the other faces take longer
    for (std::uint32_t f = 0; f < input.face_count(); ++f) {
      const Point q = make_point(input, SymbolicPoint::weighted(f, 1 + static_cast<std::uint32_t>(random.below(1000))));
      std::vector<std::uint32_t> covering;  // coplanar faces that may contain q; the others must not
      bool is_general = true;
      for (std::uint32_t g = 0; g < input.face_count(); ++g) {
        if (g != f && side_of_face(input, g, q) == Sign::zero) is_general = false;
      }
      covering.push_back(f);
      if (is_general) REQUIRE(rays.above(f, q, covering) == local.above(f, q, covering));
    }
  }
}

TEST_CASE("coincident faces that cover a point count on the side where the ray starts", "[winding]") {
  // Three times the same box, once reversed: just outside 0, inside 1.
  const Mesh one = test::box({0, 0, 0}, {2, 2, 2});
  Mesh three = one;
  for (int n = 1; n < 3; ++n)
    for (Triangle t : one.triangles) {
      if (n == 2) std::swap(t[1], t[2]);
      three.triangles.push_back(t);
    }
  InputComplex input(SelfIntersections::possible);
  input.add(three.vertices, three.triangles);
  const RayWindings rays(input, {});
  for (std::uint32_t f = 0; f < 36; ++f) {
    const std::array<std::uint32_t, 3> covering{f % 12, f % 12 + 12, f % 12 + 24};
    const Point q = make_point(input, SymbolicPoint::weighted(f, 1));
    CHECK(rays.above(f, q, covering)[0] == (f < 24 ? 0 : 1));
    CHECK(rays.around(q, 0)[0] == 0);
  }
}
