#include <algorithm>
#include <catch2/catch.hpp>

#include "random_complex.h"
#include "strata/complex.h"
#include "support/rounds.h"

namespace strata::complex {

TEST_CASE("points are in a result when the formula says so, on rays through vertices and edges too",
          "[complex][property]") {
  // Corners are from the same grid as points, so that rays from these hit vertices, edges and faces end on.
  for (const int dimension : {2, 3})
    for (std::uint32_t seed = 0; seed < test::rounds(200); ++seed) {
      CAPTURE(dimension, seed);
      RandomComplexes random(dimension, seed);
      const SelectiveComplex a = random.next(3), b = random.next(3);
      const SelectiveComplex either = a | b, both = a & b, one = a ^ b, first = a - b;
      for (int i = 0; i < 60; ++i) {
        const Vertex u = random.corner(), v = random.corner();
        RationalPoint p;
        for (std::size_t k = 0; k < 3; ++k) p[k] = (to_rational(u[k]) * i + to_rational(v[k]) * 2) / (i + 2);
        const RationalPoint q = i % 2 == 0 ? RationalPoint{to_rational(u[0]), to_rational(u[1]), to_rational(u[2])} : p;
        const bool in_a = contains(a, q), in_b = contains(b, q);
        REQUIRE(contains(either, q) == (in_a || in_b));
        REQUIRE(contains(both, q) == (in_a && in_b));
        REQUIRE(contains(one, q) == (in_a != in_b));
        REQUIRE(contains(first, q) == (in_a && !in_b));
      }
    }
}

TEST_CASE("a simplex holds what its corners' weights say", "[complex][property]") {
  for (std::uint32_t seed = 0; seed < test::rounds(300); ++seed) {
    CAPTURE(seed);
    RandomComplexes random(3, seed);
    std::vector<Vertex> corners(4);
    for (Vertex& c : corners) c = random.corner();
    SelectiveComplex open, closed;
    try {
      open = simplex(3, corners, Border::open);
      closed = simplex(3, corners, Border::closed);
    } catch (const InputError&) {
      continue;
    }
    for (int i = 0; i < 30; ++i) {
      std::array<int, 4> weights{random.below(4) - 1, random.below(4), random.below(3), random.below(3) + 1};
      const int sum = weights[0] + weights[1] + weights[2] + weights[3];
      if (sum <= 0) continue;
      RationalPoint p;
      for (std::size_t k = 0; k < 3; ++k) {
        p[k] = 0;
        for (std::size_t c = 0; c < 4; ++c) p[k] += to_rational(corners[c][k]) * weights[c] / sum;
      }
      const bool is_in = weights[0] >= 0, is_inside = weights[0] > 0 && weights[1] > 0 && weights[2] > 0;
      REQUIRE(contains(closed, p) == is_in);
      REQUIRE(contains(open, p) == is_inside);
      const auto zeros = std::count(weights.begin(), weights.end(), 0);
      if (is_in) REQUIRE(locate(closed, p).dimension == 3 - zeros);
    }
  }
}

}  // namespace strata::complex
