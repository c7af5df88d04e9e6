#include "extensions/bsp/prune.h"

#include <algorithm>

#include "strata/errors.h"

namespace strata::bsp {
namespace {

template <int D>
class Pruner {
 public:
  Pruner(const HyperplaneTable<D>& table, const std::vector<Node>& nodes) : table_(table), nodes_(nodes) {}

  Tree prune(Link root) {
    const Link link = pruned(root);
    return {std::move(kept_), link, 0};
  }

 private:
  Link pruned(Link link) {
    if (is_leaf(link)) return link;
    const Node& node = nodes_[link];
    if (!meets_inside(node.hyperplane, path_.size()))
      return pruned(side_of_part(node.hyperplane) == Sign::negative ? node.minus : node.plus);
    path_.push_back({node.hyperplane, Sign::negative});
    const Link minus = pruned(node.minus);
    path_.back().side = Sign::positive;
    const Link plus = pruned(node.plus);
    path_.pop_back();
    return divided(kept_, node.hyperplane, minus, plus);
  }

  /// True when a hyperplane has a part of its own dimension in all half-spaces of the path, except the one left out.
  bool meets_inside(std::uint32_t hyperplane, std::size_t left_out) {
    piece_ = whole(table_, hyperplane);
    for (std::size_t i = path_.size(); i-- > 0;)
      if (i != left_out && !clip(table_, piece_, path_[i])) return false;
    return true;
  }

  /// The side of a hyperplane on which a part of space lies that it does not divide, decided at one of the part's
  /// facets.
  Sign side_of_part(std::uint32_t hyperplane) {
    for (std::size_t i = 0; i < path_.size(); ++i) {
      if (path_[i].hyperplane == hyperplane) return path_[i].side;
      if (!meets_inside(path_[i].hyperplane, i)) continue;
      return lie_of(table_, piece_, hyperplane) == Lie::minus ? Sign::negative : Sign::positive;
    }
    throw LogicError("a part of space has no facet");
  }

  const HyperplaneTable<D>& table_;
  const std::vector<Node>& nodes_;
  std::vector<Node> kept_;
  Path path_;
  Piece<D> piece_;
};

}  // namespace

template <int D>
Partition<D> pruned(const HyperplaneTable<D>& table, const Tree& tree) {
  return compact(partition_from(table, Pruner<D>(table, tree.nodes).prune(tree.root)));
}

template Partition<1> pruned(const HyperplaneTable<1>&, const Tree&);
template Partition<2> pruned(const HyperplaneTable<2>&, const Tree&);
template Partition<3> pruned(const HyperplaneTable<3>&, const Tree&);

}  // namespace strata::bsp
