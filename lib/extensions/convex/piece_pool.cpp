#include "extensions/convex/piece_pool.h"

#include <utility>

namespace strata::convex {

void PiecePool::add(Cell cell) {
  for (const CellFacet& f : cell.facets) by_plane_[f.plane].push_back(size());
  pieces_.push_back(std::move(cell));
  is_gone_.push_back(false);
}

void PiecePool::join(std::uint32_t first, std::uint32_t plane) {
  std::vector<std::uint32_t> waiting;
  for (const std::uint32_t p : by_plane_[plane])
    if (p >= first && !is_gone_[p]) waiting.push_back(p);
  for (std::size_t k = 0; k < waiting.size(); ++k)
    if (!is_gone_[waiting[k]] && join_with_any(waiting[k], first)) waiting.push_back(size() - 1);
}

bool PiecePool::join_with_any(std::uint32_t piece, std::uint32_t first) {
  for (const CellFacet& f : pieces_[piece].facets) {
    const std::vector<std::uint32_t>& others = by_plane_[f.plane];
    for (std::size_t i = others.size(); i-- > 0 && others[i] >= first;) {
      const std::uint32_t other = others[i];
      if (other == piece || is_gone_[other]) continue;
      std::optional<Cell> both = maker_.merged(pieces_[piece], pieces_[other], f.plane);
      if (!both) continue;
      is_gone_[piece] = is_gone_[other] = true;
      add(std::move(*both));
      return true;
    }
  }
  return false;
}

}  // namespace strata::convex
