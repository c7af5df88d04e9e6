#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/kernel/box.h"
#include "core/kernel/input_complex.h"

namespace strata::contact {

/// The box one step of doubles further out.
[[nodiscard]] Box widened(Box box);

/// A box that holds a face wherever its vertices are: one step of doubles outwards where they are rational.
[[nodiscard]] inline Box box_of_face(const InputComplex& input, std::uint32_t part, std::uint32_t face) {
  const auto points = input.points(part);
  Box box;
  for (const std::uint32_t v : input.faces(part)[face - input.first_face(part)]) box.include(points[v]);
  return input.has_rationals() && !input.has_doubles(input.face(face)) ? widened(box) : box;
}
/// The same for a vertex.
[[nodiscard]] Box box_of_vertex(const InputComplex& input, std::uint32_t vertex);

/// A tree of boxes over the faces of one part, in the order of a Z-curve, halved again and again. Decides nothing. An
/// immutable value; O(n) to make, about 30 bytes per face.
class PartTree {
 public:
  static constexpr std::uint32_t leaf_size = 8;

  struct Node {
    Box box;
    std::uint32_t first = 0, count = 0;  ///< of its faces
    std::uint32_t right = 0;             ///< the second child, the first one is the next node; 0: a leaf

    [[nodiscard]] bool is_leaf() const { return right == 0; }
  };

  PartTree(const InputComplex& input, std::uint32_t part);

  /// The root is the first; none: a part without faces.
  [[nodiscard]] std::span<const Node> nodes() const { return nodes_; }
  /// Global numbers of a node's faces.
  [[nodiscard]] std::span<const std::uint32_t> faces(const Node& node) const {
    return std::span<const std::uint32_t>(faces_).subspan(node.first, node.count);
  }

  /// Calls `visit(face)` for all faces in leaves whose boxes, and those around them, `enter` lets in; ends, and returns
  /// false, when `visit` does.
  template <class Enter, class Visit>
  bool for_each_in(const Enter& enter, const Visit& visit, std::uint32_t node = 0) const {
    if (nodes_.empty() || !enter(nodes_[node].box)) return true;
    if (!nodes_[node].is_leaf())
      return for_each_in(enter, visit, node + 1) && for_each_in(enter, visit, nodes_[node].right);
    for (const std::uint32_t f : faces(nodes_[node]))
      if (!visit(f)) return false;
    return true;
  }
  /// The same for boxes that meet a box.
  template <class Visit>
  bool for_each_near(const Box& box, const Visit& visit) const {
    return for_each_in([&](const Box& b) { return b.overlaps(box); }, visit);
  }

 private:
  void build(const InputComplex& input, std::uint32_t part, std::uint32_t first, std::uint32_t count);

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> faces_;
};

}  // namespace strata::contact
