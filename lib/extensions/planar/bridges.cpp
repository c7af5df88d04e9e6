#include <algorithm>
#include <optional>

#include "strata/planar.h"

namespace strata::planar {
namespace {

Rational twice_area(const RationalPlacement& p, const RationalPlacement& q, const RationalPlacement& r) {
  return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
}

class Bridging {
 public:
  Bridging(const Region& region, std::uint32_t polygon) : region_(region) {
    const auto outer = region.loops.loop(region.first_loop[polygon]);
    walk_.assign(outer.begin(), outer.end());
    exact_.resize(region.loops.places.size());
    for (std::uint32_t l = region.first_loop[polygon]; l < region.first_loop[polygon + 1]; ++l)
      for (const std::uint32_t v : region.loops.loop(l))
        if (!exact_[v]) exact_[v] = exact_position(region.loops.places, v);
  }

  /// Holes are processed by their least vertices, so everything to the left of one has been joined.
  void join(std::span<const std::uint32_t> hole) {
    const std::uint32_t v = hole.front();
    const auto shared = std::find(walk_.begin(), walk_.end(), v);
    std::vector<std::uint32_t> detour(hole.begin(), hole.end());
    detour.push_back(v);
    if (shared != walk_.end()) {  // touches the joined loop: no bridge
      walk_.insert(shared + 1, detour.begin() + 1, detour.end());
      return;
    }
    const std::size_t at = occurrence_facing(visible_from(v), v);
    detour.push_back(walk_[at]);
    walk_.insert(walk_.begin() + static_cast<std::ptrdiff_t>(at) + 1, detour.begin(), detour.end());
  }
  [[nodiscard]] Loops loops() const {
    LoopsBuilder builder;
    for (const std::uint32_t v : walk_) builder.add_vertex(place(v));
    builder.end_loop();
    return builder.finish();
  }

 private:
  [[nodiscard]] const RationalPlacement& place(std::uint32_t v) const { return *exact_[v]; }
  [[nodiscard]] double height(std::uint32_t v) const { return region_.loops.places.place[v][1]; }
  /// Is p at or below v's height? Rounding is monotone, so nearest doubles decide most cases.
  [[nodiscard]] bool is_below(std::uint32_t p, std::uint32_t v) const {
    if (height(p) != height(v)) return height(p) < height(v);
    return place(p)[1] <= place(v)[1];
  }

  /// A vertex of the joined loop that is visible from the hole's least vertex v. Take the edge to the left of v just
  /// above its height, the point M where it reaches this height, and its upper end P. Of all vertices in the triangle v
  /// M P the first one in rotation upwards from M is visible.
  [[nodiscard]] std::uint32_t visible_from(std::uint32_t v) const {
    std::optional<Rational> nearest;
    std::uint32_t upper = none;
    std::optional<RationalPlacement> direction;  // of the nearest edge, upwards, for edges that start at one point
    for (std::size_t i = 0; i < walk_.size(); ++i) {
      const std::uint32_t p = walk_[i], q = walk_[i + 1 < walk_.size() ? i + 1 : 0];
      if (is_below(p, v) == is_below(q, v)) continue;
      const std::uint32_t low = is_below(p, v) ? p : q, high = low == p ? q : p;
      const RationalPlacement &a = place(low), &b = place(high);
      const Rational x = a[0] + (place(v)[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
      if (x > place(v)[0]) continue;
      const RationalPlacement d{b[0] - a[0], b[1] - a[1]};
      const bool is_nearer =
          !nearest || x > *nearest || (x == *nearest && d[0] * (*direction)[1] > d[1] * (*direction)[0]);
      if (!is_nearer) continue;
      nearest = x;
      upper = high;
      direction = d;
    }
    return first_in_triangle(v, {*nearest, place(v)[1]}, upper);
  }
  [[nodiscard]] std::uint32_t first_in_triangle(std::uint32_t v, const RationalPlacement& m,
                                                std::uint32_t upper) const {
    std::uint32_t best = upper;
    for (const std::uint32_t w : walk_) {
      if (height(w) < height(v) || height(w) > height(upper)) continue;
      const RationalPlacement &p = place(v), &q = place(w), &r = place(upper);
      if (twice_area(m, p, q) < 0 || twice_area(p, r, q) < 0 || twice_area(r, m, q) < 0) continue;
      const Rational order = twice_area(p, place(best), q);  // seen from v, upwards on the left is clockwise
      if (order > 0 || (order == 0 && squared(p, q) < squared(p, place(best)))) best = w;
    }
    return best;
  }
  static Rational squared(const RationalPlacement& p, const RationalPlacement& q) {
    return (p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]);
  }

  /// Of the occurrences of w in the joined loop, the one with v to its left, between its outgoing and its incoming
  /// edge.
  [[nodiscard]] std::size_t occurrence_facing(std::uint32_t w, std::uint32_t v) const {
    std::size_t last = 0;
    for (std::size_t i = 0; i < walk_.size(); ++i) {
      if (walk_[i] != w) continue;
      last = i;
      const RationalPlacement &before = place(walk_[i > 0 ? i - 1 : walk_.size() - 1]),
                              &after = place(walk_[i + 1 < walk_.size() ? i + 1 : 0]);
      const bool left_of_out = twice_area(place(w), after, place(v)) > 0,
                 left_of_in = twice_area(before, place(w), place(v)) > 0;
      const bool is_convex = twice_area(before, place(w), after) > 0;
      if (is_convex ? left_of_out && left_of_in : left_of_out || left_of_in) return i;
    }
    return last;
  }

  const Region& region_;
  std::vector<std::uint32_t> walk_;
  std::vector<std::optional<RationalPlacement>> exact_;
};

}  // namespace

Loops bridged(const Region& region, std::uint32_t polygon) {
  Bridging bridging(region, polygon);
  for (std::uint32_t l = region.first_loop[polygon] + 1; l < region.first_loop[polygon + 1]; ++l)
    bridging.join(region.loops.loop(l));
  return bridging.loops();
}

Region polygon_of(const Region& region, std::uint32_t polygon) {
  Loops loops = region.loops;
  const std::uint32_t first = region.first_loop[polygon], end = region.first_loop[polygon + 1];
  const std::uint32_t begin_vertex = loops.first_vertex[first], end_vertex = loops.first_vertex[end];
  loops.vertices.assign(region.loops.vertices.begin() + begin_vertex, region.loops.vertices.begin() + end_vertex);
  loops.edge_line.assign(region.loops.edge_line.begin() + begin_vertex, region.loops.edge_line.begin() + end_vertex);
  loops.first_vertex.clear();
  for (std::uint32_t l = first; l <= end; ++l)
    loops.first_vertex.push_back(region.loops.first_vertex[l] - begin_vertex);
  return fill({loops, FillRule::positive});
}

}  // namespace strata::planar
