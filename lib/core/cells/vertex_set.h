#pragma once
#include <array>
#include <atomic>
#include <cstdint>
#include <vector>

#include "core/kernel/input_complex.h"

namespace strata {

/// Some vertices of an input. Threads may add at the same time.
class VertexSet {
 public:
  VertexSet() = default;
  explicit VertexSet(std::uint32_t vertices) : has_(vertices, 0) {}

  /// Adds the corners of a face, by their own numbers: not by those that they are identified with.
  void add(const InputComplex& input, std::uint32_t face) {
    const std::uint32_t operand = input.operand_of_face(face), first = input.first_vertex(operand);
    for (const std::uint32_t v : input.faces(operand)[face - input.first_face(operand)]) {
      const std::atomic_ref<std::uint8_t> has(has_[first + v]);
      if (has.load(std::memory_order_relaxed) == 0) has.store(1, std::memory_order_relaxed);
    }
  }
  [[nodiscard]] bool has(std::uint32_t vertex) const { return has_[vertex] != 0; }
  [[nodiscard]] std::size_t bytes() const { return has_.size(); }

 private:
  std::vector<std::uint8_t> has_;
};

}  // namespace strata
