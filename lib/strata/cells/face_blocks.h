#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

#include "strata/kernel/carriers.h"

namespace strata {

/// A run of faces of one operand, by local numbers: a piece of work.
struct FaceBlock {
  std::uint32_t operand = 0, first = 0, last = 0;
};

/// All faces in runs, in order.
[[nodiscard]] inline std::vector<FaceBlock> face_blocks(const Carriers& carriers) {
  constexpr std::uint32_t size = 1 << 14;
  std::vector<FaceBlock> blocks;
  for (std::uint32_t o = 0; o < carriers.operand_count(); ++o)
    for (std::uint32_t i = 0; i < carriers.face_count(o); i += size)
      blocks.push_back({o, i, std::min(i + size, carriers.face_count(o))});
  return blocks;
}

}  // namespace strata
