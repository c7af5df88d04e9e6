#include "core/overlap/coincidences.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <numeric>
#include <utility>

#include "core/containers/hash_index.h"
#include "core/containers/huge_pages.h"
#include "core/containers/point_hash.h"
#include "core/overlap/point_table.h"

namespace strata {
namespace {

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/// The vertices that may have the position of another one, in order. Of an edge that two parts of an operand list, and
/// that meets another operand, they are both ends.
std::vector<std::uint32_t> vertices_near_others(const InputComplex& input, const CellTree& cells) {
  constexpr std::uint32_t run = 1 << 14;
  const std::uint32_t count = input.vertex_count(), runs = (count + run - 1) / run;
  const auto for_each = [&](std::size_t n, const auto& visit) {
    for (std::uint32_t v = static_cast<std::uint32_t>(n) * run; v < count && v / run == n; ++v)
      if (cells.is_near_others(v)) visit(v);
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

}  // namespace

Pairs find_coincidences(const InputComplex& input, const CellTree& cells, const Monitor& monitor) {
  std::vector<std::uint32_t> vertices = vertices_near_others(input, cells);
  if (input.has_rationals()) return PointTable(input).equal_positions(std::move(vertices), monitor);
  ConcurrentHashIndex places(vertices.size());  // each with the vertex that stands for it
  tbb::enumerable_thread_specific<Pairs> found;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, vertices.size(), 1 << 12), [&](const auto& range) {
    monitor.check();
    Pairs& pairs = found.local();
    for (std::size_t i = range.begin(); i != range.end(); ++i) {
      const InputComplex::Coordinates& p = input.vertex(vertices[i]);
      const std::uint32_t there =
          places.find_or_add(hash_of(p), vertices[i], [&](std::uint32_t v) { return input.vertex(v) == p; });
      if (there != vertices[i]) pairs.emplace_back(there, vertices[i]);
    }
  });
  Pairs all;
  for (const Pairs& pairs : found) all.insert(all.end(), pairs.begin(), pairs.end());
  return all;
}

}  // namespace strata
