#pragma once
#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <vector>

#include "core/cells/cell.h"
#include "core/cells/occupancy.h"
#include "core/cells/refinement.h"
#include "core/cells/regions.h"
#include "core/cells/space.h"
#include "core/cells/vertex_set.h"
#include "core/containers/fresh_array.h"

namespace strata {

/// A subdivision of space where faces that may meet are near each other: into bricks of equal size, and further, by
/// cuts, of the bricks with faces of different operands. For a few hundred faces it has no bricks and cuts the space
/// of interest as a whole. theory.md.
class CellTree {
 public:
  /// Runs in the current task arena. The subdivision does not depend on the number of threads; the numbering of the
  /// cells does. A few streaming passes over all faces; O(m log m) for the m faces of even density near the
  /// intersections of surfaces. `input` must outlive it.
  CellTree(const InputComplex& input, const CellOptions& options);

  [[nodiscard]] const Grid& grid() const { return space_.grid; }
  [[nodiscard]] std::span<const Cell> cells() const { return cells_; }
  /// The cell that contains a point of a face, by grid coordinates; any point, if there are cells everywhere. Cell 0 is
  /// all space in which no operand is met by another: there the winding numbers about all operands but the point's own
  /// are 0.
  [[nodiscard]] std::uint32_t cell_at(const std::array<std::int32_t, 3>& g) const;
  /// True when this cell owns the pair. Of all cells that list two faces whose boxes overlap, exactly one owns the
  /// pair, so the pair is tested once.
  [[nodiscard]] bool owns(const Cell& cell, const CellFace& a, const CellFace& b) const {
    std::array<std::int32_t, 3> corner{};
    for (std::size_t i = 0; i < 3; ++i) corner[i] = std::max(a.box.lower[i], b.box.lower[i]);
    return a.is_thinned || b.is_thinned ? owns_thinned(cell, a, b, corner) : cell.box.holds(corner);
  }
  /// True when a vertex is a corner of a face that may meet faces of other operands: of one in a mixed cell that is not
  /// apart.
  [[nodiscard]] bool is_near_others(std::uint32_t vertex) const { return !space_.empty && near_corners_.has(vertex); }
  /// Memory used, in bytes.
  [[nodiscard]] std::size_t bytes() const;
  /// The cell that contains a vertex of a face.
  [[nodiscard]] std::uint32_t cell_of_vertex(std::uint32_t vertex) const {
    if (regions_ == nullptr) return cell_without_bricks(space_.grid.at(input_.vertex(vertex)));
    const std::uint32_t place = regions_->place(bricks_.index(codes_->of(vertex)));
    return (place & Regions::mixed_flag) == 0 ? place : mixed_cell_of_vertex(place, vertex);
  }

 private:
  struct Node {
    int axis = -1;  ///< -1: leaf
    std::int32_t split = 0;
    std::uint32_t below = 0, above = 0;  ///< nodes, or `below` = cell of a leaf
  };
  void make_cells(const InputComplex& input, const CellOptions& options);
  void make_cells_without_bricks(const InputComplex& input, const CellOptions& options);
  [[nodiscard]] std::uint32_t cell_without_bricks(const std::array<std::int32_t, 3>& g) const;
  [[nodiscard]] bool owns_thinned(const Cell& cell, const CellFace& a, const CellFace& b,
                                  std::array<std::int32_t, 3> corner) const;
  [[nodiscard]] PlaneFilter plane_of(std::uint32_t face) const;
  std::uint32_t collect(Branch& branch);
  [[nodiscard]] std::uint32_t mixed_cell_of_vertex(std::uint32_t place, std::uint32_t vertex) const;
  [[nodiscard]] std::uint32_t descend(std::uint32_t node, const std::array<std::int32_t, 3>& g) const;

  static constexpr std::uint32_t outside_cell = 0;  // regions follow by number

  const InputComplex& input_;
  Space space_;
  BrickGrid bricks_;
  std::unique_ptr<const Raster> raster_;  ///< without bricks there is none, nor codes and regions
  std::unique_ptr<const BrickCodes> codes_;
  std::unique_ptr<const Regions> regions_;
  VertexSet near_corners_;
  FreshArray<std::uint32_t> numbers_;  ///< what cells that are apart show
  std::vector<Cell> cells_;
  std::vector<std::uint32_t> roots_;  ///< nodes, per mixed brick; without bricks, of the space of interest
  std::vector<Node> nodes_;
};

}  // namespace strata
