#include "core/exact/invariants.h"

#include <catch2/catch.hpp>

using namespace strata;

TEST_CASE("a stage whose invariants do not hold ends with their list, in checked builds", "[exact]") {
  const auto broken = [] {
    Violations v;
    v.add("face ", 3, " is open");
    v.add("face ", 4, " is open");
    return std::move(v).list();
  };
  if (is_checked_build) {
    CHECK_THROWS_WITH(ensure("extract", broken),
                      "invariants do not hold after extract\n  face 3 is open\n  face 4 is open");
    CHECK_THROWS_AS(ensure("extract", broken), LogicError);
  } else {
    CHECK_NOTHROW(ensure("extract", broken));
  }
  CHECK_NOTHROW(ensure("extract", [] { return std::vector<std::string>{}; }));
}

TEST_CASE("lists of violations are short", "[exact]") {
  Violations v;
  for (int i = 0; i < 1000; ++i) v.add("face ", i);
  CHECK(std::move(v).list().size() == 16);
}

TEST_CASE("samples are everything, or so many at equal distances", "[exact]") {
  std::vector<std::size_t> seen;
  const auto visit = [&](std::size_t i) { seen.push_back(i); };
  for_sample(3, 4, visit);
  CHECK(seen == std::vector<std::size_t>{0, 1, 2});
  seen.clear();
  for_sample(100, 4, visit);
  CHECK(seen == std::vector<std::size_t>{0, 25, 50, 75});
}
