#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/kernel/box.h"
#include "strata/combine.h"

namespace strata {

/// An operand and its box.
struct OperandBox {
  Box box;  ///< empty for an operand without vertices
  std::uint32_t operand = 0;

  [[nodiscard]] double middle(std::size_t axis) const { return box.lower[axis] / 2 + box.upper[axis] / 2; }
};

/// The boxes of some operands, in their order. O(vertices).
[[nodiscard]] inline std::vector<OperandBox> boxes_of(std::span<const Operand> operands,
                                                      std::span<const std::uint32_t> some) {
  std::vector<OperandBox> boxes;
  boxes.reserve(some.size());
  for (const std::uint32_t o : some) {
    boxes.push_back({{}, o});
    for (const Vertex& v : operands[o].mesh.vertices) boxes.back().box.include(v);
  }
  return boxes;
}

}  // namespace strata
