#pragma once
#include "extensions/bsp/piece.h"
#include "extensions/bsp/tree.h"
#include "strata/options.h"

namespace strata::bsp {

/// Combines two trees over one table. `nodes` contains both; nodes of the result are appended. Where one tree has a
/// leaf, the operation decides what becomes of the other: it is kept, is complemented, or becomes a leaf. Otherwise the
/// first one's root partitions the other tree, and the halves are combined on either side. Every node of the result
/// divides its part of space, and cuts that merging constructed next to a leaf have boundary on them. Throws Cancelled.
/// Source: Naylor, Amanatides and Thibault 1990; theory.md, "Merging".
template <int D>
[[nodiscard]] Link merged(const HyperplaneTable<D>& table, std::vector<Node>& nodes, Operation operation, Link a,
                          Link b, const Monitor& monitor = {});

/// A tree with leaves inside and outside exchanged; its nodes are appended. O(nodes).
[[nodiscard]] Link complemented(std::vector<Node>& nodes, Link tree);

}  // namespace strata::bsp
