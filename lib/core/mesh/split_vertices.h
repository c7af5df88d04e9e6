#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "strata/function.h"
#include "strata/mesh.h"

namespace strata {

/// The vertices of a mesh as sums of two doubles: the rounded coordinates, and what is left of rational ones, rounded.
/// O(n) to make, in parallel.
class SplitVertices {
 public:
  explicit SplitVertices(ExactMeshView mesh);

  /// What is left, and a bound on its errors.
  struct Low {
    Vertex low{};
    double error = 0;
  };
  /// Of `count` vertices, those that are rounded, by increasing number. `low_of` is called from many threads.
  SplitVertices(std::size_t count, std::span<const std::uint32_t> rounded,
                FunctionRef<Low(std::uint32_t vertex)> low_of);

  /// The second part of a rational vertex; none for one that is three doubles.
  [[nodiscard]] const Vertex* low(std::uint32_t vertex) const {
    return row_.empty() || row_[vertex] == 0 ? nullptr : &low_[row_[vertex] - 1].low;
  }
  [[nodiscard]] bool any_low(const Triangle& t) const {
    return !row_.empty() && (row_[t[0]] != 0 || row_[t[1]] != 0 || row_[t[2]] != 0);
  }
  /// No coordinate differs from the sum of its two parts by more.
  [[nodiscard]] double error() const { return error_; }

 private:
  std::vector<std::uint32_t> row_;  ///< of low_, per vertex, from 1; 0 for three doubles; empty if there are no others
  std::vector<Low> low_;
  double error_ = 0;
};

/// What the nearest doubles leave of an exact position.
[[nodiscard]] SplitVertices::Low rest_of(const RationalPoint& position, const Vertex& nearest);

}  // namespace strata
