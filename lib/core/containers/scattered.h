#pragma once
#include <cstddef>
#include <numeric>

namespace strata {

/// The numbers below a count, in an order in which those that follow each other are far apart, and so are halves of the
/// order at any time. Threads that take parts of it write to different places, also where two operands that lie on each
/// other are listed one after the other.
class Scattered {
 public:
  explicit Scattered(std::size_t count) : count_(count), step_(count * 5 / 8 + 1) {
    while (std::gcd(step_, count_) != 1) ++step_;
  }

  /// Different for different n < count.
  [[nodiscard]] std::size_t operator[](std::size_t n) const { return n * step_ % count_; }

 private:
  std::size_t count_, step_;
};

}  // namespace strata
