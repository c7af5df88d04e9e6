#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/kernel/box.h"
#include "strata/function.h"

namespace strata {

/// The boxes of numbered items in packs of eight along a Z-curve, and a tree of packs above them: for all pairs of many
/// boxes of similar size. It is quicker to build and to ask about all of its items than a BoxTree. Items with a key in
/// common are no pair. An immutable value, the same for any number of threads. About 90 bytes per item.
class PackedBoxes {
 public:
  static constexpr std::size_t width = 8;
  static constexpr std::uint32_t no_key = 0xffffffffu;  ///< in common with nothing
  using Keys = std::array<std::uint32_t, 3>;
  using BoxOf = FunctionRef<Box(std::uint32_t item)>;
  using KeysOf = FunctionRef<Keys(std::uint32_t item)>;
  struct Pair {
    std::uint32_t item, other;
  };

  /// Over items 0, ..., count - 1, whose boxes and keys are asked for several times, from several threads at once.
  /// Boxes must be finite and not empty. O(n) for items of even density; items in one cell of 1024 each way are ordered
  /// by cells of their own, which adds O(n) for each thousandfold of the distances. In parallel.
  PackedBoxes(std::uint32_t count, BoxOf box_of, KeysOf keys_of);

  [[nodiscard]] std::size_t pack_count() const { return levels_.front().size(); }

  /// Appends the pairs of overlapping boxes whose first member, in the order of the packs, is in this pack. Over all
  /// packs, every pair once. Always in the same order. Thread-safe.
  void append_pairs_of(std::size_t pack, std::vector<Pair>& pairs) const;

 private:
  /// Lanes without a box are never met.
  struct Pack {
    std::array<std::array<double, width>, 3> lower, upper;

    Pack();
    void set(std::size_t k, const Box& box);
    [[nodiscard]] Box box(std::size_t k) const;
    [[nodiscard]] Box bounds() const;
  };
  using Level = std::vector<Pack>;
  struct PackKeys {
    std::array<std::array<std::uint32_t, width>, 3> key;
  };

  static std::uint32_t overlapping(const Pack& pack, const Box& box);
  static std::uint32_t with_common_key(const PackKeys& keys, const PackKeys& of, std::size_t lane);
  void append_pairs(std::size_t first, std::size_t second, const Box& bounds_of_second, std::vector<Pair>& pairs) const;

  std::vector<std::uint32_t> items_;  ///< in the order of the packs
  std::vector<PackKeys> keys_;
  std::vector<Level> levels_;  ///< the items' boxes; the bounds of these packs; and so on, up to one pack
};

}  // namespace strata
