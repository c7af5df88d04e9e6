#include "core/containers/box_tree.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace strata {
namespace {

Box box_of_all(std::uint32_t count, const BoxTree::BoxOf& box_of) {
  const auto add = [&](const tbb::blocked_range<std::uint32_t>& range, Box box) {
    for (std::uint32_t i = range.begin(); i < range.end(); ++i) box.include(box_of({&i, 1}));
    return box;
  };
  const auto join = [](Box a, const Box& b) {
    a.include(b);
    return a;
  };
  return tbb::parallel_reduce(tbb::blocked_range<std::uint32_t>(0, count, 4096), Box{}, add, join);
}

/// Coordinates from 0 to about 1 in all of the boxes, in floats: to build by, not to decide by.
class UnitSpace {
 public:
  explicit UnitSpace(const Box& all) {
    double most = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      lower_[i] = half(all.lower[i]);
      most = std::max(most, half(all.upper[i]) - lower_[i]);
    }
    const int exponent = most > 0 ? std::ilogb(most) + 1 : 0;
    factor_ = {std::ldexp(1, -exponent / 2), std::ldexp(1, -exponent - -exponent / 2)};
  }
  [[nodiscard]] float operator()(double x, std::size_t axis) const {
    return static_cast<float>((half(x) - lower_[axis]) * factor_[0] * factor_[1]);
  }

 private:
  /// Boxes may have no end on a side.
  static double half(double x) {
    constexpr double most = std::numeric_limits<double>::max();
    return std::clamp(x, -most, most) / 2;
  }

  std::array<double, 3> lower_{};
  std::array<double, 2> factor_{};  ///< their product may be too large for one
};

struct UnitBox {
  std::array<float, 3> lower{HUGE_VALF, HUGE_VALF, HUGE_VALF}, upper{-HUGE_VALF, -HUGE_VALF, -HUGE_VALF};

  void add(const UnitBox& b) {
    for (std::size_t i = 0; i < 3; ++i) {
      lower[i] = std::min(lower[i], b.lower[i]);
      upper[i] = std::max(upper[i], b.upper[i]);
    }
  }
  void add(const std::array<float, 3>& p) { add(UnitBox{p, p}); }
  /// A half of the area of its sides.
  [[nodiscard]] float area() const {
    const float x = upper[0] - lower[0], y = upper[1] - lower[1], z = upper[2] - lower[2];
    return x * y + y * z + z * x;
  }
  [[nodiscard]] std::array<float, 3> twice_centre() const {
    return {lower[0] + upper[0], lower[1] + upper[1], lower[2] + upper[2]};
  }
};

struct Reference {
  UnitBox box;
  std::uint32_t item = 0;
};

}  // namespace

class BoxTreeBuilder {
 public:
  explicit BoxTreeBuilder(const BoxTree::BoxOf& box_of) : box_of_(box_of) {}

  BoxTree by_surface_area(std::uint32_t count) {
    BoxTree tree;
    if (count == 0) return tree;
    tree.bounds_ = box_of_all(count, box_of_);
    refer_to_items(count, UnitSpace(tree.bounds_));
    std::vector<Node> nodes(1);
    finish(grow(0, count, 0, nodes), nodes);
    nodes.shrink_to_fit();
    tree.nodes_ = std::move(nodes);
    tree.items_.resize(count);
    tbb::parallel_for(std::size_t{0}, references_.size(), [&](std::size_t i) { tree.items_[i] = references_[i].item; });
    return tree;
  }

  BoxTree by_order(std::vector<std::uint32_t> items) {
    BoxTree tree;
    if (items.empty()) return tree;
    tree.items_ = std::move(items);
    tree.nodes_.reserve(1 + 2 * tree.items_.size() / BoxTree::leaf_size);
    tree.nodes_.resize(1);
    const Child root = halve(tree.items_, 0, static_cast<std::uint32_t>(tree.items_.size()), tree.nodes_);
    finish(root, tree.nodes_);
    tree.bounds_ = root.box;
    return tree;
  }

