#include "strata/expression.h"

#include <catch2/catch.hpp>
#include <map>

#include "support/random.h"
#include "support/shapes.h"
#include "support/touching.h"

using namespace strata;
using test::box;

namespace {

Solid unit(double x, double y = 0, double z = 0) { return Solid(box({x, y, z}, {x + 1, y + 1, z + 1})); }

Solid join_of(Operation operation, const Solid& a, const Solid& b) {
  const Solid both[] = {a, b};
  return combine_solids(operation, both);
}

/// A random expression over solids, and what its steps give one after the other.
struct Tree {
  Expression expression;
  Solid solid;
};

Tree random_tree(const std::vector<Solid>& solids, test::Random& random, int depth) {
  if (depth == 0 || random.once_in(6)) {
    const auto n = random.below(solids.size());
    return {Expression(solids[n], std::string(1, static_cast<char>('a' + n))), solids[n]};
  }
  const Tree a = random_tree(solids, random, depth - 1), b = random_tree(solids, random, random.between(0, depth - 1));
  switch (random.below(4)) {
    case 0:
      return {a.expression | b.expression, join_of(Operation::union_, a.solid, b.solid)};
    case 1:
      return {a.expression & b.expression, join_of(Operation::intersection, a.solid, b.solid)};
    case 2:
      return {a.expression - b.expression, join_of(Operation::difference, a.solid, b.solid)};
    default:
      return {a.expression ^ b.expression, join_of(Operation::symmetric_difference, a.solid, b.solid)};
  }
}

std::vector<Solid> touching_solids(std::uint64_t seed, std::size_t count) {
  std::vector<Solid> solids;
  for (std::uint64_t n = 0; solids.size() < count; ++n)
    for (const Mesh& m : test::touching_operands(seed * 100 + n).meshes)
      if (solids.size() < count) solids.emplace_back(m);
  return solids;
}

Solid parsed(const std::string& text, const std::map<std::string, Solid>& solids) {
  return parse_expression(text, [&](const std::string& name) { return solids.at(name); }).evaluate();
}

}  // namespace

// Catches: rules that differ from steps, solids that occur twice, forms that are not equal.
TEST_CASE("an expression is what its steps, its positive and its disjunctive form are", "[csg][property]") {
  const auto seed = GENERATE(range(std::uint64_t{0}, std::uint64_t{40}));
  CAPTURE(seed);
  test::Random random(seed);
  const auto solids = touching_solids(seed, 2 + random.below(5));
  const Tree tree = random_tree(solids, random, 5);
  CAPTURE(tree.expression.text());
  const Solid at_once = tree.expression.evaluate();
  REQUIRE(at_once == tree.solid);
  REQUIRE(tree.expression.positive_form().evaluate() == tree.solid);
  REQUIRE(tree.expression.disjunctive_form().evaluate() == tree.solid);
  std::map<std::string, Solid> names;
  for (std::size_t n = 0; n < solids.size(); ++n) names[std::string(1, static_cast<char>('a' + n))] = solids[n];
  REQUIRE(parsed(tree.expression.text(), names) == tree.solid);
}

TEST_CASE("complements cancel and De Morgan's laws hold", "[csg]") {
  const Expression a(unit(0), "a"), b(unit(.5, .5), "b");
  const Solid both = (a & b).evaluate();
  CHECK((~(~a | ~b)).evaluate() == both);
  CHECK((~~a & b).evaluate() == both);
  CHECK((a - ~b).evaluate() == both);
  CHECK(both.volume() == Rational(1, 4));
  CHECK((~a ^ ~b).evaluate() == (a ^ b).evaluate());
  CHECK_THROWS_WITH((~a).evaluate(), Catch::Contains("not bounded"));
  CHECK_THROWS_WITH((a | ~b).evaluate(), Catch::Contains("not bounded"));
}

