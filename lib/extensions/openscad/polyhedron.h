#pragma once
#include <optional>

#include "extensions/openscad/report.h"
#include "extensions/openscad/syntax.h"
#include "strata/solid.h"

namespace strata::openscad {

/// The solid of a polyhedron, whose faces are listed clockwise as seen from outside. Faces in one plane are divided
/// exactly, others in a fixed way, which is noted. Without a value for one without faces. What bounds no solid is
/// refused with its first defect: a complete check, since hands write these. Throws CsgError.
[[nodiscard]] std::optional<Solid> polyhedron(const SyntaxNode& node, Report& report);

}  // namespace strata::openscad
