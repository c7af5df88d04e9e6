#pragma once
#include <array>
#include <functional>
#include <optional>
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

/// The operation of a node that may have children, but of no `color`, with its arguments, which are checked now. `name`
/// is for the solid that it makes. The node must outlive it. Throws CsgError for arguments of wrong kinds.
[[nodiscard]] NodeOperation operation_of(NodeKind kind, const SyntaxNode& node, const std::string& name,
                                         Placement placement, Report& report);

/// The union of all children, as of nodes without a meaning of their own.
[[nodiscard]] NodeOperation union_operation(const SyntaxNode& node);

/// Light (red, green, blue) and opacity that a `color` gives. None, with a note, for one by name, and for numbers below
/// 0, with which OpenSCAD writes colours that it does not know.
[[nodiscard]] std::optional<std::array<double, 4>> color_of(const SyntaxNode& node, Report& report);
/// The union of all children, whose solids get a material of this colour.
[[nodiscard]] NodeOperation color_operation(const SyntaxNode& node, const std::array<double, 4>& color);

}  // namespace strata::openscad
