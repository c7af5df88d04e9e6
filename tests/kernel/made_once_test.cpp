#include "core/kernel/made_once.h"

#include <atomic>
#include <catch2/catch.hpp>
#include <cstddef>
#include <thread>
#include <vector>

using strata::MadeOnce;

// Catches: a value that is made again, one that differs between threads, one of another index.
TEST_CASE("values are made once, and all threads get the same", "[kernel]") {
  constexpr std::size_t count = 2000, threads = 4;
  const MadeOnce<std::vector<std::size_t>> values(count);
  std::atomic<std::size_t> made = 0;
  const auto value = [&](std::size_t i) {
    return &values.get(i, [&] {
      ++made;
      return std::vector<std::size_t>(3, i);
    });
  };
  std::vector<std::vector<const std::vector<std::size_t>*>> seen(threads);
  std::vector<std::thread> running;
  for (std::size_t t = 0; t < threads; ++t)
    running.emplace_back([&, t] {
      for (std::size_t i = 0; i < count; ++i) seen[t].push_back(value(i));
    });
  for (std::thread& thread : running) thread.join();
  for (std::size_t t = 1; t < threads; ++t) CHECK(seen[t] == seen[0]);
  for (std::size_t i = 0; i < count; ++i) REQUIRE(*seen[0][i] == std::vector<std::size_t>(3, i));

  const std::size_t before = made;
  CHECK(before >= count);
  for (std::size_t i = 0; i < count; ++i) REQUIRE(value(i) == seen[0][i]);
  CHECK(made == before);
}
