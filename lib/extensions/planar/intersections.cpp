#include "extensions/planar/intersections.h"

#include <algorithm>

namespace strata::planar {

void IntersectionFinder::test(std::uint32_t s, std::uint32_t t, std::uint32_t strip) {
  const auto [p, q] = ends_[s];
  const auto [r, u] = ends_[t];
  if (p == q)
    return r == u ? (compare_xy(places_, p, r) == Sign::zero ? found_.equal.push_back({p, r}) : void())
                  : test_point(p, t);
  if (r == u) return test_point(r, s);
  if (p == r) return test_sharing(s, t, p, q, u);
  if (p == u) return test_sharing(s, t, p, q, r);
  if (q == r) return test_sharing(s, t, q, p, u);
  if (q == u) return test_sharing(s, t, q, p, r);

  const Sign sr = side_of(r, s), su = side_of(u, s);
  if (sr == su && sr != Sign::zero) return;
  const Sign tp = side_of(p, t), tq = side_of(q, t);
  if (tp == tq && tp != Sign::zero) return;
  if (sr == Sign::zero && su == Sign::zero) return test_overlap(s, t);
  const bool inside_t = sr != Sign::zero && su != Sign::zero, inside_s = tp != Sign::zero && tq != Sign::zero;
  const std::uint32_t end_of_t = sr == Sign::zero ? r : u, end_of_s = tp == Sign::zero ? p : q;
  if (inside_s && inside_t) {
    add_crossing(s, t, strip);
  } else if (inside_s) {
    add(s, end_of_t);
  } else if (inside_t) {
    add(t, end_of_s);
  } else {
    found_.equal.push_back({end_of_s, end_of_t});
  }
}

void IntersectionFinder::add(std::uint32_t s, std::uint32_t point) {
  count(point);
  found_.inside.push_back({s, point});
}

void IntersectionFinder::count(std::uint32_t point) {
  const std::array<Bounded, 2> place{bounded(places_, point, 0), bounded(places_, point, 1)};
  const auto differ = [](const Bounded& x, const Bounded& y) { return x.upper() < y.lower() || y.upper() < x.lower(); };
  if (differ(place[0], last_[0]) || differ(place[1], last_[1])) {
    ++new_places_;
  } else if (places_.is_meet(point)) {
    ++repeated_crossings_;
  }
  last_ = place;
}

/// A pair is tested in every strip that contains its crossing, so a strip handles it if it is certainly the only one.
void IntersectionFinder::add_crossing(std::uint32_t s, std::uint32_t t, std::uint32_t strip) {
  const std::uint32_t point = places_.add(Meet{std::min(s, t), std::max(s, t)});
  if (strip != none) {
    const Bounded y = bounded(places_, point, 1);
    const std::uint32_t first = strips_.strip_of(y.lower());
    if (first != strip && first == strips_.strip_of(y.upper())) return places_.drop_meets(point);
  }
  count(point);
  found_.inside.insert(found_.inside.end(), {{s, point}, {t, point}});
}

void IntersectionFinder::test_point(std::uint32_t point, std::uint32_t s) {
  if (point == ends_[s][0] || point == ends_[s][1]) return;
  if (side_of(point, s) == Sign::zero) test_end_inside(s, point);
}

/// A point on a segment's line: outside, inside, or at an end.
void IntersectionFinder::test_end_inside(std::uint32_t s, std::uint32_t end) {
  const auto [p, q] = ends_[s];
  const Sign from = compare_along(places_, s, p, end), to = compare_along(places_, s, end, q);
  if (from == Sign::zero) return found_.equal.push_back({p, end});
  if (to == Sign::zero) return found_.equal.push_back({q, end});
  if (from == Sign::negative && to == Sign::negative) add(s, end);
}

/// Two segments on one line.
void IntersectionFinder::test_overlap(std::uint32_t s, std::uint32_t t) {
  for (const std::uint32_t end : ends_[t]) test_end_inside(s, end);
  for (const std::uint32_t end : ends_[s]) test_end_inside(t, end);
}

/// s = shared a, t = shared b: they meet nowhere else unless they leave in the same direction.
void IntersectionFinder::test_sharing(std::uint32_t s, std::uint32_t t, std::uint32_t shared, std::uint32_t a,
                                      std::uint32_t b) {
  if (a == b) {
    found_.folds.insert(found_.folds.end(), {shared, a});
    return;
  }
  if (side_of(b, s) != Sign::zero) return;
  if (compare_along(places_, s, shared, a) != compare_along(places_, s, shared, b)) return;
  found_.folds.push_back(shared);
  const Sign order = compare_along(places_, s, shared, a) * compare_along(places_, s, a, b);
  if (order == Sign::zero) {
    found_.equal.push_back({a, b});
    found_.folds.push_back(a);
  } else if (order == Sign::positive) {  // shared, a, b
    add(t, a);
  } else {
    add(s, b);
  }
}

}  // namespace strata::planar
