#include <algorithm>
#include <stdexcept>
#include <utility>

#include "extensions/bsp/partition_data.h"

namespace strata::bsp {
namespace {

/// The half-spaces above every node, from the parents of nodes.
template <int D>
class Paths {
 public:
  explicit Paths(const Tree& tree) : nodes_(tree.nodes), parents_(tree.nodes.size(), leaf_out) {
    for (Link n = 0; n < nodes_.size(); ++n)
      for (const Link child : {nodes_[n].minus, nodes_[n].plus})
        if (!is_leaf(child)) parents_[child] = n;
  }

  [[nodiscard]] Path to(Link node) const {
    Path path;
    for (Link above = parents_[node]; !is_leaf(above); node = above, above = parents_[node])
      path.push_back({nodes_[above].hyperplane, nodes_[above].minus == node ? Sign::negative : Sign::positive});
    std::reverse(path.begin(), path.end());
    return path;
  }

 private:
  const std::vector<Node>& nodes_;
  std::vector<Link> parents_;  ///< of the root: a leaf
};

}  // namespace

template <int D>
AffineForm<D> form_of(const Hyperplane<D>& hyperplane, bool looks_to_plus) {
  AffineForm<D> form{};
  for (std::size_t i = 0; i <= D; ++i)
    form[i] = looks_to_plus ? Rational(hyperplane.exact()[i]) : Rational(-hyperplane.exact()[i]);
  return form;
}

template <int D>
BoundaryFacet<D> boundary_facet(const HyperplaneTable<D>& table, const Facet<D>& facet) {
  if (!facet.piece.is_bounded()) throw std::domain_error("the boundary of the region is not bounded");
  BoundaryFacet<D> result{form_of(table[facet.piece.hyperplane], facet.faces_plus), {}};
  for (const HyperplaneMeet<D>& c : facet.piece.corners) result.corners.push_back(table.position(c));
  const bool is_reversed = D == 3 ? !facet.faces_plus : facet.faces_plus;  // `Piece` has the order of corners
  if (is_reversed) std::reverse(result.corners.begin(), result.corners.end());
  return result;
}

template <int D>
std::vector<BoundaryFacet<D>> boundary_facets(const Partition<D>& region) {
  std::vector<BoundaryFacet<D>> facets;
  for (const Facet<D>& f : facets_of(region)) facets.push_back(boundary_facet(table_of(region), f));
  return facets;
}

template <int D>
void for_each_node_front_to_back(const Partition<D>& region, const RationalVector<D>& from,
                                 const std::function<void(Link node)>& visit) {
  const std::vector<Node>& nodes = tree_of(region).nodes;
  struct Step {
    Link link;
    bool is_ready;  // its front has been visited
  };
  std::vector<Step> open{{tree_of(region).root, false}};
  while (!open.empty()) {
    const Step step = open.back();
    open.pop_back();
    if (is_leaf(step.link)) continue;
    if (step.is_ready) {
      visit(step.link);
      continue;
    }
    const Node& node = nodes[step.link];
    const bool is_plus = table_of(region).side(node.hyperplane, from) == Sign::positive;
    open.push_back({is_plus ? node.minus : node.plus, false});
    open.push_back({step.link, true});
    open.push_back({is_plus ? node.plus : node.minus, false});
  }
}

template <int D>
void for_each_front_to_back(const Partition<D>& region, const RationalVector<D>& from,
                            FunctionRef<void(const BoundaryFacet<D>& facet)> visit) {
  const Tree& tree = tree_of(region);
  const Paths<D> paths(tree);
  for_each_node_front_to_back<D>(region, from, [&](Link node) {
    for_each_facet<D>(table_of(region), tree, node, paths.to(node),
                      [&](const Facet<D>& f) { visit(boundary_facet(table_of(region), f)); });
  });
}

#define STRATA_INSTANTIATE(D)                                                                 \
  template AffineForm<D> form_of<D>(const Hyperplane<D>&, bool);                              \
  template BoundaryFacet<D> boundary_facet<D>(const HyperplaneTable<D>&, const Facet<D>&);    \
  template std::vector<BoundaryFacet<D>> boundary_facets<D>(const Partition<D>&);             \
  template void for_each_node_front_to_back<D>(const Partition<D>&, const RationalVector<D>&, \
                                               const std::function<void(Link)>&);             \
  template void for_each_front_to_back<D>(const Partition<D>&, const RationalVector<D>&,      \
                                          FunctionRef<void(const BoundaryFacet<D>&)>);
STRATA_INSTANTIATE(1)
STRATA_INSTANTIATE(2)
STRATA_INSTANTIATE(3)
#undef STRATA_INSTANTIATE

}  // namespace strata::bsp
