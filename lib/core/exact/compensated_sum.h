#pragma once

namespace strata {

/// A sum with what its roundings lost (Neumaier 1974). With e half a unit in the last place of long double, which is at
/// least a double, n terms are off by e of the sum and n^2 e^2 of the sum of their magnitudes. Sums in another order
/// differ by as much.
class CompensatedSum {
 public:
  void add(long double term) {
    const long double next = sum_ + term;
    lost_ += magnitude(sum_) >= magnitude(term) ? (sum_ - next) + term : (term - next) + sum_;
    sum_ = next;
  }
  void add(const CompensatedSum& other) {
    add(other.sum_);
    lost_ += other.lost_;
  }
  [[nodiscard]] long double value() const { return sum_ + lost_; }

 private:
  static long double magnitude(long double x) { return x < 0 ? -x : x; }

  long double sum_ = 0, lost_ = 0;
};

}  // namespace strata
