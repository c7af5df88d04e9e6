#include "core/mesh/split_vertices.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace strata {

SplitVertices::SplitVertices(ExactMeshView mesh) {
  if (mesh.exact.empty()) return;
  row_.assign(mesh.mesh.vertices.size(), 0);
  low_.resize(mesh.exact.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, low_.size(), 1 << 8), [&](const auto& range) {
    for (std::size_t i = range.begin(); i != range.end(); ++i) {
      const auto& [vertex, position] = mesh.exact[i];
      row_[vertex] = static_cast<std::uint32_t>(i) + 1;
      for (std::size_t k = 0; k < 3; ++k)
        low_[i][k] = to_nearest_double(Rational(position[k] - to_rational(mesh.mesh.vertices[vertex][k])));
    }
  });
  double largest = 0;
  for (const Vertex& v : low_)
    for (const double x : v) largest = std::max(largest, std::fabs(x));
  // Half a unit in the last place of the largest: at most 2^-53 of it, or half of the smallest double.
  error_ = largest * 0x1p-53 + std::numeric_limits<double>::denorm_min();
}

}  // namespace strata
