#include "extensions/scene/subordination.h"

#include <array>

namespace strata {
namespace {

/// Orientations of the edges of one triangle with the corners of the other: [edge][corner].
using Turns = std::array<std::array<Sign, 3>, 3>;

enum class Gap { none, closed, open };

/// The detail that the caller requires for tetrahedra without common interior rays.
enum class Detail { all, whether_ordered };

/// Does an edge of `s` separate `t` from `s`? `open`: there is no common ray at all, rims included. The orientations
/// are complete if there is no gap.
Gap find_turns(const SeenTriangle& s, const SightLines& lines, const SeenTriangle& t, Detail detail,
               Turns& orientations) {
  Gap gap = Gap::none;
  for (std::size_t e = 0; e < 3; ++e) {
    bool in = false, on = false;
    for (std::size_t c = 0; c < 3; ++c) {
      orientations[e][c] = lines[e].orientation(t.corners[c]);
      in = in || orientations[e][c] == s.orientation;
      on = on || orientations[e][c] == Sign::zero;
    }
    if (!in && !on) return Gap::open;
    if (!in) gap = Gap::closed;
    if (!in && detail == Detail::whether_ordered) return gap;
  }
  return gap;
}

enum class Within { no, rim, inside };

/// The position of a corner of t in s, as seen from the origin.
Within within(const SeenTriangle& s, const Turns& orientations, std::size_t corner) {
  bool rim = false;
  for (std::size_t e = 0; e < 3; ++e) {
    if (orientations[e][corner] == -s.orientation) return Within::no;
    rim = rim || orientations[e][corner] == Sign::zero;
  }
  return rim ? Within::rim : Within::inside;
}

/// The depths on rays that meet both triangles.
struct Depths {
  bool before = false, behind = false;  ///< s against t
  bool inside = false;                  ///< such a ray proves that rays meet both in the interior

  void add(Sign depth_of_s) {
    before = before || depth_of_s == Sign::negative;
    behind = behind || depth_of_s == Sign::positive;
  }
};

/// Corners of s that are seen in t.
void add_corners(const Sight& sight, const SeenTriangle& s, const SeenTriangle& t, const Turns& turns_of_t,
                 bool exchanged, Depths& depths) {
  for (std::size_t c = 0; c < 3; ++c) {
    const Within w = within(t, turns_of_t, c);
    if (w == Within::no) continue;
    depths.inside = depths.inside || w == Within::inside;
    const Sign depth = sight.depth(t.corners, t.orientation, s.corners[c]);
    depths.add(exchanged ? -depth : depth);
  }
}

/// Pairs of edges that are seen to cross; theory.md, "Order at a crossing".
void add_crossings(const Sight& sight, const SeenTriangle& s, const SeenTriangle& t, const Turns& of_s,
                   const Turns& of_t, Depths& depths) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t i2 = (i + 1) % 3, j2 = (j + 1) % 3;
      if (of_s[i][j] * of_s[i][j2] != Sign::negative || of_t[j][i] * of_t[j][i2] != Sign::negative) continue;
      if (of_t[j][i] != -of_s[i][j]) continue;  // one crosses the opposite of the other
      depths.inside = true;
      depths.add(of_s[i][j] * orient3d(sight.input(), s.corners[i], s.corners[i2], t.corners[j], t.corners[j2]));
    }
}

/// Does the plane through the origin, a and b separate the tetrahedra?
bool is_parted(const Sight& sight, std::uint32_t a, std::uint32_t b, const SeenTriangle& s, const SeenTriangle& t) {
  const SightLine line(sight, a, b);
  bool s_left = false, s_right = false, t_left = false, t_right = false;
  for (std::size_t c = 0; c < 3; ++c) {
    const Sign x = line.orientation(s.corners[c]), y = line.orientation(t.corners[c]);
    s_left = s_left || x == Sign::positive;
    s_right = s_right || x == Sign::negative;
    t_left = t_left || y == Sign::positive;
    t_right = t_right || y == Sign::negative;
  }
  return (!s_left && !t_right && s_right && t_left) || (!s_right && !t_left && s_left && t_right);
}

/// Cones have no common interior exactly when a plane through the origin and two of their corners separates them.
/// Planes through two corners of one triangle were tested before.
bool is_parted_by_corners(const Sight& sight, const SeenTriangle& s, const SeenTriangle& t) {
  for (const std::uint32_t a : s.corners)
    for (const std::uint32_t b : t.corners)
      if (is_parted(sight, a, b, s, t)) return true;
  return false;
}

SightLines lines_of(const Sight& sight, const Corners& c) {
  return {SightLine(sight, c[0], c[1]), SightLine(sight, c[1], c[2]), SightLine(sight, c[2], c[0])};
}

TetrahedraOverlap find_overlap(const Sight& sight, const SeenTriangle& s, const SightLines& lines_of_s,
                               const SeenTriangle& t, Detail detail) {
  Turns of_s, of_t;
  const Gap gap_of_s = find_turns(s, lines_of_s, t, detail, of_s);
  if (gap_of_s == Gap::open) return TetrahedraOverlap::apart;
  if (gap_of_s == Gap::closed && detail == Detail::whether_ordered) return TetrahedraOverlap::touching;
  const Gap gap_of_t = find_turns(t, lines_of(sight, t.corners), s, detail, of_t);
  if (gap_of_t == Gap::open) return TetrahedraOverlap::apart;
  if (gap_of_s == Gap::closed || gap_of_t == Gap::closed) return TetrahedraOverlap::touching;
  Depths depths;
  add_corners(sight, s, t, of_t, false, depths);
  add_corners(sight, t, s, of_s, true, depths);
  add_crossings(sight, s, t, of_s, of_t, depths);
  if (!depths.inside && is_parted_by_corners(sight, s, t)) return TetrahedraOverlap::touching;
  if (depths.before && depths.behind) return TetrahedraOverlap::crossing;
  if (depths.before) return TetrahedraOverlap::before;
  return depths.behind ? TetrahedraOverlap::behind : TetrahedraOverlap::coplanar;
}

}  // namespace

TetrahedraOverlap overlap_of(const Sight& sight, const SeenTriangle& s, const SeenTriangle& t) {
  return find_overlap(sight, s, lines_of(sight, s.corners), t, Detail::all);
}

Subordination::Subordination(const Sight& sight, const SeenTriangle& s)
    : sight_(sight), s_(s), lines_(lines_of(sight, s.corners)) {}

TetrahedraOverlap Subordination::to(const SeenTriangle& t) const {
  return find_overlap(sight_, s_, lines_, t, Detail::whether_ordered);
}

}  // namespace strata
