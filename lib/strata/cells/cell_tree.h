#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "strata/cells/grid.h"
#include "strata/cells/windings.h"
#include "strata/kernel/carriers.h"
#include "strata/mesh/monitor.h"

namespace strata {

/// A face and its grid box.
struct CellFace {
  GridBox box;
  std::uint32_t face = 0;
};

/// A leaf of the subdivision: a box of space and a local origin in it with its winding numbers. A point belongs to the
/// one cell with lower <= grid coordinates < upper. In a mixed cell faces may meet, and all whose boxes reach into it
/// are listed, so every walk inside the cell meets listed faces only: the grid being monotone, a cell is convex. The
/// faces in any other cell belong to one operand; all other operands have the origin's winding numbers throughout.
struct Cell {
  GridBox box;
  Carriers::Coordinates origin{};
  std::shared_ptr<const Windings> windings;  ///< at the origin (in the sense of walk.h)
  std::vector<CellFace> faces;               ///< of a mixed cell, by increasing face number
  bool mixed = false;
};

struct CellOptions {
  bool self = false;            ///< faces of one operand may meet each other
  std::size_t leaf_faces = 32;  ///< refine cells with more faces
  Monitor monitor = {};         ///< asked at every cut
};

/// Space subdivided lazily: only where faces that may meet are near each other.
class CellTree {
 public:
  /// Boxes every face and refines. Runs in the current task arena. The subdivision does not depend on the number of
  /// threads; the numbering of the cells does.
  /// O(n log n) for faces of even density near the meeting surfaces.
  CellTree(const Carriers& carriers, const CellOptions& options);

  [[nodiscard]] const Grid& grid() const { return grid_; }
  [[nodiscard]] std::span<const Cell> cells() const { return cells_; }  ///< the leaves
  /// The cell that holds a point, by grid coordinates. The first cell is all space in which no operand is met by
  /// another: there the winding numbers about all operands but a point's own are 0.
  [[nodiscard]] std::uint32_t cell_at(const std::array<std::int32_t, 3>& g) const;
  /// The cell that holds a face's first vertex.
  [[nodiscard]] std::uint32_t cell_of_face(std::uint32_t face) const { return cell_of_face_[face]; }

 private:
  struct Node {
    int axis = -1;  ///< -1: leaf
    std::int32_t split = 0;
    std::uint32_t below = 0, above = 0;  ///< nodes, or `below` = cell of a leaf
  };
  struct Branch;
  class Grower;
  std::uint32_t collect(Branch& branch);

  static constexpr std::uint32_t outside_cell = 0;

  Grid grid_;
  GridBox box_;  ///< of the root
  std::vector<Cell> cells_;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> cell_of_face_;
};

}  // namespace strata
