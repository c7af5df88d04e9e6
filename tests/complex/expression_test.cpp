#include <catch2/catch.hpp>
#include <map>

#include "random_complex.h"
#include "strata/complex.h"
#include "support/rounds.h"

namespace strata::complex {
namespace {

/// Names that stand for complexes.
class Names {
 public:
  Expression parse(const std::string& text) {
    return parse_expression(
        text, [this](const std::string& name) { return solids_.try_emplace(name, Solid::trusted({})).first->second; });
  }

 private:
  std::map<std::string, Solid> solids_;
};

}  // namespace

TEST_CASE("expressions of complexes are evaluated at once, as they are step by step",
          "[complex][expression][property]") {
  Names names;
  const Expression e = names.parse("(a - b) - (c - d) ^ (a & ~c)");
  REQUIRE(e.primitives().size() == 4);
  for (const int dimension : {2, 3})
    for (std::uint32_t seed = 0; seed < test::rounds(60); ++seed) {
      CAPTURE(dimension, seed);
      RandomComplexes random(dimension, seed);
      const std::vector<SelectiveComplex> s{random.next(2), random.next(2), random.next(2), random.next(2)};
      const SelectiveComplex &a = s[0], &b = s[1], &c = s[2], &d = s[3];
      const SelectiveComplex result = evaluate(e, s);
      REQUIRE(result == (((a - b) - (c - d)) ^ (a & ~c)));
      for (const Expression& form : {e.positive_form(), e.disjunctive_form()}) {
        std::vector<SelectiveComplex> in_its_order;
        for (const auto& p : form.primitives()) in_its_order.push_back(s[static_cast<std::size_t>(p.name[0] - 'a')]);
        REQUIRE(evaluate(form, in_its_order) == result);
      }
      const auto products = e.products();
      for (int i = 0; i < 20; ++i) {
        const Vertex p = random.corner();
        REQUIRE(contains(products, s, p) == contains(result, p));
      }
    }
}

TEST_CASE("negative primitives are told without conversion", "[complex][expression]") {
  Names names;
  // Exercise 9 of the source: ((A\B)uC) \ ((DnE')n(G\H)).
  const Expression e = names.parse("((a - b) | c) - ((d - e) & (g - h))");
  std::string negative;
  for (const auto& p : e.primitives())
    if (p.negative) negative += p.name;
  CHECK(negative == "bdg");
  CHECK(e.positive_form().text() == "a - b + c & ((~d | e) | (~g | h))");
}

TEST_CASE("a disjunctive form asks of a primitive once, and not beyond need", "[complex][expression]") {
  Names names;
  const Expression e = names.parse("(a - b) | (b & c) | (c & d)");
  int asked = 0;
  const auto in_b_and_c = [&](std::uint32_t k) {
    ++asked;
    return k == 1 || k == 2;
  };
  CHECK(is_in_products(e.products(), in_b_and_c));
  CHECK(asked <= 3);
  // Exercise 10: (A\B)\(C\D) = (A n !B n !C) u (A n !B n D).
  CHECK(names.parse("(a - b) - (c - d)").products() ==
        Expression::Products{{{0, false}, {1, true}, {2, true}}, {{0, false}, {1, true}, {3, false}}});
}

TEST_CASE("a disjunctive form that grows exponentially is refused", "[complex][expression]") {
  Names names;
  std::string text;
  for (int i = 0; i < 24; ++i) text += (i > 0 ? " & (p" : "(p") + std::to_string(i) + " | q" + std::to_string(i) + ")";
  CHECK_THROWS_AS(names.parse(text).products(100'000), std::length_error);
}

}  // namespace strata::complex
