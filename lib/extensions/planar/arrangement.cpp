#include "extensions/planar/arrangement.h"

#include <numeric>
#include <utility>

#include "core/containers/hash_index.h"
#include "core/containers/point_hash.h"
#include "extensions/planar/intersections.h"
#include "extensions/planar/sweep.h"

namespace strata::planar {
namespace {

/// Sets of coincident points, named by their lowest numbers.
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
    for (std::uint32_t p = 0; p < name_.size(); ++p)
      name_[p] = name_[name_[p]];  // names are lower, so they are final already
    return std::move(name_);
  }

 private:
  std::vector<std::uint32_t> name_;
};

double size_of(const Box& box) { return (box.right - box.left) + (box.high - box.low); }

/// Segments between the ends of a segment with a lower number, in its direction or against it: they are split where
/// that one is. Points are no copies, and neither are isolated chains, which take ways of their own.
class Copies {
 public:
  explicit Copies(const Segments& segments) {
    const auto& ends = segments.ends;
    // A segment that has copies shares both its ends with two others: with its copy, and with one that closes the ring.
    std::vector<std::uint8_t> met(segments.places.size());  // how often, up to 3
    for (const auto& e : ends)
      for (const std::uint32_t p : e) met[p] = static_cast<std::uint8_t>(std::min(met[p] + 1, 3));
    std::vector<std::uint32_t> candidates;
    for (std::uint32_t s = 0; s < ends.size(); ++s) {
      const auto [p, q] = ends[s];
      if (met[p] == 3 && met[q] == 3 && p != q && !segments.chains.holds(s)) candidates.push_back(s);
    }
    if (candidates.empty()) return;
    next_.assign(ends.size(), none);
    is_copy_.assign(ends.size(), 0);
    HashIndex known(candidates.size());
    for (const std::uint32_t s : candidates) {
      const auto between = std::minmax(ends[s][0], ends[s][1]);
      const std::uint64_t hash =
          folded_product(between.first ^ 0x9e3779b97f4a7c15u, between.second ^ 0xd6e8feb86659fd93u);
      const std::uint32_t first =
          known.find_or_add(hash, s, [&](std::uint32_t t) { return std::minmax(ends[t][0], ends[t][1]) == between; });
      if (first == s) continue;
      is_copy_[s] = 1;
      next_[s] = std::exchange(next_[first], s);
    }
  }

  [[nodiscard]] bool has(std::uint32_t segment) const { return !is_copy_.empty() && is_copy_[segment] != 0; }
  /// Adds what was found for a segment to its copies.
  void add_to(const std::vector<std::array<std::uint32_t, 2>>& ends, Intersections& found) const {
    if (is_copy_.empty()) return;
    const std::size_t count = found.inside.size();
    for (std::size_t i = 0; i < count; ++i) {
      const Meeting m = found.inside[i];
      for (std::uint32_t s = next_[m.segment]; s != none; s = next_[s]) found.inside.push_back({s, m.point});
    }
    for (std::uint32_t s = 0; s < is_copy_.size(); ++s)
      if (has(s)) found.folds.insert(found.folds.end(), ends[s].begin(), ends[s].end());
  }

 private:
  std::vector<std::uint8_t> is_copy_;  ///< of every segment; empty if there are none
  std::vector<std::uint32_t> next_;    ///< of a segment, and of a copy: another copy
};

/// Runs of up to eight segments. They give fewer entries to sort, with boxes that are little larger. An isolated chain
/// is a run of its own.
std::vector<Run> runs_of(const Segments& segments, const std::vector<Box>& boxes, const Copies& copies) {
  constexpr std::uint32_t longest = 8;
  constexpr double progress = 0.6;  // of the box, relative to the length of the segments
  std::vector<Run> runs;
  Box box;
  double total = 0;
  for (std::uint32_t s = 0; s < boxes.size(); ++s) {
    if (copies.has(s)) continue;
    const Box joined = hull(box, boxes[s]);
    const double size = size_of(boxes[s]);
    const bool goes_on = !runs.empty() && runs.back().end == s && s - runs.back().first < longest &&
                         segments.ends[s - 1][1] == segments.ends[s][0] && !segments.chains.holds(s - 1) &&
                         !segments.chains.holds(s) && size_of(joined) >= progress * (total + size);
    if (!goes_on) runs.push_back({s, s});
    runs.back().end = s + 1;
    box = goes_on ? joined : boxes[s];
    total = goes_on ? total + size : size;
  }
  return runs;
}

