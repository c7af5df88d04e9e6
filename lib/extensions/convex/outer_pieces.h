#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/kernel/input_complex.h"
#include "core/overlap/point_table.h"
#include "core/select/subdivide.h"
#include "extensions/convex/membership.h"
#include "strata/options.h"

namespace strata::convex {

/// A triangle of a face, by its corners.
struct PieceOfFace {
  std::uint32_t face = 0;
  std::array<PointId, 3> corners{};
};

/// The side of a solid on which a position just in front of a piece lies. Every number > 0 gives another position;
/// nearly all of them are decided. Called from several threads.
using SideInFront = std::function<Side(const PieceOfFace&, int)>;

/// Drops the pieces of an arrangement that are not in the boundary of a bounded solid. The boundary consists of pieces,
/// each with the solid behind it. Around an edge the boundary has an even number of pieces. So a piece alone at an edge
/// is dropped, and two pieces alone at an edge are both kept or both dropped: one membership test per patch that is
/// connected in this way. O(n log n), and the number of edges of three or more pieces for each time that a removal
/// leaves others alone. Throws Cancelled.
void keep_outer_pieces(const InputComplex& input, std::vector<Verdict>& verdicts, Subdivision& subdivision,
                       const SideInFront& in_front, const Monitor& monitor);

}  // namespace strata::convex