 private:
  using Node = BoxTree::Node;
  using Nodes = std::vector<Node>;
  static constexpr std::size_t leaf_size = 5;
  static constexpr std::size_t task_size = 1 << 15;
  static constexpr std::size_t bin_count = 16;
  /// From here on items are halved, so that no tree is deeper than this and 32 levels more.
  static constexpr int level_of_halving = 64;

  /// A leaf, or a node by its number.
  struct Child {
    Box box;
    std::uint32_t first = 0, count = 0;
  };

  void refer_to_items(std::uint32_t count, const UnitSpace& space) {
    references_.resize(count);
    tbb::parallel_for(std::uint32_t{0}, count, [&](std::uint32_t item) {
      const Box box = box_of_({&item, 1});
      Reference& r = references_[item];
      r.item = item;
      for (std::size_t i = 0; i < 3; ++i) {
        r.box.lower[i] = space(box.lower[i], i);
        r.box.upper[i] = space(box.upper[i], i);
      }
    });
  }

  /// Completes a tree. While it is made, nodes name each other by their distance, so that they can be moved.
  static void finish(const Child& root, Nodes& nodes) {
    set(nodes[0], 0, 0, root);
    set(nodes[0], 0, 1, Child{});
    for (std::uint32_t n = 0; n < nodes.size(); ++n)
      for (std::size_t k = 0; k < 2; ++k)
        if (BoxTree::is_inner(nodes[n].count[k])) nodes[n].first[k] += n;
  }

  static void set(Node& node, std::size_t number, std::size_t k, const Child& child) {
    for (std::size_t i = 0; i < 3; ++i) {
      node.boxes[0][i][k] = child.box.lower[i];
      node.boxes[1][i][k] = child.box.upper[i];
    }
    node.count[k] = child.count;
    const auto base = BoxTree::is_inner(child.count) ? static_cast<std::uint32_t>(number) : 0;
    node.first[k] = child.first - base;
  }

  /// The tree of some references, which are put in its order. Nodes are appended, parents before children.
  Child grow(std::size_t begin, std::size_t end, int level, Nodes& nodes) {
    if (end - begin <= leaf_size) return leaf(begin, end);
    const std::size_t middle = split(begin, end, level);
    const std::size_t number = nodes.size();
    nodes.emplace_back();
    Child left, right;
    if (end - begin < task_size) {
      left = grow(begin, middle, level + 1, nodes);
      right = grow(middle, end, level + 1, nodes);
    } else {
      Nodes of_left, of_right;
      tbb::parallel_invoke([&] { left = grow(begin, middle, level + 1, of_left); },
                           [&] { right = grow(middle, end, level + 1, of_right); });
      append(of_left, left, nodes);
      append(of_right, right, nodes);
    }
    return join(number, left, right, end - begin, nodes);
  }

  static Child join(std::size_t number, const Child& left, const Child& right, std::size_t count, Nodes& nodes) {
    set(nodes[number], number, 0, left);
    set(nodes[number], number, 1, right);
    const std::size_t known = std::min<std::size_t>(count, BoxTree::most_items);
    Child whole{left.box, static_cast<std::uint32_t>(number), BoxTree::inner | static_cast<std::uint32_t>(known)};
    whole.box.include(right.box);
    return whole;
  }

  /// The tree of some items in their order.
  Child halve(std::span<const std::uint32_t> items, std::uint32_t first, std::uint32_t count, Nodes& nodes) const {
    if (count <= BoxTree::leaf_size) return {box_of_(items.subspan(first, count)), first, count};
    const std::size_t number = nodes.size();
    nodes.emplace_back();
    const Child left = halve(items, first, count / 2, nodes);
    const Child right = halve(items, first + count / 2, count - count / 2, nodes);
    return join(number, left, right, count, nodes);
  }

