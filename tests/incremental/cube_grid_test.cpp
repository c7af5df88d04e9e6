// A grid of cubes, one step per cube, and after every step the one right answer, which is known from the cells alone.
#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <iostream>
#include <numeric>
#include <ostream>
#include <utility>

#include "strata/incremental.h"
#include "strata/measure.h"
#include "support/random.h"
#include "support/shapes.h"
#include "support/transform.h"

using namespace strata;

namespace {

using Clock = std::chrono::steady_clock;

/// Cubes of one size at the origin; the incremental solid should be the union of the filled cells.
struct Cubes {
  test::CellGrid cells;
  test::Affine map{};
  Rational side;

  Cubes(int n, Rational s) : cells(n, n, n, false), side(std::move(s)) {
    for (std::size_t k = 0; k < 3; ++k) map.columns[k][k] = side;
  }

  [[nodiscard]] std::array<int, 3> place(std::size_t number) const {
    const auto n = static_cast<std::size_t>(cells.size[0]);
    return {static_cast<int>(number % n), static_cast<int>(number / n % n), static_cast<int>(number / n / n)};
  }

  [[nodiscard]] Solid cube(std::size_t number) const {
    const auto [i, j, k] = place(number);
    const Vertex lower{double(i), double(j), double(k)};
    return Solid(mapped(test::box(lower, {lower[0] + 1, lower[1] + 1, lower[2] + 1}), map));
  }

  [[nodiscard]] int exposed_squares(std::size_t number) const {
    const auto [i, j, k] = place(number);
    return !cells.at(i - 1, j, k) + !cells.at(i + 1, j, k) + !cells.at(i, j - 1, k) + !cells.at(i, j + 1, k) +
           !cells.at(i, j, k - 1) + !cells.at(i, j, k + 1);
  }
};

/// Even cells first, which touch along edges and in vertices only, then the others; both shuffled.
std::vector<std::size_t> checkerboard_order(const Cubes& cubes, test::Random& random) {
  std::vector<std::size_t> order(cubes.cells.filled.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
  std::stable_partition(order.begin(), order.end(), [&](std::size_t number) {
    const auto [i, j, k] = cubes.place(number);
    return (i + j + k) % 2 == 0;
  });
  return order;
}

/// Follows a incremental solid, and compares it after every step with what the cells say.
class Follower {
 public:
  explicit Follower(Cubes cubes) : cubes_(std::move(cubes)) {}

  void step(Operation operation, std::size_t number) {
    const bool unite = operation == Operation::union_;
    const int exposed = cubes_.exposed_squares(number);  // the same with the cell and without it
    const Solid tool = cubes_.cube(number);
    const auto start = Clock::now();
    solid_in_steps_ = solid_in_steps_.with(operation, tool);
    stepping_ += Clock::now() - start;
    cubes_.cells.filled[number] = unite;
    filled_ += unite ? 1 : -1;
    squares_ += unite ? 2 * exposed - 6 : 6 - 2 * exposed;
    compare();
    ++steps_;
  }

  void report(const char* title) const {
    std::cout << title << ": " << steps_ << " steps, " << std::chrono::duration<double>(stepping_).count()
              << " s in steps, " << std::chrono::duration<double>(checking_).count() << " s in checks; up to " << most_
              << " facets and " << most_shared_ << " edges of more than two faces\n";
    CHECK(most_shared_ > 0);
  }

  [[nodiscard]] std::size_t steps() const { return steps_; }
  [[nodiscard]] const IncrementalSolid& solid_in_steps() const { return solid_in_steps_; }

 private:
  void compare() {
    const auto start = Clock::now();
    const Solid solid = solid_in_steps_.solid();
    const Rational volume = filled_ * cubes_.side * cubes_.side * cubes_.side;
    REQUIRE(solid.volume() == volume);
    REQUIRE(solid_in_steps_.volume() == Approx(to_nearest_double(volume)).epsilon(1e-14));
    const double area = to_nearest_double(squares_ * cubes_.side * cubes_.side);
    REQUIRE(solid.area() == Approx(area).epsilon(1e-14));
    REQUIRE(solid_in_steps_.is_empty() == (filled_ == 0));
    REQUIRE(solid_in_steps_.triangle_count() == solid.mesh().triangles.size());
    const Topology topology = strata::topology(solid.exact_mesh());
    REQUIRE(topology.open_edges == 0);
    const CanonicalForm known = canonical_form(mapped(test::cell_solid(cubes_.cells), cubes_.map));
    REQUIRE(solid.canonical() == known);
    most_ = std::max(most_, known.facet_count());
    most_shared_ = std::max(most_shared_, topology.non_manifold_edges);
    checking_ += Clock::now() - start;
  }

  Cubes cubes_;
  IncrementalSolid solid_in_steps_;
  int filled_ = 0, squares_ = 0;
  std::size_t steps_ = 0, most_ = 0;
  std::uint64_t most_shared_ = 0;
  Clock::duration stepping_{}, checking_{};
};

/// All cubes united, then all but one taken away: 2 n^3 - 1 steps.
Follower follow(int n, const Rational& side, std::uint64_t seed) {
  test::Random random(seed);
  const Cubes cubes(n, side);
  Follower follower(cubes);
  for (const std::size_t number : checkerboard_order(cubes, random)) follower.step(Operation::union_, number);
  CHECK(follower.solid_in_steps().solid().canonical().facet_count() == 6);
  auto order = checkerboard_order(cubes, random);
  const std::size_t last = order.back();
  order.pop_back();
  for (const std::size_t number : order) follower.step(Operation::difference, number);
  CHECK(follower.solid_in_steps().solid() == cubes.cube(last));
  return follower;
}

}  // namespace

// Catches: any step that leaves a wall, a hole or a divided facet, where cubes touch in faces, edges and vertices.
TEST_CASE("64 cubes are put together and taken apart one by one", "[workpiece][property]") {
  const Follower follower = follow(4, 1, 1);
  CHECK(follower.steps() == 127);
  follower.report("64 cubes");
}

TEST_CASE("27 cubes of thirds are put together and taken apart one by one", "[workpiece][property]") {
  const Follower follower = follow(3, Rational(1, 3), 2);
  CHECK(follower.steps() == 53);
  follower.report("27 cubes of thirds");
}

TEST_CASE("1,000 cubes are put together and taken apart one by one", "[workpiece][slow]") {
  const Follower follower = follow(10, 1, 3);
  CHECK(follower.steps() == 1999);
  follower.report("1,000 cubes");
}
