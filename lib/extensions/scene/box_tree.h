#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/kernel/input_complex.h"
#include "extensions/scene/ray_slabs.h"
#include "strata/query.h"

namespace strata {

/// A bounding volume tree over the faces of a scene. Boxes hold their faces wherever these are rational: one step of
/// doubles outwards around the nearest ones. Nothing is decided here.
///
/// A binary tree with the boxes of both children in each node; faces are split where the surface area heuristic is
/// least over bins of their centres (Wald 2007). About 30 bytes per face. An immutable value, safe to ask from many
/// threads; the same for any number of threads that build it.
class BoxTree {
 public:
  BoxTree() = default;
  /// O(n log n), in parallel.
  explicit BoxTree(const Scene& scene);

  /// Calls `visit(faces)` for lists of faces, the nearest boxes first: of all faces that the line meets at a
  /// parameter of [0, limit], and a few more, each once. `visit` returns the limit from then on; below zero ends it.
  /// `slabs` must have been made for `bounds()`.
  template <class Visit>
  void for_each_along(const RaySlabs& slabs, double limit, const Visit& visit) const;

  [[nodiscard]] const Box& bounds() const { return bounds_; }
  [[nodiscard]] std::size_t bytes() const {
    return nodes_.capacity() * sizeof(Node) + faces_.capacity() * sizeof(std::uint32_t);
  }

 private:
  friend class BoxTreeBuilder;
  static constexpr std::uint32_t is_inner = 0xffffffffu;
  static constexpr std::size_t most_levels = 128;

  /// Child k: a leaf of `count[k]` faces from `first[k]`, or (is_inner) the node `first[k]` places further on.
  struct Node {
    BoxPair boxes;
    std::array<std::uint32_t, 2> first{}, count{};
  };

  std::vector<Node> nodes_;  ///< none: an empty scene
  std::vector<std::uint32_t> faces_;
  Box bounds_;
};

template <class Visit>
void BoxTree::for_each_along(const RaySlabs& slabs, double limit, const Visit& visit) const {
  if (nodes_.empty()) return;
  struct Waiting {
    double near;
    std::uint32_t first, count;
  };
  std::array<Waiting, most_levels> waiting;
  std::size_t size = 0;
  Waiting next{0, 0, is_inner};
  while (limit >= 0) {
    if (next.count == is_inner) {
      const Node& node = nodes_[next.first];
      const BoxEntries e = slabs.enter(node.boxes, limit);
      const auto child = [&](std::size_t k) {
        const std::uint32_t base = node.count[k] == is_inner ? next.first : 0;
        return Waiting{e.near[k], base + node.first[k], node.count[k]};
      };
      if (e.met[0] && e.met[1]) {
        const std::size_t nearer = e.near[1] < e.near[0] ? 1 : 0;
        waiting[size++] = child(1 - nearer);
        next = child(nearer);
        continue;
      }
      if (e.met[0] || e.met[1]) {
        next = child(e.met[0] ? 0 : 1);
        continue;
      }
    } else {
      limit = visit(std::span<const std::uint32_t>(faces_).subspan(next.first, next.count));
    }
    do {
      if (size == 0) return;
      next = waiting[--size];
    } while (next.near * (1 - 0x1p-49) - 0x1p-1060 > limit);
  }
}

}  // namespace strata
