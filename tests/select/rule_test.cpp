#include "core/select/rule.h"

#include <catch2/catch.hpp>

using namespace strata;

TEST_CASE("the rules of the four operations", "[select]") {
  const auto inside = [](Operation op, std::initializer_list<int> w) {
    Windings windings;
    std::uint32_t i = 0;
    for (const int x : w) windings.add(i++, x);
    return Rule(op, static_cast<std::uint32_t>(w.size())).inside(windings);
  };
  CHECK(inside(Operation::union_, {0, 1, 0}));
  CHECK_FALSE(inside(Operation::union_, {0, 0, 0}));
  CHECK_FALSE(inside(Operation::union_, {-1, 0, 0}));
  CHECK(inside(Operation::intersection, {1, 2, 1}));
  CHECK_FALSE(inside(Operation::intersection, {1, 0, 1}));
  CHECK(inside(Operation::difference, {1, 0, 0}));
  CHECK_FALSE(inside(Operation::difference, {1, 0, 1}));
  CHECK_FALSE(inside(Operation::difference, {0, 1, 0}));
  CHECK(inside(Operation::symmetric_difference, {1, 1, 1}));
  CHECK_FALSE(inside(Operation::symmetric_difference, {1, 1, 0}));
}

TEST_CASE("winding numbers are kept sparse", "[select]") {
  Windings w;
  w.add(7, 1);
  w.add(3, 2);
  w.add(7, -1);
  CHECK(w[7] == 0);
  CHECK(w[3] == 2);
  CHECK(w.begin() + 1 == w.end());
  w.set(3, 0);
  CHECK(w == Windings{});
}
