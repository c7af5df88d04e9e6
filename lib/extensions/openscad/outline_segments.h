#pragma once
#include "extensions/openscad/cap.h"
#include "extensions/openscad/linear_extrude.h"

namespace strata::openscad {

/// Where the number of segments is given, divides the longest edges of each outline equally until it has as many.
/// Points are exact parts of edges. (Versions after 2021.01 divide outlines also where no number is given.) Throws
/// std::length_error beyond ten million.
void divide_outlines(Cap& cap, const LinearExtrusion& extrusion, std::uint32_t slices);

}  // namespace strata::openscad
