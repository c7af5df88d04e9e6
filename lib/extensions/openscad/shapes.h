#pragma once
#include "extensions/openscad/part.h"
#include "extensions/openscad/report.h"
#include "extensions/openscad/syntax.h"

namespace strata::openscad {

/// Squares, circles and polygons, with the corners that OpenSCAD gives them, in doubles. What has no area is nothing,
/// with a note. A polygon is filled where its paths wind around an odd number of times. Throws CsgError for arguments
/// of wrong kinds, and for circles that are too fine.
[[nodiscard]] Part square(const SyntaxNode& node, Report& report);
[[nodiscard]] Part circle(const SyntaxNode& node, Report& report);
[[nodiscard]] Part polygon(const SyntaxNode& node, Report& report);

}  // namespace strata::openscad
