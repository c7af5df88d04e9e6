#include <catch2/catch.hpp>

#include "oracle/comparison.h"

namespace strata::oracle {
namespace {

void compare_pairs(SeedRange range) {
  Tally tally;
  for (std::uint64_t seed = range.first; seed < range.last; ++seed) {
    compare_with_nef(test::touching_pair(seed), seed, tally);
  }
  print("touching pairs " + std::to_string(range.first) + "-" + std::to_string(range.last), tally);
  CHECK(tally.oracle_failed * 100 <= tally.equal + tally.different + tally.oracle_failed);
}

void compare_several(SeedRange range) {
  Tally tally;
  for (std::uint64_t seed = range.first; seed < range.last; ++seed) {
    compare_with_nef(test::touching_operands(seed), seed, tally);
  }
  print("several operands " + std::to_string(range.first) + "-" + std::to_string(range.last), tally);
  CHECK(tally.oracle_failed * 100 <= tally.equal + tally.different + tally.oracle_failed);
}

}  // namespace

// Catches: any degenerate contact that is resolved wrongly, dangling faces, internal walls, lost or doubled pieces.
TEST_CASE("300 touching pairs give what Nef polyhedra give", "[oracle][touching][pairs]") {
  compare_pairs(seeds({0, 300}));
}

TEST_CASE("1700 more touching pairs give what Nef polyhedra give", "[oracle][touching][pairs][slow]") {
  compare_pairs(seeds({300, 2000}));
}

// Catches: planes of three operands through one point, winding vectors mixed up between operands.
TEST_CASE("60 sets of several touching operands give what Nef polyhedra give", "[oracle][touching][several]") {
  compare_several(seeds({0, 60}));
}

TEST_CASE("240 more sets of several touching operands give what Nef polyhedra give",
          "[oracle][touching][several][slow]") {
  compare_several(seeds({60, 300}));
}

}  // namespace strata::oracle
