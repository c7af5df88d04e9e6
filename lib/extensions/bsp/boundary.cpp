#include "extensions/bsp/boundary.h"

namespace strata::bsp {
namespace {

template <int D>
class BoundaryFinder {
 public:
  BoundaryFinder(const HyperplaneTable<D>& table, const Tree& tree) : table_(table), tree_(tree) {}

  std::vector<Facet<D>> find() {
    visit(tree_.root);
    return std::move(facets_);
  }

 private:
  void visit(Link link) {
    if (is_leaf(link)) return;
    for_each_facet<D>(table_, tree_, link, path_, [&](const Facet<D>& f) { facets_.push_back(f); });
    const Node& node = tree_.nodes[link];
    path_.push_back({node.hyperplane, Sign::negative});
    visit(node.minus);
    path_.back().side = Sign::positive;
    visit(node.plus);
    path_.pop_back();
  }

  const HyperplaneTable<D>& table_;
  const Tree& tree_;
  Path path_;
  std::vector<Facet<D>> facets_;
};

}  // namespace

template <int D>
void for_each_facet(const HyperplaneTable<D>& table, const Tree& tree, Link node, std::span<const HalfSpace> path,
                    const std::function<void(const Facet<D>& facet)>& visit) {
  const auto [hyperplane, minus, plus] = tree.nodes[node];
  const auto go_on = [&, plus = plus](Link below, const Piece<D>& part) {
    for_each_part<D>(table, tree, plus, part, [&](Link above, const Piece<D>& facet) {
      if (below != above) visit({facet, below == leaf_in});
    });
  };
  for_each_part<D>(table, tree, minus, part_within(table, hyperplane, path), go_on);
}

template <int D>
void for_each_part(const HyperplaneTable<D>& table, const Tree& tree, Link link, const Piece<D>& piece,
                   const std::function<void(Link leaf, const Piece<D>& part)>& visit) {
  if (is_leaf(link)) return visit(link, piece);
  const Node& node = tree.nodes[link];
  const Split<D> pieces = split(table, piece, node.hyperplane);
  switch (pieces.lie) {
    case Lie::minus:
      return for_each_part(table, tree, node.minus, piece, visit);
    case Lie::plus:
      return for_each_part(table, tree, node.plus, piece, visit);
    case Lie::both:
      for_each_part(table, tree, node.minus, pieces.minus, visit);
      return for_each_part(table, tree, node.plus, pieces.plus, visit);
    case Lie::on:
      return for_each_part<D>(table, tree, node.minus, piece, [&](Link leaf, const Piece<D>& part) {
        if (leaf == leaf_in) return visit(leaf, part);
        for_each_part(table, tree, node.plus, part, visit);
      });
  }
}

template <int D>
std::vector<Facet<D>> boundary(const HyperplaneTable<D>& table, const Tree& tree) {
  return BoundaryFinder<D>(table, tree).find();
}

template <int D>
bool reaches_infinity(const HyperplaneTable<D>& table, const Tree& tree) {
  bool found = false;
  for (std::size_t axis = 0; axis < D; ++axis)
    for (const bool is_upper : {false, true})
      for_each_part<D>(table, tree, tree.root, side_of_frame(table, axis, is_upper),
                       [&](Link leaf, const Piece<D>&) { found |= leaf == leaf_in; });
  return found;
}

#define STRATA_INSTANTIATE(D)                                                                            \
  template void for_each_part(const HyperplaneTable<D>&, const Tree&, Link, const Piece<D>&,             \
                              const std::function<void(Link, const Piece<D>&)>&);                        \
  template void for_each_facet(const HyperplaneTable<D>&, const Tree&, Link, std::span<const HalfSpace>, \
                               const std::function<void(const Facet<D>&)>&);                             \
  template std::vector<Facet<D>> boundary(const HyperplaneTable<D>&, const Tree&);                       \
  template bool reaches_infinity(const HyperplaneTable<D>&, const Tree&);
STRATA_INSTANTIATE(1)
STRATA_INSTANTIATE(2)
STRATA_INSTANTIATE(3)
#undef STRATA_INSTANTIATE

}  // namespace strata::bsp
