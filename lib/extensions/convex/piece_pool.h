#pragma once
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "extensions/convex/cell.h"

namespace strata::convex {

/// Convex pieces of a solid during its division, by number. Pieces that have been joined are removed.
class PiecePool {
 public:
  explicit PiecePool(CellMaker& maker) : maker_(maker) {}

  [[nodiscard]] std::uint32_t size() const {
    return static_cast<std::uint32_t>(pieces_.size());
  }  ///< including removed ones
  [[nodiscard]] const Cell& operator[](std::uint32_t piece) const { return pieces_[piece]; }
  [[nodiscard]] bool is_gone(std::uint32_t piece) const { return is_gone_[piece]; }

  void add(Cell cell);

  /// Joins pieces from number `first` on where the union of two is convex: those with facets in a plane, and then
  /// others for which this becomes possible. Requires that no two others can be joined.
  void join(std::uint32_t first, std::uint32_t plane);

  /// Pieces with a facet in a plane, by plane, increasing; some may be removed.
  [[nodiscard]] const std::unordered_map<std::uint32_t, std::vector<std::uint32_t>>& by_plane() const {
    return by_plane_;
  }

 private:
  bool join_with_any(std::uint32_t piece, std::uint32_t first);

  CellMaker& maker_;
  std::vector<Cell> pieces_;
  std::vector<bool> is_gone_;
  std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> by_plane_;
};

}  // namespace strata::convex
