#pragma once
#include <cstddef>
#include <utility>
#include <vector>

#include "strata/rational.h"

namespace strata {

/// Sums rationals in pairs of equal rank, as a binary counter does, so that most denominators stay small.
class PairwiseSum {
 public:
  void add(Rational term) {
    std::size_t rank = 0;
    for (; rank < partial_.size() && partial_[rank] != 0; ++rank) term += std::exchange(partial_[rank], 0);
    if (rank == partial_.size()) partial_.emplace_back();
    partial_[rank] = std::move(term);
  }
  [[nodiscard]] Rational value() const {
    Rational sum = 0;
    for (const Rational& part : partial_) sum += part;
    return sum;
  }

 private:
  std::vector<Rational> partial_;
};

}  // namespace strata
