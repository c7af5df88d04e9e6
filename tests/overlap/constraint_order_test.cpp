#include "core/overlap/constraint_order.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>

#include "support/random.h"

using namespace strata;

namespace {

/// Lists of constraints: each pair of faces in one cell, several times in a row.
std::vector<PairIntersections> random_cells(test::Random& random, std::uint32_t face_count, int pairs) {
  std::vector<PairIntersections> cells(static_cast<std::size_t>(random.between(1, 20)));
  const std::uint32_t used = random.once_in(2) ? face_count : std::min(face_count, 3U);
  for (std::uint32_t n = 0; n < static_cast<std::uint32_t>(pairs); ++n) {
    PairIntersections& cell = cells[random.below(cells.size())];
    const auto face = face_count - 1 - static_cast<std::uint32_t>(random.below(used));
    Constraint c;
    c.face = face;
    c.other = n ^ 0x5555;
    cell.constraints.insert(cell.constraints.end(), static_cast<std::size_t>(random.between(1, 6)), c);
  }
  return cells;
}

}  // namespace

// Catches: starts of runs that are off by one, faces beyond the last run, constraints of a pair out of order.
TEST_CASE("constraints are ordered by face, other face and discovery", "[overlap][property]") {
  test::Random random(5);
  for (int round = 0; round < 300; ++round) {
    CAPTURE(round);
    const auto face_count = std::uint32_t{random.pick(std::array{1U, 2U, 7U, 64U, 1000U, 1U << 20, 0xfffffffeU})};
    const auto cells = random_cells(random, face_count, random.pick(std::array{0, 1, 5, 300, 3000}));
    std::vector<ConstraintPosition> expected;
    for (std::uint32_t c = 0; c < cells.size(); ++c)
      for (std::uint32_t i = 0; i < cells[c].constraints.size(); ++i)
        expected.push_back({std::uint64_t{cells[c].constraints[i].face} << 32 | cells[c].constraints[i].other, c, i});
    std::sort(expected.begin(), expected.end());
    REQUIRE((order_by_face(cells, face_count) == expected));
  }
}
