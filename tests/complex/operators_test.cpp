#include <catch2/catch.hpp>

#include "random_complex.h"
#include "strata/complex.h"
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
  for_random(500, [](RandomComplexes& random) {
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
    REQUIRE((a | b | c) == union_(std::vector{c, b, a}));
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

TEST_CASE("intersections of open-regularized sets are open-regularized", "[complex][property]") {
  for_random(300, [](RandomComplexes& random) {
    const SelectiveComplex a = open_regularized(random.next(3)), b = open_regularized(random.next(3));
    REQUIRE(open_regularized(a & b) == (a & b));
    REQUIRE(regularized(a | b) == (regularized(a) | regularized(b)));
    REQUIRE(is_open(a | b));
  });
}

TEST_CASE("contacts between polygons of a set hold no edge", "[complex][property]") {
  for (std::uint32_t seed = 0; seed < test::rounds(300); ++seed) {
    CAPTURE(seed);
    RandomComplexes random(2, seed);
    const std::vector<SelectiveComplex> polygons = separate(open_regularized(random.next(5)));
    for (std::size_t i = 0; i < polygons.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const SelectiveComplex contact = boundary(polygons[i]) & boundary(polygons[j]);
        REQUIRE((polygons[i] & polygons[j]).is_empty());
        REQUIRE(contact.count(1) == 0);
      }
  }
}

TEST_CASE("tests of single cells agree with the operators", "[complex][property]") {
  for_random(200, [](RandomComplexes& random) {
    const SelectiveComplex s = random.next(3);
    const std::vector<Part> parts = parts_of(s);
    for (std::uint32_t i = 0; i < parts.size(); ++i) {
      const Cell c = s.incidences().cell(i);
      REQUIRE(lies_in_interior(s, c) == (parts[i] == Part::interior));
      REQUIRE(lies_in_exterior(s, c) == (parts[i] == Part::exterior));
      REQUIRE(lies_in_membrane(s, c) == (parts[i] == Part::skin || parts[i] == Part::wound));
      REQUIRE(lies_in_dangle(s, c) == (parts[i] == Part::hair || parts[i] == Part::cut));
      REQUIRE(lies_in_boundary(s, c) == (c.dimension < s.dimension()));  // the complex is minimal
    }
  });
}

}  // namespace strata::complex
