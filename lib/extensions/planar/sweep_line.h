#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "extensions/planar/monotone_chains.h"
#include "extensions/planar/ordered_list.h"
#include "extensions/planar/predicates.h"

namespace strata::planar {

/// A segment to be swept, on a line of the places that is directed from `from` to `to`. A segment from a point to
/// itself is this point.
struct SweptSegment {
  std::uint32_t line = 0, from = 0, to = 0;
};

/// The segments that a vertical sweep line meets, in order from below, while it moves over the plane from point to
/// point in lexicographic order. (It is slightly tilted: of points with equal x, the lower one is first, and a vertical
/// segment needs no case of its own.) Segments that coincide at the line are one *bundle*.
///
/// Requires that the line stops at every end of a segment and at every crossing.
class SweepLine {
 public:
  /// Segments are known by their numbers in `segments`; lines may be those of segments that represent isolated chains.
  SweepLine(const Places& places, std::span<const SweptSegment> segments, const MonotoneChains* chains = nullptr);

  /// An end of a segment, at a point.
  struct End {
    std::uint32_t point = 0, segment = 0;
    enum class Kind : std::uint8_t { start, end, alone } kind = Kind::start;  ///< alone: the segment is this point
  };
  /// All ends, in the order in which the line reaches them. O(n log n).
  [[nodiscard]] std::vector<End> ends_in_order() const;
  /// The end that the line reaches last.
  [[nodiscard]] std::uint32_t last_point(std::uint32_t segment) const {
    return is_backwards_[segment] ? segments_[segment].from : segments_[segment].to;
  }
  [[nodiscard]] bool is_backwards(std::uint32_t segment) const { return is_backwards_[segment] != 0; }

  /// Positive when a point is above a segment whose extent in the sweep order contains the point.
  [[nodiscard]] Sign side_of(std::uint32_t point, std::uint32_t segment) const {
    const std::uint32_t line = segments_[segment].line;
    const Sign s = chains_ != nullptr ? chains_->side(places_, point, line) : side(places_, point, line);
    return is_backwards_[segment] ? -s : s;
  }

  /// The event at a point.
  struct Event {
    std::uint32_t point = 0;
    std::vector<std::uint32_t> starting, ending;  ///< segments
    std::uint32_t crossing = none;                ///< a segment known to pass through, if there is one
  };
  /// The result of an event. A segment represents its bundle; none: there is none.
  struct Passage {
    std::uint32_t below = none, lowest = none, highest = none, above = none;  ///< below the point, leaving it, above it
    bool is_fold = false;  ///< several segments arrived from, or leave in, the same direction
  };
  /// Moves the line past a point. O(m log n + m log m) decisions, for the m segments at the point.
  Passage move_over(const Event& event);
  /// The segments that contain the last point in their interior.
  [[nodiscard]] std::span<const std::uint32_t> passing() const { return passing_; }

 private:
  [[nodiscard]] bool holds(std::uint32_t place, std::uint32_t point) const {
    return side_of(point, first_[place]) == Sign::zero;
  }
  void find(const Event& event);
  bool take_out(const Event& event);
  void turn_around();
  bool put_in(const Event& event);
  void put(std::uint32_t place, std::uint32_t segment);
  [[nodiscard]] Sign orientation(std::uint32_t s, std::uint32_t t) const;

  const Places& places_;
  std::span<const SweptSegment> segments_;
  const MonotoneChains* chains_;
  std::vector<std::uint8_t> is_backwards_;
  OrderedList bundles_;
  std::vector<std::uint32_t> first_;     ///< of every bundle: a segment
  std::vector<std::uint32_t> next_;      ///< of every segment: the next one of its bundle
  std::vector<std::uint32_t> place_of_;  ///< of every segment on the line: its bundle
  std::uint32_t lowest_ = none, highest_ = none, below_ = none, above_ = none;  ///< bundles at and around the point
  std::vector<std::uint32_t> passing_, leaving_;
};

}  // namespace strata::planar
