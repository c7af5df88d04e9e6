#include <algorithm>
#include <catch2/catch.hpp>

#include "convex/decomposition_check.h"
#include "strata/convex.h"
#include "support/rounds.h"
#include "support/shapes.h"
#include "support/touching.h"

namespace strata::test {
namespace {

using convex::Mark;
using convex::VolumeComplex;

VolumeComplex volumes_of(const Solid& solid) { return convex::volumes_of(solid, convex::decompose(solid)); }

/// The signed volume that the shells of a volume bound, seen from inside it: negative for the outside.
Rational measure(const VolumeComplex& complex, std::uint32_t v) {
  Rational sum = 0;
  const Positions at = positions_of(complex.points, complex.exact);
  for (const convex::Shell& shell : complex.volumes[v].shells)
    for (const std::uint32_t i : shell) {
      const convex::Interface& face = complex.interfaces[i];
      const Rational cone = dot(area_vector(at, face.polygon), at[face.polygon[0]]) / 6;
      sum += face.volumes[0] == v ? cone : -cone;
    }
  return sum;
}

}  // namespace

TEST_CASE("a box is one selected volume in the outside", "[convex]") {
  const VolumeComplex c = volumes_of(Solid(box({0, 0, 0}, {1, 2, 3})));
  REQUIRE(c.volumes.size() == 2);
  CHECK(c.volumes[0].mark == Mark::outer);
  CHECK(c.volumes[0].neighbours == std::vector<std::uint32_t>{1});
  CHECK(c.volumes[1].mark == Mark::piece);
  CHECK(c.volumes[1].shells.size() == 1);
  CHECK(c.interfaces.size() == 12);
  CHECK(measure(c, 1) == 6);
  CHECK(measure(c, 0) == -6);
  CHECK(volumes_of(Solid()).volumes.size() == 1);
}

TEST_CASE("boxes in cavities of boxes: every cavity has what floats in it", "[convex]") {
  const auto cube = [](double r) { return Solid(box({-r, -r, -r}, {r, r, r})); };
  const Solid nested = (cube(8) - cube(7)) | (cube(6) - cube(5)) | cube(4) | Solid(box({20, 0, 0}, {21, 1, 1}));
  const VolumeComplex c = volumes_of(nested);
  CHECK(c.first_piece == 3);
  CHECK(c.volumes[0].shells.size() == 2);  // the largest box, the one beside it
  CHECK(measure(c, 0) == -16 * 16 * 16 - 1);
  std::vector<Rational> cavities;
  for (const std::uint32_t v : {1U, 2U}) {
    CHECK(c.volumes[v].mark == Mark::cavity);
    CHECK(c.volumes[v].shells.size() == 2);
    cavities.push_back(measure(c, v));
  }
  std::sort(cavities.begin(), cavities.end());
  CHECK(cavities[0] == 10 * 10 * 10 - 8 * 8 * 8);
  CHECK(cavities[1] == 14 * 14 * 14 - 12 * 12 * 12);
}

TEST_CASE("all volumes together are nothing, and pieces are the solid", "[convex][property]") {
  for (std::uint64_t seed = 0; seed < rounds(100); ++seed) {
    CAPTURE(seed);
    const Operands pair = touching_pair(seed);
    const Solid solid = Solid(pair.meshes[0]) ^ Solid(pair.meshes[1]);
    const VolumeComplex c = volumes_of(solid);
    Rational all = 0, selected = 0;
    for (std::uint32_t v = 0; v < c.volumes.size(); ++v) {
      const Rational m = measure(c, v);
      all += m;
      if (c.volumes[v].mark == Mark::piece) selected += m;
      if (v > 0) CHECK(m > 0);
    }
    CHECK(all == 0);
    CHECK(selected == solid.volume());
  }
}

}  // namespace strata::test
