#include "extensions/section/general_position.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "core/containers/hash_index.h"
#include "core/containers/point_hash.h"
#include "core/kernel/predicates.h"
#include "extensions/planar/predicates.h"

namespace strata {
namespace {

using Index = std::uint32_t;
using planar::none;

/// An edge that crosses the plane: its end behind the plane, and the one in front.
struct CrossingEdge {
  Index behind = 0, front = 0;
  friend bool operator==(const CrossingEdge&, const CrossingEdge&) = default;
};

std::uint64_t hash_of_edge(const CrossingEdge& e) {
  return folded_product((std::uint64_t{e.behind} << 32 | e.front) ^ 0x9e3779b97f4a7c15u, 0xa0761d6478bd642fu);
}

/// A triangle that crosses the plane: its boundary goes behind the plane through `enter`, and comes back through
/// `leave`. The loop goes from the one to the other.
struct CrossingTriangle {
  CrossingEdge enter, leave;
  Index apex = 0;  ///< the vertex that `enter` does not have
};

/// The triangles of loops, one loop after the other.
struct TriangleLoops {
  std::vector<CrossingTriangle> triangles;
  std::vector<Index> first{0};  ///< of every loop, and the count
};

std::vector<CrossingTriangle> crossing_triangles(std::span<const Triangle> triangles, std::span<const Index> numbers,
                                                 const AxisPlane& plane) {
  std::vector<CrossingTriangle> crossing;
  crossing.reserve(numbers.size());
  for (const Index n : numbers) {
    const Triangle& t = triangles[n];
    const unsigned in_front = static_cast<unsigned>(plane.is_in_front(t[0])) |
                              static_cast<unsigned>(plane.is_in_front(t[1])) << 1 |
                              static_cast<unsigned>(plane.is_in_front(t[2])) << 2;
    if (in_front == 0 || in_front == 7) continue;
    // By the corners in front: the corner from which the boundary goes behind the plane.
    constexpr std::array<std::uint8_t, 7> last_in_front{0, 0, 1, 1, 2, 0, 2};
    const std::size_t down = last_in_front[in_front];
    const Index a = t[down], b = t[(down + 1) % 3], c = t[(down + 2) % 3];
    const bool is_alone = plane.is_in_front(c);  // b is the only corner behind
    crossing.push_back({{b, a}, is_alone ? CrossingEdge{b, c} : CrossingEdge{c, a}, c});
  }
  return crossing;
}

/// nullopt where edges do not have two triangles each.
std::optional<TriangleLoops> link(const std::vector<CrossingTriangle>& crossing) {
  const auto count = static_cast<Index>(crossing.size());
  HashIndex entered(count + std::size_t{1});
  for (Index k = 0; k < count; ++k) {
    const CrossingEdge& e = crossing[k].enter;
    if (entered.find_or_add(hash_of_edge(e), k, [&](Index other) { return crossing[other].enter == e; }) != k)
      return std::nullopt;
  }
  std::vector<Index> next(count);
  std::vector<std::uint8_t> has_previous(count, 0);
  for (Index k = 0; k < count; ++k) {
    const CrossingEdge& e = crossing[k].leave;
    next[k] = entered.find_or_add(hash_of_edge(e), count, [&](Index other) { return crossing[other].enter == e; });
    if (next[k] == count || has_previous[next[k]] != 0) return std::nullopt;
    has_previous[next[k]] = 1;
  }
  TriangleLoops loops;
  loops.triangles.reserve(count);
  for (Index start = 0; start < count; ++start) {
    if (next[start] == none) continue;
    for (Index k = start; next[k] != none;) {
      loops.triangles.push_back(crossing[k]);
      k = std::exchange(next[k], none);
    }
    loops.first.push_back(static_cast<Index>(loops.triangles.size()));
  }
  return loops;
}

/// A point of a loop: where it enters a triangle. Where a vertex is in the plane, the loop enters many triangles there;
/// the point is where it enters the last of them.
struct LoopPoint {
  Index before = 0, after = 0;  ///< the triangles in which the loop comes and goes
  bool is_at_one_edge = true;   ///< which both have in common
};

/// The points of loops, one loop after the other; consecutive ones are different.
struct PointLoops {
  std::vector<LoopPoint> points;
  std::vector<Index> first{0};  ///< of every loop, and the count
};

PointLoops points_of(const TriangleLoops& loops, const AxisPlane& plane) {
  PointLoops result;
  result.points.reserve(loops.triangles.size());
  const auto are_at_one_vertex = [&](Index t, Index u) {
    const Index v = loops.triangles[t].enter.behind;
    return loops.triangles[u].enter.behind == v && plane.contains(v);
  };
  for (std::size_t l = 0; l + 1 < loops.first.size(); ++l) {
    const Index begin = loops.first[l], end = loops.first[l + 1];
    bool is_same = are_at_one_vertex(end - 1, begin);
    for (Index before = end - 1, at = begin; at < end; before = at++) {
      const bool next_is_same = are_at_one_vertex(at, at + 1 < end ? at + 1 : begin);
      if (!next_is_same) result.points.push_back({before, at, !is_same});
      is_same = next_is_same;
    }
    if (result.points.size() > result.first.back()) result.first.push_back(static_cast<Index>(result.points.size()));
  }
  return result;
}

planar::Places places_of(const PointLoops& loops, const TriangleLoops& triangles, const AxisPlane& plane) {
  planar::Places places;
  const std::size_t count = loops.points.size();
  places.place.reserve(count);
  places.error.reserve(count);
  places.rationals.reserve(count);
  for (const LoopPoint& p : loops.points) {
    const CrossingEdge& e = triangles.triangles[p.after].enter;
    places.add(plane.crossing(e.behind, e.front));
  }
  return places;
}

bool are_doubles(const planar::Places& places, Index p) { return places.error[p] == planar::PlanePoint{0, 0}; }

/// Points that have the same doubles may be the same.
bool are_surely_different(const std::vector<planar::PlanePoint>& points) {
  HashIndex known(points.size());
  for (Index p = 0; p < points.size(); ++p)
    if (known.find_or_add(hash_of(points[p]), p, [&](Index q) { return points[q] == points[p]; }) != p) return false;
  return true;
}

/// Loops by their corners: points of `Places`. A loop starts at its least one.
struct CornerLoops {
  struct Loop {
    Index first = 0, last = 0;                      ///< in `corners`; the last one is not in the loop
    bool is_outer = false;                          ///< counter-clockwise
    double left = 0, right = 0, low = 0, high = 0;  ///< a box that contains it
    Index outer = none;                             ///< of a hole: its outer loop
  };
  std::vector<Index> corners;
  std::vector<Loop> loops;
};

class CornerFinder {
 public:
  CornerFinder(const TriangleLoops& triangles, const PointLoops& loops, const planar::Places& places,
               const AxisPlane& plane)
      : triangles_(triangles), loops_(loops), places_(places), plane_(plane) {}

