#include "extensions/planar/labels.h"

namespace strata::planar {

Labels::Labels(const Gathered& gathered, const Subdivision& s, std::span<const Operand> operands)
    : subdivision_(s), winding_(operands.size()) {
  inside_.is_in.resize(operands.size());
  for (const Operand& o : operands) fill_.push_back(o.fill);
  const auto chains = static_cast<std::uint32_t>(s.chains.size());
  same_edge_.assign(chains, none);
  operand_of_chain_.resize(chains);
  std::uint32_t operand = 0;
  for (std::uint32_t c = 0; c < chains; ++c) {
    while (s.chains[c].ring >= gathered.first_ring[operand + 1]) ++operand;  // chains are in the order of rings
    operand_of_chain_[c] = operand;
    if (s.is_edge(c)) continue;
    same_edge_[c] = same_edge_[s.edge_of[c]];
    same_edge_[s.edge_of[c]] = c;
  }
  if (s.components.size() < 2) return;
  first_inside_.assign(s.cycles, none);
  next_inside_.assign(s.components.size(), none);
  for (std::uint32_t i = 0; i < s.components.size(); ++i) {
    const std::uint32_t container = s.components[i].container;
    if (container != none) next_inside_[i] = std::exchange(first_inside_[s.cycle_of[container]], i);
  }
}

}  // namespace strata::planar
