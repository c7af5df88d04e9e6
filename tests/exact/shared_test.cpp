#include "strata/shared.h"

#include <catch2/catch.hpp>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "strata/function.h"
#include "strata/monitor.h"

using namespace strata;

namespace {

/// Counts how many there are.
struct Counted {
  explicit Counted(int* n) : count(n) { ++*count; }
  Counted(const Counted& other) : count(other.count) { ++*count; }
  Counted& operator=(const Counted&) = delete;
  ~Counted() { --*count; }
  int* count;
};

int twice(int x) { return 2 * x; }

int apply(FunctionRef<int(int)> f, int x) { return f(x); }

}  // namespace

TEST_CASE("a shared value lives as long as its last handle", "[exact]") {
  int count = 0;
  {
    Shared<Counted> a = Shared<Counted>::make(&count), b = a;
    CHECK(a == b);
    CHECK_FALSE(a.is_only());
    Shared<Counted> c = std::move(a);
    CHECK_FALSE(a);  // NOLINT(bugprone-use-after-move)
    b = Shared<Counted>();
    CHECK(c.is_only());
    CHECK(count == 1);
    c = Shared<Counted>(c);
    CHECK(count == 1);
    CHECK(c->count == &count);
  }
  CHECK(count == 0);
}

// Catches: counts that are not atomic.
TEST_CASE("threads share a value", "[exact]") {
  int count = 0;
  {
    const Shared<Counted> value = Shared<Counted>::make(&count);
    std::vector<std::thread> threads;
    for (int t = 0; t < 4; ++t)
      threads.emplace_back([value] {
        for (int i = 0; i < 50'000; ++i) const Shared<Counted> other = value;  // NOLINT: copied and dropped
      });
    for (std::thread& t : threads) t.join();
    CHECK(value.is_only());
  }
  CHECK(count == 0);
}

TEST_CASE("functions take lambdas, function objects, functions and std::function", "[exact]") {
  int calls = 0;
  const Function<int(int)> lambda = [&calls](int x) { return x + ++calls; };
  CHECK(lambda(10) == 11);
  CHECK(Function<int(int)>(lambda)(10) == 12);  // copies share state
  CHECK(Function<int(int)>(twice)(4) == 8);
  CHECK(Function<int(int)>(&twice)(4) == 8);
  CHECK(Function<int(int)>(std::function<int(int)>(twice))(4) == 8);
  CHECK(Function<int(int)>([](int x) { return x; })(3) == 3);
  CHECK_FALSE(Function<int(int)>());
  CHECK_FALSE(Function<int(int)>(nullptr));
  CHECK_FALSE(Function<int(int)>(std::function<int(int)>()));
  CHECK_FALSE(Function<int(int)>(static_cast<int (*)(int)>(nullptr)));
  const Function<void(int)> nothing_back = twice;
  nothing_back(1);
  const auto owned = std::make_shared<int>(5);
  const Function<std::string(const std::string&)> keeps = [owned](const std::string& s) {
    return s + std::to_string(*owned);
  };
  CHECK(owned.use_count() == 2);
  CHECK(keeps("a") == "a5");
}

TEST_CASE("a reference to a function calls it where it is", "[exact]") {
  int calls = 0;
  auto counter = [&calls, own = 0](int x) mutable { return calls += x + own++; };
  CHECK(apply(counter, 1) == 1);
  CHECK(apply(counter, 1) == 3);  // the state of the callable itself changed
  CHECK(apply(twice, 4) == 8);
  CHECK(apply(&twice, 4) == 8);
  CHECK(apply(Function<int(int)>(twice), 4) == 8);
  CHECK(apply([](int x) { return -x; }, 4) == -4);
}

TEST_CASE("a monitor throws once its token is set, and reports to its function", "[exact]") {
  CancelToken token;
  double seen = -1;
  const Progress progress = [&](double fraction) { seen = fraction; };
  const Monitor monitor(&token, &progress);
  monitor.check();
  monitor.report(0.25);
  CHECK(seen == 0.25);
  std::thread([&] { token.cancel(); }).join();
  CHECK(token.is_cancelled());
  CHECK_THROWS_AS(monitor.check(), Cancelled);
  token.reset();
  CHECK_NOTHROW(monitor.check());
  CHECK_NOTHROW(Monitor().check());
  Monitor().report(1);
  const Progress none;
  Monitor(nullptr, &none).report(1);
}
