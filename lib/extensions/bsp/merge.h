#pragma once
#include "extensions/bsp/piece.h"
#include "extensions/bsp/tree.h"
#include "strata/options.h"

namespace strata::bsp {

/// Combines two trees over one table. `nodes` holds both; nodes of the result are appended. Where one tree has a leaf,
/// the operation says what becomes of the other: it stays, is complemented, or is a leaf. Otherwise the other tree is
/// parted by the first one's root, and the halves are combined on either side. Every node of the result divides its
/// part of space, and next to a leaf, cuts that merging made have boundary on them. Throws Cancelled. Source: Naylor,
/// Amanatides, Thibault 1990; theory.md, "Merging".
template <int D>
[[nodiscard]] Link merged(const HyperplaneTable<D>& table, std::vector<Node>& nodes, Operation operation, Link a,
                          Link b, const Monitor& monitor = {});

/// A tree with leaves inside and outside exchanged; its nodes are appended. O(nodes).
[[nodiscard]] Link complemented(std::vector<Node>& nodes, Link tree);

}  // namespace strata::bsp
