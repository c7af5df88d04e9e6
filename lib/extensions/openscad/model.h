#pragma once
#include <vector>

#include "extensions/openscad/report.h"
#include "extensions/openscad/syntax.h"
#include "strata/expression.h"

namespace strata::openscad {

/// The solid that nodes stand for, as OpenSCAD has it (semantics.md): the union of the nodes at the top that count.
/// Throws CsgError for the first node or argument that is not supported. No recursion.
[[nodiscard]] Expression model_of(const std::vector<SyntaxNode>& nodes, Placement placement, Report& report);

}  // namespace strata::openscad