std::unique_ptr<Strips> strips_of(const Segments& segments, const std::vector<Box>& boxes,
                                  const std::vector<Run>& runs) {
  std::vector<Box> run_boxes;
  std::vector<std::array<PlanePoint, 2>> ends;
  for (const auto [first, end] : runs) {
    Box box = boxes[first];
    for (std::uint32_t s = first + 1; s < end; ++s) box = hull(box, boxes[s]);
    run_boxes.push_back(box);
    const PlanePoint& from = segments.places.place[segments.ends[first][0]];
    const PlanePoint& to = segments.places.place[segments.ends[first][1]];
    const bool is_straight = end - first == 1 && !segments.chains.holds(first);
    ends.push_back({from, is_straight ? to : from});  // only straight segments are cut along their line
  }
  return std::make_unique<Strips>(std::move(run_boxes), std::move(ends));
}

/// Finds the intersections of segments, pair by pair where boxes meet: within runs, and between runs that share a
/// strip. Segments in strips with too many pairs for the points that they find are swept instead, and the points found
/// there are dropped.
class MeetingSearch {
 public:
  MeetingSearch(Segments& segments, const std::vector<Box>& boxes, const std::vector<Run>& runs, Strips& strips,
                std::size_t patience)
      : segments_(segments),
        boxes_(boxes),
        runs_(runs),
        strips_(strips),
        patience_(patience),
        finder_(segments, strips, found_) {}

  Intersections find(const Monitor& monitor) {
    for (const Run& run : runs_)
      if (!is_monotone(run, 0) && !is_monotone(run, 1)) find_within(run);
    strips_.sort(*this);
    monitor.check();
    sweep_over_crowds(monitor);
    return std::move(found_);
  }

  void enter(std::uint32_t strip) {
    strip_ = strip;
    tests_ = 0;
    places_before_ = finder_.new_places();
    repeats_before_ = finder_.repeated_crossings();
    sizes_before_ = {found_.inside.size(), found_.equal.size(), found_.folds.size()};
    points_before_ = segments_.places.size();
  }
  void visit(std::uint32_t q, std::uint32_t r) {
    if (is_chain(q) || is_chain(r)) return;
    for (std::uint32_t s = runs_[q].first; s < runs_[q].end; ++s) {
      if (!overlap(boxes_[s], strips_.box(r))) continue;
      for (std::uint32_t t = runs_[r].first; t < runs_[r].end; ++t) {
        if (!overlap(boxes_[s], boxes_[t])) continue;
        finder_.test(s, t, strip_);
        ++tests_;
      }
    }
  }
  bool is_enough(std::size_t pairs) {
    const std::size_t cost =
        pairs + pairs_per_test * tests_ + pairs_per_repeat * (finder_.repeated_crossings() - repeats_before_);
    const std::size_t worth = 8 * strips_.segments(strip_).size() + (finder_.new_places() - places_before_);
    if (cost <= patience_ * worth) return false;
    crowds_.push_back(strip_);
    found_.inside.resize(sizes_before_[0]);
    found_.equal.resize(sizes_before_[1]);
    found_.folds.resize(sizes_before_[2]);
    segments_.places.drop_meets(points_before_);
    return true;
  }

 private:
  /// Isolated chains have no intersections.
  [[nodiscard]] bool is_chain(std::uint32_t run) const { return segments_.chains.holds(runs_[run].first); }
  /// True when a run of given doubles goes strictly up, or down, in a coordinate: then its segments meet only in common
  /// ends.
  [[nodiscard]] bool is_monotone(const Run& run, std::size_t axis) const {
    const Places& places = segments_.places;
    const auto goes_up = [&](const std::array<std::uint32_t, 2>& e) {
      return places.place[e[0]][axis] < places.place[e[1]][axis];
    };
    const bool is_up = goes_up(segments_.ends[run.first]);
    return std::all_of(segments_.ends.begin() + run.first, segments_.ends.begin() + run.end, [&](const auto& e) {
      return places.is_double(e[0]) && places.is_double(e[1]) && goes_up(is_up ? e : std::array{e[1], e[0]});
    });
  }
  void find_within(const Run& run) {
    for (std::uint32_t s = run.first; s < run.end; ++s)
      for (std::uint32_t t = s + 1; t < run.end; ++t)
        if (overlap(boxes_[s], boxes_[t])) finder_.test(s, t, none);
  }
  void sweep_over_crowds(const Monitor& monitor) {
    if (crowds_.empty()) return;
    std::vector<std::uint32_t> runs;
    for (const std::uint32_t k : crowds_) {
      const auto crowd = strips_.segments(k);
      runs.insert(runs.end(), crowd.begin(), crowd.end());
    }
    std::sort(runs.begin(), runs.end());
    runs.erase(std::unique(runs.begin(), runs.end()), runs.end());
    std::vector<SweptSegment> swept;
    std::erase_if(runs, [&](std::uint32_t r) { return is_chain(r); });
    for (const std::uint32_t r : runs)
      for (std::uint32_t s = runs_[r].first; s < runs_[r].end; ++s)
        swept.push_back({s, segments_.ends[s][0], segments_.ends[s][1]});
    const std::size_t before = found_.inside.size();
    sweep(segments_.places, swept, found_, monitor);
    for (std::size_t i = before; i < found_.inside.size(); ++i)
      found_.inside[i].segment = swept[found_.inside[i].segment].line;
  }

