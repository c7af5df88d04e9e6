#include "extensions/bsp/partition.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "extensions/bsp/merge.h"

namespace strata::bsp {

template <int D>
struct Partition<D>::Data {
  HyperplaneTable<D> table;
  Tree tree;
};

namespace {

/// A tree and the hyperplanes in it, without nodes and hyperplanes that are not used any more.
template <int D>
class Compaction {
 public:
  Compaction(const HyperplaneTable<D>& table, const std::vector<Node>& nodes) : from_(table), nodes_(nodes) {}

  Partition<D> of(Link root, std::size_t splits = 0) {
    tree_.root = copied(root);
    tree_.splits = splits;
    return Partition<D>::of(std::move(table_), std::move(tree_));
  }

 private:
  Link copied(Link link) {
    if (is_leaf(link)) return link;
    const Node& node = nodes_[link];
    const auto at = static_cast<Link>(tree_.nodes.size());
    tree_.nodes.push_back({table_.adopt(from_, node.hyperplane), leaf_out, leaf_out});
    const Link minus = copied(node.minus);
    const Link plus = copied(node.plus);
    tree_.nodes[at].minus = minus;
    tree_.nodes[at].plus = plus;
    return at;
  }

  const HyperplaneTable<D>& from_;
  const std::vector<Node>& nodes_;
  HyperplaneTable<D> table_;
  Tree tree_;
};

template <int D, class Place>
Where classify_in(const HyperplaneTable<D>& table, const std::vector<Node>& nodes, Link link, const Place& p) {
  while (!is_leaf(link)) {
    const Node& node = nodes[link];
    const Sign side = table.side(node.hyperplane, p);
    if (side == Sign::zero) {
      const Where below = classify_in(table, nodes, node.minus, p);
      if (below == Where::on) return below;
      return classify_in(table, nodes, node.plus, p) == below ? below : Where::on;
    }
    link = side == Sign::negative ? node.minus : node.plus;
  }
  return link == leaf_in ? Where::in : Where::out;
}

}  // namespace

template <int D>
Partition<D>::Partition() : Partition(std::make_shared<const Data>()) {}

template <int D>
Partition<D> Partition<D>::of(HyperplaneTable<D> table, Tree tree) {
  return Partition(std::make_shared<const Data>(Data{std::move(table), std::move(tree)}));
}

template <int D>
Partition<D> Partition<D>::all() {
  return of({}, {{}, leaf_in, 0});
}

template <int D>
Partition<D> Partition<D>::half_space(const std::array<Rational, D + 1>& coefficients) {
  if (std::all_of(coefficients.begin(), coefficients.end() - 1, [](const Rational& x) { return x.is_zero(); }))
    throw std::invalid_argument("a half-space has a normal that is not zero");
  return half_space(oriented_hyperplane<D>(coefficients));
}

template <int D>
Partition<D> Partition<D>::half_space(const OrientedHyperplane<D>& hyperplane) {
  HyperplaneTable<D> table;
  const std::uint32_t h = table.add(hyperplane.hyperplane);
  return of(std::move(table), {{{h, leaf(!hyperplane.is_turned), leaf(hyperplane.is_turned)}}, 0, 0});
}

template <int D>
Partition<D> Partition<D>::convex(std::span<const OrientedHyperplane<D>> hyperplanes) {
  if (hyperplanes.empty()) return all();
  if (hyperplanes.size() == 1) return half_space(hyperplanes[0]);
  const std::size_t half = hyperplanes.size() / 2;
  return rebuilt_if_deep(convex(hyperplanes.first(half)) & convex(hyperplanes.subspan(half)));
}

template <int D>
const HyperplaneTable<D>& Partition<D>::table() const {
  return data_->table;
}

template <int D>
const Tree& Partition<D>::tree() const {
  return data_->tree;
}

template <int D>
bool Partition<D>::is_bounded() const {
  return !reaches_infinity(table(), tree());
}

template <int D>
bool Partition<D>::contains(const Partition& other) const {
  return (other - *this).is_empty();
}

template <int D>
Where Partition<D>::classify(const std::array<double, D>& p) const {
  return classify_in(table(), tree().nodes, tree().root, p);
}

template <int D>
Where Partition<D>::classify_exact(const RationalVector<D>& p) const {
  return classify_in(table(), tree().nodes, tree().root, p);
}

template <int D>
std::vector<Facet<D>> Partition<D>::boundary() const {
  return bsp::boundary(table(), tree());
}

template <int D>
std::vector<Piece<D>> Partition<D>::part_inside(const Piece<D>& piece) const {
  std::vector<Piece<D>> parts;
  for_each_part<D>(table(), tree(), tree().root, piece, [&](Link leaf, const Piece<D>& part) {
    if (leaf == leaf_in) parts.push_back(part);
  });
  return parts;
}

template <int D>
Partition<D> combined(Operation operation, const Partition<D>& a, const Partition<D>& b, const Monitor& monitor) {
  HyperplaneTable<D> table = a.table();
  std::vector<Node> nodes = a.tree().nodes;
  const auto first = static_cast<Link>(nodes.size());
  const auto moved = [&](Link link) { return is_leaf(link) ? link : link + first; };
  std::vector<std::uint32_t> number;
  for (std::uint32_t h = 0; h < b.table().size(); ++h) number.push_back(table.adopt(b.table(), h));
  for (const Node& n : b.tree().nodes) nodes.push_back({number[n.hyperplane], moved(n.minus), moved(n.plus)});
  const Link root = merged(table, nodes, operation, a.tree().root, moved(b.tree().root), monitor);
  return Compaction<D>(table, nodes).of(root);
}

template <int D>
Partition<D> complement(const Partition<D>& region) {
  Tree tree = region.tree();
  const auto turned = [](Link link) { return is_leaf(link) ? other(link) : link; };
  for (Node& n : tree.nodes) n = {n.hyperplane, turned(n.minus), turned(n.plus)};
  tree.root = turned(tree.root);
  return Partition<D>::of(region.table(), std::move(tree));
}

template <int D>
Partition<D> compact(const Partition<D>& region) {
  return Compaction<D>(region.table(), region.tree().nodes).of(region.tree().root, region.tree().splits);
}

template <int D>
Partition<D> rebuilt(const Partition<D>& region) {
  if (is_leaf(region.tree().root)) return region;
  HyperplaneTable<D> table = region.table();
  const Tree tree = built(table, region.boundary());
  return Compaction<D>(table, tree.nodes).of(tree.root, tree.splits);
}

template <int D>
Partition<D> rebuilt_if_deep(const Partition<D>& region) {
  const TreeSize size = size_of_tree(region);
  const double usual = 30 + 6 * std::log2(static_cast<double>(size.leaves));
  return static_cast<double>(size.depth) > usual ? rebuilt(region) : region;
}

template <int D>
TreeSize size_of_tree(const Partition<D>& region) {
  const Tree& tree = region.tree();
  TreeSize size{tree.nodes.size(), tree.nodes.size() + 1, 0, 0, region.table().size(), 0, 0};
  size.bytes = tree.nodes.size() * sizeof(Node) + region.table().bytes();
  std::vector<std::pair<Link, std::size_t>> open{{tree.root, 0}};
  double sum = 0;
  while (!open.empty()) {
    const auto [link, depth] = open.back();
    open.pop_back();
    if (is_leaf(link)) {
      size.inside += link == leaf_in ? 1 : 0;
      size.depth = std::max(size.depth, depth);
      sum += static_cast<double>(depth);
      continue;
    }
    open.emplace_back(tree.nodes[link].minus, depth + 1);
    open.emplace_back(tree.nodes[link].plus, depth + 1);
  }
  size.mean_depth = sum / static_cast<double>(size.leaves);
  return size;
}

template class Partition<1>;
template class Partition<2>;
template class Partition<3>;
#define STRATA_INSTANTIATE(D)                                                                          \
  template Partition<D> combined(Operation, const Partition<D>&, const Partition<D>&, const Monitor&); \
  template Partition<D> complement(const Partition<D>&);                                               \
  template Partition<D> compact(const Partition<D>&);                                                  \
  template Partition<D> rebuilt(const Partition<D>&);                                                  \
  template Partition<D> rebuilt_if_deep(const Partition<D>&);                                          \
  template TreeSize size_of_tree(const Partition<D>&);
STRATA_INSTANTIATE(1)
STRATA_INSTANTIATE(2)
STRATA_INSTANTIATE(3)
#undef STRATA_INSTANTIATE

}  // namespace strata::bsp
