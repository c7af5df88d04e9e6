#include "corpus/csv.h"

#include <catch2/catch.hpp>

#include "corpus/corpus.h"

namespace strata::test {

TEST_CASE("a table keeps commas, quotes and line ends inside quotes", "[corpus]") {
  const auto rows = parse_csv("a,b,c\n1,\"x, \"\"y\"\"\nz\",3\r\n,,\n4\n");
  REQUIRE(rows.size() == 3);
  CHECK(rows[0].at("b") == "x, \"y\"\nz");
  CHECK(rows[0].at("c") == "3");
  CHECK(rows[1].at("a").empty());
  CHECK(rows[2].at("c").empty());
}

TEST_CASE("numbers in tables are read exactly", "[corpus]") {
  CHECK(exact_number("49/40") == Rational(49, 40));
  CHECK(exact_number("8/5 (decimals as rationals)") == Rational(8, 5));
  CHECK(exact_number("-0.05") == Rational(-1, 20));
  CHECK(exact_number("1.5e-3") == Rational(3, 2000));
  CHECK(exact_number("0") == Rational(0));
  CHECK_FALSE(exact_number("").has_value());
}

}  // namespace strata::test
