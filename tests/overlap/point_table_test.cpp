#include "core/overlap/point_table.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>
#include <utility>
#include <vector>

#include "core/kernel/input_complex.h"

using namespace strata;

namespace {

using Pairs = std::vector<std::pair<PointId, PointId>>;

}  // namespace

// Catches: points taken for one because their nearest doubles are, and points at one place whose names are not related.
TEST_CASE("points are at one place whatever their names are, and only then", "[overlap]") {
  const double least = 1e-60;
  const std::vector<InputComplex::Coordinates> points{{0, 0, 0},     {4, 0, 0},     {0, 4, 0},  // z = 0
                                                      {1, 1, -1},    {1, 1, 1},  // an edge through (1, 1, 0)
                                                      {3, 3, 0},     {2, 1, 0},     {0, 2, 0},
                                                      {2, 0, 0},  // through it, in z = 0
                                                      {1, 1, least}, {5, 1, least}, {1, 5, least},  // z = least
                                                      {1, 1, 0}};
  const std::vector<InputComplex::Indices> faces{{0, 1, 2}, {3, 4, 5}, {6, 7, 8}, {9, 10, 11}, {12, 3, 6}};
  InputComplex input;
  input.add(points, faces);
  PointTable table(input);
  const std::vector<SymbolicPoint> names{SymbolicPoint::edge_face(3, 4, 0), SymbolicPoint::edge_edge(3, 4, 7, 8),
                                         SymbolicPoint::edge_edge(0, 5, 7, 8), SymbolicPoint::edge_face(3, 4, 3)};
  const auto numbers = table.add(names, {});
  std::vector<PointId> ids = numbers;
  ids.push_back(12);
  ids.push_back(0);
  std::reverse(ids.begin(), ids.end());
  // (1, 1, 0) is there four times; (1, 1, 1e-60) and the origin are alone. The lowest stands for all.
  Pairs same = table.equal_positions(ids, {});
  std::sort(same.begin(), same.end());
  CHECK(same == Pairs{{12, numbers[0]}, {12, numbers[1]}, {12, numbers[2]}});
  CHECK(table.equal_positions({}, {}).empty());
  table.identify(same);
  CHECK(table.representative(numbers[2]) == 12);
  CHECK(table.representative(numbers[3]) == numbers[3]);
}

// Catches: points of one nearest double compared pair by pair, and taken for equal.
TEST_CASE("places between the smallest doubles are told apart", "[overlap]") {
  const double least = std::numeric_limits<double>::denorm_min();
  std::vector<InputComplex::Coordinates> points{{0, 0, 0}, {least, 0, 0}, {0, least, 0}};
  const std::vector<InputComplex::Indices> faces{{0, 1, 2}};
  InputComplex input;
  input.add(points, faces);
  PointTable table(input);
  std::vector<SymbolicPoint> names;
  for (std::uint32_t t = 1; t <= 40; ++t) names.push_back(SymbolicPoint::weighted(0, t));
  CHECK(table.equal_positions(table.add(names, {}), {}).empty());
  names.assign(1, SymbolicPoint::edge_edge(0, 1, 0, 2));
  std::vector<PointId> ids = table.add(names, {});
  for (PointId v = 0; v < table.end(); ++v) ids.push_back(v);
  CHECK(table.equal_positions(ids, {}) == Pairs{{0, table.end() - 1}});
}
