#pragma once
#include <span>
#include <vector>

#include "extensions/planar/monotone_chains.h"
#include "strata/planar.h"

namespace strata::planar {

/// Operands with an edge in place of every monotone chain, which is all of a monotone chain that other stages have to
/// see.
struct Thinned {
  std::vector<Operand> operands;  ///< of `loops`, or what was given where it has no monotone chains
  std::vector<Loops> loops;
  std::vector<MonotoneChain> chains;
  std::vector<std::vector<std::uint32_t>> chain_of;  ///< of every operand's edges, by their first vertices, as in
                                                     ///< `MonotoneChains`; empty for an operand without monotone chains
};

/// Monotone chains (theory.md, section 3) of fewer edges are left as they are.
inline constexpr std::uint32_t usual_chain = 32;

/// How many pairs of boxes may be looked at, per edge, before monotone chains are given up.
inline constexpr std::size_t usual_pairs = 2;

/// Finds monotone chains, by the boxes of monotone chains and their halves, down to single edges. Where long chains do
/// not hold a quarter of the edges, or too many boxes meet, there are none. O(n log n). The operands must outlive the
/// result.
[[nodiscard]] Thinned thin(std::span<const Operand> operands, std::uint32_t shortest_chain = usual_chain,
                           std::size_t most_pairs = usual_pairs);

}  // namespace strata::planar
