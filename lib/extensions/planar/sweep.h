#pragma once
#include "extensions/planar/intersections.h"
#include "extensions/planar/sweep_line.h"
#include "strata/options.h"

namespace strata::planar {

/// Finds the intersections of segments by a plane sweep, for dense sets in which many pairs find few points.
/// `Meeting::segment` is a number in `segments`; crossings are appended to the places, each once. O((n + m) log n) for
/// m points inside segments, counted once for every segment that contains them; memory O(n + m). Throws Cancelled.
/// Source: Bentley and Ottmann 1979, with points as events instead of pairs of segments (de Berg et al. 2008, section
/// 2.1); theory.md, section 3.
void sweep(Places& places, std::span<const SweptSegment> segments, Intersections& found, const Monitor& monitor = {});

}  // namespace strata::planar
