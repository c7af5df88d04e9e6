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

/// The intersections of segments.
struct Intersections {
  std::vector<Meeting> inside;
  std::vector<std::array<std::uint32_t, 2>> equal;  ///< coincident points
  std::vector<std::uint32_t> folds;                 ///< points that two segments leave in the same direction
};

/// Finds the intersections of pairs of segments. Cases, by the four sides of each one's ends relative to the other's
/// line (theory.md, section 3): crossing inside both, end on interior, end on end, overlapping along a common line.
/// There are no others.
class IntersectionFinder {
 public:
  IntersectionFinder(Segments& segments, const Strips& strips, Intersections& found)
      : places_(segments.places), ends_(segments.ends), strips_(strips), found_(found) {}

  /// Tests a pair of segments that may meet in a strip (none: a pair that is tested once). Crossings in other strips
  /// are left to these.
  void test(std::uint32_t s, std::uint32_t t, std::uint32_t strip);

  /// The number of points found that are certainly different from the one before, plus the number of crossings that may
  /// be. (Where many segments go through one point, many pairs have this point.)
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