TEST_CASE("solids that cannot matter are found", "[csg]") {
  const Expression a(unit(0), "a"), b(unit(.5), "b"), c(unit(.25), "c");
  const auto matters = [](const Expression& e) {
    std::string names;
    for (const Expression::Primitive& p : e.primitives())
      if (p.matters) names += p.name;
    return names;
  };
  CHECK(matters(a | (a & b)) == "a");
  CHECK(matters((a - b) | (a & b)) == "a");
  CHECK(matters(a ^ b ^ a) == "b");
  CHECK(matters((a & c) | (b - c)) == "acb");
  CHECK(matters(a - a) == "");
  CHECK((a | (a & b)).evaluate() == unit(0));
  CHECK((a - a).evaluate().is_empty());
  CHECK((a ^ a).evaluate().is_empty());
}

TEST_CASE("primitives tell how they occur", "[csg]") {
  const Expression a(unit(0), "a"), b(unit(.5), "b"), c(unit(.25), "c");
  const auto primitives = (a - (b ^ c)).primitives();
  REQUIRE(primitives.size() == 3);
  CHECK((primitives[0].positive && !primitives[0].negative));
  CHECK((primitives[1].positive && primitives[1].negative));
  const auto plain = (a - (b - c)).primitives();
  CHECK((!plain[1].positive && plain[1].negative));
  CHECK((plain[2].positive && !plain[2].negative));
  CHECK((a - (b ^ c)).size() == 3);
  CHECK((a - (b ^ c)).positive_form().size() == 5);
  CHECK((a - (b ^ c)).disjunctive_form().text() == "a - b - c | a & b & c");
}