  /// In units of pairs of boxes: the cost of a test of a pair, and of a crossing at a position that may be known
  /// already, which has to be compared exactly later.
  static constexpr std::size_t pairs_per_test = 8, pairs_per_repeat = 256;

  Segments& segments_;
  const std::vector<Box>& boxes_;
  const std::vector<Run>& runs_;
  Strips& strips_;
  std::size_t patience_;
  Intersections found_;
  IntersectionFinder finder_;
  std::uint32_t strip_ = 0;  ///< the current strip
  std::size_t tests_ = 0;    ///< in this strip
  std::size_t places_before_ = 0, repeats_before_ = 0;
  std::array<std::size_t, 3> sizes_before_{};  ///< numbers of points found before this strip
  std::uint32_t points_before_ = 0;
  std::vector<std::uint32_t> crowds_;  ///< strips
};

/// The points inside every segment, as lists in order along it. Equal ones are identified.
class PointsInside {
 public:
  PointsInside(const std::vector<Meeting>& intersections, const Segments& segments, Names& names)
      : first_(segments.ends.size() + 1), point_(intersections.size()) {
    for (const Meeting& m : intersections) ++first_[m.segment + 1];
    for (std::size_t s = 1; s < first_.size(); ++s) first_[s] += first_[s - 1];
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (const Meeting& m : intersections) point_[next[m.segment]++] = m.point;
    for (std::uint32_t s = 0; s + 1 < first_.size(); ++s) sort(segments.places, s, names);
  }
  /// On all segments.
  [[nodiscard]] std::size_t count() const { return point_.size(); }
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
      if (points[i] != points[i - 1] && order(points[i - 1], points[i]) == Sign::zero)
        names.unite(points[i - 1], points[i]);
  }

  std::vector<std::uint32_t> first_, point_;
};

void split(const PointsInside& inside, Arrangement& a) {
  a.first_piece.push_back(0);
  a.first_piece.reserve(a.ends.size() + 1);
  a.pieces.reserve(a.ends.size() + inside.count());
  a.segment_of.reserve(a.ends.size() + inside.count());
  for (std::uint32_t s = 0; s < a.ends.size(); ++s) {
    std::uint32_t from = a.ends[s][0];
    const auto go_to = [&](std::uint32_t to) {
      if (to != from) a.pieces.push_back({from, to});
      from = to;
    };
    for (const std::uint32_t p : inside.of(s)) go_to(a.vertex_of[p]);
    go_to(a.ends[s][1]);
    a.segment_of.resize(a.pieces.size(), s);
    a.first_piece.push_back(static_cast<std::uint32_t>(a.pieces.size()));
  }
}

}  // namespace

Arrangement arrange(Segments segments, const Monitor& monitor, std::size_t patience) {
  Arrangement a;
  std::vector<Box> boxes;
  boxes.reserve(segments.ends.size());
  for (const auto& [p, q] : segments.ends)
    boxes.push_back(hull(box_of(segments.places, p), box_of(segments.places, q)));
  const Copies copies(segments);
  a.runs = runs_of(segments, boxes, copies);
  std::unique_ptr<Strips> strips = strips_of(segments, boxes, a.runs);
  monitor.check();
  Intersections found = MeetingSearch(segments, boxes, a.runs, *strips, patience).find(monitor);
  copies.add_to(segments.ends, found);
  a.strips = std::move(strips);
  monitor.check();

  Names names(segments.places.size());
  for (const auto& [p, q] : found.equal) names.unite(p, q);
  const PointsInside inside(found.inside, segments, names);
  a.vertex_of = names.take();
  a.places = std::move(segments.places);
  a.ends = std::move(segments.ends);
  a.chains = std::move(segments.chains);
  for (auto& e : a.ends) e = {a.vertex_of[e[0]], a.vertex_of[e[1]]};
  a.is_fold.assign(a.places.size(), 0);
  for (const std::uint32_t p : found.folds) a.is_fold[a.vertex_of[p]] = 1;
  monitor.check();
  split(inside, a);
  return a;
}

std::vector<std::uint32_t> first_equal(std::span<const PlanePoint> points) {
  HashIndex table(points.size());
  std::vector<std::uint32_t> name(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i)
    name[i] = table.find_or_add(hash_of(points[i]), i, [&](std::uint32_t k) { return points[k] == points[i]; });
  return name;
}

}  // namespace strata::planar
