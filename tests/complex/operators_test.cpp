#include <catch2/catch.hpp>

#include "random_complex.h"
#include "support/rounds.h"

namespace strata::complex {
namespace {

/// Calls `check` with random complexes of the plane and of space.
template <class Check>
void for_random(std::uint64_t count, const Check& check) {
  for (const int dimension : {2, 3})
    for (std::uint32_t seed = 0; seed < test::rounds(dimension == 2 ? count : count / 4); ++seed) {
      CAPTURE(dimension, seed);
      RandomComplexes random(dimension, seed);
      check(random);
    }
}

}  // namespace

TEST_CASE("laws of Boolean algebra hold without regularization", "[complex][property]") {
  for_random(1000, [](RandomComplexes& random) {
    const SelectiveComplex a = random.next(3), b = random.next(3);
    REQUIRE((a ^ b) == ((a | b) - (a & b)));
    REQUIRE((a ^ b) == ((a - b) | (b - a)));
    REQUIRE(~(a | b) == (~a & ~b));
    REQUIRE(~(a & b) == (~a | ~b));
    REQUIRE((a - b) == (a & ~b));
    REQUIRE((a | (a & b)) == a);
    REQUIRE(((a - b) | (a & b)) == a);
    REQUIRE(((a ^ b) ^ b) == a);
    REQUIRE(~~a == a);
    REQUIRE((a | ~a).is_all());
    REQUIRE((a & ~a).is_empty());
  });
}

TEST_CASE("distribution holds for three sets", "[complex][property]") {
  for_random(400, [](RandomComplexes& random) {
    const SelectiveComplex a = random.next(2), b = random.next(2), c = random.next(2);
    REQUIRE((a & (b | c)) == ((a & b) | (a & c)));
    REQUIRE((a | (b & c)) == ((a | b) & (a | c)));
    REQUIRE((a | b | c) == unite(std::vector{c, b, a}));
  });
}

TEST_CASE("operators obey the laws of topology", "[complex][property]") {
  for_random(4000, [](RandomComplexes& random) {
    const SelectiveComplex s = random.next(4);
    REQUIRE(interior(s) == ~closure(~s));
    REQUIRE(exterior(s) == interior(~s));
    REQUIRE(boundary(s) == boundary(~s));
    REQUIRE(interior(interior(s)) == interior(s));
    REQUIRE(closure(closure(s)) == closure(s));
    REQUIRE(regularized(s) == closure(interior(s)));
    REQUIRE(open_regularized(s) == interior(closure(s)));
    REQUIRE(regularized(s) == closure(open_regularized(s)));   // S.r = S.o.c
    REQUIRE(open_regularized(s) == interior(regularized(s)));  // S.o = S.r.i
    REQUIRE(regularized(regularized(s)) == regularized(s));
    REQUIRE(open_regularized(open_regularized(s)) == open_regularized(s));
    REQUIRE(interior(boundary(s)).is_empty());
  });
}

TEST_CASE("operators are what overlays of their definitions give", "[complex][property]") {
  for_random(300, [](RandomComplexes& random) {
    const SelectiveComplex s = random.next(4);
    REQUIRE(interior(s) == (s - boundary(s)));
    REQUIRE(closure(s) == (s | boundary(s)));
    REQUIRE(boundary(s) == (closure(s) & closure(~s)));
    REQUIRE(membrane(s) == (boundary(interior(s)) & boundary(exterior(s))));
    REQUIRE(dangle(s) == (boundary(s) - membrane(s)));
    REQUIRE(part(s, Part::skin) == (membrane(s) & s));
    REQUIRE(part(s, Part::wound) == (membrane(s) - s));
    REQUIRE(part(s, Part::hair) == (dangle(s) & s));
    REQUIRE(part(s, Part::cut) == (dangle(s) - s));
    // Trim the hair, heal wound and cut, as far as these touch what the source says they do.
    const SelectiveComplex touched = closure(interior(s));
    REQUIRE(regularized(s) ==
            ((s - (part(s, Part::hair) - touched)) | part(s, Part::wound) | (part(s, Part::cut) & touched)));
  });
}

TEST_CASE("the six parts are exclusive and exhaustive", "[complex][property]") {
  for_random(200, [](RandomComplexes& random) {
    const SelectiveComplex s = random.next(4);
    SelectiveComplex all(s.dimension());
    for (const Part p : {Part::interior, Part::exterior, Part::skin, Part::wound, Part::hair, Part::cut}) {
      const SelectiveComplex one = part(s, p);
      REQUIRE((all & one).is_empty());
      all = all | one;
    }
    REQUIRE(all.is_all());
  });
}

}  // namespace strata::complex
