// The Menger sponge: all coordinates are thirds of thirds, so no double holds them, and all faces touch.
#include <array>
#include <catch2/catch.hpp>
#include <chrono>
#include <iostream>

#include "strata/expression.h"
#include "strata/measure.h"
#include "support/rounds.h"
#include "support/shapes.h"
#include "support/transform.h"

using namespace strata;

namespace {

int power(int base, int exponent) { return exponent == 0 ? 1 : base * power(base, exponent - 1); }

/// Of three ternary digits at one place at least two are 1: the middle of a side, or of the cube.
bool is_hole(int x, int y, int z) { return (x % 3 == 1) + (y % 3 == 1) + (z % 3 == 1) >= 2; }

Solid unit_cube() { return Solid(test::box({0, 0, 0}, {1, 1, 1})); }

/// The part of a cube of three by three by three.
Transform to_part(int x, int y, int z) {
  const Rational third(1, 3);
  return Transform::scaling({third, third, third}) * Transform::translation({x, y, z});
}

/// 20 copies of what it makes from the level before, down to cubes: 20^levels solids.
Expression of_cubes(const Expression& cube, int levels) {
  if (levels == 0) return cube;
  const Expression smaller = of_cubes(cube, levels - 1);
  std::vector<Expression> parts;
  for (int x = 0; x < 3; ++x)
    for (int y = 0; y < 3; ++y)
      for (int z = 0; z < 3; ++z)
        if (!is_hole(x, y, z)) parts.push_back(smaller.transformed(to_part(x, y, z)));
  return Expression::any(parts);
}

/// A square bar through the cube along an axis: its lower corner, in numbers of its sides.
Expression bar(std::size_t axis, int u, int v, int parts) {
  RationalPoint lower, size;
  for (std::size_t k = 0; k < 3; ++k) {
    const bool along = k == axis;
    lower[k] = along ? Rational(0) : Rational(k == (axis + 1) % 3 ? u : v, parts);
    size[k] = along ? Rational(1) : Rational(1, parts);
  }
  return Expression(unit_cube()).transformed(Transform::translation(lower) * Transform::scaling(size));
}

/// The cube without square bars along three axes: 3 (1 + 8 + 64 + ...) of them.
Expression without_bars(int levels) {
  std::vector<Expression> bars;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (int level = 1; level <= levels; ++level)
      for (int u = 1; u < power(3, level); u += 3)
        for (int v = 1; v < power(3, level); v += 3) {
          bool open = true;  // not in a larger bar
          for (int a = u / 3, b = v / 3; a > 0 && b > 0; a /= 3, b /= 3) open = open && !(a % 3 == 1 && b % 3 == 1);
          if (open) bars.push_back(bar(axis, u, v, power(3, level)));
        }
  return Expression(unit_cube()) - Expression::any(bars);
}

/// From the cells that are left, without any Boolean.
CanonicalForm known_form(int levels) {
  const int n = power(3, levels);
  test::CellGrid grid(n, n, n, true);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k)
        for (int x = i, y = j, z = k, level = 0; level < levels; ++level, x /= 3, y /= 3, z /= 3)
          if (is_hole(x, y, z)) grid.filled[grid.number(i, j, k)] = false;
  test::Affine map{};
  for (std::size_t k = 0; k < 3; ++k) map.columns[k][k] = Rational(1, n);
  return canonical_form(mapped(test::cell_solid(grid), map));
}

void check_sponge(const Solid& sponge, int levels) {
  constexpr std::array genus{0, 5, 81, 1409};
  const Rational volume(power(20, levels), power(27, levels));
  CHECK(sponge.volume() == volume);
  const Topology facts = topology(sponge.exact_mesh());
  CHECK(facts.components == 1);
  CHECK(facts.open_edges == 0);
  CHECK(facts.non_manifold_edges == 0);
  CHECK(facts.non_manifold_vertices == 0);
  CHECK(facts.euler == 2 - 2 * genus[static_cast<std::size_t>(levels)]);
  CHECK((sponge.canonical() == known_form(levels)));
}

/// Evaluates, says how long that took, and checks.
void check_sponge(const char* way, const Expression& expression, int levels) {
  const auto start = std::chrono::steady_clock::now();
  const Solid sponge = expression.evaluate();
  std::cout << "Menger sponge of level " << levels << ", " << expression.size() << " " << way << ": "
            << std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() << " s, "
            << sponge.mesh().triangles.size() << " triangles\n";
  check_sponge(sponge, levels);
}

}  // namespace

// Catches: rational vertices that are rounded on the way, contacts of thirds that are missed, facets not merged.
TEST_CASE("Menger sponges of two levels have their volume, genus and form", "[csg][menger]") {
  check_sponge("cubes", of_cubes(unit_cube(), 1), 1);
  check_sponge("cubes and bars", without_bars(1), 1);
  check_sponge("cubes and bars", without_bars(2), 2);
  if (test::is_sanitized) return;
  check_sponge("smaller sponges", of_cubes(of_cubes(unit_cube(), 1).evaluate(), 1), 2);
}

TEST_CASE("a Menger sponge of 400 cubes has its volume, genus and form", "[csg][menger][slow]") {
  check_sponge("cubes", of_cubes(unit_cube(), 2), 2);
}

TEST_CASE("a Menger sponge of three levels has its volume, genus and form", "[csg][menger]") {
  if (test::is_sanitized) return;
  check_sponge("cubes and bars", without_bars(3), 3);
}

TEST_CASE("a Menger sponge of smaller ones has its volume, genus and form", "[csg][menger][slow]") {
  check_sponge("smaller sponges", of_cubes(without_bars(2).evaluate(), 1), 3);
}

TEST_CASE("a Menger sponge of 8,000 cubes has its volume, genus and form", "[csg][menger][slow]") {
  check_sponge("cubes", of_cubes(unit_cube(), 3), 3);
}
