#include "extensions/bsp/partition.h"

#include <stdexcept>
#include <utility>

#include "extensions/bsp/determinant.h"

namespace strata::bsp {
namespace {

/// The rows x with x . matrix = unit vectors: Cramer's rule, by replaced rows.
template <int D>
std::array<RationalVector<D>, D> inverse(const std::array<RationalVector<D>, D>& matrix) {
  const Rational whole = determinant(matrix);
  if (whole == 0) throw std::invalid_argument("the map is singular");
  std::array<RationalVector<D>, D> result{};
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t k = 0; k < D; ++k) {
      auto replaced = matrix;
      replaced[k] = {};
      replaced[k][i] = 1;
      result[i][k] = determinant(replaced) / whole;
    }
  return result;
}

}  // namespace

template <int D>
Partition<D> transformed(const Partition<D>& region, const AffineMap<D>& map) {
  const auto back = inverse<D>(map.matrix);
  HyperplaneTable<D> table;
  std::vector<std::pair<std::uint32_t, bool>> images;  // and whether sides are exchanged
  for (std::uint32_t h = 0; h < region.table().size(); ++h) {
    const auto& form = region.table()[h].exact();
    std::array<Rational, D + 1> image{};
    image[D] = form[D];
    for (std::size_t k = 0; k < D; ++k) {
      for (std::size_t i = 0; i < D; ++i) image[k] += form[i] * back[i][k];
      image[D] -= image[k] * map.shift[k];
    }
    OrientedHyperplane<D> oriented = oriented_hyperplane<D>(image);
    images.emplace_back(table.add(std::move(oriented.hyperplane)), oriented.is_turned);
  }
  Tree tree = region.tree();
  for (Node& n : tree.nodes) {
    if (images[n.hyperplane].second) std::swap(n.minus, n.plus);
    n.hyperplane = images[n.hyperplane].first;
  }
  return Partition<D>::of(std::move(table), std::move(tree));
}

template <int D>
void for_each_front_to_back(const Partition<D>& region, const RationalVector<D>& from,
                            const std::function<void(Link node)>& visit) {
  const std::vector<Node>& nodes = region.tree().nodes;
  struct Step {
    Link link;
    bool is_ready;  // its front has been shown
  };
  std::vector<Step> open{{region.tree().root, false}};
  while (!open.empty()) {
    const Step step = open.back();
    open.pop_back();
    if (is_leaf(step.link)) continue;
    if (step.is_ready) {
      visit(step.link);
      continue;
    }
    const Node& node = nodes[step.link];
    const bool is_plus = region.table().side(node.hyperplane, from) == Sign::positive;
    open.push_back({is_plus ? node.minus : node.plus, false});
    open.push_back({step.link, true});
    open.push_back({is_plus ? node.plus : node.minus, false});
  }
}

#define STRATA_INSTANTIATE(D)                                                            \
  template Partition<D> transformed<D>(const Partition<D>&, const AffineMap<D>&);        \
  template void for_each_front_to_back<D>(const Partition<D>&, const RationalVector<D>&, \
                                          const std::function<void(Link)>&);
STRATA_INSTANTIATE(1)
STRATA_INSTANTIATE(2)
STRATA_INSTANTIATE(3)
#undef STRATA_INSTANTIATE

}  // namespace strata::bsp
