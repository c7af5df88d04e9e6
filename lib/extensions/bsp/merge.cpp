#include "extensions/bsp/merge.h"

#include <memory>
#include <utility>

#include "strata/errors.h"

namespace strata::bsp {
namespace {

/// The effect of a leaf of one tree on the other tree.
enum class Effect { stays, orientations, becomes_in, becomes_out };

/// `is_first`: the leaf belongs to the first operand.
Effect effect_of(Operation operation, Link leaf, bool is_first) {
  const bool inside = leaf == leaf_in;
  switch (operation) {
    case Operation::union_:
      return inside ? Effect::becomes_in : Effect::stays;
    case Operation::intersection:
      return inside ? Effect::stays : Effect::becomes_out;
    case Operation::difference:
      if (is_first) return inside ? Effect::orientations : Effect::becomes_out;
      return inside ? Effect::becomes_out : Effect::stays;
    case Operation::symmetric_difference:
      return inside ? Effect::orientations : Effect::stays;
  }
  return Effect::stays;
}

template <int D>
class Merger {
 public:
  Merger(const HyperplaneTable<D>& table, std::vector<Node>& nodes, Operation operation, const Monitor& monitor)
      : table_(table),
        nodes_(nodes),
        operation_(operation),
        monitor_(monitor),
        first_new_(static_cast<Link>(nodes.size())) {}

  /// Merges two trees that divide the part of space at the end of the path.
  Link merge(Link a, Link b) {
    if (is_leaf(a)) return changed(b, effect_of(operation_, a, true));
    if (is_leaf(b)) return changed(a, effect_of(operation_, b, false));
    monitor_.check();
    const Node cut = nodes_[a];
    const Piece<D> part = part_within(table_, cut.hyperplane, path_);
    const auto [minus, plus] = parted(b, part);
    const Link below = on_side(cut, Sign::negative, [&, other = minus] { return merge(cut.minus, other); });
    const Link above = on_side(cut, Sign::positive, [&, other = plus] { return merge(cut.plus, other); });
    return joined(cut.hyperplane, part, below, above);
  }

 private:
  using Halves = std::pair<Link, Link>;  ///< on the minus side, on the plus side
  using Part = std::shared_ptr<const Piece<D>>;

  /// Evaluates `find` with the path extended to that side.
  template <class Find>
  auto on_side(const Node& node, Sign side, const Find& find) {
    path_.push_back({node.hyperplane, side});
    const auto found = find();
    path_.pop_back();
    return found;
  }

  /// A node, unless its cut is redundant: one side is a leaf, and the cut's part reaches only equal leaves on the other
  /// side. Then the other side's tree is right on both (theory.md, "Merging").
  Link joined(std::uint32_t hyperplane, const Piece<D>& part, Link minus, Link plus) {
    if (is_leaf(minus) && is_all(plus, part, minus)) return plus;
    if (is_leaf(plus) && is_all(minus, part, plus)) return minus;
    return divided(nodes_, hyperplane, minus, plus);
  }

  /// True if a piece reaches only leaves of one kind in a tree.
  bool is_all(Link tree, const Piece<D>& piece, Link leaf) const {
    if (is_leaf(tree)) return tree == leaf;
    const Node& node = nodes_[tree];
    const Split<D> pieces = split(table_, piece, node.hyperplane);
    if (pieces.lie == Lie::both) return is_all(node.minus, pieces.minus, leaf) && is_all(node.plus, pieces.plus, leaf);
    return is_all(pieces.lie == Lie::minus ? node.minus : node.plus, piece, leaf);
  }

  /// The tree without cuts that have become redundant.
  Link reduced(Link tree) {
    if (is_leaf(tree) || tree < first_new_) return tree;
    monitor_.check();
    const Node node = nodes_[tree];
    const Link minus = reduced(node.minus), plus = reduced(node.plus);
    return joined(node.hyperplane, *parts_[tree], minus, plus);
  }

  Link changed(Link tree, Effect effect) {
    switch (effect) {
      case Effect::stays:
        return reduced(tree);
      case Effect::orientations:
        return complemented(nodes_, reduced(tree));
      case Effect::becomes_in:
        return leaf_in;
      case Effect::becomes_out:
        return leaf_out;
    }
    return tree;
  }

