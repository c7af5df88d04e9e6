#include "core/mesh/split_vertices.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/containers/for_each_index.h"

namespace strata {
namespace {

std::vector<std::uint32_t> vertices_of(std::span<const ExactVertex> exact) {
  std::vector<std::uint32_t> vertices;
  vertices.reserve(exact.size());
  for (const ExactVertex& e : exact) vertices.push_back(e.vertex);
  return vertices;
}

}  // namespace

SplitVertices::Low rest_of(const RationalPoint& position, const Vertex& nearest) {
  SplitVertices::Low rest;
  double largest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    rest.low[k] = to_nearest_double(Rational(position[k] - to_rational(nearest[k])));
    largest = std::max(largest, std::abs(rest.low[k]));
  }
  // Half a unit in the last place of the largest: at most 2^-53 of it, or half of the smallest double.
  rest.error = largest * 0x1p-53 + std::numeric_limits<double>::denorm_min();
  return rest;
}

SplitVertices::SplitVertices(ExactMeshView mesh)
    : SplitVertices(mesh.mesh.vertices.size(), vertices_of(mesh.exact), [&](std::uint32_t v) {
        const auto e = std::lower_bound(mesh.exact.begin(), mesh.exact.end(), v,
                                        [](const ExactVertex& a, std::uint32_t vertex) { return a.vertex < vertex; });
        return rest_of(e->position, mesh.mesh.vertices[v]);
      }) {}

SplitVertices::SplitVertices(std::size_t count, std::span<const std::uint32_t> rounded,
                             FunctionRef<Low(std::uint32_t vertex)> low_of) {
  if (rounded.empty()) return;
  row_.assign(count, 0);
  low_.resize(rounded.size());
  for_each_index(rounded.size(), 1 << 8, [&](std::size_t i) {
    row_[rounded[i]] = static_cast<std::uint32_t>(i) + 1;
    low_[i] = low_of(rounded[i]);
  });
  for (const Low& l : low_) error_ = std::max(error_, l.error);
}

}  // namespace strata
