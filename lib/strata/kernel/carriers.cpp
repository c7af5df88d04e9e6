#include "strata/kernel/carriers.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace strata {

void Carriers::add(std::span<const Coordinates> points, std::span<const Indices> faces,
                   std::span<const ExactVertex> exact) {
  constexpr std::size_t most = std::numeric_limits<std::uint32_t>::max() - 1;
  if (points.size() > most - vertex_end_ || faces.size() > most - face_end_)
    throw std::length_error("more than 2^32 - 2 vertices or faces in one evaluation");
  blocks_.push_back({points, faces, exact, vertex_end_, face_end_});
  vertex_end_ += static_cast<std::uint32_t>(points.size());
  face_end_ += static_cast<std::uint32_t>(faces.size());
  const std::uint32_t operand = operand_count() - 1;
  while (operand_at_vertex_.size() << stride < vertex_end_) operand_at_vertex_.push_back(operand);
  while (operand_at_face_.size() << stride < face_end_) operand_at_face_.push_back(operand);
  has_rationals_ = has_rationals_ || !exact.empty();
}

const RationalPoint* Carriers::find_exact(std::uint32_t vertex) const {
  const Block& b = blocks_[find<true>(vertex)];
  const std::uint32_t local = vertex - b.first_vertex;
  const auto at = std::lower_bound(b.exact.begin(), b.exact.end(), local,
                                   [](const ExactVertex& e, std::uint32_t v) { return e.vertex < v; });
  return at != b.exact.end() && at->vertex == local ? &at->position : nullptr;
}

}  // namespace strata
