#include "support/planes.h"

#include <array>

namespace strata::test {
namespace {

RationalPoint rational(const Vertex& v) { return {to_rational(v[0]), to_rational(v[1]), to_rational(v[2])}; }

/// det(b - a, c - a, d - a)
Rational determinant(const RationalPoint& a, RationalPoint b, RationalPoint c, RationalPoint d) {
  for (int k = 0; k < 3; ++k) {
    b[k] -= a[k];
    c[k] -= a[k];
    d[k] -= a[k];
  }
  return b[0] * (c[1] * d[2] - c[2] * d[1]) + b[1] * (c[2] * d[0] - c[0] * d[2]) + b[2] * (c[0] * d[1] - c[1] * d[0]);
}

bool lies_in_source(const ExactMesh& result, const Triangle& triangle, const Mesh& operand, std::uint32_t face) {
  std::array<RationalPoint, 3> plane;
  for (int i = 0; i < 3; ++i) plane[i] = rational(operand.vertices[operand.triangles[face][i]]);
  for (const std::uint32_t v : triangle) {
    if (determinant(plane[0], plane[1], plane[2], result.position(v)) != 0) return false;
  }
  return true;
}

}  // namespace

std::string wrong_sources(const ExactMesh& result, const std::vector<Source>& sources,
                          const std::vector<Mesh>& operands) {
  const auto& triangles = result.mesh.triangles;
  if (sources.size() != triangles.size()) {
    return std::to_string(triangles.size()) + " triangles with " + std::to_string(sources.size()) + " sources";
  }
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto [operand, face] = sources[i];
    if (operand >= operands.size() || face >= operands[operand].triangles.size() ||
        !lies_in_source(result, triangles[i], operands[operand], face)) {
      return "triangle " + std::to_string(i) + " is not in the plane of operand " + std::to_string(operand) +
             ", face " + std::to_string(face);
    }
  }
  return {};
}

}  // namespace strata::test
