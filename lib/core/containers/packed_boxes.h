#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/containers/box_pack.h"
#include "core/containers/fresh_array.h"
#include "core/kernel/box.h"
#include "strata/function.h"

namespace strata {

/// The boxes of numbered items in packs of eight along a Z-curve, and a tree of packs above them: for all pairs of many
/// boxes of similar size. It is quicker to build and to ask about all of its items than a BoxTree. Items with a key in
/// common are no pair. An immutable value, the same for any number of threads. About 90 bytes per item.
class PackedBoxes {
 public:
  static constexpr std::size_t width = BoxPack::width;
  static constexpr std::uint32_t no_key = KeyPack::no_key;  ///< in common with nothing
  using Keys = std::array<std::uint32_t, 3>;
  using BoxOf = FunctionRef<Box(std::uint32_t item)>;
  using KeysOf = FunctionRef<Keys(std::uint32_t item)>;
  /// Is it known that none of these items makes a pair with one of those?
  using AreApart = FunctionRef<bool(std::span<const std::uint32_t> items, std::span<const std::uint32_t> others)>;
  struct Pair {
    std::uint32_t item, other;
  };

  /// Over items 0, ..., count - 1, whose boxes, within these bounds, and keys are asked for twice, from several threads
  /// at once. Boxes must be finite and not empty. O(n) for items of even density; items in one cell of 1024 each way
  /// are ordered by cells of their own, which adds O(n) for each thousandfold of the distances. In parallel.
  PackedBoxes(std::uint32_t count, const Box& bounds, BoxOf box_of, KeysOf keys_of,
              const BoxPackTests& tests = BoxPackTests::fastest());

  /// Groups are eight packs, as they are in one node above them.
  [[nodiscard]] std::size_t group_count() const { return (pack_count() + width - 1) / width; }

  /// Appends the pairs of overlapping boxes whose first member, in the order of the packs, is in this group. Over all
  /// groups, every pair once. Always in the same order. Thread-safe.
  void append_pairs_of(std::size_t group, std::vector<Pair>& pairs) const;
  /// The same, but for pairs of two groups that are apart, as far as it was worth asking: most boxes of long items
  /// overlap.
  void append_pairs_of(std::size_t group, std::vector<Pair>& pairs, AreApart are_apart) const;

 private:
  using Level = FreshArray<BoxPack>;

  [[nodiscard]] std::size_t pack_count() const { return levels_.front().size(); }
  [[nodiscard]] std::span<const std::uint32_t> items_of(std::size_t group) const;
  template <class Visit>
  void for_each_near(const Box& bounds, std::size_t first, const Visit& visit) const;
  void append_pairs(std::size_t first, std::size_t second, const Box& bounds_of_second, std::vector<Pair>& pairs) const;

  const BoxPackTests* tests_;
  FreshArray<std::uint32_t> items_;  ///< in the order of the packs
  FreshArray<KeyPack> keys_;
  std::vector<Level> levels_;  ///< the items' boxes; the bounds of these packs; and so on, up to one pack
};

}  // namespace strata
