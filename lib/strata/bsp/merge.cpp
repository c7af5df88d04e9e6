#include "strata/bsp/merge.h"

#include <array>
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

  /// Of two trees that divide the part of space at the end of the path.
  Link merge(Link a, Link b) {
    if (is_leaf(a)) return changed(b, effect_of(operation_, a, true));
    if (is_leaf(b)) return changed(a, effect_of(operation_, b, false));
    monitor_.check();
    const Node cut = nodes_[a];
    const auto [minus, plus] = parted(b, part_within(table_, cut.hyperplane, path_));
    path_.push_back({cut.hyperplane, Sign::negative});
    const Link below = merge(cut.minus, minus);
    path_.back().side = Sign::positive;
    const Link above = merge(cut.plus, plus);
    path_.pop_back();
    return divided(nodes_, cut.hyperplane, below, above);
  }

 private:
  using Halves = std::pair<Link, Link>;  ///< on the minus side, on the plus side

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

  /// A tree of the part of space at the end of the path, parted by a hyperplane of which `cut` is what lies in there.
  Halves parted(Link tree, const Piece<D>& cut) {
    if (is_leaf(tree)) return {tree, tree};
    const Node node = nodes_[tree];
    if (node.hyperplane == cut.hyperplane) return {node.minus, node.plus};
    const Split<D> pieces = split(table_, cut, node.hyperplane);
    switch (pieces.lie) {
      case Lie::both: {
        const Halves below = parted(node, Sign::negative, pieces.minus);
        const Halves above = parted(node, Sign::positive, pieces.plus);
        return {divided(nodes_, node.hyperplane, below.first, above.first),
                divided(nodes_, node.hyperplane, below.second, above.second)};
      }
      case Lie::minus: {
        const Halves halves = parted(node, Sign::negative, cut);
        if (side_of_root(node, cut.hyperplane) == Lie::plus)
          return {halves.first, divided(nodes_, node.hyperplane, halves.second, node.plus)};
        return {divided(nodes_, node.hyperplane, halves.first, node.plus), halves.second};
      }
      case Lie::plus: {
        const Halves halves = parted(node, Sign::positive, cut);
        if (side_of_root(node, cut.hyperplane) == Lie::plus)
          return {halves.first, divided(nodes_, node.hyperplane, node.minus, halves.second)};
        return {divided(nodes_, node.hyperplane, node.minus, halves.first), halves.second};
      }
      case Lie::on:
        break;
    }
    throw LogicError("equal hyperplanes have different numbers");
  }

  /// The child on one side.
  Halves parted(const Node& node, Sign side, const Piece<D>& cut) {
    path_.push_back({node.hyperplane, side});
    const Halves halves = parted(side == Sign::negative ? node.minus : node.plus, cut);
    path_.pop_back();
    return halves;
  }

  /// On which side of a hyperplane the root's own part lies, which it does not cross.
  Lie side_of_root(const Node& node, std::uint32_t hyperplane) {
    return lie_of(table_, part_within(table_, node.hyperplane, path_), hyperplane);
  }

  const HyperplaneTable<D>& table_;
  std::vector<Node>& nodes_;
  const Operation operation_;
  const Monitor& monitor_;
  Path path_;
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
