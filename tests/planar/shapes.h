#pragma once
#include <random>
#include <vector>

#include "strata/planar.h"
#include "support/rounds.h"

// What the tests of the plane share: small shapes, random degenerate ones, and facts from the definitions.
namespace strata::planar::test {

using Loop = std::vector<PlanePoint>;
using Random = std::mt19937_64;

/// Seeds for a property: a twentieth under a sanitizer.
constexpr unsigned seeds(unsigned usual) { return static_cast<unsigned>(strata::test::rounds(usual)); }

inline Loop box(double left, double low, double right, double high) {
  return {{left, low}, {right, low}, {right, high}, {left, high}};
}
inline Loops loops(std::vector<Loop> all) { return loops_of(all); }
inline Loops square(double left, double low, double side = 1) {
  return loops({box(left, low, left + side, low + side)});
}

/// One to three loops over a small grid: they cross, touch, overlap and run back. Coordinates are multiples of `unit`.
inline std::vector<Loop> random_grid_loops(Random& random, int grid, double unit = 1) {
  std::vector<Loop> all(1 + random() % 3);
  for (Loop& loop : all) {
    const std::size_t count = 3 + random() % 6;
    for (std::size_t i = 0; i < count; ++i)
      loop.push_back(
          {unit * static_cast<double>(random() % (grid + 1)), unit * static_cast<double>(random() % (grid + 1))});
  }
  return all;
}

/// Points of an arc from p to q in steps of eight, q left out; straight for some pairs. The same arc back from q to p.
inline void add_arc(const PlanePoint& p, const PlanePoint& q, double unit, Loop& loop) {
  const bool is_back = q < p;
  const PlanePoint &from = is_back ? q : p, &to = is_back ? p : q;
  const PlanePoint step{(to[0] - from[0]) * 8, (to[1] - from[1]) * 8};
  const int bulge = static_cast<int>(static_cast<unsigned>(from[0] + 5 * from[1] + 2 * to[0] + 3 * to[1]) % 4) - 1;
  for (int i = 0; i < 8; ++i) {
    const double j = is_back ? 8 - i : i, bend = bulge * j * (8 - j) / 2;
    loop.push_back({unit * (64 * from[0] + j * step[0] - bend * step[1] / 8),
                    unit * (64 * from[1] + j * step[1] + bend * step[0] / 8)});
  }
}

/// Loops over a small grid with arcs in place of their edges: many edges and few intersections, but arcs that coincide,
/// run back, touch at their ends, and go straight.
inline std::vector<Loop> random_arcs(Random& random, int grid, double unit = 1) {
  std::vector<Loop> all;
  for (const Loop& corners : random_grid_loops(random, grid)) {
    Loop& loop = all.emplace_back();
    for (std::size_t i = 0; i < corners.size(); ++i) add_arc(corners[i], corners[(i + 1) % corners.size()], unit, loop);
  }
  return all;
}

/// The same in thirds, which are no doubles.
inline Loops in_thirds(const std::vector<Loop>& all) {
  LoopsBuilder builder;
  for (const Loop& loop : all) {
    for (const PlanePoint& p : loop)
      builder.add_vertex(RationalPlacement{to_rational(p[0]) / 3, to_rational(p[1]) / 3});
    builder.end_loop();
  }
  return builder.finish();
}

/// How often loops wind around a point on none of their edges, from the definition, in rationals.
inline int winding(const Loops& loops, const RationalPlacement& q) {
  int sum = 0;
  for (std::uint32_t l = 0; l < loops.size(); ++l) {
    const auto loop = loops.loop(l);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const RationalPlacement a = exact_position(loops.places, loop[i]),
                              b = exact_position(loops.places, loop[(i + 1) % loop.size()]);
      if ((a[1] <= q[1]) == (b[1] <= q[1])) continue;
      const Rational orientation = (b[0] - a[0]) * (q[1] - a[1]) - (b[1] - a[1]) * (q[0] - a[0]);
      if (b[1] > a[1] && orientation > 0) ++sum;
      if (b[1] < a[1] && orientation < 0) --sum;
    }
  }
  return sum;
}

}  // namespace strata::planar::test
