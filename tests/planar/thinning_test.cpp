#include "extensions/planar/thinning.h"

#include <catch2/catch.hpp>
#include <numbers>

#include "extensions/planar/extract.h"
#include "extensions/planar/gather.h"
#include "extensions/planar/labels.h"
#include "planar/shapes.h"
#include "strata/planar.h"

namespace strata::planar {
namespace {

using namespace test;

constexpr std::size_t endless = std::size_t{1} << 40;

struct Pipeline {
  bool has_chains = true;
  std::size_t patience = usual_patience;
  std::size_t chains = 0;  ///< so far

  Region combine(const std::vector<Operand>& operands, Operation operation) {
    Thinned thinned = thin(operands, has_chains ? 1 : none, endless);
    chains += thinned.chains.size();
    Gathered gathered = gather(std::move(thinned));
    const Arrangement a = arrange(std::move(gathered.segments), {}, patience);
    const Subdivision s = subdivide(a, gathered.first_segment, ChainEnds::nodes, patience);
    return extract(a, s, Labels(gathered, s, operands).evaluate([&](const Inside& i) { return holds(operation, i); }));
  }
};

/// All that is listed, in its order; places by their nearest doubles, too.
struct Listed {
  std::vector<std::uint32_t> first_loop, first_vertex;
  std::vector<RationalPlacement> corners;
  std::vector<PlanePoint> nearest;
  std::vector<std::uint32_t> partner;  ///< of every vertex: the first one with its number
  friend bool operator==(const Listed&, const Listed&) = default;
};
Listed listed(const Region& r) {
  Listed all{r.first_loop, r.loops.first_vertex, {}, {}, {}};
  const auto& vertices = r.loops.vertices;
  for (const std::uint32_t v : vertices) {
    all.corners.push_back(exact_position(r.loops.places, v));
    all.nearest.push_back(r.loops.places.place[v]);
    all.partner.push_back(
        static_cast<std::uint32_t>(std::find(vertices.begin(), vertices.end(), v) - vertices.begin()));
  }
  return all;
}

double unit_of(unsigned seed) {
  constexpr std::array units{1.0, 1.0, 0x1p-1074, 1e300, 0x1p-300, 0.1, 0x1p1010};
  return units[seed % units.size()];
}

/// With vertices on the way, vertices twice, and steps back.
Loop disturbed(Random& random, const Loop& loop) {
  Loop all;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const PlanePoint &p = loop[i], &q = loop[(i + 1) % loop.size()];
    all.push_back(p);
    if (random() % 4 == 0) all.push_back({p[0] / 2 + q[0] / 2, p[1] / 2 + q[1] / 2});
    if (random() % 16 == 0) all.push_back(p);
    if (random() % 16 == 0) all.insert(all.end(), {q, p});
  }
  return all;
}

/// Steps within one quadrant, many of them level or vertical, closed from outside.
Loop random_stairs(Random& random, int grid, double unit) {
  const double right = random() % 2 == 0 ? 1 : -1, up = random() % 2 == 0 ? 1 : -1;
  double x = static_cast<double>(random() % (64 * static_cast<unsigned>(grid))),
         y = static_cast<double>(random() % (64 * static_cast<unsigned>(grid)));
  Loop loop;
  for (int i = 0; i < 24; ++i) {
    loop.push_back({unit * x, unit * y});
    x += right * static_cast<double>(random() % 4);
    y += up * static_cast<double>(random() % 4);
  }
  loop.push_back({unit * (x + 40), unit * (y + 3)});
  return loop;
}

/// Arcs and stairs, islands among them, loops given twice, loops of few vertices.
std::vector<Loop> random_outlines(Random& random, int grid, double unit) {
  std::vector<Loop> all = random_arcs(random, grid, unit);
  for (Loop& loop : all) {
    if (random() % 4 == 0) loop = disturbed(random, loop);
    if (random() % 8 == 0)
      std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(random() % loop.size()), loop.end());
  }
  for (std::size_t i = 0, islands = random() % 2 * (random() % 8); i < islands; ++i) {
    const auto coordinate = [&] { return static_cast<double>(random() % (64 * static_cast<unsigned>(grid))); };
    const double x = unit * coordinate(), y = unit * coordinate(), r = unit * static_cast<double>(1 + random() % 9);
    all.push_back({{x, y}, {x + r, y}, {x + r + unit, y + r}, {x, y + r}});
    if (random() % 2 == 0) std::reverse(all.back().begin(), all.back().end());
  }
  for (std::size_t i = random() % 4; i > 0; --i) all.push_back(random_stairs(random, grid, unit));
  if (random() % 8 == 0) all.push_back(all[0]);
  if (random() % 8 == 0) all.push_back({all[0][0], all[0][random() % all[0].size()]});
  if (random() % 8 == 0) all.push_back({all[0][random() % all[0].size()]});
  return all;
}

