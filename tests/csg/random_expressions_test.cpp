// Large random expressions about solids that touch: one answer, whichever way it is found. The oracle room has the same
// expressions beside CGAL's.
#include <algorithm>
#include <catch2/catch.hpp>
#include <iostream>
#include <optional>

#include "csg/recipe_solids.h"
#include "strata/measure.h"
#include "support/random_recipe.h"
#include "support/rounds.h"
#include "support/shapes.h"

using namespace strata;
using test::Recipe;

namespace {

struct Tally {
  std::size_t expressions = 0, solids = 0, deepest = 0, empty = 0, facets = 0;
  std::size_t skipped_positive = 0, skipped_disjunctive = 0;

  void add(const Recipe& recipe, const CanonicalForm& result) {
    ++expressions;
    solids += solid_count(recipe);
    deepest = std::max(deepest, depth(recipe));
    empty += result.planes.empty();
    facets += result.facet_count();
  }
};

std::ostream& operator<<(std::ostream& out, const Tally& t) {
  return out << t.expressions << " expressions with " << t.solids << " solids, up to " << t.deepest
             << " deep; results: " << t.facets << " facets, " << t.empty << " empty; too large: " << t.skipped_positive
             << " positive and " << t.skipped_disjunctive << " disjunctive forms";
}

/// Nothing if the form would be larger than that.
template <class Form>
std::optional<CanonicalForm> canonical_of(const Form& form) {
  try {
    return form().evaluate().canonical();
  } catch (const std::length_error&) {
    return std::nullopt;
  }
}

/// What is wrong with the ways to evaluate the recipe; empty if they agree.
std::string disagreement(const Recipe& recipe, Tally* tally = nullptr) {
  constexpr std::size_t most = 2000;
  const auto solids = solids_of(recipe);
  const Expression expression = expression_of(recipe, solids);
  const Solid result = expression.evaluate();
  const CanonicalForm at_once = result.canonical();
  if (tally != nullptr) tally->add(recipe, at_once);
  if (topology(result.exact_mesh()).open_edges != 0) return "the boundary is open";
  if (!(by_steps(recipe, solids).canonical() == at_once)) return "steps give something else";
  const auto positive = canonical_of([&] { return expression.positive_form(most); });
  if (positive && !(*positive == at_once)) return "the positive form is something else";
  const auto disjunctive = canonical_of([&] { return expression.disjunctive_form(most); });
  if (disjunctive && !(*disjunctive == at_once)) return "the disjunctive form is something else";
  if (tally != nullptr) {
    tally->skipped_positive += !positive;
    tally->skipped_disjunctive += !disjunctive;
  }
  return {};
}

std::string thrown_or_disagreement(const Recipe& recipe, Tally* tally = nullptr) {
  try {
    return disagreement(recipe, tally);
  } catch (const std::exception& e) {
    return std::string("thrown: ") + e.what();
  }
}

/// The six tetrahedra of every cube of a grid; what is outside the grid is all in or all out.
struct Flags {
  std::vector<bool> inside;
  bool outside = false;
};

constexpr std::array<int, 3> kuhn_size{2, 2, 2};
constexpr std::size_t kuhn_count = 6 * 8;

Flags joined(Recipe::Kind kind, const Flags& a, const Flags& b) {
  const auto of_two = [&](bool p, bool q) {
    if (kind == Recipe::Kind::union_) return p || q;
    if (kind == Recipe::Kind::symmetric_difference) return p != q;
    return p && q != (kind == Recipe::Kind::difference);
  };
  Flags result{std::vector<bool>(kuhn_count), of_two(a.outside, b.outside)};
  for (std::size_t i = 0; i < kuhn_count; ++i) result.inside[i] = of_two(a.inside[i], b.inside[i]);
  return result;
}

std::vector<bool> random_flags(test::Random& random) {
  std::vector<bool> flags(kuhn_count, false);
  const bool whole_cubes = random.once_in(3);
  const auto one_in = 2 + random.below(3);
  for (std::size_t i = 0; i < kuhn_count; ++i)
    flags[i] = whole_cubes && i % 6 != 0 ? flags[i - 1] : random.once_in(one_in);
  if (std::find(flags.begin(), flags.end(), true) == flags.end()) flags.front() = true;
  return flags;
}

const test::Affine identity{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}}}};

/// The expression's answer in flags.
std::vector<bool> known_answer(const Recipe& recipe, const std::vector<std::vector<bool>>& flags) {
  const Flags answer = test::value_of<Flags>(
      recipe, [&](std::uint32_t n) { return Flags{flags[n]}; }, joined,
      [](Flags f) {
        f.inside.flip();
        f.outside = !f.outside;
        return f;
      },
      [](const Flags& f, const test::Affine&) { return f; });
  return answer.inside;
}

}  // namespace

// Catches: rules that judge otherwise than steps, copies of solids taken for one another, forms that are not equal,
// walls and holes in arrangements of many solids that touch in all ways.
TEST_CASE("random expressions about touching solids have one answer in four ways", "[csg][property]") {
  constexpr std::uint64_t count = test::rounds(500);
  Tally tally;
  for (std::uint64_t seed = 0; seed < count; ++seed) {
    const Recipe recipe = test::touching_recipe(seed, {});
    const std::string wrong = thrown_or_disagreement(recipe, &tally);
    if (wrong.empty()) continue;
    const Recipe less = shrunken(recipe, [](const Recipe& r) { return !thrown_or_disagreement(r).empty(); });
    FAIL_CHECK("seed " << seed << ": " << wrong << "\n"
                       << text(recipe) << "\nless of it: " << thrown_or_disagreement(less) << "\n"
                       << full_text(less));
  }
  std::cout << "random expressions: " << tally << '\n';
  CHECK(tally.expressions == count);
  CHECK(tally.deepest >= 11);
  CHECK(tally.empty * 4 < count);
  CHECK(tally.skipped_disjunctive * 2 < count);
}

// Catches: what is wrong in all of those ways. The answer is known without any geometry.
TEST_CASE("random expressions about tetrahedra of one subdivision are what flags say", "[csg][property]") {
  constexpr std::uint64_t count = test::rounds(500);
  Tally tally;
  for (std::uint64_t seed = 0; seed < count; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    std::vector<std::vector<bool>> flags;
    std::vector<ExactMesh> solids;
    // Rational vertices take about twenty times as long.
    const test::Affine map = seed % 40 == 0 ? test::map_by_thirds(random) : identity;
    for (auto n = 2 + random.below(15); n > 0; --n) {
      flags.push_back(random.once_in(6) && !flags.empty() ? random.pick(flags) : random_flags(random));
      solids.push_back(mapped(test::kuhn_solid(kuhn_size, flags.back()), map));
    }
    const Recipe recipe = test::random_recipe(random, solids, {.maps = false});
    CAPTURE(text(recipe));
    const CanonicalForm known = canonical_form(mapped(test::kuhn_solid(kuhn_size, known_answer(recipe, flags)), map));
    const CanonicalForm found = expression_of(recipe, test::solids_of(recipe)).evaluate().canonical();
    tally.add(recipe, known);
    REQUIRE(found == known);
  }
  std::cout << "random expressions known by flags: " << tally << '\n';
  CHECK(tally.empty * 4 < count);
}
