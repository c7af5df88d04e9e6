#include "core/containers/concatenated.h"

#include <catch2/catch.hpp>
#include <numeric>

using namespace strata;

TEST_CASE("parts are put one after another") {
  std::vector<std::vector<int>> parts(100);
  std::vector<int> expected;
  for (std::size_t n = 0; n < parts.size(); ++n) {
    parts[n].resize(n % 7 == 0 ? 0 : 13 * n);
    std::iota(parts[n].begin(), parts[n].end(), static_cast<int>(expected.size()));
    expected.insert(expected.end(), parts[n].begin(), parts[n].end());
  }
  const FreshArray<int> all = concatenated(parts, {});
  CHECK(std::vector<int>(all.begin(), all.end()) == expected);
  CHECK(concatenated(std::vector<std::vector<int>>{}, {}).size() == 0);
  CHECK(concatenated(std::vector<std::vector<int>>(3), {}).size() == 0);
}
