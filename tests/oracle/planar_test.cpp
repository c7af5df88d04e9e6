#include <CGAL/Gmpq.h>
#include <CGAL/Polygon_set_2.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <iostream>
#include <list>
#include <string>

#include "core/exact/big_integer.h"
#include "extensions/planar/extract.h"
#include "extensions/planar/gather.h"
#include "extensions/planar/labels.h"
#include "planar/shapes.h"

// Booleans of polygons beside CGAL's Boolean_set_operations_2: a sweep over curves, no code in common.
namespace strata::planar {
namespace {

using Kernel = CGAL::Simple_cartesian<CGAL::Gmpq>;
using Polygon = CGAL::Polygon_2<Kernel>;
using Set = CGAL::Polygon_set_2<Kernel>;

CGAL::Gmpq to_gmpq(const Rational& x) { return CGAL::Gmpq(native(x).backend().data()); }
Rational from_gmpq(const CGAL::Gmpq& x) {
  Rational r;
  mpq_set(native(r).backend().data(), x.mpq());
  return r;
}

/// What loops fill by parity, as CGAL sees it: the symmetric difference of the triangles that edges make with a point.
Set parity_of(const Loops& loops) {
  Set set;
  const Kernel::Point_2 apex(-1, -3);
  for (std::uint32_t l = 0; l < loops.size(); ++l) {
    const auto loop = loops.loop(l);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      Polygon triangle;
      triangle.push_back(apex);
      for (const std::uint32_t v : {loop[i], loop[(i + 1) % loop.size()]}) {
        const RationalPlacement p = exact_position(loops.places, v);
        triangle.push_back({to_gmpq(p[0]), to_gmpq(p[1])});
      }
      const auto orientation = CGAL::orientation(triangle[0], triangle[1], triangle[2]);
      if (orientation == CGAL::COLLINEAR) continue;
      if (orientation == CGAL::CLOCKWISE) std::reverse(triangle.container().begin(), triangle.container().end());
      set.symmetric_difference(triangle);
    }
  }
  return set;
}

Set combined(Operation operation, Set a, const Set& b) {
  switch (operation) {
    case Operation::union_:
      a.join(b);
      break;
    case Operation::intersection:
      a.intersection(b);
      break;
    case Operation::difference:
      a.difference(b);
      break;
    case Operation::symmetric_difference:
      a.symmetric_difference(b);
      break;
  }
  return a;
}

struct Facts {
  Rational area = 0;
  std::vector<std::vector<RationalPlacement>> loops;
};

/// CGAL's polygons: their area as CGAL computes it, and their loops, without what goes straight on.
Facts facts_of(const Set& set) {
  std::list<CGAL::Polygon_with_holes_2<Kernel>> polygons;
  set.polygons_with_holes(std::back_inserter(polygons));
  Facts facts;
  LoopsBuilder builder;
  const auto add = [&](const Polygon& polygon) {
    facts.area += from_gmpq(polygon.area());
    for (const auto& p : polygon.container()) builder.add_vertex(RationalPlacement{from_gmpq(p.x()), from_gmpq(p.y())});
    builder.end_loop();
  };
  for (const auto& polygon : polygons) {
    add(polygon.outer_boundary());
    for (auto hole = polygon.holes_begin(); hole != polygon.holes_end(); ++hole) add(*hole);
  }
  facts.loops = canonical_form(fill(builder.finish()));
  return facts;
}

Loops random_loops(test::Random& random, std::uint64_t seed) {
  const auto all = test::random_grid_loops(random, 2 + static_cast<int>(seed % 6));
  return seed % 4 == 0 ? test::in_thirds(all) : test::loops(all);
}

/// `combine` with monotone chains wherever there are any.
Region combined_by_chains(std::span<const Operand> operands, Operation operation) {
  Gathered gathered = gather(thin(operands, 1, std::size_t{1} << 40));
  const Arrangement a = arrange(std::move(gathered.segments));
  const Subdivision s = subdivide(a, gathered.first_segment);
  return extract(a, s, Labels(gathered, s, operands).evaluate([&](const Inside& i) { return holds(operation, i); }));
}

void compare_seeds(std::uint64_t first, std::uint64_t last) {
  if (const char* seeds = std::getenv("STRATA_SEEDS")) {  // "first-last": a part of the long run
    const std::string text = seeds;
    first = std::stoull(text);
    last = std::stoull(text.substr(text.find('-') + 1));
  }
  for (std::uint64_t seed = first; seed < last; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    const Loops a = random_loops(random, seed), b = random_loops(random, seed / 4);
    const auto operation = static_cast<Operation>(seed % 4);
    const Region ours = combine(std::vector<Operand>{{a, FillRule::even_odd}, {b, FillRule::even_odd}}, operation);
    const Facts theirs = facts_of(combined(operation, parity_of(a), parity_of(b)));
    CHECK(area(ours) == theirs.area);
    CHECK(canonical_form(ours) == theirs.loops);
  }
  std::cout << "polygons " << first << "-" << last << " compared with CGAL's Boolean_set_operations_2\n";
}

}  // namespace

// Catches: whatever the library's own laws and definitions have in common with its arrangement.
TEST_CASE("600 Booleans of random degenerate polygons are what CGAL gives", "[oracle][planar]") {
  compare_seeds(0, 600);
}

TEST_CASE("60 Booleans of outlines of arcs are what CGAL gives", "[oracle][planar]") {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    const int grid = 2 + static_cast<int>(seed % 3);
    const Loops a = test::loops(test::random_arcs(random, grid)), b = test::loops(test::random_arcs(random, grid));
    const auto operation = static_cast<Operation>(seed % 4);
    const Region ours =
        combined_by_chains(std::vector<Operand>{{a, FillRule::even_odd}, {b, FillRule::even_odd}}, operation);
    CHECK(canonical_form(ours) == facts_of(combined(operation, parity_of(a), parity_of(b))).loops);
  }
}

TEST_CASE("9,400 more Booleans of random degenerate polygons are what CGAL gives", "[oracle][planar][slow]") {
  compare_seeds(600, 10000);
}

}  // namespace strata::planar
