#pragma once
#include <vector>

#include "extensions/openscad/report.h"
#include "extensions/openscad/syntax.h"
#include "strata/openscad.h"

namespace strata::openscad {

/// The model of a tree of nodes, as in OpenSCAD (semantics.md): the union of the evaluated top nodes; without notes.
/// Throws CsgError for the first node or argument that is not supported. No recursion.
[[nodiscard]] CsgModel model_of(const std::vector<SyntaxNode>& nodes, const CsgOptions& options, Report& report);

}  // namespace strata::openscad
