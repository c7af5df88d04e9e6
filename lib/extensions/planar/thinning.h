#pragma once
#include <span>
#include <vector>

#include "extensions/planar/monotone_chains.h"
#include "strata/planar.h"

namespace strata::planar {

/// Operands with one edge in place of every isolated chain. All later stages see a chain only as this edge.
struct Thinned {
  std::vector<Operand> operands;  ///< of `loops`, or the given ones where there are no isolated chains
  std::vector<Loops> loops;
  std::vector<MonotoneChain> chains;
  std::vector<std::vector<std::uint32_t>> chain_of;  ///< of every operand's edges, by their first vertices, as in
                                                     ///< `MonotoneChains`; empty for an operand without monotone chains
};

/// Isolated chains (theory.md, section 3) with fewer edges are left unchanged.
inline constexpr std::uint32_t usual_chain = 32;

/// How many pairs of boxes may be tested, per edge, before the search is abandoned.
inline constexpr std::size_t usual_pairs = 2;

/// Finds isolated chains, by the boxes of monotone chains and their halves, down to single edges. Where long chains do
/// not contain a quarter of the edges, or too many boxes meet, there are none. O(n log n). The operands must outlive
/// the result.
[[nodiscard]] Thinned thin(std::span<const Operand> operands, std::uint32_t shortest_chain = usual_chain,
                           std::size_t most_pairs = usual_pairs);

}  // namespace strata::planar
