#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <iostream>

#include "oracle/comparison.h"
#include "oracle/isolated.h"
#include "oracle/nef.h"
#include "strata/convex.h"
#include "strata/io.h"
#include "support/shapes.h"
#include "support/touching.h"
#include "support/transform.h"

// Sums beside CGAL::minkowski_sum_3, which decomposes both operands: no mathematics in common.
namespace strata::oracle {
namespace {

/// CGAL's union of the sums of all pairs of convex pieces.
NefSolid union_of_pairs(const Solid& a, const Solid& b) {
  const convex::Decomposition of_a = convex::decompose(a), of_b = convex::decompose(b);
  std::vector<NefSolid> sums;
  for (std::uint32_t i = 0; i < of_a.pieces.size(); ++i)
    for (std::uint32_t j = 0; j < of_b.pieces.size(); ++j)
      sums.emplace_back(convex::solid_of(convex::sum(of_a.polytope(i), of_b.polytope(j))).exact_mesh());
  return nef_combine(Operation::union_, sums, Way::in_order);
}

/// Compares one sum; CGAL may be slow or crash, which is counted and never taken for an answer. CGAL 5.5 contradicts
/// itself in one sum of random solids that touch themselves out of seventy: there its Booleans decide.
void compare_sum(const Solid& a, const Solid& b, unsigned seconds, Tally& tally) {
  const std::string found = convex::minkowski_sum(a, b).canonical().text();
  const auto is_equal = [&](const auto& way) {
    return found == in_child([&] { return canonical_form(way().facets()).text(); }, seconds);
  };
  try {
    bool equal = is_equal([&] { return nef_minkowski_sum(NefSolid(a.exact_mesh()), NefSolid(b.exact_mesh())); });
    if (!equal) {
      equal = is_equal([&] { return union_of_pairs(a, b); });
      if (equal) std::cout << "oracle: CGAL's sum is not its union of the sums of pieces\n";
    }
    CHECK(equal);
    ++(equal ? tally.equal : tally.different);
  } catch (const OracleFailed& e) {
    std::cout << "oracle: " << e.what() << '\n';
    ++tally.oracle_failed;
  }
}

void compare_seeds(SeedRange range) {
  Tally tally;
  for (std::uint64_t seed = range.first; seed < range.last; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    const Solid a{test::lattice_solid(random)}, b{test::lattice_solid(random)};
    compare_sum(a, b, 20, tally);
  }
  print("Minkowski sums " + std::to_string(range.first) + "-" + std::to_string(range.last), tally);
  CHECK(tally.equal > tally.oracle_failed);
}

}  // namespace

// Catches: what the library's own sums of pieces have in common with its general sums.
TEST_CASE("40 sums of random solids are what Nef polyhedra give", "[oracle][minkowski]") {
  compare_seeds(seeds({0, 40}));
}

TEST_CASE("400 more sums of random solids are what Nef polyhedra give", "[oracle][minkowski][slow]") {
  compare_seeds(seeds({40, 440}));
}

TEST_CASE("sums of CGAL's examples are what Nef polyhedra give", "[oracle][minkowski]") {
  const char* corpus = std::getenv("STRATA_CORPUS");
  if (corpus == nullptr) {
    std::cout << "SKIPPED: sums of CGAL's examples (STRATA_CORPUS is not set)\n";
    return;
  }
  const std::filesystem::path folder = std::filesystem::path(corpus) / "csg/cgal-tests/Nef_3";
  std::vector<Solid> solids{Solid(test::box({0, 0, 0}, {1, 1, 1}))};
  for (const char* name : {"test/Nef_3/data/star.off", "test/Nef_3/data/icosahedron.off",
                           "archive/Visual_hull/Nef_3/hole.off", "archive/Visual_hull/Nef_3/corner.off"})
    solids.emplace_back(read_mesh(folder / name).mesh, InputClass::repair);
  Tally tally;
  for (std::size_t i = 0; i < solids.size(); ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      CAPTURE(i, j);
      compare_sum(solids[i], solids[j], 40, tally);
    }
  print("Minkowski sums of examples", tally);
}

}  // namespace strata::oracle
