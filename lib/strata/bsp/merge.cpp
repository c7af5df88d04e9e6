#include "strata/bsp/merge.h"

#include <memory>
#include <utility>

#include "strata/mesh/defect.h"

namespace strata::bsp {
namespace {

/// What a leaf of one tree makes of the other tree.
enum class Effect { stays, turns, becomes_in, becomes_out };

/// `is_first`: the leaf belongs to the first operand.
Effect effect_of(Operation operation, Link leaf, bool is_first) {
  const bool inside = leaf == leaf_in;
  switch (operation) {
    case Operation::unite:
      return inside ? Effect::becomes_in : Effect::stays;
    case Operation::intersect:
      return inside ? Effect::stays : Effect::becomes_out;
    case Operation::subtract:
      if (is_first) return inside ? Effect::turns : Effect::becomes_out;
      return inside ? Effect::becomes_out : Effect::stays;
    case Operation::exclude:
      return inside ? Effect::turns : Effect::stays;
  }
  return Effect::stays;
}

template <int D>
class Merger {
 public:
  Merger(const HyperplaneTable<D>& table, std::vector<Node>& nodes, Operation operation, const Monitor& monitor)
      : table_(table), nodes_(nodes), operation_(operation), monitor_(monitor) {}

  Link merge(Link a, Link b) {
    parts_.resize(nodes_.size());
    find_parts(b);
    return merge_here(a, b);
  }

 private:
  using Halves = std::pair<Link, Link>;  ///< on the minus side, on the plus side
  using Part = std::shared_ptr<const Piece<D>>;

  /// What lies of each node's hyperplane in the node's part of space.
  void find_parts(Link link) {
    if (is_leaf(link)) return;
    const Node node = nodes_[link];
    parts_[link] = std::make_shared<const Piece<D>>(part_within(table_, node.hyperplane, path_));
    path_.push_back({node.hyperplane, Sign::negative});
    find_parts(node.minus);
    path_.back().side = Sign::positive;
    find_parts(node.plus);
    path_.pop_back();
  }

  /// Of two trees that divide the part of space at the end of the path. The parts of the second one's nodes are known.
  Link merge_here(Link a, Link b) {
    if (is_leaf(a)) return changed(b, effect_of(operation_, a, true));
    if (is_leaf(b)) return changed(a, effect_of(operation_, b, false));
    monitor_.check();
    const Node cut = nodes_[a];
    const auto [minus, plus] = parted(b, part_within(table_, cut.hyperplane, path_));
    path_.push_back({cut.hyperplane, Sign::negative});
    const Link below = merge_here(cut.minus, minus);
    path_.back().side = Sign::positive;
    const Link above = merge_here(cut.plus, plus);
    path_.pop_back();
    return divided(nodes_, cut.hyperplane, below, above);
  }

  Link changed(Link tree, Effect effect) {
    switch (effect) {
      case Effect::stays:
        return tree;
      case Effect::turns:
        return complemented(nodes_, tree);
      case Effect::becomes_in:
        return leaf_in;
      case Effect::becomes_out:
        return leaf_out;
    }
    return tree;
  }

  /// The second tree, or what is left of it here, parted by a hyperplane of which `cut` is what lies in this part of
  /// space.
  Halves parted(Link tree, const Piece<D>& cut) {
    if (is_leaf(tree)) return {tree, tree};
    const Node node = nodes_[tree];
    if (node.hyperplane == cut.hyperplane) return {node.minus, node.plus};
    const Part part = parts_[tree];
    const Split<D> pieces = split(table_, cut, node.hyperplane);
    switch (pieces.lie) {
      case Lie::both: {
        const Halves below = parted(node.minus, pieces.minus), above = parted(node.plus, pieces.plus);
        Split<D> halves = split(table_, *part, cut.hyperplane);  // they cross, so it has two
        return {kept(node, below.first, above.first, std::make_shared<const Piece<D>>(std::move(halves.minus))),
                kept(node, below.second, above.second, std::make_shared<const Piece<D>>(std::move(halves.plus)))};
      }
      case Lie::minus: {
        const Halves halves = parted(node.minus, cut);
        if (lie_of(table_, *part, cut.hyperplane) == Lie::plus)
          return {halves.first, kept(node, halves.second, node.plus, part)};
        return {kept(node, halves.first, node.plus, part), halves.second};
      }
      case Lie::plus: {
        const Halves halves = parted(node.plus, cut);
        if (lie_of(table_, *part, cut.hyperplane) == Lie::plus)
          return {halves.first, kept(node, node.minus, halves.second, part)};
        return {kept(node, node.minus, halves.first, part), halves.second};
      }
      case Lie::on:
        break;
    }
    throw LogicError("equal hyperplanes have different numbers");
  }

  /// A node with other children, and its part.
  Link kept(const Node& node, Link minus, Link plus, Part part) {
    const Link link = divided(nodes_, node.hyperplane, minus, plus);
    if (is_leaf(link)) return link;
    parts_.resize(nodes_.size());
    parts_[link] = std::move(part);
    return link;
  }

  const HyperplaneTable<D>& table_;
  std::vector<Node>& nodes_;
  const Operation operation_;
  const Monitor& monitor_;
  Path path_;
  std::vector<Part> parts_;  ///< by node, of what the second tree is at any time
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
