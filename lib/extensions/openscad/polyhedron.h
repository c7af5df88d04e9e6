#pragma once
#include <optional>

#include "extensions/openscad/report.h"
#include "extensions/openscad/syntax.h"
#include "strata/solid.h"

namespace strata::openscad {

/// The solid of a polyhedron, whose faces are listed clockwise as seen from outside. Planar faces are triangulated
/// exactly, others in a fixed way, which is noted. Nullopt if there are no faces. Faces that bound no solid are refused
/// with the first defect: a complete check, because such files are written by hand. Throws CsgError.
[[nodiscard]] std::optional<Solid> polyhedron(const SyntaxNode& node, Report& report);

}  // namespace strata::openscad
