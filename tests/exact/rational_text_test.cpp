#include <catch2/catch.hpp>
#include <random>
#include <string>

#include "strata/rational.h"

using namespace strata;

// Seen to fail: a denominator with a sign; a denominator 00.

TEST_CASE("integers are read from digits with or without a sign", "[exact]") {
  CHECK(parse_integer("0") == Integer(0));
  CHECK(parse_integer("-0") == Integer(0));
  CHECK(parse_integer("+007") == Integer(7));  // not octal
  CHECK(parse_integer("-123456789012345678901234567890") == Integer("-123456789012345678901234567890"));
  for (const char* text : {"", "-", "+", "--1", "+-1", "1.0", "1e3", " 1", "1 ", "0x10", "1/2", "a"}) {
    CAPTURE(text);
    CHECK_FALSE(parse_integer(text));
  }
}

TEST_CASE("quotients are read from integers and digits", "[exact]") {
  CHECK(parse_quotient("-7") == Rational(-7));
  CHECK(parse_quotient("37/6") == Rational(37, Integer(6)));
  CHECK(parse_quotient("-4/06") == Rational(-2, Integer(3)));
  CHECK(parse_quotient("+0/5") == Rational(0));
  for (const char* text : {"", "/", "1/", "/2", "1/0", "1/00", "1/-2", "1/+2", "1/2/3", "1/2.5", "1 / 2", "0.5"}) {
    CAPTURE(text);
    CHECK_FALSE(parse_quotient(text));
  }
}

TEST_CASE("what is written is read", "[exact][property]") {
  std::mt19937_64 random(7);
  for (int n = 0; n < 500; ++n) {
    const Integer above = Integer(static_cast<std::int64_t>(random())) * Integer(static_cast<std::int64_t>(random()));
    const Rational x(above, Integer(1 + random() % 1'000'000) * Integer(1 + random() % 1'000'000));
    REQUIRE(parse_quotient(x.str()) == x);
  }
}
