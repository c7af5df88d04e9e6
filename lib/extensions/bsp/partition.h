#pragma once
#include <array>
#include <memory>
#include <span>
#include <vector>

#include "core/winding/location.h"
#include "extensions/bsp/boundary.h"
#include "extensions/bsp/build.h"
#include "extensions/bsp/tree.h"
#include "strata/options.h"

namespace strata::bsp {

/// A regular region of the line (D = 1), the plane (2) or space (3), bounded or not, as a binary space partition: cuts
/// by hyperplanes, convex leaves that are inside or outside. All decisions are exact for whatever rationals it is made
/// of. Hyperplanes are those of the input and, where trees are built, axis-parallel ones through doubles: coefficients
/// do not grow, whatever is combined.
///
/// An immutable value, cheap to copy, safe to read from many threads.
template <int D>
class Partition {
 public:
  Partition();  ///< the empty region

  [[nodiscard]] static Partition all();  ///< the whole line, plane or space
  /// What is behind a hyperplane as it was given, the side that it does not look to.
  [[nodiscard]] static Partition half_space(const OrientedHyperplane<D>& hyperplane);
  /// What is behind all of these: convex, may be empty. Merged by halves, and built anew with
  /// axis-parallel cuts where that is less deep.
  [[nodiscard]] static Partition convex(std::span<const OrientedHyperplane<D>> hyperplanes);
  /// A tree over a table. Every node must divide its part of space; `pruned` makes trees so.
  [[nodiscard]] static Partition of(HyperplaneTable<D> table, Tree tree);

  [[nodiscard]] const HyperplaneTable<D>& table() const;
  [[nodiscard]] const Tree& tree() const;

  [[nodiscard]] bool is_empty() const { return tree().root == leaf_out; }
  [[nodiscard]] bool is_full() const { return tree().root == leaf_in; }
  [[nodiscard]] bool is_bounded() const;
  /// True when another region is part of this one.
  [[nodiscard]] bool contains(const Partition& other) const;

  /// Descends from the root; on a hyperplane both sides are asked. Exact. O(depth) for most points.
  [[nodiscard]] Where classify(const std::array<double, D>& p) const;
  [[nodiscard]] Where classify_exact(const RationalVector<D>& p) const;  ///< the same for rationals

  /// Convex facets with their interiors apart; `table()` has their corners.
  [[nodiscard]] std::vector<Facet<D>> boundary() const;

  /// The parts of a piece over this table that are in the region or on its boundary, convex and with interiors apart.
  [[nodiscard]] std::vector<Piece<D>> part_inside(const Piece<D>& piece) const;

 private:
  struct Data;
  explicit Partition(std::shared_ptr<const Data> data) : data_(std::move(data)) {}
  std::shared_ptr<const Data> data_;
};

/// The regularized combination, by merging the trees. Laws: those of sets, up to the choice of leaves.
/// Depths add up at worst: where many are combined, do it by halves, or use `rebuilt_if_deep` (recursion is as deep
/// as trees are: a depth of a thousand fits on any thread's stack). Expected output-sensitive; at worst every node of
/// one tree meets every node of the other. Throws Cancelled.
template <int D>
[[nodiscard]] Partition<D> combined(Operation operation, const Partition<D>& a, const Partition<D>& b,
                                    const Monitor& monitor = {});

template <int D>
[[nodiscard]] Partition<D> operator|(const Partition<D>& a, const Partition<D>& b) {
  return combined(Operation::unite, a, b);
}
template <int D>
[[nodiscard]] Partition<D> operator&(const Partition<D>& a, const Partition<D>& b) {
  return combined(Operation::intersect, a, b);
}
template <int D>
[[nodiscard]] Partition<D> operator-(const Partition<D>& a, const Partition<D>& b) {
  return combined(Operation::subtract, a, b);
}
template <int D>
[[nodiscard]] Partition<D> operator^(const Partition<D>& a, const Partition<D>& b) {
  return combined(Operation::exclude, a, b);
}
/// The closure of what is outside. O(nodes).
template <int D>
[[nodiscard]] Partition<D> complement(const Partition<D>& region);

/// Equal as point sets.
template <int D>
[[nodiscard]] bool operator==(const Partition<D>& a, const Partition<D>& b) {
  return (a ^ b).is_empty();
}

/// The same tree, without hyperplanes that are not in it.
template <int D>
[[nodiscard]] Partition<D> compact(const Partition<D>& region);

/// The same region, its tree built anew from its boundary.
template <int D>
[[nodiscard]] Partition<D> rebuilt(const Partition<D>& region);

/// The same region, its tree built anew if it is deep for its size: deeper than 30 + 6 log2(leaves).
template <int D>
[[nodiscard]] Partition<D> rebuilt_if_deep(const Partition<D>& region);

/// Sizes of a tree, for reports.
struct TreeSize {
  std::size_t nodes = 0, leaves = 0, inside = 0, depth = 0, hyperplanes = 0, bytes = 0;
  double mean_depth = 0;  ///< of leaves
};
template <int D>
[[nodiscard]] TreeSize size_of_tree(const Partition<D>& region);

extern template class Partition<1>;
extern template class Partition<2>;
extern template class Partition<3>;

}  // namespace strata::bsp
