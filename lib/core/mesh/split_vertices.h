#pragma once
#include <cstdint>
#include <vector>

#include "strata/mesh.h"

namespace strata {

/// The vertices of a mesh as sums of two doubles: the rounded coordinates, and what is left of rational ones, rounded.
/// Refers to the mesh. O(n) to make, in parallel.
class SplitVertices {
 public:
  explicit SplitVertices(ExactMeshView mesh);

  /// The second part of a rational vertex; none for one that is three doubles.
  [[nodiscard]] const Vertex* low(std::uint32_t vertex) const {
    return row_.empty() || row_[vertex] == 0 ? nullptr : &low_[row_[vertex] - 1];
  }
  [[nodiscard]] bool any_low(const Triangle& t) const {
    return !row_.empty() && (row_[t[0]] != 0 || row_[t[1]] != 0 || row_[t[2]] != 0);
  }
  /// No coordinate differs from the sum of its two parts by more.
  [[nodiscard]] double error() const { return error_; }

 private:
  std::vector<std::uint32_t> row_;  ///< of low_, per vertex, from 1; 0 for three doubles; empty if there are no others
  std::vector<Vertex> low_;
  double error_ = 0;
};

}  // namespace strata
