#include "shapes.h"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace shapes {
namespace {

using strata::Mesh;
using Point2 = std::array<double, 2>;
using std::uint32_t;

double angle(uint32_t k, uint32_t n) { return 2 * std::numbers::pi * k / n; }

void add_quad(Mesh& mesh, uint32_t a, uint32_t b, uint32_t c, uint32_t d) {
  mesh.triangles.push_back({a, b, c});
  mesh.triangles.push_back({a, c, d});
}

// Outline k sits at vertices k (below) and n + k (above); the outline is counter-clockwise.
Mesh walls(const std::vector<Point2>& loop, double height) {
  Mesh mesh;
  const auto n = static_cast<uint32_t>(loop.size());
  for (const double z : {-height / 2, height / 2}) {
    for (const Point2& p : loop) mesh.vertices.push_back({p[0], p[1], z});
  }
  for (uint32_t k = 0; k < n; ++k) {
    const uint32_t next = (k + 1) % n;
    add_quad(mesh, k, next, n + next, n + k);
  }
  return mesh;
}

// A prism over an outline that sees the origin.
Mesh extrude_star(const std::vector<Point2>& loop, double height) {
  Mesh mesh = walls(loop, height);
  const auto n = static_cast<uint32_t>(loop.size());
  mesh.vertices.push_back({0, 0, -height / 2});
  mesh.vertices.push_back({0, 0, height / 2});
  for (uint32_t k = 0; k < n; ++k) {
    const uint32_t next = (k + 1) % n;
    mesh.triangles.push_back({2 * n, next, k});
    mesh.triangles.push_back({2 * n + 1, n + k, n + next});
  }
  return mesh;
}

}  // namespace

Mesh box(const strata::Vertex& size) {
  const double x = size[0] / 2;
  const double y = size[1] / 2;
  Mesh mesh = walls({{-x, -y}, {x, -y}, {x, y}, {-x, y}}, size[2]);
  add_quad(mesh, 3, 2, 1, 0);
  add_quad(mesh, 4, 5, 6, 7);
  return mesh;
}

Mesh sphere(double radius, unsigned n) {
  Mesh mesh;
  const uint32_t around = 2 * n;
  for (uint32_t i = 1; i < n; ++i) {
    const double latitude = angle(i, 2 * n);
    for (uint32_t k = 0; k < around; ++k) {
      mesh.vertices.push_back({radius * std::sin(latitude) * std::cos(angle(k, around)),
                               radius * std::sin(latitude) * std::sin(angle(k, around)), -radius * std::cos(latitude)});
    }
  }
  const auto south = static_cast<uint32_t>(mesh.vertices.size());
  mesh.vertices.push_back({0, 0, -radius});
  mesh.vertices.push_back({0, 0, radius});
  for (uint32_t k = 0; k < around; ++k) {
    const uint32_t next = (k + 1) % around;
    mesh.triangles.push_back({south, next, k});
    for (uint32_t i = 0; i + 2 < n; ++i) {
      add_quad(mesh, i * around + k, i * around + next, (i + 1) * around + next, (i + 1) * around + k);
    }
    mesh.triangles.push_back({south + 1, (n - 2) * around + k, (n - 2) * around + next});
  }
  return mesh;
}

Mesh torus(double radius, double tube, unsigned n) {
  Mesh mesh;
  const uint32_t around = 2 * n;
  for (uint32_t i = 0; i < around; ++i) {
    for (uint32_t k = 0; k < n; ++k) {
      const double from_axis = radius + tube * std::cos(angle(k, n));
      mesh.vertices.push_back({from_axis * std::cos(angle(i, around)), from_axis * std::sin(angle(i, around)),
                               tube * std::sin(angle(k, n))});
    }
  }
  for (uint32_t i = 0; i < around; ++i) {
    const uint32_t j = (i + 1) % around;
    for (uint32_t k = 0; k < n; ++k) {
      const uint32_t next = (k + 1) % n;
      add_quad(mesh, i * n + k, j * n + k, j * n + next, i * n + next);
    }
  }
  return mesh;
}

Mesh cylinder(double radius, double height, unsigned n) {
  std::vector<Point2> loop;
  for (uint32_t k = 0; k < n; ++k) loop.push_back({radius * std::cos(angle(k, n)), radius * std::sin(angle(k, n))});
  return extrude_star(loop, height);
}

Mesh gear(double inner, double outer, double height, unsigned n) {
  std::vector<Point2> loop;
  for (uint32_t k = 0; k < 4 * n; ++k) {
    const double radius = k % 4 < 2 ? outer : inner;
    loop.push_back({radius * std::cos(angle(k, 4 * n)), radius * std::sin(angle(k, 4 * n))});
  }
  return extrude_star(loop, height);
}

Mesh bracket(double leg, double thickness, double width) {
  Mesh mesh = walls({{0, 0}, {leg, 0}, {leg, thickness}, {thickness, thickness}, {thickness, leg}, {0, leg}}, width);
  add_quad(mesh, 3, 2, 1, 0);
  add_quad(mesh, 5, 4, 3, 0);
  add_quad(mesh, 6, 7, 8, 9);
  add_quad(mesh, 6, 9, 10, 11);
  return mesh;
}

}  // namespace shapes
