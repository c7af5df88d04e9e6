#include <cmath>
#include <memory>

#include "extensions/planar/predicates.h"
#include "extensions/planar/strips.h"
#include "strata/planar.h"

namespace strata::planar {

namespace {

/// A point with bounds; its exact coordinates are computed when bounds do not decide.
struct Query {
  std::array<Bounded, 2> bounded;
  const PlanePoint* doubles = nullptr;
  const RationalPlacement* rationals = nullptr;

  [[nodiscard]] RationalPlacement exact() const {
    return doubles != nullptr ? RationalPlacement{to_rational((*doubles)[0]), to_rational((*doubles)[1])} : *rationals;
  }
};

}  // namespace

struct Locator::Data {
  explicit Data(const Region& region);

  [[nodiscard]] Membership locate(const Query& q) const;
  [[nodiscard]] Sign compare_height(std::uint32_t vertex, const Query& q) const;
  [[nodiscard]] Sign compare_x(std::uint32_t vertex, const Query& q) const;
  [[nodiscard]] Sign side(const Query& q, std::uint32_t edge) const;

  const Loops& loops_;
  std::vector<std::array<std::uint32_t, 2>> edges_;
  std::vector<Line> lines_;
  std::unique_ptr<const Strips> strips_;
};

Locator::Data::Data(const Region& region) : loops_(region.loops) {
  const Places& places = loops_.places;
  std::vector<Box> boxes;
  std::vector<std::array<PlanePoint, 2>> ends;
  for (std::uint32_t l = 0; l < loops_.size(); ++l)
    for (std::uint32_t i = loops_.first_vertex[l]; i < loops_.first_vertex[l + 1]; ++i) {
      const std::uint32_t p = loops_.vertices[i];
      const std::uint32_t q = loops_.vertices[i + 1 < loops_.first_vertex[l + 1] ? i + 1 : loops_.first_vertex[l]];
      edges_.push_back({p, q});
      Line line{p, q};
      if (loops_.edge_line[i] != none) {
        line = places.lines[loops_.edge_line[i]];
        if (compare_xy(places, p, q) != compare_xy(places, line.from, line.to)) std::swap(line.from, line.to);
      }
      lines_.push_back(line);
      Box box{HUGE_VAL, -HUGE_VAL, HUGE_VAL, -HUGE_VAL};
      for (const std::uint32_t v : {p, q}) {
        const Bounded x = bounded(places, v, 0), y = bounded(places, v, 1);
        box = {std::min(box.left, x.lower()), std::max(box.right, x.upper()), std::min(box.low, y.lower()),
               std::max(box.high, y.upper())};
      }
      boxes.push_back(box);
      ends.push_back({places.place[p], places.place[q]});
    }
  strips_ = std::make_unique<const Strips>(std::move(boxes), std::move(ends));
}

Sign Locator::Data::compare_height(std::uint32_t vertex, const Query& q) const {
  if (const auto sign = (bounded(loops_.places, vertex, 1) - q.bounded[1]).sign()) return *sign;
  return sign_of(Rational(exact_position(loops_.places, vertex)[1] - q.exact()[1]));
}

Sign Locator::Data::compare_x(std::uint32_t vertex, const Query& q) const {
  if (const auto sign = (bounded(loops_.places, vertex, 0) - q.bounded[0]).sign()) return *sign;
  return sign_of(Rational(exact_position(loops_.places, vertex)[0] - q.exact()[0]));
}

/// Side of the point relative to the line of an edge.
Sign Locator::Data::side(const Query& q, std::uint32_t edge) const {
  const auto [a, b] = lines_[edge];
  const Places& places = loops_.places;
  const Bounded ax = bounded(places, a, 0), ay = bounded(places, a, 1);
  const Bounded orientation =
      (bounded(places, b, 0) - ax) * (q.bounded[1] - ay) - (bounded(places, b, 1) - ay) * (q.bounded[0] - ax);
  if (const auto sign = orientation.sign()) return *sign;
  const RationalPlacement p = exact_position(places, a), r = exact_position(places, b), x = q.exact();
  return sign_of(Rational((r[0] - p[0]) * (x[1] - p[1]) - (r[1] - p[1]) * (x[0] - p[0])));
}

Locator::Locator(const Region& region) : data_(Shared<Data>::make(region)) {}

Membership Locator::locate(const PlanePoint& p) const { return data_->locate(Query{{p[0], p[1]}, &p, nullptr}); }

Membership Locator::locate(const RationalPlacement& p) const {
  Query q{{}, nullptr, &p};
  for (std::size_t i = 0; i < 2; ++i) {
    const double x = to_nearest_double(p[i]);
    if (!std::isfinite(x)) return Membership::out;  // beyond all doubles: beyond all given points, and meets of edges
    q.bounded[i] =
        to_rational(x) == p[i] ? Bounded(x) : Bounded(x, std::abs(x) * Bounded::rounding + Bounded::underflow);
  }
  return data_->locate(q);
}

Membership Locator::Data::locate(const Query& q) const {
  const std::uint32_t first = strips_->strip_of(q.bounded[1].lower()), last = strips_->strip_of(q.bounded[1].upper());
  bool is_in = false;
  for (std::uint32_t k = first; k <= last; ++k)
    for (const std::uint32_t e : strips_->segments(k)) {
      const Box& box = strips_->box(e);
      if (box.left > q.bounded[0].upper() || box.low > q.bounded[1].upper() || box.high < q.bounded[1].lower())
        continue;
      if (k > first && strips_->strip_of(box.low) < k) continue;  // handled before
      const auto [from, to] = edges_[e];
      const Sign start = compare_height(from, q), end = compare_height(to, q);
      if (start == end && start != Sign::zero) continue;
      if (side(q, e) == Sign::zero) {
        if (compare_x(from, q) * compare_x(to, q) != Sign::positive) return Membership::on;
        continue;
      }
      const bool starts_below = start != Sign::positive, ends_below = end != Sign::positive;
      if (starts_below == ends_below) continue;
      if (side(q, e) == (starts_below ? Sign::negative : Sign::positive)) is_in = !is_in;
    }
  return is_in ? Membership::in : Membership::out;
}

}  // namespace strata::planar
