#pragma once
#include <cstdint>
#include <vector>

#include "extensions/planar/arrangement.h"
#include "extensions/planar/predicates.h"

namespace strata::planar {

/// A point inside a segment, or at its end under another name.
struct Meeting {
  std::uint32_t segment = 0, point = 0;
};

/// Where segments meet.
struct Intersections {
  std::vector<Meeting> inside;
  std::vector<std::array<std::uint32_t, 2>> equal;  ///< points that have one place
  std::vector<std::uint32_t> folds;                 ///< points that two segments leave the same way
};

/// Finds where pairs of segments meet. Cases, by the four sides of each one's ends to the other's line (theory.md,
/// section 3): crossing inside both, end on inside, end on end, overlapping along a common line; nothing else is a
/// meeting.
class IntersectionFinder {
 public:
  IntersectionFinder(Segments& segments, const Strips& strips, Intersections& found)
      : places_(segments.places), ends_(segments.ends), strips_(strips), found_(found) {}

  /// A pair of segments that may meet in a strip (none: a pair that comes once). Crossings elsewhere are left to the
  /// strips they are in.
  void test(std::uint32_t s, std::uint32_t t, std::uint32_t strip);

  /// How many points were found that are certainly elsewhere than the one before, and how many crossings that may be
  /// there. (Where many segments go through one point, so do many pairs.)
  [[nodiscard]] std::size_t new_places() const { return new_places_; }
  [[nodiscard]] std::size_t repeated_crossings() const { return repeated_crossings_; }

 private:
  void add(std::uint32_t s, std::uint32_t point);
  void count(std::uint32_t point);
  using Ends = std::array<std::uint32_t, 2>;
  void test_point(std::uint32_t point, std::uint32_t s);
  void test_sharing(std::uint32_t s, std::uint32_t t, std::uint32_t shared, std::uint32_t a, std::uint32_t b);
  void test_overlap(std::uint32_t s, std::uint32_t t);
  void test_end_inside(std::uint32_t s, std::uint32_t end);
  void add_crossing(std::uint32_t s, std::uint32_t t, std::uint32_t strip);
  [[nodiscard]] Sign side_of(std::uint32_t point, std::uint32_t s) const { return side(places_, point, s); }

  Places& places_;
  const std::vector<Ends>& ends_;
  const Strips& strips_;
  Intersections& found_;
  std::array<Bounded, 2> last_{HUGE_VAL, HUGE_VAL};
  std::size_t new_places_ = 0, repeated_crossings_ = 0;
};

}  // namespace strata::planar
