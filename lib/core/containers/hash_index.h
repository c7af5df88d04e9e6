#pragma once
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/containers/huge_pages.h"

namespace strata {

/// Slots with open addresses and linear probing (Knuth 1998, 6.4): each one vacant, or the number of a thing. The
/// things themselves stay where they are; a hash says where the search for one starts.
struct HashSlots {
  static constexpr std::uint32_t vacant = 0xffffffffu;

  /// `least` slots, rounded up to a power of two. Searches end at a vacant slot: some must always be left.
  explicit HashSlots(std::size_t least) : mask(std::bit_ceil(least) - 1) { resize_fresh(slots, mask + 1, vacant); }

  std::size_t mask;
  std::vector<std::uint32_t> slots;
};

/// Finds the numbers of things by hash and equality: a hash table that holds 32-bit numbers. What the table answers
/// does not depend on the hash. Expected O(1) per call for hashes with well mixed low bits. For one thread at a time.
class HashIndex {
 public:
  /// With room for `count` things, of which half of the slots stay free.
  explicit HashIndex(std::size_t count = 0) : slots_(2 * count + 2) {}

  /// The number of the first thing for which `is_equal(its number)` holds, in the order in which those of one hash were
  /// added; `number`, which is added, if there is none. Requires room.
  template <class IsEqual>
  std::uint32_t find_or_add(std::uint64_t hash, std::uint32_t number, const IsEqual& is_equal) {
    std::size_t at = hash & slots_.mask;
    for (; slots_.slots[at] != HashSlots::vacant; at = (at + 1) & slots_.mask)
      if (const std::uint32_t there = slots_.slots[at]; is_equal(there)) return there;
    slots_.slots[at] = number;
    return number;
  }

  /// The most things that there is room for.
  [[nodiscard]] std::size_t room() const { return (slots_.mask + 1) / 2; }
  /// Makes room for `count` things, of which 0, ..., known - 1 are in the table; `hash_of(number)` is as before.
  template <class HashOf>
  void grow(std::size_t count, std::uint32_t known, const HashOf& hash_of) {
    slots_ = HashSlots(2 * count);
    for (std::uint32_t n = 0; n < known; ++n) find_or_add(hash_of(n), n, [](std::uint32_t) { return false; });
  }
  /// Takes everything out and keeps the memory.
  void clear() { slots_.slots.assign(slots_.slots.size(), HashSlots::vacant); }

 private:
  HashSlots slots_;
};

/// The same, to which many threads add at the same time. The things must be there before, and stay. Does not grow.
class ConcurrentHashIndex {
 public:
  /// With room for `count` things: a third of the slots stays free.
  explicit ConcurrentHashIndex(std::size_t count) : slots_(count + count / 2 + 1) {}

  /// Soon the thing of this hash is searched for: its slot is fetched meanwhile. Many searches of a large table wait
  /// for memory together then.
  void prefetch(std::uint64_t hash) const { __builtin_prefetch(&slots_.slots[hash & slots_.mask], 1); }

  /// The number of an equal thing that is in the table; `number`, which is added, if there is none. Of equal things
  /// added at the same time any one may stay.
  template <class IsEqual>
  std::uint32_t find_or_add(std::uint64_t hash, std::uint32_t number, const IsEqual& is_equal) {
    for (std::size_t at = hash;; ++at) {
      const std::atomic_ref<std::uint32_t> slot(slots_.slots[at & slots_.mask]);
      std::uint32_t there = slot.load(std::memory_order_relaxed);
      if (there == HashSlots::vacant && slot.compare_exchange_strong(there, number, std::memory_order_relaxed))
        return number;
      if (is_equal(there)) return there;
    }
  }

  /// Adds `number`. Of equal things the one of the lowest number stays, whatever the order in which threads come: a
  /// slot, once taken, is lowered to the least number seen. Returns true if an equal thing was in the table.
  template <class IsEqual>
  bool add_lowest(std::uint64_t hash, std::uint32_t number, const IsEqual& is_equal) {
    for (std::size_t at = hash;; ++at) {
      const std::atomic_ref<std::uint32_t> slot(slots_.slots[at & slots_.mask]);
      std::uint32_t there = slot.load(std::memory_order_relaxed);
      if (there == HashSlots::vacant && slot.compare_exchange_strong(there, number, std::memory_order_relaxed))
        return false;
      if (!is_equal(there)) continue;
      while (number < there && !slot.compare_exchange_weak(there, number, std::memory_order_relaxed)) {
      }
      return true;
    }
  }

  /// The number of the equal thing in the table, which must be there. While nobody adds.
  template <class IsEqual>
  [[nodiscard]] std::uint32_t find(std::uint64_t hash, const IsEqual& is_equal) const {
    for (std::size_t at = hash;; ++at)
      if (const std::uint32_t there = slots_.slots[at & slots_.mask]; is_equal(there)) return there;
  }

 private:
  HashSlots slots_;
};

}  // namespace strata
