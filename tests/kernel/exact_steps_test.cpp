#include "core/kernel/exact_steps.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "core/kernel/predicates.h"
#include "kernel/numbers.h"
#include "kernel/reference.h"
#include "kernel/tiers.h"
#include "support/random.h"

using namespace strata;
using namespace strata::test;

namespace {

using Coordinates = InputComplex::Coordinates;
using Four = std::array<Coordinates, 4>;

RationalPoint exact(const Coordinates& p) { return {to_rational(p[0]), to_rational(p[1]), to_rational(p[2])}; }

Sign expected(const Four& p) { return RationalPlane{exact(p[0]), exact(p[1]), exact(p[2])}.side(exact(p[3])); }

std::optional<Sign> found(const Four& p) { return orient3d_in_exact_steps(p[0], p[1], p[2], p[3]); }

bool is_finite(const Four& four) {
  for (const Coordinates& p : four)
    for (const double x : p)
      if (!std::isfinite(x)) return false;
  return true;
}

/// What was asked, decided, and decided as zero.
struct Tally {
  int decided = 0, zeros = 0;

  void check(const Four& four) {
    if (!is_finite(four)) return;
    const auto sign = found(four);
    if (!sign) return;
    REQUIRE(*sign == expected(four));
    ++decided;
    zeros += static_cast<int>(*sign == Sign::zero);
  }
};

/// Three points of a grid of 2^bits steps, and one that is in their plane or one step beside it.
Four on_grid(Random& random, int bits, double step) {
  const auto whole = [&](int b) { return std::floor(random.unit() * std::ldexp(1, b)); };
  Four p;
  for (std::size_t i = 0; i < 3; ++i) {
    p[0][i] = whole(bits - 1);
    p[1][i] = p[0][i] + whole(bits - 2);
    p[2][i] = p[0][i] + whole(bits - 2);
    p[3][i] = p[1][i] + p[2][i] - p[0][i];
  }
  if (random.once_in(2)) p[3][random.below(3)] += random.once_in(2) ? 1 : -1;
  for (Coordinates& q : p)
    for (double& x : q) x *= step;
  return p;
}

}  // namespace

