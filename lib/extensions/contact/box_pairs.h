#pragma once
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/kernel/box.h"

namespace strata::contact {

/// Pairs of boxes that have a point in common, by increasing numbers, the lower one first; empty boxes have none. By a
/// sweep along the axis along which boxes are shortest beside all of them. O(n log n + pairs that overlap there).
[[nodiscard]] std::vector<std::pair<std::uint32_t, std::uint32_t>> overlapping_boxes(std::span<const Box> boxes);

}  // namespace strata::contact
