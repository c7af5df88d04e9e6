#include "core/kernel/input_complex.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "kernel/numbers.h"

using namespace strata;

TEST_CASE("operands are numbered one after another", "[kernel]") {
  const std::vector<InputComplex::Coordinates> two{{0, 0, 0}, {1, 0, 0}}, three{{2, 0, 0}, {3, 0, 0}, {4, 0, 0}};
  const std::vector<InputComplex::Indices> one_face{{0, 1, 0}}, two_faces{{0, 1, 2}, {2, 1, 0}};
  InputComplex input;
  input.add(two, one_face);
  input.add({}, {});
  input.add(three, two_faces);
  input.add({}, {});
  CHECK(input.operand_count() == 4);
  CHECK(input.vertex_count() == 5);
  CHECK(input.face_count() == 3);
  CHECK(input.first_vertex(2) == 2);
  CHECK(input.first_face(2) == 1);
  for (std::uint32_t v = 0; v < 5; ++v) {
    CHECK(input.vertex(v)[0] == v);
    CHECK(input.operand_of_vertex(v) == (v < 2 ? 0U : 2U));
  }
  CHECK(input.face(0) == InputComplex::Indices{0, 1, 0});
  CHECK(input.face(2) == InputComplex::Indices{4, 3, 2});
  CHECK(input.operand_of_face(0) == 0);
  CHECK(input.operand_of_face(1) == 2);
}

TEST_CASE("rational vertices are found in their own operand only", "[kernel]") {
  const std::vector<InputComplex::Coordinates> points{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  const std::vector<ExactVertex> exact{{0, {Rational(1, 7), 0, 0}}, {2, {Rational(2, 7), 0, 0}}};
  InputComplex input;
  input.add(points, {});
  CHECK_FALSE(input.has_rationals());
  CHECK(input.exact(0) == nullptr);
  input.add(points, {}, exact);
  CHECK(input.has_rationals());
  for (const std::uint32_t v : {0U, 1U, 2U, 4U}) CHECK(input.exact(v) == nullptr);
  REQUIRE(input.exact(3) != nullptr);
  REQUIRE(input.exact(5) != nullptr);
  CHECK((*input.exact(3))[0] == Rational(1, 7));
  CHECK((*input.exact(5))[0] == Rational(2, 7));
}

namespace {

/// The place of a vertex whose coordinates are all x.
VertexPosition place_of(InputComplex& input, std::vector<InputComplex::Coordinates>& points,
                        std::vector<ExactVertex>& exact, const Rational& x) {
  const double nearest = to_nearest_double(x);
  points = {{nearest, nearest, nearest}};
  exact = {{0, {x, x, x}}};
  input.add(points, {}, exact);
  return input.place(0);
}

/// The remainder that a rational is kept with, which together with the nearest double is the rational; or none, where
/// no double is what is left.
void check_place(const Rational& x) {
  CAPTURE(x);
  const double nearest = to_nearest_double(x);
  if (!std::isfinite(nearest)) return;
  const Rational rest = x - to_rational(nearest);
  const bool is_sum = to_rational(to_nearest_double(rest)) == rest;
  InputComplex input;
  std::vector<InputComplex::Coordinates> points;
  std::vector<ExactVertex> exact;
  const VertexPosition place = place_of(input, points, exact, x);
  REQUIRE_FALSE(place.has_doubles());
  REQUIRE((place.remainder != nullptr) == is_sum);
  if (is_sum) {
    for (const double r : *place.remainder) REQUIRE(to_rational(r) == rest);
  } else {
    const HPoint<Integer>& p = input.homogeneous(0);
    REQUIRE(Rational(p.x, p.w) == x);
    REQUIRE(p.w == denominator(x));
    REQUIRE(&input.homogeneous(0) == &p);
  }
}

}  // namespace

// Catches: a remainder of the wrong sign or size, one that was rounded, a rational that is taken for a sum of doubles.
TEST_CASE("a rational vertex is kept as the sum of two doubles where it is one", "[kernel][property]") {
  using test::Family;
  for (int family = 0; family < test::family_count; ++family) {
    test::Random random(static_cast<std::uint64_t>(family) + 5);
    test::Numbers number(static_cast<Family>(family), random);
    for (int i = 0; i < 2000; ++i) {
      const Rational a = to_rational(number()), b = to_rational(number()), c = to_rational(number());
      for (const Rational& x : {Rational(a + b), Rational(a - b), Rational((a + b) / 2), Rational(a + b + c),
                                Rational(a * b), Rational(a + b / 3)})
        check_place(x);
    }
  }
  const double least = std::numeric_limits<double>::denorm_min(), most = std::numeric_limits<double>::max();
  for (const double x : {0.0, least, 0.1, 0x1p60, most})
    for (const double y : {least, 0x1p-1022, 0x1p-60, 1.0, 3.0, 0x1p64, 0x1p117, most}) {
      check_place(to_rational(x) + to_rational(y) / 2);
      check_place(to_rational(x) - to_rational(y));
      check_place(-to_rational(x) + to_rational(y));
    }
}
