#pragma once
#include <array>
#include <boost/container/small_vector.hpp>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "core/containers/ray_slabs.h"
#include "core/kernel/box.h"

namespace strata {

/// A bounding volume hierarchy: a binary tree over the boxes of numbered items, with the boxes of both children in each
/// node. Boxes are kept for nodes only; whether an item of a leaf is of interest is the caller's to find out. An
/// immutable value, safe to ask from many threads, and the same for any number of threads that build it. About 30 bytes
/// per item.
class BoxTree {
 public:
  /// A part of a tree: a child of a node.
  struct Branch {
    std::uint32_t node = 0;
    std::uint32_t side = 0;
  };
  /// A box of all of some items.
  using BoxOf = std::function<Box(std::span<const std::uint32_t> items)>;
  /// Leaves of a tree `by_order` hold no more items than this.
  static constexpr std::uint32_t leaf_size = 8;

  /// A tree without items.
  BoxTree() = default;
  /// Over items 0, ..., count - 1, divided where the surface area heuristic is least over bins of the boxes' centres
  /// (Wald 2007): for trees that are asked often. Asks for the box of every item three times, from several threads at
  /// once. O(n log n), in parallel.
  [[nodiscard]] static BoxTree by_surface_area(std::uint32_t count, const BoxOf& box_of);
  /// Over items in a given order, halved again and again: quick to build. Asks for every box once. O(n).
  [[nodiscard]] static BoxTree by_order(std::vector<std::uint32_t> items, const BoxOf& box_of);

  [[nodiscard]] bool empty() const { return nodes_.empty(); }
  /// Of all items.
  [[nodiscard]] const Box& bounds() const { return bounds_; }
  [[nodiscard]] std::size_t bytes() const {
    return nodes_.capacity() * sizeof(Node) + items_.capacity() * sizeof(std::uint32_t);
  }

  /// The whole tree. Requires items, as everything about branches does.
  [[nodiscard]] static Branch root() { return {}; }
  [[nodiscard]] bool is_leaf(Branch b) const { return !is_inner(nodes_[b.node].count[b.side]); }
  [[nodiscard]] Box box(Branch b) const { return box(nodes_[b.node], b.side); }
  /// How many items are in a branch.
  [[nodiscard]] std::uint32_t count(Branch b) const { return nodes_[b.node].count[b.side] & most_items; }
  /// The parts of a branch that is no leaf.
  [[nodiscard]] std::array<Branch, 2> children(Branch b) const {
    const std::uint32_t node = nodes_[b.node].first[b.side];
    return {Branch{node, 0}, Branch{node, 1}};
  }
  /// The items of a leaf.
  [[nodiscard]] std::span<const std::uint32_t> items(Branch leaf) const {
    const Node& node = nodes_[leaf.node];
    return std::span(items_).subspan(node.first[leaf.side], node.count[leaf.side]);
  }

  /// Calls `visit(item)` for all items of leaves whose boxes, and those around them, `enter(box)` lets in; ends, and
  /// returns false, when `visit` does.
  template <class Enter, class Visit>
  bool for_each_in(const Enter& enter, const Visit& visit) const {
    return empty() || for_each_below(nodes_[0], enter, visit);
  }
  /// The same for leaves that meet a box: all items that do, and a few more. O(log n + found) for small boxes apart.
  template <class Visit>
  bool for_each_near(const Box& box, const Visit& visit) const {
    return empty() || for_each_near_below(nodes_[0], box, visit);
  }
  /// Calls `visit(items)` for leaves, the nearest boxes first: of all items that the line meets at a parameter of
  /// [0, limit], and a few more, each once. `visit` returns the limit from then on; below zero ends it.
  /// `slabs` must have been made for `bounds()`.
  template <class Visit>
  void for_each_along(const RaySlabs& slabs, double limit, const Visit& visit) const;

 private:
  friend class BoxTreeBuilder;
  static constexpr std::uint32_t inner = 0x80000000u, most_items = inner - 1;
  static constexpr std::size_t most_levels = 128;
  static bool is_inner(std::uint32_t count) { return (count & inner) != 0; }

  /// Child k: a leaf of `count[k]` items from `first[k]`, or, where `count[k]` is marked as `inner`, the node of that
  /// number. The first node has one child, the root; the other one is an empty leaf with an empty box.
  struct Node {
    BoxPair boxes;
    std::array<std::uint32_t, 2> first{}, count{};
  };

  [[nodiscard]] static Box box(const Node& node, std::size_t side);
  template <class Enter, class Visit>
  bool for_each_below(const Node& node, const Enter& enter, const Visit& visit) const;
  template <class Visit>
  bool for_each_near_below(const Node& node, const Box& box, const Visit& visit) const;