// Catches: what rounding takes from the last products left out; a sum of these that rounds, unnoticed.
TEST_CASE("four points of a grid of 2^26 steps are decided in exact steps", "[kernel][property]") {
  Random random(1);
  int zeros = 0, refused = 0;
  for (int i = 0; i < 20'000; ++i) {
    CAPTURE(i);
    const double step = random.pick(std::array{1.0, 0x1p-70, 0x1p300});
    const Four p = on_grid(random, i % 2 == 0 ? 26 : random.between(3, 25), step);
    const auto sign = found(p);
    REQUIRE(sign);
    REQUIRE(*sign == expected(p));
    zeros += static_cast<int>(*sign == Sign::zero);
  }
  CHECK(zeros > 8'000);
  for (int i = 0; i < 2'000; ++i) {  // beyond, some step rounds and says so
    const Four p = on_grid(random, random.between(28, 50), 1);
    const auto sign = found(p);
    if (sign) REQUIRE(*sign == expected(p));
    refused += static_cast<int>(!sign);
  }
  CHECK(refused > 1'000);
}

// Catches: a step that is not checked, among others where products vanish or overflow.
TEST_CASE("exact steps agree with rationals or give up, at any magnitude", "[kernel][property][degenerate]") {
  Random random(2);
  for (int family = 0; family < family_count; ++family) {
    CAPTURE(family);
    Tally tally;
    for (int i = 0; i < (family == static_cast<int>(Family::wild) ? 300 : 3000); ++i) {
      CAPTURE(i);
      Numbers number(static_cast<Family>(family), random);
      Four p;
      for (Coordinates& q : p) q = {number(), number(), number()};
      tally.check(p);
      for (std::size_t k = 0; k < 3; ++k) p[3][k] = p[1][k] + p[2][k] - p[0][k];  // in the plane unless this rounds
      tally.check(p);
      if (random.once_in(2)) p[3][random.below(3)] = number();
      tally.check(p);
    }
    if (family == static_cast<int>(Family::small_integers) || family == static_cast<int>(Family::floats)) {
      CHECK(tally.decided > 4000);
      CHECK(tally.zeros > 1000);
    }
  }
}

// Every coordinate is some bits at some height: what is lost is lost in another step each time.
TEST_CASE("exact steps notice what mixed magnitudes lose", "[kernel][property][degenerate]") {
  Random random(3);
  Tally tally;
  for (int i = 0; i < 60'000; ++i) {
    CAPTURE(i);
    const int middle = random.pick(std::array{0, 0, -150, -300, -340, -450, -500, -1000, 300, 340, 500, 1000});
    const int bits = random.between(1, 53), apart = random.pick(std::array{0, 1, 10, 30, 50, 200});
    const auto coordinate = [&] {
      if (random.once_in(5)) return 0.0;
      const double whole = std::floor((random.unit() - 0.5) * std::ldexp(1, bits));
      return std::ldexp(whole, middle - bits + random.between(-apart, apart));
    };
    Four p;
    for (Coordinates& q : p) q = {coordinate(), coordinate(), coordinate()};
    if (random.once_in(2)) p[0] = {0, 0, 0};
    if (random.once_in(2))
      for (std::size_t k = 0; k < 3; ++k) p[3][k] = p[0][k] + 2 * (p[1][k] - p[0][k]) - (p[2][k] - p[0][k]);
    tally.check(p);
  }
  CHECK(tally.decided > 8'000);
  CHECK(tally.zeros > 3'000);
}

TEST_CASE("exact steps refuse what rounds, vanishes or overflows", "[kernel]") {
  const double up = std::nextafter(1.0, 2.0), tiny = std::numeric_limits<double>::denorm_min();
  const auto refused = [](const Four& p) { return !found(p); };
  CHECK(refused({{{-4, -4, 0}, {1, 1, 0}, {1, up, 0}, {3, 5, 1}}}));                    // differences
  CHECK(refused({{{0, 0, 0}, {up, 1, 0}, {1, up, 0}, {0, 0, 1}}}));                     // products of two
  CHECK(refused({{{0, 0, 0}, {0x1p60, 1, 0}, {1, 1, 0}, {0, 0, 1}}}));                  // their difference
  CHECK(refused({{{0, 0, 0}, {tiny, 0, 0}, {0, tiny, 0}, {0, 0, 1}}}));                 // a product vanishes
  CHECK(refused({{{0, 0, 0}, {0x1p-400, 0, 0}, {0, 0x1p-400, 0}, {0, 0, 0x1p-400}}}));  // the last one does
  CHECK(refused({{{0, 0, 0}, {0x1p600, 0, 0}, {0, 0x1p600, 0}, {0, 0, 1}}}));           // a product overflows
  CHECK(refused({{{0, 0, 0}, {0x1p400, 0, 0}, {0, 0x1p400, 0}, {0, 0, 0x1p400}}}));     // the last one does
  CHECK(refused({{{-1.7e308, 0, 0}, {1.7e308, 0, 0}, {0, 1, 0}, {0, 0, 1}}}));          // a difference does
  const double most = std::numeric_limits<double>::max();
  CHECK(found({{{0, 0, 0}, {1, 0, 0}, {-1, 1, 0}, {most, most, most}}}) == Sign::positive);
}

// The same plane, near and far: points of a face that was moved by an exact turn.
TEST_CASE("coplanar vertices on a common grid take no integers", "[kernel][degenerate]") {
  if (!counts_tiers) return;
  Random random(4);
  for (int i = 0; i < 100; ++i) {
    const auto point = [&](double x, double y) {  // of a plane with the normal (2, 3, 6)
      return Coordinates{3 * x + 6 * y, -2 * x + 2 * y, -3 * y};
    };
    const auto any = [&] { return point(random.between(-4000, 4000), random.between(-4000, 4000)); };
    const Four p{any(), any(), any(), any()};
    TierProbe probe;
    CHECK(orient3d(p[0], p[1], p[2], p[3]) == Sign::zero);
    const auto counts = probe.take();
    CHECK(counts[static_cast<std::size_t>(Tier::steps)] + counts[static_cast<std::size_t>(Tier::filter)] == 1);
  }
}
