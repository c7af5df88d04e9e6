#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "oracle/comparison.h"

namespace strata::oracle {
namespace {

/// Compares all engines with CGAL on the operands of these seeds.
void compare_all(const std::string& title, SeedRange range, test::Operands (*operands)(std::uint64_t)) {
  std::vector<Compared> engines = all_engines();
  for (std::uint64_t seed = range.first; seed < range.last; ++seed) compare_with_nef(operands(seed), seed, engines);
  for (const auto& [name, engine, tally] : engines) {
    print(title + ' ' + std::to_string(range.first) + '-' + std::to_string(range.last) + " by " + name, tally);
    CHECK(tally.oracle_failed * 100 <= tally.equal + tally.different + tally.oracle_failed);
  }
}

void compare_pairs(SeedRange range) { compare_all("touching pairs", range, test::touching_pair); }
void compare_several(SeedRange range) { compare_all("several operands", range, test::touching_operands); }

}  // namespace

// Catches: any degenerate contact that is resolved wrongly, dangling faces, internal walls, lost or doubled pieces.
TEST_CASE("300 touching pairs give what Nef polyhedra give, by every engine", "[oracle][touching][pairs]") {
  compare_pairs(seeds({0, 300}));
}

TEST_CASE("1700 more touching pairs give what Nef polyhedra give, by every engine", "[oracle][touching][pairs][slow]") {
  compare_pairs(seeds({300, 2000}));
}

// Catches: planes of three operands through one point, winding vectors mixed up between operands.
TEST_CASE("60 sets of several touching operands give what Nef polyhedra give, by every engine",
          "[oracle][touching][several]") {
  compare_several(seeds({0, 60}));
}

TEST_CASE("240 more sets of several touching operands give what Nef polyhedra give, by every engine",
          "[oracle][touching][several][slow]") {
  compare_several(seeds({60, 300}));
}

}  // namespace strata::oracle
