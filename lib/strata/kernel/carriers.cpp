#include "strata/kernel/carriers.h"

#include <limits>
#include <stdexcept>

#include "strata/kernel/disjoint_sets.h"

namespace strata {

namespace {

constexpr std::uint32_t not_listed = 0xffffffffu;

/// Where each vertex is listed among those that are not doubles, if there are any.
template <class Listed>
std::shared_ptr<const std::vector<std::uint32_t>> places(std::size_t vertices, std::span<const Listed> listed) {
  if (listed.empty()) return nullptr;
  const auto list = std::make_shared<std::vector<std::uint32_t>>(vertices, not_listed);
  for (std::uint32_t i = 0; i < listed.size(); ++i) (*list)[listed[i].vertex] = i;
  return list;
}

}  // namespace

void Carriers::add(std::span<const Coordinates> points, std::span<const Indices> faces,
                   std::span<const ExactVertex> exact, const std::optional<Box>& bounds) {
  add({points, faces, exact, {}, {}, places(points.size(), exact), vertex_end_, face_end_, bounds});
}

void Carriers::add(std::span<const Coordinates> points, std::span<const Indices> faces,
                   std::span<const PlacedVertex> placed, std::span<const SourcePlane* const> planes,
                   const Box& bounds) {
  add({points, faces, {}, placed, planes, places(points.size(), placed), vertex_end_, face_end_, bounds});
}

void Carriers::add(Block block) {
  constexpr std::size_t most = std::numeric_limits<std::uint32_t>::max() - 1;
  if (block.points.size() > most - vertex_end_ || block.faces.size() > most - face_end_)
    throw std::length_error("more than 2^32 - 2 vertices or faces in one evaluation");
  vertex_end_ += static_cast<std::uint32_t>(block.points.size());
  face_end_ += static_cast<std::uint32_t>(block.faces.size());
  has_rationals_ = has_rationals_ || block.place != nullptr;
  has_planes_ = has_planes_ || !block.planes.empty();
  blocks_.push_back(std::move(block));
  constexpr std::uint32_t many = 64;
  if (operand_count() == many) {
    stride_ = 3;
    operand_at_vertex_.clear();
    operand_at_face_.clear();
    for (std::uint32_t o = 0; o + 1 < many; ++o) list_operand(o);
  }
  list_operand(operand_count() - 1);
}

void Carriers::list_operand(std::uint32_t operand) {
  const Block& b = blocks_[operand];
  while (operand_at_vertex_.size() << stride_ < b.first_vertex + b.points.size()) operand_at_vertex_.push_back(operand);
  while (operand_at_face_.size() << stride_ < b.first_face + b.faces.size()) operand_at_face_.push_back(operand);
}

void Carriers::identify(std::span<const std::pair<std::uint32_t, std::uint32_t>> equal) {
  if (equal.empty()) return;
  shared_.resize(vertex_end_);
  DisjointSets<std::uint32_t> sets(vertex_end_);
  for (std::uint32_t v = 0; v < same_.size(); ++v) sets.unite(same_[v], v);
  for (const auto& [a, b] : equal) {
    sets.unite(a, b);
    shared_[a] = shared_[b] = true;
  }
  same_.resize(vertex_end_);
  for (std::uint32_t v = 0; v < vertex_end_; ++v) same_[v] = sets.find(v);
}

Carriers::Place Carriers::find_place(std::uint32_t vertex) const {
  const Block& b = blocks_[find<true>(vertex)];
  if (b.place == nullptr) return {};
  const std::uint32_t place = (*b.place)[vertex - b.first_vertex];
  if (place == not_listed) return {};
  if (b.exact.empty()) return {true, b.placed[place].rational, b.placed[place].meet};
  return {true, &b.exact[place].position, nullptr};
}

}  // namespace strata
