#pragma once
#include <functional>
#include <string>
#include <vector>

#include "extensions/openscad/node_kind.h"
#include "extensions/openscad/part.h"
#include "extensions/openscad/report.h"
#include "extensions/openscad/syntax.h"
#include "strata/options.h"
#include "strata/transform.h"

namespace strata::openscad {

/// Makes the part of a node from those of its children. Operations share nothing that they change.
using NodeOperation = std::function<Part(std::vector<Part> children, const Options& options, Report& report)>;

/// The operation of a node that may have children, with its arguments, which are checked now. `name` is for the solid
/// that it makes. The node must outlive it. Throws CsgError for arguments of wrong kinds.
[[nodiscard]] NodeOperation operation_of(NodeKind kind, const SyntaxNode& node, const std::string& name,
                                         Placement placement, Report& report);

/// The union of all children, as of nodes without a meaning of their own.
[[nodiscard]] NodeOperation union_operation(const SyntaxNode& node);

}  // namespace strata::openscad
