#pragma once
#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <cstdint>
#include <utility>

namespace strata {

/// The winding numbers about all operands at one point. Operands that are not listed have 0. A point is inside few
/// operands at a time, so the vector is sparse: (operand, winding number), by increasing operand.
class Windings {
 public:
  using Entry = std::pair<std::uint32_t, std::int32_t>;

  [[nodiscard]] std::int32_t operator[](std::uint32_t operand) const {
    const auto at = find(operand);
    return at != entries_.end() && at->first == operand ? at->second : 0;
  }
  void add(std::uint32_t operand, std::int32_t change) {
    if (change == 0) return;
    const auto at = find(operand);
    if (at == entries_.end() || at->first != operand) {
      entries_.insert(at, {operand, change});
    } else if ((at->second += change) == 0) {
      entries_.erase(at);
    }
  }
  void set(std::uint32_t operand, std::int32_t value) { add(operand, value - (*this)[operand]); }

  [[nodiscard]] auto begin() const { return entries_.begin(); }
  [[nodiscard]] auto end() const { return entries_.end(); }
  friend bool operator==(const Windings& a, const Windings& b) { return a.entries_ == b.entries_; }

 private:
  using Entries = boost::container::small_vector<Entry, 4>;
  [[nodiscard]] Entries::iterator find(std::uint32_t operand) {
    return std::lower_bound(entries_.begin(), entries_.end(), operand,
                            [](const Entry& e, std::uint32_t o) { return e.first < o; });
  }
  [[nodiscard]] Entries::const_iterator find(std::uint32_t operand) const {
    return std::lower_bound(entries_.begin(), entries_.end(), operand,
                            [](const Entry& e, std::uint32_t o) { return e.first < o; });
  }

  Entries entries_;
};

}  // namespace strata
