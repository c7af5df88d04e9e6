#include <catch2/catch.hpp>

#include "strata/bsp.h"
#include "strata/query.h"
#include "support/random.h"
#include "support/rounds.h"
#include "support/touching.h"

namespace strata::bsp {

TEST_CASE("trees locate points as local origins do, faces included", "[bsp][property]") {
  std::uint64_t on = 0;
  const std::uint64_t rounds = test::rounds(100);
  for (std::uint64_t seed = 0; seed < rounds; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    std::vector<ExactMesh> solids;
    for (int k = random.between(1, 3); k > 0; --k) solids.push_back({test::lattice_solid(random), {}});
    const Scene scene(solids);
    const Locator usual(scene);
    const PartitionLocator trees(scene);
    for (int k = 0; k < 100; ++k) {
      Vertex q{};
      for (double& x : q) x = random.between(-1, 9) * 0.5;
      const Location a = usual.locate(q), b = trees.locate(q);
      CHECK(a.windings == b.windings);
      CHECK(a.contacts == b.contacts);
      on += a.where() == Where::on ? 1 : 0;
    }
  }
  CHECK(on > 2 * rounds);
}

}  // namespace strata::bsp
