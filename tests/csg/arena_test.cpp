#include "core/csg/arena.h"

#include <tbb/parallel_for.h>

#include <catch2/catch.hpp>
#include <functional>
#include <stdexcept>
#include <thread>

namespace strata {
namespace {

int concurrency() { return tbb::this_task_arena::max_concurrency(); }

}  // namespace

TEST_CASE("few faces are work of one thread, as is what one thread is asked for", "[arena]") {
  CHECK(arena_for({}, 999).execute(concurrency) == 1);
  CHECK(arena_for({.threads = 1}).execute(concurrency) == 1);
  CHECK(arena_for({.threads = 2}).execute(concurrency) == std::min(2, tbb::info::default_concurrency()));
}

TEST_CASE("arenas of one thread are entered within each other, also through larger ones", "[arena]") {
  const Arena one(1), two(2);
  int left = 10;
  const std::function<int()> nested = [&] {
    return --left == 0 ? concurrency() : two.execute([&] { return one.execute(nested); });
  };
  CHECK(one.execute([&] { return one.execute(nested); }) == 1);
}

TEST_CASE("work that throws leaves its arena", "[arena]") {
  const Arena one(1);
  CHECK_THROWS_AS(one.execute([]() -> int { throw std::runtime_error("no"); }), std::runtime_error);
  CHECK(one.execute([] { return 1; }) == 1);
}

TEST_CASE("arenas of one thread are used by many threads", "[arena]") {
  std::atomic<int> sum = 0;
  Arena(2).execute([&] { tbb::parallel_for(0, 1000, [&](int i) { sum += Arena(1).execute([&] { return i; }); }); });
  std::thread([&] { sum += Arena(1).execute([] { return 1; }); }).join();
  CHECK(sum == 999 * 1000 / 2 + 1);
}

}  // namespace strata
