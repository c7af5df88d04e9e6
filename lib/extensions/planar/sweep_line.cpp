#include "extensions/planar/sweep_line.h"

#include <algorithm>

namespace strata::planar {

SweepLine::SweepLine(const Places& places, std::span<const SweptSegment> segments, const MonotoneChains* chains)
    : places_(places),
      segments_(segments),
      chains_(chains),
      is_backwards_(segments.size()),
      next_(segments.size(), none),
      place_of_(segments.size(), none) {
  for (std::size_t s = 0; s < segments.size(); ++s)
    is_backwards_[s] = compare_xy(places, segments[s].from, segments[s].to) == Sign::positive;
}

std::vector<SweepLine::End> SweepLine::ends_in_order() const {
  std::vector<End> ends;
  ends.reserve(2 * segments_.size());
  for (std::uint32_t s = 0; s < segments_.size(); ++s) {
    const auto [line, from, to] = segments_[s];
    if (compare_xy(places_, from, to) == Sign::zero) {
      ends.push_back({from, s, End::Kind::alone});
      if (from != to) ends.push_back({to, s, End::Kind::alone});
    } else {
      ends.push_back({is_backwards_[s] ? to : from, s, End::Kind::start});
      ends.push_back({last_point(s), s, End::Kind::end});
    }
  }
  std::sort(ends.begin(), ends.end(), [&](const End& p, const End& q) {
    const Sign order = compare_xy(places_, p.point, q.point);
    return order != Sign::zero ? order == Sign::negative : p.segment < q.segment;
  });
  return ends;
}

SweepLine::Passage SweepLine::move_over(const Event& event) {
  find(event);
  Passage passage;
  passing_.clear();
  if (event.starting.empty() && event.ending.empty() && lowest_ != none) {
    turn_around();
  } else {
    passage.is_fold = take_out(event);
    passage.is_fold |= put_in(event);
  }
  const auto segment = [&](std::uint32_t place) { return place == none ? none : first_[place]; };
  passage.below = segment(below_);
  passage.lowest = segment(lowest_);
  passage.highest = segment(highest_);
  passage.above = segment(above_);
  return passage;
}

/// Finds the bundles that contain the point, and their neighbours.
void SweepLine::find(const Event& event) {
  std::uint32_t known = !event.ending.empty()    ? place_of_[event.ending.front()]
                        : event.crossing != none ? place_of_[event.crossing]
                                                 : none;
  lowest_ = highest_ = none;
  if (known == none) {
    known = bundles_.first_not([&](std::uint32_t b) { return side_of(event.point, first_[b]) == Sign::positive; });
    if (known == none || !holds(known, event.point)) {
      above_ = known;
      below_ = known == none ? bundles_.last() : bundles_.before(known);
      return;
    }
  }
  lowest_ = highest_ = known;
  while ((below_ = bundles_.before(lowest_)) != none && holds(below_, event.point)) lowest_ = below_;
  while ((above_ = bundles_.after(highest_)) != none && holds(above_, event.point)) highest_ = above_;
}

/// Nothing starts or ends: reverses the order of the bundles.
void SweepLine::turn_around() {
  std::uint32_t low = lowest_, high = highest_;
  for (std::uint32_t b = lowest_; b != above_; b = bundles_.after(b))
    for (std::uint32_t s = first_[b]; s != none; s = next_[s]) passing_.push_back(s);
  while (low != high) {
    std::swap(first_[low], first_[high]);
    for (const std::uint32_t b : {low, high})
      for (std::uint32_t s = first_[b]; s != none; s = next_[s]) place_of_[s] = b;
    low = bundles_.after(low);
    if (low == high) break;
    high = bundles_.before(high);
  }
}

/// Removes the segments that end, and takes out those that continue, to be inserted again. True if several segments
/// arrived from the same direction.
bool SweepLine::take_out(const Event& event) {
  bool is_fold = false;
  if (lowest_ == none) return is_fold;
  for (const std::uint32_t s : event.ending) place_of_[s] = none;
  for (std::uint32_t b = lowest_; b != above_; b = bundles_.after(b)) {
    is_fold |= next_[first_[b]] != none;
    for (std::uint32_t s = first_[b]; s != none; s = next_[s])
      if (place_of_[s] != none) passing_.push_back(s);
  }
  return is_fold;
}

/// Inserts the segments that leave the point into the bundles that contained it, and into new ones if there are more.
/// True if several segments leave in the same direction.
bool SweepLine::put_in(const Event& event) {
  leaving_.assign(passing_.begin(), passing_.end());
  leaving_.insert(leaving_.end(), event.starting.begin(), event.starting.end());
  std::sort(leaving_.begin(), leaving_.end(), [&](std::uint32_t s, std::uint32_t t) {
    const Sign order = orientation(s, t);
    return order != Sign::zero ? order == Sign::positive : s < t;
  });
  bool is_fold = false;
  std::uint32_t old = lowest_, last = below_;
  lowest_ = highest_ = none;
  for (std::size_t i = 0; i < leaving_.size(); ++i) {
    const std::uint32_t s = leaving_[i];
    if (i > 0 && orientation(leaving_[i - 1], s) == Sign::zero) {
      is_fold = true;
      next_[s] = first_[last];
      put(last, s);
      continue;
    }
    if (old != none) {
      last = old;
      old = bundles_.after(old) == above_ ? none : bundles_.after(old);
    } else {
      last = bundles_.insert_after(last);
    }
    next_[s] = none;
    put(last, s);
    if (lowest_ == none) lowest_ = last;
    highest_ = last;
  }
  while (old != none) {
    const std::uint32_t after = bundles_.after(old);
    bundles_.erase(old);
    old = after == above_ ? none : after;
  }
  return is_fold;
}

void SweepLine::put(std::uint32_t place, std::uint32_t segment) {
  if (place >= first_.size()) first_.resize(place + 1, none);
  first_[place] = segment;
  place_of_[segment] = place;
}

/// Positive when t is above s to the right of their common point.
Sign SweepLine::orientation(std::uint32_t s, std::uint32_t t) const {
  const Sign sign = cross(places_, segments_[s].line, segments_[t].line);
  return is_backwards_[s] == is_backwards_[t] ? sign : -sign;
}

}  // namespace strata::planar
