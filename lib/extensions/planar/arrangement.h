#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "extensions/planar/monotone_chains.h"
#include "extensions/planar/places.h"
#include "extensions/planar/strips.h"
#include "strata/options.h"

namespace strata::planar {

/// Segments of the plane, to be split where they meet. Line i of `places` carries segment i and points its way; further
/// lines are those that meets among the given points refer to. A segment from a point to itself stands for this point
/// alone. A segment that stands for a monotone chain is a piece as it is: the monotone chain meets no other segment but
/// in its ends.
struct Segments {
  Places places;
  std::vector<std::array<std::uint32_t, 2>> ends;  ///< of segment i: points it goes from and to
  MonotoneChains chains;
};

/// Segments split where they meet: vertices, and pieces between them.
///
/// What holds: two pieces meet in common ends only, or have both ends in common and coincide. Equal places are one
/// vertex: `vertex_of` names every point by the lowest number that its place has, and pieces use only such numbers. (So
/// a place given as doubles is named by a point given as doubles.) The pieces of segment i are first_piece[i] ..
/// first_piece[i + 1] - 1, in order along it, each from pieces[k][0] to pieces[k][1] in the segment's direction; a
/// segment that is a point has none. Places of crossings are meets of two segments' lines, appended to the points that
/// were given.
struct Arrangement {
  Places places;
  std::vector<std::array<std::uint32_t, 2>> ends;    ///< of segments, as vertices
  std::vector<std::uint32_t> vertex_of;              ///< of every point
  std::vector<std::uint32_t> first_piece;            ///< of every segment, and the count of pieces
  std::vector<std::array<std::uint32_t, 2>> pieces;  ///< from vertex to vertex
  std::vector<std::uint8_t> is_fold;                 ///< of every vertex: two segments leave it the same way
  MonotoneChains chains;                             ///< that segments stand for
  std::vector<std::uint32_t> first_of_run;           ///< segments in runs of a few consecutive ones, and their count
  std::unique_ptr<const Strips> strips;              ///< where runs are, for queries

  /// The segment a piece is of. O(log n).
  [[nodiscard]] std::uint32_t segment_of(std::uint32_t piece) const;
  /// The points of a point set: segments from a point to itself, as vertices; they may lie on pieces' ends.
  [[nodiscard]] bool is_point(std::uint32_t segment) const { return ends[segment][0] == ends[segment][1]; }
};

/// How many pairs of boxes may be looked at, per eighth of a segment and per point found, before a sweep takes over:
/// about what a sweep takes for them. Results do not depend on it, but for the numbers of vertices.
inline constexpr std::size_t usual_patience = 64;

/// Splits segments where they meet, exactly. O((n + k) log n) for n segments with k points inside them, counted once
/// for every segment that they are in; memory O(n + k). Throws Cancelled when the monitor asks for it.
[[nodiscard]] Arrangement arrange(Segments segments, const Monitor& monitor = {},
                                  std::size_t patience = usual_patience);

/// The names of equal doubles made equal: of each place the first point's. O(n). -0 equals 0.
[[nodiscard]] std::vector<std::uint32_t> first_equal(std::span<const PlanePoint> points);

}  // namespace strata::planar
