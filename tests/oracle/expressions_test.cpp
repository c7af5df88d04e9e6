#include <algorithm>
#include <catch2/catch.hpp>
#include <iostream>
#include <optional>

#include "csg/recipe_solids.h"
#include "oracle/comparison.h"
#include "oracle/isolated.h"
#include "oracle/nef.h"
#include "support/random_recipe.h"
#include "support/shapes.h"

namespace strata::oracle {
namespace {

using test::Recipe;

Operation operation_of(Recipe::Kind kind) {
  switch (kind) {
    case Recipe::Kind::union_:
      return Operation::union_;
    case Recipe::Kind::intersection:
      return Operation::intersection;
    case Recipe::Kind::difference:
      return Operation::difference;
    case Recipe::Kind::symmetric_difference:
      return Operation::symmetric_difference;
    case Recipe::Kind::solid:
    case Recipe::Kind::complement:
    case Recipe::Kind::map:
      break;
  }
  throw std::invalid_argument("no operation of two solids");
}

/// The recipe step by step. Solids that are mapped are mapped before CGAL sees them. Complements are what is left of a
/// huge box: far out everything is outside then, as it is in the bounded result. (CGAL's own complement of nothing is
/// all of space, which without vertices is taken for nothing in the next step.)
CanonicalForm nef_recipe(const Recipe& recipe, Way way) {
  const Recipe plain = without_maps(recipe);
  const NefSolid space(test::exact(test::box({-1e6, -1e6, -1e6}, {1e6, 1e6, 1e6})));
  const NefSolid result = test::value_of<NefSolid>(
      plain, [&](std::uint32_t n) { return NefSolid(plain.solids[n]); },
      [&](Recipe::Kind kind, const NefSolid& a, const NefSolid& b) {
        return nef_combine(operation_of(kind), std::vector{a, b}, way);
      },
      [&](const NefSolid& a) {
        return nef_combine(Operation::difference, std::vector{space, a}, way);
      },
      [](const NefSolid& a, const test::Affine&) { return a; });
  return canonical_form(result.facets());
}

std::optional<std::string> answer_of_cgal(const Recipe& recipe, Way way) {
  constexpr unsigned seconds = 20;
  try {
    return in_child([&] { return nef_recipe(recipe, way).text(); }, seconds);
  } catch (const OracleFailed& e) {
    std::cout << "oracle: " << e.what() << '\n';
    return std::nullopt;
  }
}

std::string answer_of_engine(const Recipe& recipe) {
  try {
    return expression_of(recipe, test::solids_of(recipe)).evaluate().canonical().text();
  } catch (const std::exception& e) {
    return std::string("thrown: ") + e.what();
  }
}

enum class Verdict { equal, different, oracle_failed };

/// As for single operations: the engine is wrong only if no way of CGAL that has an answer has the engine's.
Verdict judge(const Recipe& recipe, const std::string& found) {
  bool contradicted = false;
  for (const Way way : {Way::in_order, Way::regularized, Way::other_formula}) {
    const auto answer = answer_of_cgal(recipe, way);
    if (answer == found) return contradicted ? Verdict::oracle_failed : Verdict::equal;
    contradicted |= answer.has_value();
  }
  return contradicted ? Verdict::different : Verdict::oracle_failed;
}

void report(const Recipe& recipe, std::uint64_t seed) {
  const Recipe less =
      shrunken(recipe, [](const Recipe& r) { return judge(r, answer_of_engine(r)) == Verdict::different; });
  FAIL_CHECK("seed " << seed << "\n"
                     << text(recipe) << "\nless of it:\n"
                     << full_text(less) << "found:\n"
                     << answer_of_engine(less));
}

void compare_expressions(SeedRange range) {
  Tally tally;
  std::size_t solids = 0, deepest = 0;
  for (std::uint64_t seed = range.first; seed < range.last; ++seed) {
    const Recipe recipe = test::touching_recipe(seed, {.solids = 16, .leaves = 24});
    solids += solid_count(recipe);
    deepest = std::max(deepest, depth(recipe));
    const Verdict verdict = judge(recipe, answer_of_engine(recipe));
    if (verdict == Verdict::different) report(recipe, seed);
    if (verdict == Verdict::oracle_failed) std::cout << "oracle failed: expression of seed " << seed << '\n';
    ++(verdict == Verdict::equal ? tally.equal : verdict == Verdict::different ? tally.different : tally.oracle_failed);
  }
  print("random expressions " + std::to_string(range.first) + "-" + std::to_string(range.last) + " with " +
            std::to_string(solids) + " solids, up to " + std::to_string(deepest) + " deep",
        tally);
  CHECK(tally.oracle_failed * 100 <= tally.equal + tally.different + tally.oracle_failed);
}

}  // namespace

// Catches: what all ways of the engine have in common, complements and maps of results among them.
TEST_CASE("800 random expressions about touching solids are what Nef polyhedra give", "[oracle][expressions]") {
  compare_expressions(seeds({0, 800}));
}

TEST_CASE("2200 more random expressions are what Nef polyhedra give", "[oracle][expressions][slow]") {
  compare_expressions(seeds({800, 3000}));
}

}  // namespace strata::oracle
