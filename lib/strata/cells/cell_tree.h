#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "strata/cells/grid.h"
#include "strata/cells/windings.h"
#include "strata/kernel/carriers.h"

namespace strata {

/// A face and its grid box.
struct CellFace {
  GridBox box;
  std::uint32_t face = 0;
};

/// A leaf of the subdivision: a box of space, the faces that may meet it, and a local origin in it with its winding
/// numbers. A point belongs to the one cell with lower <= grid coordinates < upper; the faces listed are those whose
/// boxes reach into it, so every walk inside a cell meets listed faces only: the grid being monotone, a cell is convex.
struct Cell {
  GridBox box;
  Carriers::Coordinates origin{};
  std::shared_ptr<const Windings> windings;  ///< at the origin (in the sense of walk.h)
  std::vector<CellFace> faces;               ///< by increasing face number
  bool mixed = false;                        ///< faces may meet here; otherwise all belong to one operand
};

struct CellOptions {
  bool self = false;            ///< faces of one operand may meet each other
  std::size_t leaf_faces = 32;  ///< refine cells with more faces
};

/// Space subdivided lazily: only where faces that may meet are near each other.
class CellTree {
 public:
  /// Boxes every face and refines. Runs in the current task arena; the result does not depend on the number of threads.
  /// O(n log n) for faces of even density near the meeting surfaces.
  CellTree(const Carriers& carriers, const CellOptions& options);

  [[nodiscard]] const Grid& grid() const { return grid_; }
  [[nodiscard]] std::span<const Cell> cells() const { return cells_; }  ///< the leaves, in a fixed order
  [[nodiscard]] std::uint32_t cell_at(const std::array<std::int32_t, 3>& g) const;

 private:
  struct Node {
    int axis = -1;  ///< -1: leaf
    std::int32_t split = 0;
    std::uint32_t below = 0, above = 0;  ///< nodes, or `below` = cell of a leaf
  };
  struct Branch;
  std::uint32_t collect(Branch& branch);

  Grid grid_;
  std::vector<Cell> cells_;
  std::vector<Node> nodes_;
};

}  // namespace strata
