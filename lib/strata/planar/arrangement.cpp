#include "strata/planar/arrangement.h"

#include <bit>
#include <numeric>

#include "strata/planar/meetings.h"

namespace strata::plane {
namespace {

/// Sets of points with one place, named by their lowest numbers.
class Names {
 public:
  explicit Names(std::uint32_t count) : name_(count) { std::iota(name_.begin(), name_.end(), 0u); }

  std::uint32_t find(std::uint32_t p) {
    while (name_[p] != p) p = name_[p] = name_[name_[p]];
    return p;
  }
  void unite(std::uint32_t p, std::uint32_t q) {
    p = find(p);
    q = find(q);
    name_[std::max(p, q)] = std::min(p, q);
  }
  std::vector<std::uint32_t> take() {
    for (std::uint32_t p = 0; p < name_.size(); ++p) name_[p] = name_[name_[p]];  // names are lower: settled before
    return std::move(name_);
  }

 private:
  std::vector<std::uint32_t> name_;
};

Box box_of(const Places& places, const std::array<std::uint32_t, 2>& ends) {
  if (places.is_double(ends[0]) && places.is_double(ends[1])) {
    const PlanePoint &p = places.place[ends[0]], &q = places.place[ends[1]];
    return {std::min(p[0], q[0]), std::max(p[0], q[0]), std::min(p[1], q[1]), std::max(p[1], q[1])};
  }
  Box box{HUGE_VAL, -HUGE_VAL, HUGE_VAL, -HUGE_VAL};
  for (const std::uint32_t p : ends) {
    const Bounded x = places.bounded(p, 0), y = places.bounded(p, 1);
    box = {std::min(box.left, x.lower()), std::max(box.right, x.upper()), std::min(box.low, y.lower()),
           std::max(box.high, y.upper())};
  }
  return box;
}

std::unique_ptr<Strips> strips_of(const Segments& segments) {
  std::vector<Box> boxes;
  std::vector<std::array<PlanePoint, 2>> ends;
  boxes.reserve(segments.ends.size());
  ends.reserve(segments.ends.size());
  for (const auto& e : segments.ends) {
    boxes.push_back(box_of(segments.places, e));
    ends.push_back({segments.places.place[e[0]], segments.places.place[e[1]]});
  }
  return std::make_unique<Strips>(std::move(boxes), std::move(ends));
}

/// The points inside every segment, as lists in order along it. Equal ones are united.
class PointsInside {
 public:
  PointsInside(const std::vector<Meeting>& meetings, const Segments& segments, Names& names)
      : first_(segments.ends.size() + 1), point_(meetings.size()) {
    for (const Meeting& m : meetings) ++first_[m.segment + 1];
    for (std::size_t s = 1; s < first_.size(); ++s) first_[s] += first_[s - 1];
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (const Meeting& m : meetings) point_[next[m.segment]++] = m.point;
    for (std::uint32_t s = 0; s + 1 < first_.size(); ++s) sort(segments.places, s, names);
  }
  [[nodiscard]] std::span<const std::uint32_t> of(std::uint32_t s) const {
    return {point_.data() + first_[s], point_.data() + first_[s + 1]};
  }

 private:
  void sort(const Places& places, std::uint32_t s, Names& names) {
    const std::span<std::uint32_t> points(point_.data() + first_[s], point_.data() + first_[s + 1]);
    if (points.size() < 2) return;
    const auto order = [&](std::uint32_t p, std::uint32_t q) { return compare_along(places, s, p, q); };
    std::sort(points.begin(), points.end(), [&](auto p, auto q) { return order(p, q) == Sign::negative; });
    for (std::size_t i = 1; i < points.size(); ++i)
      if (points[i] != points[i - 1] && order(points[i - 1], points[i]) == Sign::zero) names.unite(points[i - 1], points[i]);
  }

  std::vector<std::uint32_t> first_, point_;
};

void split(const PointsInside& inside, Arrangement& a) {
  a.first_piece.push_back(0);
  a.first_piece.reserve(a.ends.size() + 1);
  a.pieces.reserve(a.ends.size());
  for (std::uint32_t s = 0; s < a.ends.size(); ++s) {
    std::uint32_t from = a.ends[s][0];
    const auto go_to = [&](std::uint32_t to) {
      if (to != from) a.pieces.push_back({from, to});
      from = to;
    };
    for (const std::uint32_t p : inside.of(s)) go_to(a.vertex_of[p]);
    go_to(a.ends[s][1]);
    a.first_piece.push_back(static_cast<std::uint32_t>(a.pieces.size()));
  }
}

}  // namespace

std::uint32_t Arrangement::segment_of(std::uint32_t piece) const {
  return static_cast<std::uint32_t>(std::upper_bound(first_piece.begin(), first_piece.end(), piece) - first_piece.begin() - 1);
}

Arrangement arrange(Segments segments, const Monitor& monitor) {
  Arrangement a;
  std::unique_ptr<Strips> strips = strips_of(segments);
  monitor.check();
  MeetingFinder finder(segments, *strips);
  strips->sort([&](std::uint32_t s, std::uint32_t t, std::uint32_t strip) { finder.test(s, t, strip); });
  a.strips = std::move(strips);
  monitor.check();

  Names names(segments.places.size());
  for (const auto& [p, q] : finder.equal) names.unite(p, q);
  const PointsInside inside(finder.meetings, segments, names);
  a.vertex_of = names.take();
  a.places = std::move(segments.places);
  a.ends = std::move(segments.ends);
  for (auto& e : a.ends) e = {a.vertex_of[e[0]], a.vertex_of[e[1]]};
  a.is_fold.assign(a.places.size(), 0);
  for (const std::uint32_t p : finder.folds) a.is_fold[a.vertex_of[p]] = 1;
  monitor.check();
  split(inside, a);
  return a;
}

std::vector<std::uint32_t> first_equal(std::span<const PlanePoint> points) {
  const std::size_t mask = std::bit_ceil(points.size() * 2 + 2) - 1;
  std::vector<std::uint32_t> slots(mask + 1, none), name(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const auto x = std::bit_cast<std::uint64_t>(points[i][0] + 0.0), y = std::bit_cast<std::uint64_t>(points[i][1] + 0.0);
    std::uint64_t h = (x ^ std::rotl(y * 0x9e3779b97f4a7c15, 29)) * 0xbf58476d1ce4e5b9;
    h = (h ^ (h >> 32)) * 0x94d049bb133111eb;
    std::size_t at = (h >> 20) & mask;
    while (slots[at] != none && points[slots[at]] != points[i]) at = (at + 1) & mask;
    if (slots[at] == none) slots[at] = i;
    name[i] = slots[at];
  }
  return name;
}

}  // namespace strata::plane