  std::vector<Node> nodes_;  ///< none: no items
  std::vector<std::uint32_t> items_;
  Box bounds_;
};

inline Box BoxTree::box(const Node& node, std::size_t side) {
  const auto& [lower, upper] = node.boxes;
  return {{lower[0][side], lower[1][side], lower[2][side]}, {upper[0][side], upper[1][side], upper[2][side]}};
}

template <class Enter, class Visit>
bool BoxTree::for_each_below(const Node& node, const Enter& enter, const Visit& visit) const {
  for (std::size_t side = 0; side < 2; ++side) {
    if (!enter(box(node, side))) continue;
    const std::uint32_t first = node.first[side], count = node.count[side];
    if (is_inner(count)) {
      if (!for_each_below(nodes_[first], enter, visit)) return false;
      continue;
    }
    for (std::uint32_t i = first; i < first + count; ++i)
      if (!visit(items_[i])) return false;
  }
  return true;
}

/// Looks at both children at once, without branches.
template <class Visit>
bool BoxTree::for_each_near_below(const Node& node, const Box& box, const Visit& visit) const {
  const auto& [lower, upper] = node.boxes;
  std::array<bool, 2> met{true, true};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 2; ++k)
      met[k] = (static_cast<int>(met[k]) & static_cast<int>(lower[i][k] <= box.upper[i]) &
                static_cast<int>(box.lower[i] <= upper[i][k])) != 0;
  const auto look = [&](std::size_t k) {
    const std::uint32_t first = node.first[k], count = node.count[k];
    if (is_inner(count)) return for_each_near_below(nodes_[first], box, visit);
    for (std::uint32_t i = first; i < first + count; ++i)
      if (!visit(items_[i])) return false;
    return true;
  };
  return (!met[0] || look(0)) && (!met[1] || look(1));
}

template <class Visit>
void BoxTree::for_each_along(const RaySlabs& slabs, double limit, const Visit& visit) const {
  if (nodes_.empty()) return;
  struct Waiting {
    double near;
    std::uint32_t first, count;
  };
  std::array<Waiting, most_levels> waiting;
  std::size_t size = 0;
  Waiting next{0, nodes_[0].first[0], nodes_[0].count[0]};
  while (limit >= 0) {
    if (is_inner(next.count)) {
      const Node& node = nodes_[next.first];
      const BoxEntries e = slabs.enter(node.boxes, limit);
      const auto child = [&](std::size_t k) { return Waiting{e.near[k], node.first[k], node.count[k]}; };
      if (e.met[0] && e.met[1]) {
        const std::size_t nearer = e.near[1] < e.near[0] ? 1 : 0;
        waiting[size++] = child(1 - nearer);
        next = child(nearer);
        continue;
      }
      if (e.met[0] || e.met[1]) {
        next = child(e.met[0] ? 0 : 1);
        continue;
      }
    } else {
      limit = visit(std::span<const std::uint32_t>(items_).subspan(next.first, next.count));
    }
    do {
      if (size == 0) return;
      next = waiting[--size];
    } while (next.near * (1 - 0x1p-49) - 0x1p-1060 > limit);
  }
}

/// True where the first of two branches, not both of them leaves, is the one to divide: the one of more items, leaves
/// never.
inline bool is_first_divided(const BoxTree& a, BoxTree::Branch m, const BoxTree& b, BoxTree::Branch n) {
  return b.is_leaf(n) || (!a.is_leaf(m) && a.count(m) >= b.count(n));
}

/// Calls `visit(leaf of a, leaf of b)` for pairs of leaves whose boxes meet; ends, and returns false, when it does.
/// Always in the same order.
template <class Visit>
bool for_each_near_leaves(const BoxTree& a, const BoxTree& b, const Visit& visit) {
  using Node = BoxTree::Branch;
  boost::container::small_vector<std::pair<Node, Node>, 128> waiting;
  if (!a.empty() && !b.empty() && a.bounds().overlaps(b.bounds())) waiting.emplace_back(a.root(), b.root());
  while (!waiting.empty()) {
    const auto [m, n] = waiting.back();
    waiting.pop_back();
    if (a.is_leaf(m) && b.is_leaf(n)) {
      if (!visit(m, n)) return false;
    } else if (is_first_divided(a, m, b, n)) {
      const Box other = b.box(n);
      const auto [left, right] = a.children(m);
      if (a.box(right).overlaps(other)) waiting.emplace_back(right, n);
      if (a.box(left).overlaps(other)) waiting.emplace_back(left, n);
    } else {
      const Box other = a.box(m);
      const auto [left, right] = b.children(n);
      if (b.box(right).overlaps(other)) waiting.emplace_back(m, right);
      if (b.box(left).overlaps(other)) waiting.emplace_back(m, left);
    }
  }
  return true;
}

}  // namespace strata
