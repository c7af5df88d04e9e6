#include "strata/formula.h"

#include <catch2/catch.hpp>
#include <functional>
#include <vector>

#include "core/cells/windings.h"
#include "support/random.h"

using namespace strata;

namespace {

using Assignment = std::function<bool(std::uint32_t)>;

/// A formula, and the same as a function.
struct Pair {
  Formula::Term term;
  std::function<bool(const Assignment&)> value;
};

Pair random_pair(Formula& formula, test::Random& random, int depth) {
  Pair p = [&]() -> Pair {
    if (depth == 0 || random.once_in(4)) {
      const auto operand = static_cast<std::uint32_t>(random.below(formula.operands()));
      return {formula.operand(operand), [operand](const Assignment& in) { return in(operand); }};
    }
    const auto join = static_cast<Formula::Join>(random.below(3));
    std::vector<Formula::Term> terms;
    std::vector<std::function<bool(const Assignment&)>> values;
    for (auto n = random.below(4); n > 0; --n) {
      Pair t = random_pair(formula, random, depth - 1);
      terms.push_back(t.term);
      values.push_back(t.value);
    }
    return {formula.join(join, terms), [join, values](const Assignment& in) {
              std::size_t held = 0;
              for (const auto& v : values) held += v(in);
              return join == Formula::Join::any   ? held > 0
                     : join == Formula::Join::all ? held == values.size()
                                                  : held % 2 == 1;
            }};
  }();
  if (random.once_in(3)) return {!p.term, [value = p.value](const Assignment& in) { return !value(in); }};
  return p;
}

Windings windings_of(std::uint32_t bits) {
  Windings w;
  for (std::uint32_t o = 0; bits >> o != 0; ++o)
    if ((bits >> o & 1) != 0) w.add(o, 1 + static_cast<int>(o % 2));
  return w;
}

}  // namespace

// Catches: negations lost where joints are absorbed, counts at rest, operands that occur twice.
TEST_CASE("formulas hold where the same functions do", "[select][property]") {
  const auto seed = GENERATE(range(0, 400));
  CAPTURE(seed);
  test::Random random(static_cast<std::uint64_t>(seed));
  Formula formula(5);
  const Pair p = random_pair(formula, random, 5);
  formula.close(p.term);
  const auto value = [&](std::uint32_t bits) {
    return p.value([bits](std::uint32_t o) { return (bits >> o & 1) != 0; });
  };
  for (std::uint32_t bits = 0; bits < 32; ++bits) REQUIRE(formula.holds(windings_of(bits)) == value(bits));
  for (std::uint32_t o = 0; o < 5; ++o)
    for (const bool in : {false, true}) {
      if (!formula.settles(o, in)) continue;
      std::size_t held = 0;
      for (std::uint32_t bits = 0; bits < 32; ++bits) held += ((bits >> o & 1) != 0) == in && value(bits);
      REQUIRE((held == 0 || held == 16));
    }
}

TEST_CASE("chains settle as unions and differences do", "[select]") {
  Formula formula(100);
  Formula::Term chain = formula.operand(0);
  for (std::uint32_t o = 1; o < 100; ++o) {
    const std::vector<Formula::Term> terms{chain, !formula.operand(o)};
    chain = formula.join(Formula::Join::all, terms);
  }
  formula.close(chain);
  CHECK(formula.settles(0, false));
  CHECK_FALSE(formula.settles(0, true));
  for (std::uint32_t o = 1; o < 100; ++o) {
    CHECK(formula.settles(o, true));
    CHECK_FALSE(formula.settles(o, false));
  }
  Windings w;
  w.add(0, 1);
  CHECK(formula.holds(w));
  w.add(57, 1);
  CHECK_FALSE(formula.holds(w));
}

// Catches: operands that occur twice, negated terms of unions, terms of intersections taken for those of unions.
TEST_CASE("operands of a union may be replaced by one of them", "[select][property]") {
  const auto seed = GENERATE(range(0, 300));
  CAPTURE(seed);
  test::Random random(static_cast<std::uint64_t>(seed));
  Formula formula(6);
  const Pair p = random_pair(formula, random, 3);
  formula.close(p.term);
  for (const auto& list : formula.unions()) {
    REQUIRE(list.size() >= 2);
    std::uint32_t members = 0;
    for (const std::uint32_t o : list) members |= 1u << o;
    for (std::uint32_t bits = 0; bits < 64; ++bits)
      if ((bits & members) != 0)
        REQUIRE(formula.holds(windings_of(bits)) == formula.holds(windings_of((bits & ~members) | 1u << list.front())));
  }
}

TEST_CASE("what a difference takes away is a union", "[select]") {
  Formula formula(5);
  const Formula::Term away =
      formula.join(Formula::Join::any, std::vector<Formula::Term>{formula.operand(1), formula.operand(2)});
  const std::vector<Formula::Term> whole{formula.operand(0), !away, !formula.operand(4)};
  formula.close(formula.join(Formula::Join::all, whole));
  CHECK(formula.unions() == std::vector<std::vector<std::uint32_t>>{{1, 2, 4}});
}

TEST_CASE("a formula without operands is a constant", "[select]") {
  Formula everything(0);
  everything.close(everything.join(Formula::Join::all, {}));
  CHECK(everything.holds({}));
  Formula nothing(0);
  nothing.close(nothing.join(Formula::Join::odd, {}));
  CHECK_FALSE(nothing.holds({}));
}
