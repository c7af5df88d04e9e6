#include "core/select/early_out.h"

#include <algorithm>

namespace strata {

bool EarlyOut::is_settled() {
  for (const std::uint32_t v : corners_)
    if (const std::uint32_t* operand = known_.find(v); operand != nullptr && !meets(*operand)) return settle(*operand);
  return false;
}

bool EarlyOut::is_settled(const Windings& windings) {
  for (const auto& [operand, w] : windings)
    if (rule_.settles(operand, w) && !meets(operand)) return settle(operand);
  std::uint32_t absent = 0;
  while (absent < rule_.operands() && (windings[absent] != 0 || meets(absent))) ++absent;
  return absent < rule_.operands() && rule_.settles(absent, 0) && settle(absent);
}

void EarlyOut::tell(std::uint32_t corner, const Windings& windings) {
  for (const auto& [operand, winding] : windings)
    if (rule_.settles(operand, winding)) known_.remember(corner, operand);
}

bool EarlyOut::meets(std::uint32_t operand) const { return std::binary_search(met_.begin(), met_.end(), operand); }

/// Other corners than the one that was evaluated may lie on the operand, but only where it has a vertex: the face would
/// meet it otherwise.
bool EarlyOut::settle(std::uint32_t operand) {
  for (const std::uint32_t v : corners_)
    if (!input_.is_shared(v)) known_.remember(v, operand);
  return true;
}

}  // namespace strata