Loops circle(double x, double y, double radius, int edges) {
  Loop loop;
  for (int i = 0; i < edges; ++i) {
    const double angle = 2 * std::numbers::pi * i / edges;
    loop.push_back({x + radius * std::cos(angle), y + radius * std::sin(angle)});
  }
  return loops({loop});
}

}  // namespace

TEST_CASE("circles apart are strands but for a few edges", "[planar][thinning]") {
  const Loops a = circle(0, 0, 1, 1000), b = circle(3, 0, 1, 1000);
  const std::vector<Operand> operands{a, b};
  const Thinned thinned = thin(operands);
  CHECK(thinned.chains.size() == 8);
  for (const Operand& o : thinned.operands) CHECK(o.loops->vertices.size() < 24);
  CHECK(canonical_form(union_(a, b)) == canonical_form(Pipeline{false}.combine(operands, Operation::union_)));
  CHECK(union_(a, b).loops.vertices.size() == 2000);
  CHECK(validate(union_(a, b)).empty());
}

TEST_CASE("where chains are short, or too many boxes meet, there are no strands", "[planar][thinning]") {
  const Loops a = circle(0, 0, 1, 100), b = circle(1, 0, 1, 1000), twice = circle(1, 0, 1, 1000);
  CHECK(thin(std::array<Operand, 1>{a}).chains.empty());
  CHECK(thin(std::array<Operand, 1>{a}, 8).chains.size() == 4);
  CHECK_FALSE(thin(std::array<Operand, 1>{b}).chains.empty());
  CHECK(thin(std::array<Operand, 2>{b, twice}).chains.empty());
  CHECK(thin(std::array<Operand, 1>{b}, usual_chain, 0).chains.empty());
}

// Catches: a monotone chain next to a place where the boundary goes straight on, or with such places inside.
TEST_CASE("a result has no vertices where an outline goes straight on", "[planar][thinning][degenerate]") {
  Loop loop;  // a parabola's vertices and the middles of its edges; the top is straight
  for (int i = -40; i <= 40; ++i) {
    loop.push_back({4.0 * i, 2.0 * i * i});
    if (i < 40) loop.push_back({4.0 * i + 2, (i * i + (i + 1.0) * (i + 1.0))});
  }
  const Loops a = loops({loop}), b = square(1000, 0);
  CHECK_FALSE(thin(std::array<Operand, 1>{a}).chains.empty());
  CHECK(union_(a, b).loops.vertices.size() == 81 + 4);
  CHECK(union_(a, circle(0, 20, 1, 200)).loops.vertices.size() == 81 + 0);
}

// Catches: edges that touch something in a monotone chain; monotone chains that change their direction, or do not
// follow their loops.
TEST_CASE("a strand meets nothing but its neighbours", "[planar][thinning][degenerate][property]") {
  const auto seed = GENERATE(range(0u, seeds(300)));
  CAPTURE(seed);
  Random random(seed);
  const int grid = 2 + static_cast<int>(seed % 5);
  const Loops a = loops(random_outlines(random, grid, unit_of(seed))),
              b = loops(random_outlines(random, grid, unit_of(seed)));
  const std::array<Operand, 2> operands{a, b};
  const Thinned thinned = thin(operands, 1 + seed % 3, endless);
  Loops all = a;  // one after the other, and where they meet
  const auto shift = static_cast<std::uint32_t>(a.vertices.size());
  for (std::uint32_t l = 0; l < b.size(); ++l) {
    std::vector<PlanePoint> loop;
    for (const std::uint32_t v : b.loop(l)) loop.push_back(b.places.place[v]);
    all.add(loop);
  }
  std::vector<std::uint8_t> is_inside(all.vertices.size()), is_edge(all.vertices.size());
  for (const MonotoneChain& s : thinned.chains) {
    const std::uint32_t offset = s.loops == &a ? 0 : shift;
    for (std::uint32_t i = s.first; i < s.last; ++i) is_edge[offset + i] = 1;
    for (std::uint32_t i = s.first; i <= s.last; ++i) is_inside[offset + i] = 1;
    std::vector<PlanePoint> points, turned;
    for (std::uint32_t i = s.first; i <= s.last; ++i) points.push_back(s.point(i));
    for (const PlanePoint& p : points) turned.push_back({p[1], p[0]});
    for (const auto& ordered : {points, turned})
      CHECK((std::is_sorted(ordered.begin(), ordered.end()) || std::is_sorted(ordered.rbegin(), ordered.rend())));
    CHECK(orientation(s.point(s.first - 1), s.point(s.first), s.point(s.first + 1)) != Sign::zero);
    CHECK(orientation(s.point(s.last - 1), s.point(s.last), s.point(s.last + 1)) != Sign::zero);
  }
  for (const SelfMeeting& m : self_intersections(all)) {
    for (const std::uint32_t v : m.vertices) CHECK(is_inside[v] == 0);
    for (const std::uint32_t e : m.edges) CHECK(is_edge[e] == 0);
  }
  for (std::size_t i = 0; i < 2; ++i) {  // put back in, the loops are what they were
    const Loops &given = *operands[i].loops, &left = *thinned.operands[i].loops;
    std::vector<PlanePoint> before, after;
    for (const std::uint32_t v : given.vertices) before.push_back(given.places.place[v]);
    for (std::uint32_t k = 0; k < left.vertices.size(); ++k) {
      after.push_back(left.places.place[left.vertices[k]]);
      if (thinned.chain_of[i].empty() || thinned.chain_of[i][k] == none) continue;
      const MonotoneChain& s = thinned.chains[thinned.chain_of[i][k]];
      for (std::uint32_t v = s.first + 1; v < s.last; ++v) after.push_back(s.point(v));
    }
    CHECK(before == after);
  }
}

