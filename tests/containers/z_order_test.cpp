#include "core/containers/z_order.h"

#include <catch2/catch.hpp>

using namespace strata;

TEST_CASE("bits of three numbers are taken in turn", "[containers][property]") {
  CHECK(z_order(0, 0, 0) == 0);
  CHECK(z_order(1023, 1023, 1023) == (1u << 30) - 1);
  for (std::uint32_t n = 0; n < 1024; ++n) {
    const std::uint32_t x = n, y = n * 7 % 1024, z = n * 345 % 1024;
    std::uint32_t expected = 0;
    for (int bit = 9; bit >= 0; --bit)
      for (const std::uint32_t c : {x, y, z}) expected = expected << 1 | (c >> bit & 1);
    REQUIRE(z_order(x, y, z) == expected);
  }
}
