#pragma once
#include <cstdint>
#include <vector>

#include "extensions/planar/places.h"

namespace strata::planar {

/// A list whose entries have numbers, searchable by any predicate that is monotone along it: a treap (Seidel and Aragon
/// 1996) with priorities that are a hash of the numbers, so that its shape is determined by the operations on it.
///
/// insert, erase and search take O(log n) expected; neighbours are O(1). Numbers of erased entries are reused.
class OrderedList {
 public:
  /// Inserts a new entry after another; none: at the front.
  std::uint32_t insert_after(std::uint32_t place);
  void erase(std::uint32_t place);

  [[nodiscard]] std::uint32_t before(std::uint32_t place) const { return nodes_[place].before; }
  [[nodiscard]] std::uint32_t after(std::uint32_t place) const { return nodes_[place].after; }
  [[nodiscard]] std::uint32_t last() const { return last_; }  ///< none if the list is empty

  /// The first entry for which is_early(entry) is false, none if there is none. Requires that it is true up to some
  /// entry and false after it.
  template <class IsEarly>
  [[nodiscard]] std::uint32_t first_not(const IsEarly& is_early) const {
    std::uint32_t found = none;
    for (std::uint32_t n = root_; n != none;) {
      if (is_early(n)) {
        n = nodes_[n].right;
      } else {
        found = n;
        n = nodes_[n].left;
      }
    }
    return found;
  }

 private:
  struct Node {
    std::uint32_t parent = none, left = none, right = none;
    std::uint32_t before = none, after = none;
    std::uint32_t priority = 0;
  };
  std::uint32_t new_node();
  void hang(std::uint32_t node, std::uint32_t parent, std::uint32_t instead_of);
  void rise(std::uint32_t node);

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> free_;
  std::uint32_t root_ = none, first_ = none, last_ = none;
};

}  // namespace strata::planar