// Catches: a pair of parentheses for every second operator, and texts that are copied for every operator.
TEST_CASE("sums are written as they are read, of any length", "[csg]") {
  const auto written = [](const std::string& text) {
    return parse_expression(text, [](const std::string&) { return Solid(); }).text();
  };
  for (const char* text : {"a - b + c - d + e", "a - b + ~c - d", "(a | b) - c + d", "a - b | c & d",
                           "(a - b | c & d) - e", "a & b - c + d", "a - (b - c + d)", "a - b | c - d", "~(a - b + c)"})
    CHECK(written(text) == text);
  std::string sum = "a";
  for (int n = 0; n < 50'000; ++n) sum += n % 2 == 0 ? " - b" : " + c";
  CHECK(written(sum) == sum);
}

TEST_CASE("forms beyond a size are refused", "[csg]") {
  std::vector<Expression> terms;
  for (int i = 0; i < 40; ++i) terms.emplace_back(unit(i * .5), std::string("s").append(std::to_string(i)));
  const Expression odd = Expression::odd(terms);
  CHECK_THROWS_AS(odd.positive_form(), std::length_error);
  CHECK_THROWS_AS(odd.disjunctive_form(1000), std::length_error);
  CHECK(odd.evaluate().volume() == 1);
}

TEST_CASE("transforms are exact, multiplied first, and mirror as they should", "[csg]") {
  const Solid a = unit(0);
  const Expression third =
      Expression(a).transformed(Transform::scaling({Rational(1, 3), Rational(1, 3), Rational(1, 3)}));
  CHECK(third.evaluate().volume() == Rational(1, 27));
  const Expression back = third.transformed(Transform::scaling({3, 3, 3}));
  CHECK(back.evaluate() == a);
  CHECK(back.evaluate().exact_mesh().exact.empty());
  const Expression mirrored = Expression(a).transformed(Transform::mirror({1, 0, 0}));
  CHECK(mirrored.evaluate() == unit(-1));
  CHECK((Expression(a) | mirrored).evaluate().canonical().facet_count() == 6);
  const Expression moved = (Expression(a) | mirrored).transformed(Transform::translation({Rational(1, 10), 0, 0}));
  CHECK(moved.evaluate().volume() == 2);
  CHECK_FALSE(moved.evaluate().exact_mesh().exact.empty());
  const Expression rounded =
      Expression(a).transformed(Transform::translation({Rational(1, 3), 0, 0}), Placement::rounded);
  CHECK(rounded.evaluate().exact_mesh().exact.empty());
  CHECK(rounded.evaluate().mesh().vertices[0][0] == 1.0 / 3);
  CHECK_THROWS_AS(Transform::scaling({1, 0, 1}), std::invalid_argument);
  CHECK_THROWS_AS(Expression(a).transformed(Transform::scaling({to_rational(1e308) * 10, 1, 1})).evaluate(),
                  std::overflow_error);
}

TEST_CASE("chains of any length are made, read, evaluated and forgotten", "[csg]") {
  Expression chain(Solid(box({0, 0, 0}, {2000, 1, 1})), "a");
  for (int i = 0; i < 1000; ++i) chain = chain - Expression(unit(2 * i, .5), "b");
  CHECK(chain.evaluate().volume() == 1500);
  Expression long_chain(unit(0), "a");
  for (int i = 0; i < 300'000; ++i) long_chain = long_chain | (long_chain.transformed(Transform()) - long_chain);
  CHECK(long_chain.size() == ~std::size_t{0});
  CHECK_THROWS_AS(long_chain.evaluate(), std::length_error);
}

TEST_CASE("texts are read, and errors have places", "[csg]") {
  const std::map<std::string, Solid> solids{{"a", unit(0)}, {"b", unit(.5)}, {"c.x_1", unit(.25)}};
  CHECK(parsed(" a ", solids).volume() == 1);
  CHECK(parsed("a-b", solids).volume() == Rational(1, 2));
  CHECK(parsed("a - b | b & c.x_1", solids).volume() == Rational(5, 4));
  CHECK(parsed("a & b - a + b", solids) == parsed("a & ((b - a) | b)", solids));
  CHECK(parsed("a ^ b & b ^ a", solids).volume() == 1);
  CHECK(parsed("!~a", solids).volume() == 1);
  const auto position_of_error = [&](const std::string& text) {
    try {
      (void)parsed(text, solids);
    } catch (const ParseError& error) {
      return static_cast<int>(error.position());
    }
    return -1;
  };
  CHECK(position_of_error("") == 0);
  CHECK(position_of_error("a - ") == 4);
  CHECK(position_of_error("a b") == 2);
  CHECK(position_of_error("(a - b") == 0);
  CHECK(position_of_error("a) - b") == 1);
  CHECK(position_of_error("a | (b & d)") == 9);
  CHECK(position_of_error("a $ b") == 2);
  CHECK(position_of_error(std::string(100'000, '(')) == 1001);
  CHECK_THROWS_WITH(parsed("a & (b - d)", solids), Catch::Contains("column 10") && Catch::Contains("'d'"));
}

TEST_CASE("an expression about other solids keeps its names, maps and sharing", "[csg]") {
  const Solid a = unit(0), b = unit(0.5);
  const Expression x(a, "x"), y(b, "y");
  const Expression whole = ((x | y) - x.transformed(Transform::translation({0, 0, Rational(1, 2)}))) ^ ~~(x & y);
  int calls = 0;
  const Expression grown = whole.with_solids([&](const Solid& solid) {
    ++calls;
    return solid.scaled(2);
  });
  CHECK(calls == 2);
  CHECK(grown.text() == whole.text());
  CHECK(grown.size() == whole.size());
  CHECK(grown.primitives().size() == whole.primitives().size());
  const Expression u(a.scaled(2), "x"), v(b.scaled(2), "y");
  CHECK(grown.evaluate() ==
        (((u | v) - u.transformed(Transform::translation({0, 0, Rational(1, 2)}))) ^ (u & v)).evaluate());

  Expression chain = x;
  for (int i = 0; i < 100'000; ++i) chain = chain | y;
  CHECK(chain.with_solids([](const Solid& solid) { return solid; }).size() == chain.size());
}
