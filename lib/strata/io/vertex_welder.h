#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "strata/mesh/mesh.h"

namespace strata::io {

/// Numbers the different points of a stream in order of first use. -0 equals 0, and a vertex keeps the zeros it came
/// with first. An open hash table whose slots are fetched ahead, batch by batch. O(1) expected per point.
class VertexWelder {
 public:
  explicit VertexWelder(std::size_t expected_vertices);

  /// Writes the vertex number of every point. Requires finite coordinates and fewer than 2^32 - 1 points in all.
  void add(std::span<const Vertex> points, std::span<std::uint32_t> numbers);
  [[nodiscard]] std::vector<Vertex>& vertices() { return vertices_; }

 private:
  struct Slot {
    std::uint32_t vertex_plus_one = 0;  ///< 0: free
    std::uint32_t tag = 0;              ///< upper half of the hash: spares looking at vertices that differ
  };
  static constexpr std::size_t batch = 64;

  void add_batch(std::span<const Vertex> points, std::uint32_t* numbers);
  std::uint32_t find_or_add(const Vertex& p, std::uint64_t hash);
  void grow();

  std::vector<Vertex> vertices_;
  std::vector<Slot> slots_;  ///< a power of two, at most half full
};

}  // namespace strata::io
