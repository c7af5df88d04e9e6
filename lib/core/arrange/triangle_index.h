#pragma once
#include <cstddef>
#include <cstdint>

namespace strata::triangle_index {

/// Corners and sides of a triangle, counter-clockwise: side i runs from corner i to corner next(i).
constexpr int next(int i) { return i == 2 ? 0 : i + 1; }
constexpr int previous(int i) { return i == 0 ? 2 : i - 1; }
constexpr std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

}  // namespace strata::triangle_index