  /// nullopt for a loop without area.
  std::optional<CornerLoops> find() {
    result_.corners.reserve(loops_.points.size());
    for (std::size_t l = 0; l + 1 < loops_.first.size(); ++l)
      if (!add_loop(loops_.first[l], loops_.first[l + 1])) return std::nullopt;
    return std::move(result_);
  }

 private:
  bool add_loop(Index begin, Index end) {
    const auto first = static_cast<Index>(result_.corners.size());
    Index least = none;
    Sign at_least = Sign::zero;
    CornerLoops::Loop loop{.first = first,
                           .left = std::numeric_limits<double>::infinity(),
                           .right = -std::numeric_limits<double>::infinity(),
                           .low = std::numeric_limits<double>::infinity(),
                           .high = -std::numeric_limits<double>::infinity()};
    for (Index k = begin, before = end - 1; k < end; before = k++) {
      const Sign turn = turn_at(before, k, k + 1 < end ? k + 1 : begin);
      if (turn == Sign::zero) continue;
      const auto [x, y] = places_.place[k];
      loop.left = std::min(loop.left, x);
      loop.right = std::max(loop.right, x);
      loop.low = std::min(loop.low, y);
      loop.high = std::max(loop.high, y);
      if (least == none || planar::compare_xy(places_, k, result_.corners[least]) == Sign::negative) {
        least = static_cast<Index>(result_.corners.size());
        at_least = turn;
      }
      result_.corners.push_back(k);
    }
    loop.last = static_cast<Index>(result_.corners.size());
    if (loop.last - first < 3) return false;
    const auto corners = result_.corners.begin();
    std::rotate(corners + first, corners + least, corners + loop.last);
    loop.is_outer = at_least == Sign::positive;
    result_.loops.push_back(loop);
    return true;
  }
  /// How the loop turns: to the left at a convex edge.
  [[nodiscard]] Sign turn_at(Index before, Index at, Index after) const {
    const LoopPoint& point = loops_.points[at];
    if (!point.is_at_one_edge) return turn_of_points(before, at, after);
    const CrossingTriangle &t = triangles_.triangles[point.before], &u = triangles_.triangles[point.after];
    const std::array corners{t.enter.front, t.enter.behind, t.apex, u.apex};
    if (!std::all_of(corners.begin(), corners.end(), [&](Index v) { return plane_.is_double(v); }))
      return turn_of_points(before, at, after);
    return -orient3d(plane_.rounded(corners[0]), plane_.rounded(corners[1]), plane_.rounded(corners[2]),
                     plane_.rounded(corners[3]));
  }
  [[nodiscard]] Sign turn_of_points(Index before, Index at, Index after) const {
    const std::array points{before, at, after};
    if (std::all_of(points.begin(), points.end(), [&](Index p) { return are_doubles(places_, p); }))
      return orient2d(places_.place[before], places_.place[at], places_.place[after]);
    const auto way = [&](Index from, Index to, std::size_t i) {
      return planar::bounded(places_, to, i) - planar::bounded(places_, from, i);
    };
    const Bounded turn = way(before, at, 0) * way(at, after, 1) - way(before, at, 1) * way(at, after, 0);
    if (const auto sign = turn.sign()) return *sign;
    const auto p = exact_position(places_, before), q = exact_position(places_, at), r = exact_position(places_, after);
    return static_cast<Sign>(((q[0] - p[0]) * (r[1] - q[1]) - (q[1] - p[1]) * (r[0] - q[0])).sign());
  }

