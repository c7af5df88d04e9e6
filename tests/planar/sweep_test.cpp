#include "extensions/planar/sweep.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "extensions/planar/extract.h"
#include "extensions/planar/gather.h"
#include "extensions/planar/labels.h"
#include "planar/shapes.h"

namespace strata::planar {
namespace {

using namespace test;

/// A combination with all intersections and all nesting found by sweeps (patience 0), or all by pairs and rays.
Region combine_with(std::size_t patience, const std::vector<Operand>& operands, Operation operation) {
  Gathered gathered = gather(operands);
  const Arrangement a = arrange(std::move(gathered.segments), {}, patience);
  const Subdivision s = subdivide(a, gathered.first_segment, ChainEnds::nodes, patience);
  return extract(a, s, Labels(gathered, s, operands).evaluate([&](const Inside& i) { return holds(operation, i); }));
}

constexpr std::size_t endless = std::size_t{1} << 40;

bool agree(const std::vector<Operand>& operands, Operation operation) {
  return canonical_form(combine_with(0, operands, operation)) ==
         canonical_form(combine_with(endless, operands, operation));
}

/// Triangles around the origin with corners on a lattice: edges that share it, some along one another, some vertical.
std::vector<Loop> random_fan(Random& random, int grid, double unit) {
  std::vector<Loop> all(2 + random() % 12);
  for (Loop& loop : all) {
    loop.push_back({0, 0});
    for (int i = 0; i < 2; ++i) {
      const auto coordinate = [&] { return unit * (static_cast<double>(random() % (2 * grid + 1)) - grid); };
      loop.push_back({coordinate(), coordinate()});
    }
  }
  return all;
}

/// Teeth of several lengths along x, or along y: edges that cross, touch with their ends, or overlap.
std::vector<Loop> random_comb(Random& random, bool along_x, double unit) {
  std::vector<Loop> all(1);
  const int teeth = 2 + static_cast<int>(random() % 6);
  const auto add = [&](int across, int along) {
    all[0].push_back(along_x ? PlanePoint{unit * along, unit * across} : PlanePoint{unit * across, unit * along});
  };
  add(0, -1);
  for (int i = 0; i < teeth; ++i) {
    add(2 * i, 0);
    add(2 * i + static_cast<int>(random() % 2), 1 + static_cast<int>(random() % (2 * teeth)));
    if (random() % 2 == 0) add(2 * i + 1, 1 + static_cast<int>(random() % (2 * teeth)));
  }
  add(2 * teeth, -1);
  return all;
}

/// Rings around one center, turned and upright, some of which touch; the inner ones end somewhere.
std::vector<Loop> nested(Random& random, double unit) {
  std::vector<Loop> all;
  for (int k = 1; k < 9; ++k) {
    const double r = unit * k;
    Loop loop = random() % 2 == 0 ? box(-r, -r, r, r) : Loop{{r, 0}, {0, r}, {-r, 0}, {0, -r}};
    if (random() % 3 == 0) std::reverse(loop.begin(), loop.end());
    if (random() % 4 != 0) all.push_back(std::move(loop));
  }
  for (int i = 0; i < 4; ++i) {  // small ones, anywhere
    const double x = unit * static_cast<double>(random() % 17) - 8 * unit,
                 y = unit * static_cast<double>(random() % 17) - 8 * unit;
    all.push_back({{x, y}, {x + unit / 2, y}, {x, y + unit / 2}});
  }
  return all;
}

double unit_of(unsigned seed) {
  constexpr std::array units{1.0, 1.0, 1.0, 0x1p-1073, 1e-300, 1e300, 0x1p1018};
  return units[seed % units.size()];
}

}  // namespace

TEST_CASE("a list that is searched by its order stays in order", "[planar][sweep][property]") {
  const auto seed = GENERATE(range(0u, 20u));
  CAPTURE(seed);
  Random random(seed);
  OrderedList list;
  std::vector<std::uint32_t> expected;
  std::vector<std::uint32_t> rank;  // of every place
  const auto check = [&] {
    rank.assign(1000, none);
    for (std::uint32_t i = 0; i < expected.size(); ++i) rank[expected[i]] = i;
    for (std::uint32_t i = 0; i < expected.size(); ++i) {
      REQUIRE(list.before(expected[i]) == (i > 0 ? expected[i - 1] : none));
      REQUIRE(list.after(expected[i]) == (i + 1 < expected.size() ? expected[i + 1] : none));
      REQUIRE(list.first_not([&](std::uint32_t p) { return rank[p] < i; }) == expected[i]);
    }
    REQUIRE(list.last() == (expected.empty() ? none : expected.back()));
    REQUIRE(list.first_not([](std::uint32_t) { return true; }) == none);
  };
  for (int step = 0; step < 400; ++step) {
    const std::size_t at = random() % (expected.size() + 1);
    const bool grows = step < 200 ? random() % 4 != 0 : random() % 4 == 0;
    if (grows || at == expected.size()) {
      const std::uint32_t place = list.insert_after(at > 0 ? expected[at - 1] : none);
      expected.insert(expected.begin() + static_cast<std::ptrdiff_t>(at), place);
    } else {
      list.erase(expected[at]);
      expected.erase(expected.begin() + static_cast<std::ptrdiff_t>(at));
    }
    if (step % 20 == 0) check();
  }
  check();
}

// Catches: bundles lost or torn where they turn around, crossings not looked for after an end, wrong containers.
TEST_CASE("sweeps find what pairs and rays find", "[planar][sweep][degenerate][property]") {
  const auto seed = GENERATE(range(0u, seeds(600)));
  CAPTURE(seed);
  Random random(seed);
  const double unit = unit_of(seed);
  const int grid = 1 + static_cast<int>(random() % 4);
  std::vector<Loop> a, b;
  switch (seed % 4) {
    case 0:
      a = random_fan(random, grid, unit);
      b = random_fan(random, grid, unit);
      break;
    case 1:
      a = random_comb(random, true, unit);
      b = random_comb(random, false, unit);
      break;
    case 2:
      a = nested(random, unit);
      b = nested(random, unit);
      break;
    default:
      a = random_grid_loops(random, 2 * grid, unit);
      b = random_grid_loops(random, 2 * grid, unit);
  }
  const bool thirds = seed % 15 == 0;
  const Loops p = thirds ? in_thirds(a) : loops(a), q = thirds ? in_thirds(b) : loops(b);
  const FillRule fill = seed % 3 == 0 ? FillRule::even_odd : FillRule::nonzero;
  const std::vector<Operand> operands{{p, fill}, {q, fill}};
  for (const Operation operation : {Operation::union_, Operation::symmetric_difference})
    CHECK(agree(operands, operation));
  // Operands with meets for vertices.
  const Region either = combine(operands, Operation::symmetric_difference),
               both = combine(operands, Operation::intersection);
  CHECK(agree({either, both, {q, fill}}, Operation::symmetric_difference));
  CHECK(agree({either, both}, Operation::union_));
}

TEST_CASE("a fan whose edges overlap in several lengths has every end on the longer ones",
          "[planar][sweep][degenerate]") {
  for (const double unit : {1.0, 0x1p-1074, 1e300}) {
    Segments segments;
    segments.places.add(PlanePoint{0, 0});
    for (int k = 1; k <= 5; ++k) segments.places.add(PlanePoint{0, k * unit});  // vertical
    for (int k = 1; k <= 5; ++k) segments.places.add(PlanePoint{-k * unit, 0});
    for (std::uint32_t end = 1; end <= 10; ++end) {
      segments.ends.push_back(end % 2 == 0 ? std::array{0u, end} : std::array{end, 0u});
      segments.places.lines.push_back({segments.ends.back()[0], segments.ends.back()[1]});
    }
    const Arrangement a = arrange(std::move(segments), {}, 0);
    CHECK(a.pieces.size() == 2 * (1 + 2 + 3 + 4 + 5));
    CHECK(a.is_fold[0] != 0);
    for (std::uint32_t s = 0; s < 10; ++s) CHECK(a.first_piece[s + 1] - a.first_piece[s] == s % 5 + 1);
  }
}

TEST_CASE("points under several names, and segments that are points, are one event", "[planar][sweep][degenerate]") {
  Segments segments;
  const auto add = [&](std::uint32_t from, std::uint32_t to) {
    segments.ends.push_back({from, to});
    segments.places.lines.push_back({from, to});
  };
  for (const PlanePoint& p : std::vector<PlanePoint>{{0, 0}, {4, 4}, {0, 4}, {4, 0}, {2, 2}, {7, 7}})
    segments.places.add(p);
  const std::uint32_t third = segments.places.add(RationalPlacement{Rational(1, 3), Rational(1, 3)});
  const std::uint32_t again = segments.places.add(RationalPlacement{Rational(1, 3), Rational(1, 3)});
  add(0, 1);
  add(3, 2);
  add(4, 4);  // a point where they cross
  add(5, 5);  // a point of nothing
  add(third, third);
  add(again, 3);
  for (const std::size_t patience : {std::size_t{0}, endless}) {
    const Arrangement a = arrange(segments, {}, patience);
    CHECK(a.first_piece == std::vector<std::uint32_t>{0, 3, 5, 5, 5, 5, 6});
    CHECK(a.pieces[0][1] == third);
    CHECK(a.pieces[3][1] == 4);
    CHECK(a.vertex_of[again] == third);
  }
}

// These take minutes by pairs.
TEST_CASE("a fan of many triangles around one vertex", "[planar][sweep]") {
  constexpr int count = 20'000;
  std::vector<Loop> fan;
  const auto at = [](int i) {
    const double angle = i * (std::acos(-1.0) / count);
    return PlanePoint{std::cos(angle), std::sin(angle)};
  };
  for (int i = 0; i < count; ++i) fan.push_back({{0, 0}, at(2 * i), at(2 * i + 1)});
  const Region r = fill(loops(fan));
  CHECK(r.polygons() == count);
  CHECK(r.loops.vertices.size() == 3 * count);
}

TEST_CASE("many bow ties through one point that no vertex is at", "[planar][sweep][degenerate]") {
  constexpr int count = 1'000;
  std::vector<Loop> ties;
  const auto at = [](int i) {
    const double angle = (i + 0.3) * (std::acos(-1.0) / (2 * count));
    return PlanePoint{std::cos(angle), std::sin(angle)};
  };
  for (int i = 0; i < count; ++i) {
    const PlanePoint p = at(2 * i), q = at(2 * i + 1);
    ties.push_back({p, {-p[0], -p[1]}, {-q[0], -q[1]}, q});
  }
  const Region r = fill(loops(ties));
  CHECK(r.polygons() == 2 * count);
  CHECK(r.loops.vertices.size() == 6 * count);
}

TEST_CASE("many long slivers side by side, and squares in one another", "[planar][sweep]") {
  constexpr int count = 10'000;
  std::vector<Loop> slivers, squares;
  for (int i = 0; i < count; ++i) {
    const double x = 4 * i, far = 8 * count, r = i + 1;
    slivers.push_back({{x, 0}, {x + 1, 0}, {x + 1 + far, far}, {x + far, far}});
    squares.push_back({{r, 0}, {0, r}, {-r, 0}, {0, -r}});
  }
  CHECK(fill(loops(slivers)).polygons() == count);
  const Region rings = fill({loops(squares), FillRule::even_odd});
  CHECK(rings.polygons() == count / 2);
  CHECK(area(rings) == Rational(count) * (count + 1));
}

}  // namespace strata::planar