// Catches: monotone chains on the wrong side of a ray or of a sweep, taken the wrong way around, or lost; lines and
// meets of results that come to the wrong points.
TEST_CASE("results do not depend on strands", "[planar][thinning][degenerate][property]") {
  static std::size_t chains = 0;
  const auto seed = GENERATE(range(0u, seeds(400)));
  CAPTURE(seed);
  Random random(seed);
  const int grid = 2 + static_cast<int>(seed % 5);
  const double unit = unit_of(seed);
  const Loops a = loops(random_outlines(random, grid, unit)), b = loops(random_outlines(random, grid, unit));
  const Loops c = seed % 3 == 0 ? in_thirds(random_arcs(random, grid, unit)) : loops(random_arcs(random, grid, unit));
  const FillRule rule = seed % 3 == 0 ? FillRule::nonzero : seed % 3 == 1 ? FillRule::even_odd : FillRule::positive;
  const auto first = static_cast<Operation>(seed % 4), second = static_cast<Operation>(random() % 4);
  Pipeline without{false};
  const Region expected = without.combine({{a, rule}, {b, rule}}, first);
  const Region then = without.combine({expected, {c, rule}}, second);
  for (const std::size_t patience : {std::size_t{0}, endless}) {
    Pipeline with{true, patience};
    CHECK(listed(with.combine({{a, rule}, {b, rule}}, first)) == listed(expected));
    CHECK(listed(with.combine({expected, {c, rule}}, second)) == listed(then));
    chains += with.chains;
  }
  if (seed + 1 == seeds(400)) CHECK(chains > seed);  // they do come up
}

// Catches: rays and sweeps that take a monotone chain for the line between its ends: they pass by it, or see it on the
// wrong side.
TEST_CASE("islands are seen between a strand and the line through its ends", "[planar][thinning][property]") {
  const auto seed = GENERATE(range(0u, seeds(60)));
  CAPTURE(seed);
  Random random(seed);
  std::uniform_real_distribution<double> radius(0.7, 1.2), angle(0, 2 * std::numbers::pi);
  std::vector<Operand> operands;
  const Loops rings[] = {circle(0, 0, 1, 200), circle(0, 0, 1.04, 200), circle(0, 0, 0.96, 200)};
  for (const Loops& ring : rings) operands.emplace_back(ring);
  std::vector<Loop> doubles, others;  // the islands' least vertices are doubles, or rationals, or meets
  LoopsBuilder thirds;
  for (int i = 0; i < 30; ++i) {
    const double r = radius(random), t = angle(random), x = r * std::cos(t), y = r * std::sin(t), s = 0x1p-9;
    if (i % 3 != 1) doubles.push_back({{x, y}, {x + s, y - s}, {x + s, y + s}});
    if (i % 3 == 2) others.push_back({{x + s / 2, y - s}, {x + s / 2, y + s}, {x - s, y}});
    if (i % 3 != 1) continue;
    const Rational a = to_rational(x) + Rational(1, 3000), b = to_rational(y) + Rational(1, 7000);
    thirds.add_vertex(RationalPlacement{a, b});
    thirds.add_vertex(RationalPlacement{a + to_rational(s), b - to_rational(s)});
    thirds.add_vertex(RationalPlacement{a + to_rational(s), b + to_rational(s)});
    thirds.end_loop();
  }
  const Loops plain = loops(doubles), rational = thirds.finish();
  const Region crossed = symmetric_difference(plain, loops(others));
  operands.emplace_back(rational);
  operands.emplace_back(crossed);
  const Region expected = Pipeline{false}.combine(operands, Operation::symmetric_difference);
  for (const std::size_t patience : {std::size_t{0}, endless}) {
    Pipeline with{true, patience};
    CHECK(listed(with.combine(operands, Operation::symmetric_difference)) == listed(expected));
    CHECK(with.chains >= 12);
  }
}

}  // namespace strata::planar
