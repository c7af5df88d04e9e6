#pragma once
#include "strata/mesh.h"

namespace bench {

using strata::Mesh;
using strata::Triangle;
using strata::Vertex;

/// a + factor * b
[[nodiscard]] inline Vertex sum(const Vertex& a, double factor, const Vertex& b) {
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}

[[nodiscard]] inline Vertex scaled(const Vertex& v, double factor) { return sum(Vertex{}, factor, v); }

}  // namespace bench