  const TriangleLoops& triangles_;
  const PointLoops& loops_;
  const planar::Places& places_;
  const AxisPlane& plane_;
  CornerLoops result_;
};

/// Finds the outer loop of every hole: of the outer loops around it the one whose least point is the greatest, since
/// loops around a point contain one another.
class Nesting {
 public:
  Nesting(planar::Places& places, CornerLoops& loops) : places_(places), loops_(loops) {}

  /// Requires loops in the order of their least points. False where too many edges would be tested.
  bool find() {
    const std::size_t most = 64 * (loops_.corners.size() + 64);
    std::vector<Index> outer;
    for (Index l = 0; l < loops_.loops.size(); ++l) {
      CornerLoops::Loop& loop = loops_.loops[l];
      if (loop.is_outer) {
        outer.push_back(l);
        continue;
      }
      loop.outer = outer_of(loop, outer);
      if (loop.outer == none || tested_ > most) return false;
    }
    return true;
  }

 private:
  /// Of loops in the order of their least points, all of them lesser than the hole's.
  [[nodiscard]] Index outer_of(const CornerLoops::Loop& hole, std::span<const Index> outer) {
    tested_ += outer.size() / 16;
    Index found = none;  // the last one whose box contains the hole's: if no other one does, it need not be tested
    for (auto at = outer.rbegin(); at != outer.rend(); ++at) {
      const CornerLoops::Loop& loop = loops_.loops[*at];
      if (loop.left > hole.left || loop.right < hole.right || loop.low > hole.low || loop.high < hole.high) continue;
      if (found != none && is_around(loops_.loops[found], hole)) return found;
      found = *at;
    }
    return found;
  }
  [[nodiscard]] bool is_around(const CornerLoops::Loop& loop, const CornerLoops::Loop& hole) {
    tested_ += loop.last - loop.first;
    return contains(loop, loops_.corners[hole.first]);
  }
  /// True where a ray upwards from the point, which is not on the loop, leaves what the loop goes around.
  [[nodiscard]] bool contains(const CornerLoops::Loop& loop, Index point) {
    bool is_inside = false;
    bool was_left = is_left(loops_.corners[loop.last - 1], point);
    for (Index i = loop.first, before = loop.last - 1; i < loop.last; before = i++) {
      const bool now = is_left(loops_.corners[i], point);
      if (now == was_left) continue;
      was_left = now;
      // The edge from left to right has the point below it where it sees it to its right.
      places_.lines = {{loops_.corners[now ? i : before], loops_.corners[now ? before : i]}};
      if (planar::side(places_, point, 0) == Sign::negative) is_inside = !is_inside;
    }
    places_.lines.clear();
    return is_inside;
  }
  [[nodiscard]] bool is_left(Index p, Index of) const { return planar::compare(places_, p, of, 0) == Sign::negative; }

