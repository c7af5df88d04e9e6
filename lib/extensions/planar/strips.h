#pragma once
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "extensions/planar/places.h"

namespace strata::planar {

/// A closed box of the plane.
struct Box {
  double left = 0, right = 0, low = 0, high = 0;
};

/// The box of the possible positions of a point.
[[nodiscard]] inline Box box_of(const Places& places, std::uint32_t p) {
  if (const PlanePoint& q = places.place[p]; places.is_double(p)) return {q[0], q[0], q[1], q[1]};
  const Bounded x = bounded(places, p, 0), y = bounded(places, p, 1);
  return {x.lower(), x.upper(), y.lower(), y.upper()};
}

[[nodiscard]] inline Box hull(const Box& a, const Box& b) {
  return {std::min(a.left, b.left), std::max(a.right, b.right), std::min(a.low, b.low), std::max(a.high, b.high)};
}

[[nodiscard]] inline bool overlap(const Box& a, const Box& b) {
  return a.left <= b.right && b.left <= a.right && a.low <= b.high && b.low <= a.high;
}

/// Horizontal strips of the plane, each with the segments that enter it. Two segments that meet share a strip in which
/// their boxes meet: heights are mapped to strips by a monotone function, and a segment's part in a strip is only
/// overestimated. Strips have equal heights or, where segments are dense, equal numbers of segments.
class Strips {
 public:
  /// Boxes of the segments; `ends` are both ends of each, as doubles; the boxes include their uncertainty. O(n +
  /// entries); there are less than about 8 n entries.
  Strips(std::vector<Box> boxes, std::vector<std::array<PlanePoint, 2>> ends);

  [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(first_.size() - 1); }
  [[nodiscard]] std::uint32_t strip_of(double y) const;
  /// The segments that enter a strip.
  [[nodiscard]] std::span<const std::uint32_t> segments(std::uint32_t strip) const {
    return {segment_.data() + first_[strip], segment_.data() + first_[strip + 1]};
  }

  /// The same, by the left ends of their parts in the strip, once the strips are sorted; and these left ends.
  [[nodiscard]] std::span<const double> lefts(std::uint32_t strip) const {
    return {left_.data() + first_[strip], left_.data() + first_[strip + 1]};
  }
  /// The largest width of a part in the strip.
  [[nodiscard]] double widest(std::uint32_t strip) const { return widest_[strip]; }
  [[nodiscard]] const Box& box(std::uint32_t segment) const { return boxes_[segment]; }

  /// Sorts the segments of every strip. Calls visitor.enter(strip), then visitor.visit(segment, segment) for every pair
  /// of them whose boxes meet in the strip, and after every segment visitor.is_enough(pairs tested in the strip): true
  /// skips the strip's other pairs. A pair may occur in several strips.
  template <class Visitor>
  void sort(Visitor& visitor) {
    std::vector<Entry> entries;
    left_.resize(segment_.size());
    widest_.assign(count(), 0);
    for (std::uint32_t k = 0; k < count(); ++k) {
      load(k, entries);
      visitor.enter(k);
      std::size_t pairs = 0;
      for (std::size_t i = 0; i < entries.size(); ++i) {
        const Box& a = entries[i].box;
        std::size_t j = i + 1;
        for (; j < entries.size() && entries[j].box.left <= a.right; ++j)
          if (entries[j].box.low <= a.high && entries[j].box.high >= a.low)
            visitor.visit(entries[i].segment, entries[j].segment);
        pairs += j - i;
        if (visitor.is_enough(pairs)) break;
      }
    }
  }

 private:
  struct Entry {
    Box box;  ///< of the segment's part in the strip
    std::uint32_t segment;
  };
  void choose_heights();
  void choose_overlapping();
  void fill();
  [[nodiscard]] bool overlaps_many() const;
  void load(std::uint32_t strip, std::vector<Entry>& entries);
  [[nodiscard]] Box part_in(std::uint32_t segment, double low, double high) const;

  std::vector<Box> boxes_;
  std::vector<std::array<PlanePoint, 2>> ends_;
  double half_low_ = 0, scale_ = 0;  ///< y -> (y / 2 - half_low) * scale
  std::uint32_t count_ = 1;
  std::vector<double> bounds_;  ///< lower bounds of the strips 1, 2, ... where they have unequal heights
  std::vector<std::uint32_t> first_{0, 0}, segment_;
  std::vector<double> left_, widest_;
};

}  // namespace strata::planar
