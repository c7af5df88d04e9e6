#include "core/overlap/coincidences.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <bit>
#include <numeric>

#include "core/mesh/corner_hash.h"
#include "core/mesh/huge_pages.h"

namespace strata {
namespace {

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/// The vertices that may have the position of another one, in order.
std::vector<std::uint32_t> vertices_near_others(const InputComplex& input, const CellTree& cells) {
  constexpr std::uint32_t run = 1 << 14;
  const std::uint32_t count = input.vertex_count(), runs = (count + run - 1) / run;
  const auto for_each = [&](std::size_t n, const auto& visit) {
    for (std::uint32_t v = static_cast<std::uint32_t>(n) * run; v < count && v / run == n; ++v)
      if (cells.is_near_others(v) && input.has_doubles(v)) visit(v);
  };
  std::vector<std::size_t> first(runs + 1, 0);
  tbb::parallel_for(std::size_t{0}, std::size_t{runs}, [&](std::size_t n) {
    std::size_t found = 0;
    for_each(n, [&](std::uint32_t) { ++found; });
    first[n + 1] = found;
  });
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<std::uint32_t> vertices;
  resize_fresh(vertices, first.back());
  tbb::parallel_for(std::size_t{0}, std::size_t{runs}, [&](std::size_t n) {
    std::size_t i = first[n];
    for_each(n, [&](std::uint32_t v) { vertices[i++] = v; });
  });
  return vertices;
}

/// A hash table of positions, each with one of its vertices.
class Places {
 public:
  explicit Places(std::size_t vertices) : mask_(std::bit_ceil(vertices + vertices / 2 + 1) - 1) {
    resize_fresh(slots_, mask_ + 1, nobody);
  }

  /// The vertex that represents the position of this one; itself if there was none. Threads may insert at the same
  /// time.
  std::uint32_t insert(const InputComplex& input, std::uint32_t vertex) {
    const InputComplex::Coordinates& p = input.vertex(vertex);
    for (std::size_t s = hash_of(p);; ++s) {
      const std::atomic_ref<std::uint32_t> slot(slots_[s & mask_]);
      std::uint32_t there = slot.load(std::memory_order_relaxed);
      if (there == nobody && slot.compare_exchange_strong(there, vertex, std::memory_order_relaxed)) return vertex;
      if (input.vertex(there) == p) return there;
    }
  }

 private:
  static constexpr std::uint32_t nobody = 0xffffffffu;
  std::size_t mask_;
  std::vector<std::uint32_t> slots_;
};

}  // namespace

Pairs find_coincidences(const InputComplex& input, const CellTree& cells, const Monitor& monitor) {
  const std::vector<std::uint32_t> vertices = vertices_near_others(input, cells);
  Places places(vertices.size());
  tbb::enumerable_thread_specific<Pairs> found;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, vertices.size(), 1 << 12), [&](const auto& range) {
    monitor.check();
    Pairs& pairs = found.local();
    for (std::size_t i = range.begin(); i != range.end(); ++i)
      if (const std::uint32_t there = places.insert(input, vertices[i]); there != vertices[i])
        pairs.emplace_back(there, vertices[i]);
  });
  Pairs all;
  for (const Pairs& pairs : found) all.insert(all.end(), pairs.begin(), pairs.end());
  return all;
}

}  // namespace strata