  planar::Places& places_;
  CornerLoops& loops_;
  std::size_t tested_ = 0;
};

/// Writes loops in the order of a Region: a polygon's outer loop, its holes. Requires loops in the order of their least
/// points.
planar::Region region_of(planar::Places&& places, const CornerLoops& loops) {
  std::vector<Index> order(loops.loops.size());
  for (Index l = 0; l < order.size(); ++l) order[l] = l;
  std::stable_sort(order.begin(), order.end(), [&](Index l, Index m) {
    const CornerLoops::Loop &a = loops.loops[l], &b = loops.loops[m];
    const Index p = a.is_outer ? l : a.outer, q = b.is_outer ? m : b.outer;
    return p != q ? p < q : a.is_outer > b.is_outer;
  });
  planar::Region region;
  planar::Loops& to = region.loops;
  // Points of two doubles come first.
  const std::size_t count = loops.corners.size();
  to.vertices.reserve(count);
  to.edge_line.assign(count, none);
  const auto is_double = [&](Index p) { return are_doubles(places, p); };
  const auto doubles = static_cast<Index>(std::count_if(loops.corners.begin(), loops.corners.end(), is_double));
  to.places.place.resize(count);
  to.places.error.reserve(count - doubles);
  to.places.rationals.reserve(count - doubles);
  Index next_double = 0, next_rational = doubles;
  for (const Index l : order) {
    const CornerLoops::Loop& loop = loops.loops[l];
    if (loop.is_outer && l != order.front()) region.first_loop.push_back(to.size());
    for (Index i = loop.first; i < loop.last; ++i) {
      const Index p = loops.corners[i];
      const Index number = is_double(p) ? next_double++ : next_rational++;
      to.vertices.push_back(number);
      to.places.place[number] = places.place[p];
      if (number < doubles) continue;
      to.places.error.push_back(places.error[p]);
      to.places.rationals.push_back(std::move(places.rationals[p]));
    }
    to.first_vertex.push_back(static_cast<Index>(to.vertices.size()));
  }
  if (!order.empty()) region.first_loop.push_back(to.size());
  return region;
}

}  // namespace

std::optional<planar::Region> section_in_general_position(std::span<const Triangle> triangles,
                                                          std::span<const Index> numbers, const AxisPlane& plane) {
  const auto linked = link(crossing_triangles(triangles, numbers, plane));
  if (!linked) return std::nullopt;
  const PointLoops points = points_of(*linked, plane);
  planar::Places places = places_of(points, *linked, plane);
  if (!are_surely_different(places.place)) return std::nullopt;
  auto loops = CornerFinder(*linked, points, places, plane).find();
  if (!loops) return std::nullopt;
  std::sort(loops->loops.begin(), loops->loops.end(), [&](const auto& l, const auto& m) {
    return planar::compare_xy(places, loops->corners[l.first], loops->corners[m.first]) == Sign::negative;
  });
  if (!Nesting(places, *loops).find()) return std::nullopt;
  return region_of(std::move(places), *loops);
}

}  // namespace strata
