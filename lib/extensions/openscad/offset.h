#pragma once
#include "extensions/openscad/tessellation.h"
#include "strata/planar.h"

namespace strata::openscad {

/// How OpenSCAD's offset joins the moved edges at corners that stick out.
enum class OffsetJoin {
  round,    ///< r: by an arc
  miter,    ///< delta: they are prolonged
  chamfer,  ///< delta, chamfer: by a straight line at the distance
};

/// A region grown by a distance, or shrunk by a negative one. Every edge is moved along its normal, in doubles, and
/// what the resulting loops wind around is filled, exactly. Corners that reach in are joined through the corner itself.
/// Vertices that are no doubles are rounded to doubles first. An arc has the steps of the circle with that radius,
/// counted from the normal of the edge before. Requires a finite distance.
/// Throws std::length_error for circles of more than a million sides.
[[nodiscard]] planar::Region offset(const planar::Region& region, double distance, OffsetJoin join,
                                    const Resolution& resolution);

}  // namespace strata::openscad
