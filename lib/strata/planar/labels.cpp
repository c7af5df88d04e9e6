#include "strata/planar/labels.h"

namespace strata::plane {

Labels::Labels(const Gathered& gathered, const Subdivision& s, std::span<const Operand> operands)
    : gathered_(gathered), subdivision_(s), winding_(operands.size()) {
  inside_.is_in.resize(operands.size());
  for (const Operand& o : operands) fill_.push_back(o.fill);
  const auto chains = static_cast<std::uint32_t>(s.chains.size());
  same_edge_.assign(chains, none);
  operand_of_chain_.resize(chains);
  std::uint32_t operand = 0;
  for (std::uint32_t c = 0; c < chains; ++c) {
    while (s.chains[c].ring >= gathered.first_ring[operand + 1]) ++operand;  // chains come in the order of rings
    operand_of_chain_[c] = operand;
    if (s.is_edge(c)) continue;
    same_edge_[c] = same_edge_[s.edge_of[c]];
    same_edge_[s.edge_of[c]] = c;
  }
}

/// Going along the ray to the right: over a segment that goes up, to its right.
void Labels::count_hits(const Subdivision::Component& c, int times) {
  for (std::uint32_t i = c.first_hit; i < c.end_hit; ++i) {
    const Subdivision::Hit& hit = subdivision_.hits[i];
    add(gathered_.operand_of[hit.segment], hit.upward ? -times : times);
  }
}

}  // namespace strata::plane
