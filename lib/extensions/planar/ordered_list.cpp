#include "extensions/planar/ordered_list.h"

namespace strata::planar {
namespace {

/// Mixes the bits of a number, one to one. Source: Appleby, MurmurHash3, the finalizer.
std::uint32_t mixed(std::uint32_t x) {
  x = (x ^ (x >> 16)) * 0x85ebca6b;
  x = (x ^ (x >> 13)) * 0xc2b2ae35;
  return x ^ (x >> 16);
}

}  // namespace

std::uint32_t OrderedList::new_node() {
  if (free_.empty()) {
    nodes_.emplace_back();
    free_.push_back(static_cast<std::uint32_t>(nodes_.size() - 1));
  }
  const std::uint32_t node = free_.back();
  free_.pop_back();
  nodes_[node] = {};
  nodes_[node].priority = mixed(node);
  return node;
}

/// Attaches a node to a parent (none: at the root) instead of another node.
void OrderedList::hang(std::uint32_t node, std::uint32_t parent, std::uint32_t instead_of) {
  if (node != none) nodes_[node].parent = parent;
  if (parent == none) {
    root_ = node;
  } else if (nodes_[parent].left == instead_of) {
    nodes_[parent].left = node;
  } else {
    nodes_[parent].right = node;
  }
}

/// Rotates a node above its parent.
void OrderedList::rise(std::uint32_t node) {
  const std::uint32_t parent = nodes_[node].parent;
  hang(node, nodes_[parent].parent, parent);
  const bool is_left = nodes_[parent].left == node;
  std::uint32_t& inner = is_left ? nodes_[node].right : nodes_[node].left;
  (is_left ? nodes_[parent].left : nodes_[parent].right) = inner;
  if (inner != none) nodes_[inner].parent = parent;
  inner = parent;
  nodes_[parent].parent = node;
}

std::uint32_t OrderedList::insert_after(std::uint32_t place) {
  const std::uint32_t node = new_node(), next = place == none ? first_ : nodes_[place].after;
  nodes_[node].before = place;
  nodes_[node].after = next;
  (place == none ? first_ : nodes_[place].after) = node;
  (next == none ? last_ : nodes_[next].before) = node;
  // Of two neighbours in order, one is a descendant of the other and has no child towards it.
  if (place != none && nodes_[place].right == none) {
    nodes_[place].right = node;
    nodes_[node].parent = place;
  } else if (next != none) {
    nodes_[next].left = node;
    nodes_[node].parent = next;
  } else {
    root_ = node;
  }
  while (nodes_[node].parent != none && nodes_[nodes_[node].parent].priority < nodes_[node].priority) rise(node);
  return node;
}

void OrderedList::erase(std::uint32_t place) {
  while (nodes_[place].left != none && nodes_[place].right != none) {
    const std::uint32_t left = nodes_[place].left, right = nodes_[place].right;
    rise(nodes_[left].priority > nodes_[right].priority ? left : right);
  }
  const auto [parent, left, right, before, after, priority] = nodes_[place];
  hang(left != none ? left : right, parent, place);
  (before == none ? first_ : nodes_[before].after) = after;
  (after == none ? last_ : nodes_[after].before) = before;
  free_.push_back(place);
}

}  // namespace strata::planar
