#include "extensions/planar/sweep.h"

#include <algorithm>
#include <unordered_set>

namespace strata::planar {
namespace {

class Sweep {
 public:
  Sweep(Places& places, std::span<const SweptSegment> segments, Intersections& found)
      : places_(places), segments_(segments), found_(found), line_(places, segments), ends_(line_.ends_in_order()) {}

  void run(const Monitor& monitor) {
    for (std::size_t count = 1; gather_event(); ++count) {
      const SweepLine::Passage passage = line_.move_over(event_);
      for (const std::uint32_t s : line_.passing()) found_.inside.push_back({s, event_.point});
      if (passage.is_fold) found_.folds.push_back(event_.point);
      if (passage.lowest == none) {
        look_ahead(passage.below, passage.above);
      } else {
        look_ahead(passage.below, passage.lowest);
        look_ahead(passage.highest, passage.above);
      }
      if (count % 0x10000 == 0) monitor.check();
    }
  }

 private:
  struct Crossing {
    std::uint32_t point = 0, low = 0, high = 0;  ///< the meet, and what is below and above before it
  };
  struct IsLater {
    const Places& places;
    bool operator()(const Crossing& p, const Crossing& q) const {
      return compare_xy(places, p.point, q.point) == Sign::positive;
    }
  };

  /// Gathers the next point and all that ends, starts or crosses there. False when nothing is left.
  bool gather_event() {
    const bool has_end = next_end_ < ends_.size(), has_crossing = !crossings_.empty();
    if (!has_end && !has_crossing) return false;
    const bool is_end = has_end && (!has_crossing || compare_xy(places_, ends_[next_end_].point,
                                                                crossings_.front().point) != Sign::positive);
    const std::uint32_t point = is_end ? ends_[next_end_].point : crossings_.front().point;
    event_.point = point;
    event_.starting.clear();
    event_.ending.clear();
    event_.crossing = none;
    if (is_end) gather_ends();
    while (!crossings_.empty() && is_here(crossings_.front().point)) pop_crossing();
    return true;
  }
  void gather_ends() {
    for (; next_end_ < ends_.size() && is_here(ends_[next_end_].point); ++next_end_) {
      const auto [point, segment, kind] = ends_[next_end_];
      if (point != event_.point && point != ends_[next_end_ - 1].point) found_.equal.push_back({event_.point, point});
      if (kind == SweepLine::End::Kind::start) event_.starting.push_back(segment);
      if (kind == SweepLine::End::Kind::end) event_.ending.push_back(segment);
    }
  }
  void pop_crossing() {
    std::pop_heap(crossings_.begin(), crossings_.end(), IsLater{places_});
    const Crossing crossing = crossings_.back();
    crossings_.pop_back();
    if (crossing.point != event_.point) found_.equal.push_back({event_.point, crossing.point});
    event_.crossing = crossing.low;
    known_.erase(key(crossing.low, crossing.high));
  }
  [[nodiscard]] bool is_here(std::uint32_t point) const {
    return compare_xy(places_, point, event_.point) == Sign::zero;
  }

  /// Tests whether two neighbours cross later: the one that ends first is then on the wrong side of the other. (If it
  /// ends on the other one, that is found at its end.) They have not met after the line's point, where they separate.
  void look_ahead(std::uint32_t low, std::uint32_t high) {
    if (low == none || high == none) return;
    const std::uint32_t p = line_.last_point(low), q = line_.last_point(high);
    const bool is_low_first = compare_xy(places_, p, q) != Sign::positive;
    const Sign s = is_low_first ? line_.side_of(p, high) : -line_.side_of(q, low);
    if (s != Sign::positive || !known_.insert(key(low, high)).second) return;
    const auto [first, second] = std::minmax(segments_[low].line, segments_[high].line);
    crossings_.push_back({places_.add(Meet{first, second}), low, high});
    std::push_heap(crossings_.begin(), crossings_.end(), IsLater{places_});
  }

  static std::uint64_t key(std::uint32_t low, std::uint32_t high) { return std::uint64_t{low} << 32 | high; }

  Places& places_;
  std::span<const SweptSegment> segments_;
  Intersections& found_;
  SweepLine line_;
  std::vector<SweepLine::End> ends_;
  std::size_t next_end_ = 0;
  std::vector<Crossing> crossings_;          ///< to come: a heap
  std::unordered_set<std::uint64_t> known_;  ///< the pairs of these
  SweepLine::Event event_;
};

}  // namespace

void sweep(Places& places, std::span<const SweptSegment> segments, Intersections& found, const Monitor& monitor) {
  Sweep(places, segments, found).run(monitor);
}

}  // namespace strata::planar
