#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "strata/planar/loops.h"
#include "strata/planar/region.h"

namespace strata::plane {

/// How polyloops fail to be clean: two of their vertices and edges share a point (source document, 4.1).
enum class SelfMeetingKind {
  vertex_on_vertex,   ///< several vertices have one place
  vertex_on_edge,     ///< vertices lie inside edges
  edges_crossing,     ///< edges share a point inside each of them
  edges_overlapping,  ///< edges share a stretch, from `where` to `to`
  lone_vertex,        ///< a loop of one vertex has no edges
};
[[nodiscard]] std::string_view name(SelfMeetingKind kind);  ///< "vertex on edge"

struct SelfMeeting {
  SelfMeetingKind kind = SelfMeetingKind::vertex_on_vertex;
  RationalPlacement where, to;          ///< exact; `to` of overlaps only
  std::vector<std::uint32_t> vertices;  ///< at `where`, as indices of `Loops::vertices`
  std::vector<std::uint32_t> edges;     ///< through `where`, by the indices of the vertices they start from
};

/// Every place where the loops, all together, meet themselves, and loops of one vertex. Loops are clean when there is
/// none: the edges of a loop of two vertices overlap. O((n + k) log n).
[[nodiscard]] std::vector<SelfMeeting> self_meetings(const Loops& loops);

/// Whether loops are clean polyloops, apart from each other, of three vertices or more.
[[nodiscard]] bool is_clean(const Loops& loops);

/// Where a region's loops, with every vertex at its nearest double, would meet other than in the vertices that they
/// share: what must be known before the rounded region is taken for a region. Empty where all vertices are doubles. O(n
/// log n).
[[nodiscard]] std::vector<SelfMeeting> rounding_conflicts(const Region& region);

/// What a region promises and does not keep; empty for every result of this room. O(n log n).
[[nodiscard]] std::vector<std::string> validate(const Region& region);

}  // namespace strata::plane
