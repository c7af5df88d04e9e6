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

/// Segments of the plane, to be split at their intersections. Segment i lies on line i of `places`, which has its
/// direction; further lines are those of meets among the given points. A segment from a point to itself represents this
/// point alone. A segment that represents an isolated chain is a single piece: the chain meets other segments in its
/// ends only.
struct Segments {
  Places places;
  std::vector<std::array<std::uint32_t, 2>> ends;  ///< of segment i: points it goes from and to
  MonotoneChains chains;
};

/// A few consecutive segments that go forward: first, ..., end - 1.
struct Run {
  std::uint32_t first = 0, end = 0;
};

/// Segments split at their intersections: vertices, and pieces between them.
///
/// Invariants: two pieces meet in common ends only, or have both ends in common and coincide. Coincident points are one
/// vertex: `vertex_of` maps every point to the lowest number of its position, and pieces use only such numbers. (So a
/// position given as doubles has a number of a point given as doubles.) The pieces of segment i are first_piece[i] ..
/// first_piece[i + 1] - 1, in order along it, each from pieces[k][0] to pieces[k][1] in the segment's direction; a
/// segment that is a point has none. A *copy* is a segment between the ends of one with a lower number, from which it
/// is known where it is split. Crossings are meets of two segments' lines, appended to the given points.
struct Arrangement {
  Places places;
  std::vector<std::array<std::uint32_t, 2>> ends;    ///< of segments, as vertices
  std::vector<std::uint32_t> vertex_of;              ///< of every point
  std::vector<std::uint32_t> first_piece;            ///< of every segment, and the count of pieces
  std::vector<std::array<std::uint32_t, 2>> pieces;  ///< from vertex to vertex
  std::vector<std::uint8_t> is_fold;                 ///< of every vertex: two segments leave it in the same direction
  MonotoneChains chains;                             ///< the isolated chains
  std::vector<std::uint32_t> segment_of;             ///< of every piece
  std::vector<Run> runs;                             ///< of all segments that are no copies
  std::unique_ptr<const Strips> strips;              ///< strips of the runs, for queries

  /// True for the points of a point set: segments from a point to itself, as vertices; they may lie on pieces' ends.
  [[nodiscard]] bool is_point(std::uint32_t segment) const { return ends[segment][0] == ends[segment][1]; }
};

/// How many pairs of boxes may be tested, per eighth of a segment and per point found, before a sweep takes over: about
/// the cost of a sweep for them. Results do not depend on it, except the numbers of vertices.
inline constexpr std::size_t usual_patience = 64;

/// Splits segments at their intersections, exactly. O((n + k) log n) for n segments with k points inside them, counted
/// once for every segment that contains them; memory O(n + k). Throws Cancelled when the monitor requests it.
[[nodiscard]] Arrangement arrange(Segments segments, const Monitor& monitor = {},
                                  std::size_t patience = usual_patience);

/// Identifies equal doubles: maps every point to the first equal one. O(n). -0 equals 0.
[[nodiscard]] std::vector<std::uint32_t> first_equal(std::span<const PlanePoint> points);

}  // namespace strata::planar
