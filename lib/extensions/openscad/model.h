#pragma once
#include <vector>

#include "extensions/openscad/report.h"
#include "extensions/openscad/syntax.h"
#include "strata/expression.h"

namespace strata::openscad {

/// The solid of a tree of nodes, as in OpenSCAD (semantics.md): the union of the evaluated top nodes. Throws CsgError
/// for the first node or argument that is not supported. No recursion.
[[nodiscard]] Expression model_of(const std::vector<SyntaxNode>& nodes, Placement placement, Report& report);

}  // namespace strata::openscad
