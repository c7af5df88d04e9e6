#include "extensions/complex/collinear.h"

#include <algorithm>

#include "core/kernel/filters.h"

namespace strata::complex {
namespace {

bool has_doubles(const Cells& cells, std::uint32_t v) {
  return cells.exact.empty() || !std::binary_search(cells.exact.begin(), cells.exact.end(), ExactVertex{v, {}},
                                                    [](const auto& x, const auto& y) { return x.vertex < y.vertex; });
}

}  // namespace

bool are_collinear(const Cells& cells, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  if (has_doubles(cells, a) && has_doubles(cells, b) && has_doubles(cells, c)) {
    const auto bounded = [&](std::uint32_t v) {
      const Vertex& p = cells.points[v];
      return BoundedPoint{p[0], p[1], p[2]};
    };
    const BoundedPoint p = bounded(a);
    for (const Bounded& x : cross<Bounded>(bounded(b) - p, bounded(c) - p))
      if (const auto sign = x.sign(); sign && *sign != Sign::zero) return false;
  }
  const RationalPoint p = cells.position(a), q = cells.position(b), r = cells.position(c);
  RationalPoint u, v;
  for (std::size_t i = 0; i < 3; ++i) {
    u[i] = q[i] - p[i];
    v[i] = r[i] - p[i];
  }
  return u[0] * v[1] == u[1] * v[0] && u[1] * v[2] == u[2] * v[1] && u[0] * v[2] == u[2] * v[0];
}

}  // namespace strata::complex
