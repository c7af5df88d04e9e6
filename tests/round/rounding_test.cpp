#include "core/round/rounding.h"

#include <catch2/catch.hpp>

#include "support/random.h"

using namespace strata;

namespace {

RationalPoint cross(const RationalPoint& u, const RationalPoint& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

Rational dot(const RationalPoint& u, const RationalPoint& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }

RationalPoint minus(const Vertex& p, const Vertex& q) {
  return {to_rational(p[0]) - to_rational(q[0]), to_rational(p[1]) - to_rational(q[1]),
          to_rational(p[2]) - to_rational(q[2])};
}

/// Only input complex that meet in one point name one.
bool meet_in_one_point(const std::vector<Vertex>& p, const SymbolicPoint& name) {
  const auto normal = [&](std::size_t f) {
    return cross(minus(p[3 * f + 1], p[3 * f]), minus(p[3 * f + 2], p[3 * f]));
  };
  if (name.kind == SymbolicPoint::Kind::edge_face) return dot(normal(1), minus(p[1], p[0])) != 0;
  return dot(normal(0), cross(normal(1), normal(2))) != 0;
}

}  // namespace

TEST_CASE("constructed points round to the nearest doubles, ties included", "[round][property]") {
  test::Random random(4);
  for (int n = 0; n < 3'000; ++n) {
    std::vector<Vertex> points(9);
    const bool lattice = random.once_in(2);
    for (Vertex& p : points)
      for (double& x : p) x = lattice ? random.between(-4, 4) : random.unit() * 2 - 1;
    const std::vector<Triangle> faces{{0, 1, 2}, {3, 4, 5}, {6, 7, 8}};
    InputComplex input;
    input.add(points, faces);
    const auto name = random.once_in(2) ? SymbolicPoint::edge_face(0, 1, 1) : SymbolicPoint::three_faces(0, 1, 2);
    if (!meet_in_one_point(points, name)) continue;
    PointTable table(input);
    std::vector<PointId> constructed = table.add(std::vector{name}, {});
    const Boundary boundary{{}, std::move(constructed), {}, {}, {}, std::move(table)};
    const auto rounded = round_to_doubles(input, boundary, {});
    const RationalPoint exact = exact_position(input, make_point(input, name));
    for (std::size_t i = 0; i < 3; ++i) REQUIRE(rounded[0][i] == to_nearest_double(exact[i]));
    const auto places = exact_positions(input, boundary, rounded, {});
    const bool is_double = to_rational(rounded[0][0]) == exact[0] && to_rational(rounded[0][1]) == exact[1] &&
                           to_rational(rounded[0][2]) == exact[2];
    REQUIRE(places.size() == (is_double ? 0 : 1));
    if (!is_double) REQUIRE(places[0].position == exact);
  }
}
