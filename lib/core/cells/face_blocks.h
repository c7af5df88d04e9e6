#pragma once
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "core/containers/scattered.h"
#include "core/kernel/input_complex.h"
#include "strata/options.h"

namespace strata {

/// A range of faces of one operand, by local numbers: a unit of work.
struct FaceBlock {
  std::uint32_t operand = 0, first = 0, last = 0;
};

/// All faces in ranges, in order.
[[nodiscard]] inline std::vector<FaceBlock> face_blocks(const InputComplex& input) {
  constexpr std::uint32_t size = 1 << 14;
  std::vector<FaceBlock> blocks;
  for (std::uint32_t o = 0; o < input.operand_count(); ++o)
    for (std::uint32_t i = 0; i < input.face_count(o); i += size)
      blocks.push_back({o, i, std::min(i + size, input.face_count(o))});
  return blocks;
}

/// The faces of a block and what they refer to.
struct FaceBlockView {
  std::size_t number = 0;  ///< of the block
  std::uint32_t operand = 0;
  std::uint32_t first_face = 0;    ///< of the block
  std::uint32_t first_vertex = 0;  ///< of the operand
  std::span<const InputComplex::Coordinates> points;
  std::span<const InputComplex::Indices> faces;  ///< by local vertices
};

/// Visits the blocks in parallel, each as a FaceBlockView, in an order in which threads are in different places.
template <class Visit>
void for_each_face_block(const InputComplex& input, const std::vector<FaceBlock>& blocks, const Monitor& monitor,
                         const Visit& visit) {
  const Scattered order(blocks.size());
  tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t i) {
    monitor.check();
    const std::size_t n = order[i];
    const auto& [operand, first, last] = blocks[n];
    visit(FaceBlockView{n, operand, input.first_face(operand) + first, input.first_vertex(operand),
                        input.points(operand), input.faces(operand).subspan(first, last - first)});
  });
}

}  // namespace strata
