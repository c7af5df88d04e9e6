#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "extensions/bsp/merge.h"
#include "extensions/bsp/partition_data.h"

namespace strata::bsp {

namespace {

/// Copies a tree and its hyperplanes, without nodes and hyperplanes that are not used any more.
template <int D>
class Compaction {
 public:
  Compaction(const HyperplaneTable<D>& table, const std::vector<Node>& nodes) : from_(table), nodes_(nodes) {}

  Partition<D> of(Link root, std::size_t splits = 0) {
    tree_.root = copied(root);
    tree_.splits = splits;
    return partition_from(std::move(table_), std::move(tree_));
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

template <int D>
OrientedHyperplane<D> oriented(const AffineForm<D>& f) {
  if (std::all_of(f.begin(), f.end() - 1, [](const Rational& x) { return x.is_zero(); }))
    throw std::invalid_argument("a half-space has a normal that is not zero");
  return oriented_hyperplane<D>(f);
}

}  // namespace

template <int D>
Partition<D>::Partition() : Partition(Shared<Data>::make()) {}

template <int D>
Partition<D> Partition<D>::all() {
  return partition_from(HyperplaneTable<D>(), {{}, leaf_in, 0});
}

template <int D>
Partition<D> Partition<D>::half_space(const AffineForm<D>& f) {
  return behind(oriented<D>(f));
}

template <int D>
Partition<D> Partition<D>::convex(std::span<const AffineForm<D>> forms) {
  std::vector<OrientedHyperplane<D>> hyperplanes;
  for (const AffineForm<D>& f : forms) hyperplanes.push_back(oriented<D>(f));
  return behind_all<D>(hyperplanes);
}

template <int D>
Partition<D> behind(const OrientedHyperplane<D>& hyperplane) {
  HyperplaneTable<D> table;
  const std::uint32_t h = table.add(hyperplane.hyperplane);
  return partition_from(std::move(table), {{{h, leaf(!hyperplane.is_reversed), leaf(hyperplane.is_reversed)}}, 0, 0});
}

template <int D>
Partition<D> behind_all(std::span<const OrientedHyperplane<D>> hyperplanes) {
  if (hyperplanes.empty()) return Partition<D>::all();
  if (hyperplanes.size() == 1) return behind(hyperplanes[0]);
  const std::size_t half = hyperplanes.size() / 2;
  return rebuilt_if_deep(behind_all(hyperplanes.first(half)) & behind_all(hyperplanes.subspan(half)));
}

template <int D>
bool Partition<D>::is_empty() const {
  return data_->tree.root == leaf_out;
}

template <int D>
bool Partition<D>::is_full() const {
  return data_->tree.root == leaf_in;
}

template <int D>
bool Partition<D>::is_bounded() const {
  return !reaches_infinity(data_->table, data_->tree);
}

template <int D>
bool Partition<D>::contains(const Partition& other) const {
  return (other - *this).is_empty();
}

template <int D>
Where Partition<D>::classify(const std::array<double, D>& p) const {
  return classify_in(data_->table, data_->tree.nodes, data_->tree.root, p);
}

template <int D>
Where Partition<D>::classify_exact(const RationalVector<D>& p) const {
  return classify_in(data_->table, data_->tree.nodes, data_->tree.root, p);
}

template <int D>
std::vector<Piece<D>> part_inside(const Partition<D>& region, const Piece<D>& piece) {
  std::vector<Piece<D>> parts;
  for_each_part<D>(table_of(region), tree_of(region), tree_of(region).root, piece,
                   [&](Link leaf, const Piece<D>& part) {
                     if (leaf == leaf_in) parts.push_back(part);
                   });
  return parts;
}

template <int D>
Partition<D> combined(Operation operation, const Partition<D>& a, const Partition<D>& b, const Monitor& monitor) {
  HyperplaneTable<D> table = table_of(a);
  std::vector<Node> nodes = tree_of(a).nodes;
  const auto first = static_cast<Link>(nodes.size());
  const auto moved = [&](Link link) { return is_leaf(link) ? link : link + first; };
  std::vector<std::uint32_t> number;
  for (std::uint32_t h = 0; h < table_of(b).size(); ++h) number.push_back(table.adopt(table_of(b), h));
  for (const Node& n : tree_of(b).nodes) nodes.push_back({number[n.hyperplane], moved(n.minus), moved(n.plus)});
  const Link root = merged(table, nodes, operation, tree_of(a).root, moved(tree_of(b).root), monitor);
  return Compaction<D>(table, nodes).of(root);
}

template <int D>
Partition<D> complement(const Partition<D>& region) {
  Tree tree = tree_of(region);
  const auto complemented = [](Link link) { return is_leaf(link) ? other(link) : link; };
  for (Node& n : tree.nodes) n = {n.hyperplane, complemented(n.minus), complemented(n.plus)};
  tree.root = complemented(tree.root);
  return partition_from(table_of(region), std::move(tree));
}

template <int D>
Partition<D> compact(const Partition<D>& region) {
  return Compaction<D>(table_of(region), tree_of(region).nodes).of(tree_of(region).root, tree_of(region).splits);
}

template <int D>
Partition<D> rebuilt(const Partition<D>& region) {
  if (is_leaf(tree_of(region).root)) return region;
  HyperplaneTable<D> table = table_of(region);
  const Tree tree = built(table, facets_of(region));
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
  const Tree& tree = tree_of(region);
  TreeSize size;
  size.nodes = tree.nodes.size();
  size.leaves = tree.nodes.size() + 1;
  size.hyperplanes = table_of(region).size();
  size.splits = tree.splits;
  size.bytes = tree.nodes.size() * sizeof(Node) + table_of(region).bytes();
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
  template TreeSize size_of_tree(const Partition<D>&);                                                 \
  template Partition<D> behind(const OrientedHyperplane<D>&);                                          \
  template Partition<D> behind_all(std::span<const OrientedHyperplane<D>>);                            \
  template std::vector<Piece<D>> part_inside(const Partition<D>&, const Piece<D>&);
STRATA_INSTANTIATE(1)
STRATA_INSTANTIATE(2)
STRATA_INSTANTIATE(3)
#undef STRATA_INSTANTIATE

}  // namespace strata::bsp