  /// The part of a node's hyperplane in the node's part of space, which is the end of the path.
  const Part& part_of(Link link) {
    if (parts_.size() < nodes_.size()) parts_.resize(nodes_.size());
    Part& part = parts_[link];
    if (!part) part = std::make_shared<const Piece<D>>(part_within(table_, nodes_[link].hyperplane, path_));
    return part;
  }

  /// A subtree of the second tree, which divides the part of space at the end of the path, partitioned by a hyperplane
  /// whose part there is `cut`.
  Halves parted(Link tree, const Piece<D>& cut) {
    if (is_leaf(tree)) return {tree, tree};
    const Node node = nodes_[tree];
    if (node.hyperplane == cut.hyperplane) return {node.minus, node.plus};
    const Part part = part_of(tree);
    const auto below = [&](const Piece<D>& piece) {
      return on_side(node, Sign::negative, [&] { return parted(node.minus, piece); });
    };
    const auto above = [&](const Piece<D>& piece) {
      return on_side(node, Sign::positive, [&] { return parted(node.plus, piece); });
    };
    const Split<D> pieces = split(table_, cut, node.hyperplane);
    switch (pieces.lie) {
      case Lie::both: {
        const Halves minus = below(pieces.minus), plus = above(pieces.plus);
        Split<D> halves = split(table_, *part, cut.hyperplane);  // they cross, so there are two
        return {kept(node, minus.first, plus.first, std::make_shared<const Piece<D>>(std::move(halves.minus))),
                kept(node, minus.second, plus.second, std::make_shared<const Piece<D>>(std::move(halves.plus)))};
      }
      case Lie::minus: {
        const Halves halves = below(cut);
        if (lie_of(table_, *part, cut.hyperplane) == Lie::plus)
          return {halves.first, kept(node, halves.second, node.plus, part)};
        return {kept(node, halves.first, node.plus, part), halves.second};
      }
      case Lie::plus: {
        const Halves halves = above(cut);
        if (lie_of(table_, *part, cut.hyperplane) == Lie::plus)
          return {halves.first, kept(node, node.minus, halves.second, part)};
        return {kept(node, node.minus, halves.first, part), halves.second};
      }
      case Lie::on:
        break;
    }
    throw LogicError("equal hyperplanes have different numbers");
  }

  /// A copy of a node with other children, and its part.
  Link kept(const Node& node, Link minus, Link plus, Part part) {
    const Link link = divided(nodes_, node.hyperplane, minus, plus);
    if (is_leaf(link)) return link;
    if (parts_.size() < nodes_.size()) parts_.resize(nodes_.size());
    parts_[link] = std::move(part);
    return link;
  }

  const HyperplaneTable<D>& table_;
  std::vector<Node>& nodes_;
  const Operation operation_;
  const Monitor& monitor_;
  const Link first_new_;
  Path path_;
  std::vector<Part> parts_;  ///< by node of the current second tree; computed when they are needed
};

}  // namespace

template <int D>
Link merged(const HyperplaneTable<D>& table, std::vector<Node>& nodes, Operation operation, Link a, Link b,
            const Monitor& monitor) {
  return Merger<D>(table, nodes, operation, monitor).merge(a, b);
}

Link complemented(std::vector<Node>& nodes, Link tree) {
  if (is_leaf(tree)) return other(tree);
  const Node node = nodes[tree];
  const Link minus = complemented(nodes, node.minus), plus = complemented(nodes, node.plus);
  nodes.push_back({node.hyperplane, minus, plus});
  return static_cast<Link>(nodes.size() - 1);
}

template Link merged(const HyperplaneTable<1>&, std::vector<Node>&, Operation, Link, Link, const Monitor&);
template Link merged(const HyperplaneTable<2>&, std::vector<Node>&, Operation, Link, Link, const Monitor&);
template Link merged(const HyperplaneTable<3>&, std::vector<Node>&, Operation, Link, Link, const Monitor&);

}  // namespace strata::bsp
