#pragma once
#include <memory>
#include <utility>

#include "core/cells/cell_tree.h"
#include "core/kernel/input_complex.h"
#include "strata/options.h"

namespace strata {

/// The faces that may meet, sorted into cells: every pair of faces that share a point is in a common cell. Coincident
/// vertices of the input complex have one number. Reading is thread-safe.
class Candidates {
 public:
  [[nodiscard]] const InputComplex& input() const { return *input_; }
  [[nodiscard]] const CellTree& cells() const { return cells_; }

  /// Gives up the cells; the input complex stays where it is.
  [[nodiscard]] static std::unique_ptr<const InputComplex> without_cells(Candidates candidates) {
    return std::move(candidates.input_);
  }

 private:
  friend Candidates find_candidates(InputComplex input, const Monitor& monitor);
  Candidates(std::unique_ptr<InputComplex> input, const Monitor& monitor);

  std::unique_ptr<InputComplex> input_;  ///< the cells refer to it
  CellTree cells_;
};

/// Sorts faces into cells and identifies vertices that have equal coordinates, where faces may meet. O(n) for n faces
/// in streaming passes, and O(m log m) for the m faces near others; in parallel. Throws Cancelled.
[[nodiscard]] Candidates find_candidates(InputComplex input, const Monitor& monitor);

}  // namespace strata
