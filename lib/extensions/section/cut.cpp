#include "extensions/section/cut.h"

#include <algorithm>

#include "strata/errors.h"

namespace strata {
namespace {

std::uint64_t edge_of(std::uint32_t behind, std::uint32_t front) { return std::uint64_t{behind} << 32 | front; }

}  // namespace

void CutEdges::add(std::uint32_t enter_behind, std::uint32_t enter_front, std::uint32_t leave_behind,
                   std::uint32_t leave_front) {
  const auto triangle = static_cast<std::uint32_t>(enters_.size());
  enters_.push_back({edge_of(enter_behind, enter_front), triangle});
  leaves_.push_back({edge_of(leave_behind, leave_front), triangle});
}

/// Per triangle the one that its loop enters next. Every edge is left as often as it is entered.
std::vector<std::uint32_t> CutEdges::successors() {
  std::sort(enters_.begin(), enters_.end());
  std::sort(leaves_.begin(), leaves_.end());
  std::vector<std::uint32_t> next(enters_.size());
  for (std::size_t i = 0; i < next.size(); ++i) {
    if (enters_[i].edge != leaves_[i].edge) throw LogicError("the boundary of a solid is not closed");
    next[leaves_[i].triangle] = enters_[i].triangle;
  }
  return next;
}

}  // namespace strata
