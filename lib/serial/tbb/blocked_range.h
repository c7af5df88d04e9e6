#pragma once
#include <cstddef>

namespace tbb {

/// Tells the constructor that divides.
class split {};

/// The numbers from `begin` to before `end`, which are divided as long as there are more than `grain`.
template <class Value>
class blocked_range {
 public:
  using const_iterator = Value;

  blocked_range(Value begin, Value end, std::size_t grain = 1) : begin_(begin), end_(end), grain_(grain) {}
  /// Takes the upper half of another one.
  blocked_range(blocked_range& other, split)
      : begin_(other.begin_ + (other.end_ - other.begin_) / 2), end_(other.end_), grain_(other.grain_) {
    other.end_ = begin_;
  }

  [[nodiscard]] Value begin() const { return begin_; }
  [[nodiscard]] Value end() const { return end_; }
  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(end_ - begin_); }
  [[nodiscard]] bool empty() const { return !(begin_ < end_); }
  [[nodiscard]] bool is_divisible() const { return grain_ < size(); }

 private:
  Value begin_, end_;
  std::size_t grain_;
};

}  // namespace tbb
