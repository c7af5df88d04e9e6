#pragma once
#include "extensions/planar/intersections.h"
#include "extensions/planar/sweep_line.h"
#include "strata/options.h"

namespace strata::planar {

/// Finds where segments meet by a plane sweep: for crowds of pairs that find little. `Meeting::segment` is a number in
/// `segments`; crossings are appended to the places, each once. O((n + m) log n) for m points inside segments, counted
/// once for every segment that they are in; memory O(n + m). Throws Cancelled.
/// Source: Bentley and Ottmann 1979, with points in place of pairs of segments (de Berg et al., "Computational
/// Geometry", 2.1); theory.md, section 3.
void sweep(Places& places, std::span<const SweptSegment> segments, Intersections& found, const Monitor& monitor = {});

}  // namespace strata::planar
