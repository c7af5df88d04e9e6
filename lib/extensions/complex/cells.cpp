#include <algorithm>

#include "core/kernel/rational_point.h"
#include "strata/complex.h"

namespace strata::complex {

RationalPoint Cells::position(std::uint32_t vertex) const {
  const auto at = std::lower_bound(exact.begin(), exact.end(), vertex,
                                   [](const ExactVertex& e, std::uint32_t v) { return e.vertex < v; });
  if (at != exact.end() && at->vertex == vertex) return at->position;
  const Vertex& p = points[vertex];
  return to_rational(p);
}

bool operator==(const Cells& a, const Cells& b) {
  const auto same = [](const ExactVertex& x, const ExactVertex& y) {
    return x.vertex == y.vertex && x.position == y.position;
  };
  return a.dimension == b.dimension && a.marks == b.marks && a.points == b.points && a.edges == b.edges &&
         a.wings == b.wings && a.sides == b.sides && a.vertices_in_faces == b.vertices_in_faces &&
         a.vertices_in_volumes == b.vertices_in_volumes && a.edges_in_volumes == b.edges_in_volumes &&
         std::equal(a.exact.begin(), a.exact.end(), b.exact.begin(), b.exact.end(), same);
}

}  // namespace strata::complex
