#pragma once
#include <vector>

#include "extensions/openscad/part.h"
#include "extensions/openscad/report.h"
#include "strata/options.h"

namespace strata::openscad {

/// Parts of one dimension, that of the first that is not empty; others become empty, with a note, as in OpenSCAD.
[[nodiscard]] std::vector<Part> of_one_dimension(std::vector<Part> parts, const Place& place, Report& report);

/// Boolean operations of parts of one dimension: of shapes at once, of solids as expressions. An intersection is empty
/// as soon as one part is, a difference if the first is.
[[nodiscard]] Part union_of(std::vector<Part> parts, const Monitor& monitor);
[[nodiscard]] Part intersection_of(std::vector<Part> parts, const Monitor& monitor);
[[nodiscard]] Part difference_of(std::vector<Part> parts, const Monitor& monitor);

}  // namespace strata::openscad
