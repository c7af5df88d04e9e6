#include "core/csg/decision_diagram.h"

#include <algorithm>

namespace strata {

DecisionDiagram::DecisionDiagram() : nodes_(2) {}

DecisionDiagram::Function DecisionDiagram::variable(std::uint32_t number) { return make({number, never, always}); }

DecisionDiagram::Function DecisionDiagram::join(Formula::Join join, std::span<const Function> terms) {
  Function f = join == Formula::Join::all ? always : never;
  for (const Function t : terms) switch (join) {
      case Formula::Join::any:
        f = choose(t, always, f);
        break;
      case Formula::Join::all:
        f = choose(t, f, never);
        break;
      case Formula::Join::odd:
        f = choose(t, negate(f), f);
        break;
    }
  return f;
}

DecisionDiagram::Function DecisionDiagram::make(const Node& node) {
  if (node.low == node.high) return node.low;
  const auto [at, is_new] = known_nodes_.try_emplace(node, static_cast<Function>(nodes_.size()));
  if (is_new) nodes_.push_back(node);
  return at->second;
}

/// The depth of recursion is at most the number of variables.
DecisionDiagram::Function DecisionDiagram::choose(Function condition, Function then, Function otherwise) {
  if (condition == always || then == otherwise) return then;
  if (condition == never) return otherwise;
  if (is_too_large()) return never;
  const std::array<Function, 3> question{condition, then, otherwise};
  if (const auto known = known_choices_.find(question); known != known_choices_.end()) return known->second;
  std::uint32_t top = 0xffffffffu;
  for (const Function f : question) top = std::min(top, nodes_[f].variable);
  const auto part = [&](Function f, bool high) {
    return nodes_[f].variable != top ? f : high ? nodes_[f].high : nodes_[f].low;
  };
  const Function high = choose(part(condition, true), part(then, true), part(otherwise, true));
  const Function low = choose(part(condition, false), part(then, false), part(otherwise, false));
  return known_choices_[question] = make({top, low, high});
}

std::vector<bool> DecisionDiagram::support(Function f, std::size_t variables) const {
  std::vector<bool> depends(variables), seen(nodes_.size());
  std::vector<Function> open{f};
  while (!open.empty()) {
    const Function g = open.back();
    open.pop_back();
    if (g <= always || seen[g]) continue;
    seen[g] = true;
    depends[nodes_[g].variable] = true;
    open.push_back(nodes_[g].low);
    open.push_back(nodes_[g].high);
  }
  return depends;
}

}  // namespace strata