  static void append(const Nodes& part, Child& root, Nodes& nodes) {
    if (BoxTree::is_inner(root.count)) root.first += static_cast<std::uint32_t>(nodes.size());
    nodes.insert(nodes.end(), part.begin(), part.end());
  }

  [[nodiscard]] Child leaf(std::size_t begin, std::size_t end) const {
    Child child{{}, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end - begin)};
    for (std::size_t i = begin; i < end; ++i) child.box.include(box_of_({&references_[i].item, 1}));
    return child;
  }

  /// Parts the references; both parts have some.
  std::size_t split(std::size_t begin, std::size_t end, int level) {
    UnitBox centres;
    for (std::size_t i = begin; i < end; ++i) centres.add(references_[i].box.twice_centre());
    std::size_t axis = 0;
    for (std::size_t i = 1; i < 3; ++i)
      if (centres.upper[i] - centres.lower[i] > centres.upper[axis] - centres.lower[axis]) axis = i;
    const float lower = centres.lower[axis], width = centres.upper[axis] - lower;
    if (!(width > 0) || level >= level_of_halving) return middle_of(begin, end, axis);
    const float scale = bin_count * (1 - 0x1p-20F) / width;
    if (!std::isfinite(scale)) return middle_of(begin, end, axis);
    const auto bin_of = [=](const Reference& r) {
      return static_cast<std::size_t>((r.box.lower[axis] + r.box.upper[axis] - lower) * scale);
    };
    const std::size_t last = cheapest_cut(begin, end, bin_of);
    const auto at = static_cast<std::ptrdiff_t>(begin);
    const auto middle = std::partition(references_.begin() + at, references_.begin() + static_cast<std::ptrdiff_t>(end),
                                       [&](const Reference& r) { return bin_of(r) <= last; });
    return static_cast<std::size_t>(middle - references_.begin());
  }

  /// The last bin of the left part where (area times items) of both parts is least. The first and the last bin hold
  /// items, so both parts do.
  template <class BinOf>
  std::size_t cheapest_cut(std::size_t begin, std::size_t end, const BinOf& bin_of) const {
    std::array<UnitBox, bin_count> box;
    std::array<std::size_t, bin_count> count{};
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t b = bin_of(references_[i]);
      box[b].add(references_[i].box);
      ++count[b];
    }
    std::array<float, bin_count> cost_of_right{};
    UnitBox right, left;
    std::size_t behind = 0, before = 0;
    for (std::size_t b = bin_count - 1; b > 0; --b) {
      right.add(box[b]);
      behind += count[b];
      cost_of_right[b - 1] = right.area() * static_cast<float>(behind);
    }
    std::size_t best = 0;
    float least = HUGE_VALF;
    for (std::size_t b = 0; b + 1 < bin_count; ++b) {
      left.add(box[b]);
      before += count[b];
      const float cost = left.area() * static_cast<float>(before) + cost_of_right[b];
      if (cost < least) {
        least = cost;
        best = b;
      }
    }
    return best;
  }

  std::size_t middle_of(std::size_t begin, std::size_t end, std::size_t axis) {
    const std::size_t middle = begin + (end - begin) / 2;
    const auto at = [&](std::size_t i) { return references_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(begin), at(middle), at(end), [&](const Reference& a, const Reference& b) {
      const float x = a.box.twice_centre()[axis], y = b.box.twice_centre()[axis];
      return x != y ? x < y : a.item < b.item;
    });
    return middle;
  }

  const BoxTree::BoxOf& box_of_;
  std::vector<Reference> references_;
};

BoxTree BoxTree::by_surface_area(std::uint32_t count, const BoxOf& box_of) {
  return BoxTreeBuilder(box_of).by_surface_area(count);
}

BoxTree BoxTree::by_order(std::vector<std::uint32_t> items, const BoxOf& box_of) {
  return BoxTreeBuilder(box_of).by_order(std::move(items));
}

}  // namespace strata
