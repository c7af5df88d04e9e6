#include "core/mesh/equal_vertices.h"

#include <array>
#include <bit>
#include <limits>

namespace strata {
namespace {

using Bits = std::array<std::uint64_t, 3>;

Bits bits(const Vertex& v) {
  Bits result;
  for (int i = 0; i < 3; ++i) result[i] = v[i] == 0 ? 0 : std::bit_cast<std::uint64_t>(v[i]);  // -0 = 0
  return result;
}

std::uint64_t hash(const Bits& b) {
  std::uint64_t h = 0;
  for (const std::uint64_t word : b) {
    h = (h ^ word) * 0x9E3779B97F4A7C15U;
    h ^= h >> 32;
  }
  return h;
}

/// Hashing with linear probing. `equal` compares vertices whose doubles are equal.
template <class Equal>
std::vector<std::uint32_t> first_equal(std::span<const Vertex> vertices, Equal equal) {
  constexpr auto empty = std::numeric_limits<std::uint32_t>::max();
  const std::size_t slots = std::bit_ceil(vertices.size() * 2 + 2);
  std::vector<std::uint32_t> table(slots, empty);
  std::vector<std::uint32_t> first(vertices.size());
  for (std::uint32_t v = 0; v < vertices.size(); ++v) {
    const Bits key = bits(vertices[v]);
    std::size_t slot = hash(key) & (slots - 1);
    while (table[slot] != empty && !(bits(vertices[table[slot]]) == key && equal(table[slot], v))) {
      slot = (slot + 1) & (slots - 1);
    }
    if (table[slot] == empty) table[slot] = v;
    first[v] = table[slot];
  }
  return first;
}

}  // namespace

std::vector<std::uint32_t> equal_vertices(std::span<const Vertex> vertices) {
  return first_equal(vertices, [](std::uint32_t, std::uint32_t) { return true; });
}

std::vector<std::uint32_t> equal_vertices(ExactMeshView mesh) {
  if (mesh.exact.empty()) return equal_vertices(mesh.mesh.vertices);
  std::vector<const RationalPoint*> exact(mesh.mesh.vertices.size(), nullptr);
  for (const ExactVertex& e : mesh.exact) exact[e.vertex] = &e.position;
  return first_equal(mesh.mesh.vertices, [&](std::uint32_t a, std::uint32_t b) {
    if (!exact[a] && !exact[b]) return true;
    return exact[a] && exact[b] ? *exact[a] == *exact[b] : mesh.position(a) == mesh.position(b);
  });
}

}  // namespace strata
