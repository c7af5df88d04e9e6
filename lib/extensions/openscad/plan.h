#pragma once
#include <cstdint>
#include <vector>

#include "extensions/openscad/operations.h"
#include "extensions/openscad/part.h"
#include "extensions/openscad/report.h"
#include "extensions/openscad/syntax.h"
#include "strata/openscad.h"

namespace strata::openscad {

/// A part of a model that is made once: a leaf, which is made already, or an operation on other parts.
struct Step {
  const SyntaxNode* node = nullptr;  ///< null for the union of the top nodes
  NodeKind kind = NodeKind::union_;
  NodeOperation operation;  ///< none for a leaf
  std::vector<std::uint32_t> children;
  std::uint32_t level = 0;    ///< above those of its children
  std::uint32_t uses = 0;     ///< by other steps
  Part part;                  ///< of a leaf
  bool is_evaluated = false;  ///< several steps use it, and one of them takes its value, which is made once
};

/// The steps that a model takes, parents before their children; the first is the whole. Nodes with equal texts and
/// equal children are one step. Throws CsgError for the first node or argument that is not supported. No recursion.
/// O(size of the text) and what the leaves take.
[[nodiscard]] std::vector<Step> plan_of(const std::vector<SyntaxNode>& nodes, const CsgOptions& options,
                                        Report& report);

}  // namespace strata::openscad
