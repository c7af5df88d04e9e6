#include "core/containers/distinct_hashes.h"

#include <catch2/catch.hpp>
#include <cstdint>
#include <random>
#include <vector>

using namespace strata;

TEST_CASE("hashes are distinct unless two are the same, wherever these are", "[containers][property]") {
  std::mt19937_64 random(7);
  for (const std::size_t count : {0, 1, 2, 3, 1000, 1024, 5000, 70000, 300000}) {
    std::vector<std::uint64_t> hashes(count);
    for (std::uint64_t& h : hashes) h = random() << 1;  // the lowest bit does not count
    REQUIRE(are_distinct(hashes));
    if (count < 2) continue;
    for (int round = 0; round < 10; ++round) {
      const std::size_t from = random() % count, to = random() % count;
      if (from == to) continue;
      std::vector<std::uint64_t> twice = hashes;
      twice[to] = twice[from];
      REQUIRE_FALSE(are_distinct(twice));
    }
  }
}

TEST_CASE("hashes that are badly mixed are told apart all the same", "[containers]") {
  std::vector<std::uint64_t> hashes(20000);
  for (std::size_t i = 0; i < hashes.size(); ++i) hashes[i] = 2 * i;
  CHECK(are_distinct(hashes));
  hashes.back() = 0;
  CHECK_FALSE(are_distinct(hashes));
  for (std::size_t i = 0; i < hashes.size(); ++i) hashes[i] = static_cast<std::uint64_t>(i) << 50 | 0xffffffffu;
  CHECK_FALSE(are_distinct(hashes));  // 2^14 values
  hashes.resize(1 << 14);
  CHECK(are_distinct(hashes));
}
