#include "support/transform.h"

#include <algorithm>
#include <cmath>

namespace strata::test {
namespace {

Rational determinant(const Affine& map) {
  const auto& [a, b, c, d] = map.columns;
  static_cast<void>(d);
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

RationalPoint image(const RationalPoint& p, const Affine& map) {
  RationalPoint q = map.columns[3];
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t k = 0; k < 3; ++k) q[k] += map.columns[c][k] * p[c];
  }
  return q;
}

}  // namespace

Mesh reversed(Mesh mesh) {
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

Mesh merged(std::span<const Mesh> meshes) {
  Mesh all;
  for (const Mesh& mesh : meshes) {
    const auto base = static_cast<std::uint32_t>(all.vertices.size());
    all.vertices.insert(all.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
    for (const auto& [a, b, c] : mesh.triangles) all.triangles.push_back({base + a, base + b, base + c});
  }
  return all;
}

Mesh translated(Mesh mesh, const Vertex& by) {
  for (Vertex& v : mesh.vertices) {
    for (int k = 0; k < 3; ++k) v[k] += by[k];
  }
  return mesh;
}

Mesh scaled(Mesh mesh, int exponent) { return scaled(std::move(mesh), {exponent, exponent, exponent}); }

Mesh scaled(Mesh mesh, const std::array<int, 3>& exponents) {
  for (Vertex& v : mesh.vertices) {
    for (int k = 0; k < 3; ++k) v[k] = std::ldexp(v[k], exponents[k]);
  }
  return mesh;
}

Mesh turned(const Mesh& mesh, int number) {
  std::array<int, 3> order{0, 1, 2};
  for (int i = 0; i < number / 8; ++i) std::next_permutation(order.begin(), order.end());
  const int flips = number % 8;
  Mesh result = mesh;
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      const double x = mesh.vertices[i][order[k]];
      result.vertices[i][k] = (flips >> k & 1) != 0 ? 0 - x : x;
    }
  }
  const bool odd_order = (order[1] - order[0] + 3) % 3 != 1;
  const bool odd_flips = ((flips ^ flips >> 1 ^ flips >> 2) & 1) != 0;
  return odd_order != odd_flips ? reversed(std::move(result)) : result;
}

Mesh relisted(const Mesh& mesh) {
  Mesh result = mesh;
  std::reverse(result.vertices.begin(), result.vertices.end());
  std::reverse(result.triangles.begin(), result.triangles.end());
  const auto last = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
  for (Triangle& t : result.triangles) t = {last - t[1], last - t[2], last - t[0]};
  return result;
}

ExactMesh exact(const Mesh& mesh) { return {mesh, {}}; }

ExactMesh exact_mesh(std::span<const RationalPoint> points, std::span<const Triangle> triangles) {
  ExactMesh result;
  result.mesh.triangles.assign(triangles.begin(), triangles.end());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const RationalPoint& p = points[i];
    const Vertex rounded{to_nearest_double(p[0]), to_nearest_double(p[1]), to_nearest_double(p[2])};
    result.mesh.vertices.push_back(rounded);
    const bool same =
        to_rational(rounded[0]) == p[0] && to_rational(rounded[1]) == p[1] && to_rational(rounded[2]) == p[2];
    if (!same) result.exact.push_back({i, p});
  }
  return result;
}

ExactMesh exact_box(const RationalPoint& lower, const RationalPoint& upper) {
  Affine map{};
  for (int k = 0; k < 3; ++k) {
    map.columns[k][k] = upper[k] - lower[k];
    map.columns[3][k] = lower[k];
  }
  std::vector<RationalPoint> corners;
  for (int c = 0; c < 8; ++c) {
    RationalPoint p;
    for (int k = 0; k < 3; ++k) p[k] = (c >> k & 1) != 0 ? upper[k] : lower[k];
    corners.push_back(p);
  }
  static constexpr std::array<std::array<std::uint32_t, 4>, 6> sides{
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
  std::vector<Triangle> triangles;
  for (const auto& [a, b, c, d] : sides) triangles.insert(triangles.end(), {Triangle{a, b, c}, Triangle{a, c, d}});
  return exact_mesh(corners, triangles);
}

ExactMesh translated(const ExactMesh& mesh, const RationalPoint& by) {
  std::vector<RationalPoint> points;
  for (std::uint32_t v = 0; v < mesh.mesh.vertices.size(); ++v) {
    points.push_back(mesh.position(v));
    for (int k = 0; k < 3; ++k) points.back()[k] += by[k];
  }
  return exact_mesh(points, mesh.mesh.triangles);
}

ExactMesh mapped(const Mesh& mesh, const Affine& map) { return mapped(exact(mesh), map); }

ExactMesh mapped(const ExactMesh& mesh, const Affine& map) {
  std::vector<RationalPoint> points;
  for (std::uint32_t v = 0; v < mesh.mesh.vertices.size(); ++v) points.push_back(image(mesh.position(v), map));
  return exact_mesh(points, determinant(map) < 0 ? reversed(mesh.mesh).triangles : mesh.mesh.triangles);
}

Affine product(const Affine& a, const Affine& b) {
  Affine result;
  for (std::size_t c = 0; c < 4; ++c) {
    result.columns[c] = image(b.columns[c], a);
    if (c == 3) continue;
    for (std::size_t k = 0; k < 3; ++k) result.columns[c][k] -= a.columns[3][k];
  }
  return result;
}

}  // namespace strata::test
