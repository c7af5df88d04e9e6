#include "strata/io/vertex_welder.h"

#include <algorithm>
#include <array>
#include <bit>

namespace strata::io {
namespace {

std::uint64_t folded_product(std::uint64_t a, std::uint64_t b) {
  const auto p = static_cast<unsigned __int128>(a) * b;
  return static_cast<std::uint64_t>(p) ^ static_cast<std::uint64_t>(p >> 64);
}

/// Equal points have equal hashes: adding 0 turns -0 into 0.
std::uint64_t hash_of(const Vertex& p) {
  const auto bits = [&](std::size_t i) { return std::bit_cast<std::uint64_t>(p[i] + 0.0); };
  const std::uint64_t xy = folded_product(bits(0) ^ 0x9e3779b97f4a7c15u, bits(1) ^ 0xd6e8feb86659fd93u);
  return folded_product(xy ^ bits(2), 0xa0761d6478bd642fu);
}

}  // namespace

VertexWelder::VertexWelder(std::size_t expected_vertices)
    : slots_(std::bit_ceil(2 * std::max<std::size_t>(expected_vertices, 32))) {
  vertices_.reserve(expected_vertices);
}

void VertexWelder::add(std::span<const Vertex> points, std::span<std::uint32_t> numbers) {
  for (std::size_t i = 0; i < points.size(); i += batch)
    add_batch(points.subspan(i, std::min(batch, points.size() - i)), numbers.data() + i);
}

void VertexWelder::add_batch(std::span<const Vertex> points, std::uint32_t* numbers) {
  while (2 * (vertices_.size() + points.size()) > slots_.size()) grow();
  std::array<std::uint64_t, batch> hash{};
  for (std::size_t i = 0; i < points.size(); ++i) {
    hash[i] = hash_of(points[i]);
    __builtin_prefetch(&slots_[hash[i] & (slots_.size() - 1)]);
  }
  for (std::size_t i = 0; i < points.size(); ++i) numbers[i] = find_or_add(points[i], hash[i]);
}

std::uint32_t VertexWelder::find_or_add(const Vertex& p, std::uint64_t hash) {
  const std::size_t mask = slots_.size() - 1;
  const auto tag = static_cast<std::uint32_t>(hash >> 32);
  for (std::size_t at = hash & mask;; at = (at + 1) & mask) {
    Slot& slot = slots_[at];
    if (slot.vertex_plus_one == 0) {
      vertices_.push_back(p);
      slot = {static_cast<std::uint32_t>(vertices_.size()), tag};
      return slot.vertex_plus_one - 1;
    }
    if (slot.tag == tag && vertices_[slot.vertex_plus_one - 1] == p) return slot.vertex_plus_one - 1;
  }
}

void VertexWelder::grow() {
  std::vector<Slot> larger(2 * slots_.size());
  const std::size_t mask = larger.size() - 1;
  for (const Slot& slot : slots_) {
    if (slot.vertex_plus_one == 0) continue;
    std::size_t at = hash_of(vertices_[slot.vertex_plus_one - 1]) & mask;
    while (larger[at].vertex_plus_one != 0) at = (at + 1) & mask;
    larger[at] = slot;
  }
  slots_ = std::move(larger);
}

}  // namespace strata::io
