#include "core/kernel/point.h"

#include <catch2/catch.hpp>

#include "kernel/scene.h"

using namespace strata;
using namespace strata::test;

namespace {

/// No double is nearer to x, and a tie went to the even mantissa.
void check_nearest(double found, const Rational& x) {
  const Rational beyond = Rational(Integer(1) << 1024);
  const auto value = [&](double d) { return std::isfinite(d) ? to_rational(d) : d > 0 ? beyond : Rational(-beyond); };
  const Rational off = abs(Rational(value(found) - x));
  for (const double next : {std::nextafter(found, -HUGE_VAL), std::nextafter(found, HUGE_VAL)}) {
    const Rational other = abs(Rational(value(next) - x));
    REQUIRE(off <= other);
    if (off == other && next != found) REQUIRE((std::bit_cast<std::uint64_t>(found) & 1U) == 0);
  }
}

void check_bounds(const Bounded& bound, const Rational& x, double size) {
  const double nearest = to_nearest_double(x);
  REQUIRE(std::isfinite(bound.value) == std::isfinite(nearest));
  if (!std::isfinite(nearest)) {
    REQUIRE_FALSE(std::isfinite(bound.error));
    return;
  }
  REQUIRE(abs(Rational(x - to_rational(bound.value))) <= to_rational(bound.error) * to_rational(Bounded::slack));
  REQUIRE(bound.error <= size * 0x1p-49);
  if (std::isfinite(bound.lower())) REQUIRE(to_rational(bound.lower()) <= x);
  if (std::isfinite(bound.upper())) REQUIRE(x <= to_rational(bound.upper()));
}

void check_point(const InputComplex& input, const Known& known) {
  CAPTURE(static_cast<int>(known.point.name.kind), known.point.name.id);
  REQUIRE(exact_position(input, known.point) == known.place);
  const auto nearest = nearest_doubles(input, known.point);
  double size = 0x1p-900;
  for (const Bounded& x : known.point.at) size = std::max(size, std::abs(x.value));
  for (std::size_t i = 0; i < 3; ++i) {
    check_bounds(known.point.at[i], known.place[i], size);
    check_nearest(nearest[i], known.place[i]);
  }
}

/// The points of one evaluation with vertices `points` and faces of three vertices each, in order.
struct Given {
  Given(std::vector<InputComplex::Coordinates> p, std::vector<InputComplex::Indices> f = {})
      : points(std::move(p)), faces(std::move(f)) {
    input.add(points, faces);
  }
  std::vector<InputComplex::Coordinates> points;
  std::vector<InputComplex::Indices> faces;
  InputComplex input;
};

}  // namespace

// Catches: a sign in a meet, a bound that leaves out an error, a weight not made positive, a unit not applied.
TEST_CASE("every named point lies where its carriers meet", "[kernel][property][degenerate]") {
  for (int family = 0; family < family_count; ++family) {
    for (int i = 0; i < affordable(static_cast<Family>(family), 400); ++i) {
      CAPTURE(family, i);
      Scene scene(static_cast<Family>(family), i % 3 == 2, static_cast<std::uint64_t>(i));
      for (const Known& known : scene.known_points(25)) check_point(scene.input, known);
    }
  }
}

TEST_CASE("names say truly which faces and edges a point is on", "[kernel][property]") {
  int on_faces = 0, on_edges = 0;
  for (int i = 0; i < 300; ++i) {
    CAPTURE(i);
    Scene scene(Family::small_integers, i % 2 == 1, static_cast<std::uint64_t>(i));
    for (const Known& known : scene.known_points(25)) {
      const std::uint32_t f = scene.any_face(), a = scene.any_vertex(), b = scene.any_vertex();
      if (named_on_face(known.point.name, f, scene.input.face(f))) {
        REQUIRE(scene.plane(f).side(known.place) == Sign::zero);
        ++on_faces;
      }
      if (named_on_edge(known.point.name, a, b)) {
        REQUIRE(is_zero(cross(scene.places[b] - scene.places[a], known.place - scene.places[a])));
        ++on_edges;
      }
    }
  }
  CHECK(on_faces > 300);
  CHECK(on_edges > 100);
}

TEST_CASE("names do not depend on the order of their carriers", "[kernel]") {
  CHECK(SymbolicPoint::edge_face(4, 2, 7) == SymbolicPoint::edge_face(2, 4, 7));
  CHECK(SymbolicPoint::edge_edge(4, 2, 1, 9) == SymbolicPoint::edge_edge(9, 1, 2, 4));
  CHECK(SymbolicPoint::edge_edge(1, 2, 1, 3) == SymbolicPoint::edge_edge(3, 1, 2, 1));
  CHECK(SymbolicPoint::three_faces(3, 1, 2) == SymbolicPoint::three_faces(2, 3, 1));
  CHECK(SymbolicPoint::input(3) != SymbolicPoint::weighted(3, 0));
}

// Catches: infinite bounds taken for tight ones.
TEST_CASE("a point between vertices whose difference overflows is found", "[kernel]") {
  const Given given({{-1.7e308, -1.7e308, 1}, {1.7e308, 1.7e308, 1}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}}, {{2, 3, 4}});
  const Point p = make_point(given.input, SymbolicPoint::edge_face(0, 1, 0));
  CHECK(p.at[0].value == 0);
  CHECK(p.at[1].value == 0);
  CHECK(p.at[2].value == 1);
  CHECK(std::isfinite(p.at[0].error));
}

TEST_CASE("a meet beyond the largest double has no finite bound", "[kernel]") {
  const Given given({{0, 0, 0}, {1, 0, 1e-300}, {0, 0, 1e300}, {0, 1, 1e300}, {1, 0, 1e300}}, {{2, 3, 4}});
  const Point p = make_point(given.input, SymbolicPoint::edge_face(0, 1, 0));
  CHECK_FALSE(std::isfinite(p.at[0].error));
  CHECK(nearest_doubles(given.input, p)[0] == HUGE_VAL);
  CHECK(to_nearest_double(exact_position(given.input, p)[2]) == 1e300);
}

TEST_CASE("nearly parallel carriers still give a bound of a few ulps", "[kernel]") {
  const double up = std::nextafter(1.0, 2.0);
  const Given given({{0, 0, 1}, {1, 0, up}, {0, 0, 1}, {3, 0, 1}, {0, 1, 1}, {7, 7, 1}}, {{3, 4, 5}});
  const Point p = make_point(given.input, SymbolicPoint::edge_face(0, 1, 0));
  for (const Bounded& x : p.at) CHECK(x.error <= 0x1p-49);
  CHECK(exact_position(given.input, p) == RationalPoint{0, 0, 1});
}

TEST_CASE("an input vertex keeps its doubles, and a rational one its nearest", "[kernel]") {
  const std::vector<InputComplex::Coordinates> points{{-0.0, 0.1, 3}, {1.0 / 3, 0, 0}};
  const std::vector<ExactVertex> exact{{1, {Rational(1, 3), 0, 0}}};
  InputComplex input;
  input.add(points, {}, exact);
  const Point p = make_point(input, SymbolicPoint::input(0)), q = make_point(input, SymbolicPoint::input(1));
  CHECK(p.at[1].value == 0.1);
  CHECK(p.at[1].error == 0);
  CHECK(q.at[0].error > 0);
  CHECK(exact_position(input, q)[0] == Rational(1, 3));
  CHECK(nearest_doubles(input, q)[0] == 1.0 / 3);
}
