#pragma once
#include <cstddef>
#include <utility>
#include <vector>

#include "strata/rational.h"

namespace strata {

/// Sums rationals in pairs of equal rank, as a binary counter does, so that most denominators stay small.
class PairwiseSum {
 public:
  void add(Rational term) { add(std::move(term), 0); }
  void add(const PairwiseSum& other) {
    for (std::size_t rank = 0; rank < other.partial_.size(); ++rank)
      if (other.partial_[rank] != 0) add(other.partial_[rank], rank);
  }
  [[nodiscard]] Rational value() const {
    Rational sum = 0;
    for (const Rational& part : partial_) sum += part;
    return sum;
  }

 private:
  void add(Rational term, std::size_t rank) {
    for (; rank < partial_.size() && partial_[rank] != 0; ++rank) term += std::exchange(partial_[rank], 0);
    if (rank >= partial_.size()) partial_.resize(rank + 1);
    partial_[rank] = std::move(term);
  }

  std::vector<Rational> partial_;
};

}  // namespace strata
