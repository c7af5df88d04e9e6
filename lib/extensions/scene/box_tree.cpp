#include "extensions/scene/box_tree.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>

#include "core/kernel/input_complex.h"
#include "extensions/scene/scene_data.h"

namespace strata {
namespace {

Box box_of(const InputComplex& input, std::uint32_t face) {
  Box box;
  for (const std::uint32_t v : input.face(face)) {
    const Vertex& p = input.vertex(v);
    Box at{p, p};
    if (input.exact(v) != nullptr)
      for (std::size_t i = 0; i < 3; ++i) {
        at.lower[i] = std::nextafter(p[i], -HUGE_VAL);
        at.upper[i] = std::nextafter(p[i], HUGE_VAL);
      }
    box.include(at);
  }
  return box;
}

Box box_of_all(const InputComplex& input) {
  const auto add = [&](const tbb::blocked_range<std::uint32_t>& range, Box box) {
    for (std::uint32_t f = range.begin(); f < range.end(); ++f) box.include(box_of(input, f));
    return box;
  };
  const auto join = [](Box a, const Box& b) {
    a.include(b);
    return a;
  };
  return tbb::parallel_reduce(tbb::blocked_range<std::uint32_t>(0, input.face_count(), 4096), Box{}, add, join);
}

/// Coordinates from 0 to about 1 in all of a scene, in floats: to build by, not to decide by.
class UnitSpace {
 public:
  explicit UnitSpace(const Box& all) {
    double most = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      lower_[i] = all.lower[i] / 2;
      most = std::max(most, all.upper[i] / 2 - lower_[i]);
    }
    const int exponent = most > 0 ? std::ilogb(most) + 1 : 0;
    factor_ = {std::ldexp(1, -exponent / 2), std::ldexp(1, -exponent - -exponent / 2)};
  }
  [[nodiscard]] float operator()(double x, std::size_t axis) const {
    return static_cast<float>((x / 2 - lower_[axis]) * factor_[0] * factor_[1]);
  }

 private:
  Vertex lower_{};
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
  std::uint32_t face = 0;
};

}  // namespace

class BoxTreeBuilder {
 public:
  explicit BoxTreeBuilder(const Scene& scene) : input_(input_complex_of(scene)) {}

  void build(BoxTree& tree) {
    tree.bounds_ = box_of_all(input_);
    refer_to_faces(UnitSpace(tree.bounds_));
    if (references_.empty()) return;
    std::vector<Node> nodes;
    const Child root = grow(0, references_.size(), 0, nodes);
    if (root.count != BoxTree::is_inner) {
      nodes.push_back({});
      set(nodes[0], 0, 0, root);
      set(nodes[0], 0, 1, Child{});
    }
    nodes.shrink_to_fit();
    tree.nodes_ = std::move(nodes);
    tree.faces_.resize(references_.size());
    tbb::parallel_for(std::size_t{0}, references_.size(), [&](std::size_t i) { tree.faces_[i] = references_[i].face; });
  }

 private:
  using Node = BoxTree::Node;
  using Nodes = std::vector<Node>;
  static constexpr std::size_t leaf_size = 5;
  static constexpr std::size_t task_size = 1 << 15;
  static constexpr std::size_t bin_count = 16;
  /// From here on faces are halved, so that no tree is deeper than this and 32 levels more.
  static constexpr int level_of_halving = 64;

  /// A leaf, or a node by its number.
  struct Child {
    Box box;
    std::uint32_t first = 0, count = 0;
  };

  void refer_to_faces(const UnitSpace& space) {
    references_.resize(input_.face_count());
    tbb::parallel_for(std::uint32_t{0}, input_.face_count(), [&](std::uint32_t f) {
      const Box box = box_of(input_, f);
      Reference& r = references_[f];
      r.face = f;
      for (std::size_t i = 0; i < 3; ++i) {
        r.box.lower[i] = space(box.lower[i], i);
        r.box.upper[i] = space(box.upper[i], i);
      }
    });
  }

  static void set(Node& node, std::size_t number, std::size_t k, const Child& child) {
    for (std::size_t i = 0; i < 3; ++i) {
      node.boxes[0][i][k] = child.box.lower[i];
      node.boxes[1][i][k] = child.box.upper[i];
    }
    node.count[k] = child.count;
    node.first[k] = child.count == BoxTree::is_inner ? child.first - static_cast<std::uint32_t>(number) : child.first;
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
    set(nodes[number], number, 0, left);
    set(nodes[number], number, 1, right);
    Child whole{left.box, static_cast<std::uint32_t>(number), BoxTree::is_inner};
    whole.box.include(right.box);
    return whole;
  }

  /// Nodes name each other by their distance: they can be moved.
  static void append(const Nodes& part, Child& root, Nodes& nodes) {
    if (root.count == BoxTree::is_inner) root.first += static_cast<std::uint32_t>(nodes.size());
    nodes.insert(nodes.end(), part.begin(), part.end());
  }

  [[nodiscard]] Child leaf(std::size_t begin, std::size_t end) const {
    Child child{{}, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end - begin)};
    for (std::size_t i = begin; i < end; ++i) child.box.include(box_of(input_, references_[i].face));
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
    if (!(width > 0) || level >= level_of_halving) return halve(begin, end, axis);
    const float scale = bin_count * (1 - 0x1p-20F) / width;
    if (!std::isfinite(scale)) return halve(begin, end, axis);
    const auto bin_of = [=](const Reference& r) {
      return static_cast<std::size_t>((r.box.lower[axis] + r.box.upper[axis] - lower) * scale);
    };
    const std::size_t last = cheapest_cut(begin, end, bin_of);
    const auto at = static_cast<std::ptrdiff_t>(begin);
    const auto middle = std::partition(references_.begin() + at, references_.begin() + static_cast<std::ptrdiff_t>(end),
                                       [&](const Reference& r) { return bin_of(r) <= last; });
    return static_cast<std::size_t>(middle - references_.begin());
  }

  /// The last bin of the left part where (area times faces) of both parts is least. The first and the last bin hold
  /// faces, so both parts do.
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

  std::size_t halve(std::size_t begin, std::size_t end, std::size_t axis) {
    const std::size_t middle = begin + (end - begin) / 2;
    const auto at = [&](std::size_t i) { return references_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(begin), at(middle), at(end), [&](const Reference& a, const Reference& b) {
      const float x = a.box.twice_centre()[axis], y = b.box.twice_centre()[axis];
      return x != y ? x < y : a.face < b.face;
    });
    return middle;
  }

  const InputComplex& input_;
  std::vector<Reference> references_;
};

BoxTree::BoxTree(const Scene& scene) { BoxTreeBuilder(scene).build(*this); }

}  // namespace strata
