#include <stdexcept>
#include <utility>

#include "extensions/bsp/determinant.h"
#include "extensions/bsp/partition_data.h"

namespace strata::bsp {
namespace {

/// The rows x with x . matrix = unit vectors, by Cramer's rule with replaced rows.
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
  for (std::uint32_t h = 0; h < table_of(region).size(); ++h) {
    const auto& form = table_of(region)[h].exact();
    std::array<Rational, D + 1> image{};
    image[D] = form[D];
    for (std::size_t k = 0; k < D; ++k) {
      for (std::size_t i = 0; i < D; ++i) image[k] += form[i] * back[i][k];
      image[D] -= image[k] * map.shift[k];
    }
    OrientedHyperplane<D> oriented = oriented_hyperplane<D>(image);
    images.emplace_back(table.add(std::move(oriented.hyperplane)), oriented.is_reversed);
  }
  Tree tree = tree_of(region);
  for (Node& n : tree.nodes) {
    if (images[n.hyperplane].second) std::swap(n.minus, n.plus);
    n.hyperplane = images[n.hyperplane].first;
  }
  return partition_from(std::move(table), std::move(tree));
}

template Partition<1> transformed<1>(const Partition<1>&, const AffineMap<1>&);
template Partition<2> transformed<2>(const Partition<2>&, const AffineMap<2>&);
template Partition<3> transformed<3>(const Partition<3>&, const AffineMap<3>&);

}  // namespace strata::bsp
