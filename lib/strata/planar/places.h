#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "strata/exact/bounded.h"
#include "strata/exact/rational.h"
#include "strata/kernel/filtered_turn.h"

/// The plane: points by name, arrangements of segments, polygons and their Booleans. theory.md has the mathematics.
namespace strata::plane {

/// "No such number" wherever points, lines, segments, pieces are numbered.
inline constexpr std::uint32_t none = 0xffffffff;

/// A point with rational coordinates.
using RationalPlacement = std::array<Rational, 2>;

/// The directed line through two given points, by their numbers.
struct Line {
  std::uint32_t from = 0, to = 0;
  friend bool operator==(const Line&, const Line&) = default;
};

/// The point where two lines meet, by their numbers; they are not parallel.
struct Meet {
  std::uint32_t first = 0, second = 0;
  friend bool operator==(const Meet&, const Meet&) = default;
};

/// Points and lines by number. A point is *given* (two doubles, or two rationals) or the *meet* of two lines; a line
/// goes through two given points. So every point is at most two steps away from numbers somebody wrote down, however
/// many operations it took to find it: its coordinates are quotients of polynomials of degree 3 and 2.
///
/// Numbers: points given as doubles come first, then those given as rationals, then meets.
/// `place` and `error` hold the exact point: |exact - place[i]| <= error (as in `Bounded`) for each coordinate.
struct Places {
  std::vector<PlanePoint> place;             ///< of every point; exact for doubles
  std::vector<PlanePoint> error;             ///< of every point that is not given as doubles
  std::vector<RationalPlacement> rationals;  ///< of every point given as rationals
  std::vector<Meet> meets;                   ///< of every point that is a meet
  std::vector<Line> lines;                   ///< no line's points are equal, except where a segment is a single point

  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(place.size()); }
  /// How many points are given as doubles: the first ones.
  [[nodiscard]] std::uint32_t doubles() const { return static_cast<std::uint32_t>(place.size() - error.size()); }
  /// How many points are given at all.
  [[nodiscard]] std::uint32_t given() const { return static_cast<std::uint32_t>(place.size() - meets.size()); }
  [[nodiscard]] bool is_double(std::uint32_t p) const { return p < doubles(); }
  [[nodiscard]] bool is_meet(std::uint32_t p) const { return p >= given(); }
  [[nodiscard]] const Meet& meet(std::uint32_t p) const { return meets[p - given()]; }
  [[nodiscard]] const RationalPlacement& rational(std::uint32_t p) const { return rationals[p - doubles()]; }
  /// One coordinate with its bound.
  [[nodiscard]] Bounded bounded(std::uint32_t p, std::size_t axis) const {
    return is_double(p) ? Bounded(place[p][axis]) : Bounded(place[p][axis], error[p - doubles()][axis]);
  }

  /// Appends a point; doubles before rationals before meets. Requires finite doubles and lines that are not parallel.
  std::uint32_t add(const PlanePoint& p);
  std::uint32_t add(RationalPlacement p);
  std::uint32_t add(const Meet& m);
  /// Takes the last meets away, so that `count` points are left.
  void drop_meets(std::uint32_t count);
};

/// The exact coordinates of a point. O(1) operations on rationals.
[[nodiscard]] RationalPlacement exact_place(const Places& places, std::uint32_t point);

/// The doubles nearest to a point's coordinates, ties to even. Mostly settled by 106-bit arithmetic.
[[nodiscard]] PlanePoint nearest_place(const Places& places, std::uint32_t point);

}  // namespace strata::plane
