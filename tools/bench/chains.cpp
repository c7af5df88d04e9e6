#include "chains.h"

#include <array>
#include <cmath>
#include <numbers>

#include "placement.h"
#include "random.h"
#include "solids.h"
#include "spheres.h"

namespace bench {
namespace {

using std::uint32_t;
using strata::Mesh;
using strata::Vertex;

constexpr double pi = std::numbers::pi;

/// Closes rows of vertices, equally long, into a tube: row after row, each closed in itself.
void add_tube(Mesh& mesh, uint32_t rows, uint32_t length, bool is_ring) {
  for (uint32_t r = 0; r + (is_ring ? 0 : 1) < rows; ++r)
    for (uint32_t k = 0; k < length; ++k) {
      const uint32_t next = (k + 1) % length, above = (r + 1) % rows * length, here = r * length;
      mesh.triangles.push_back({here + k, here + next, above + next});
      mesh.triangles.push_back({here + k, above + next, above + k});
    }
}

/// Coordinates taken round: z to x, x to y, y to z.
Mesh cycled(Mesh mesh) {
  for (Vertex& v : mesh.vertices) v = {v[2], v[0], v[1]};
  return mesh;
}

constexpr uint32_t profile_size = 24;  ///< corners of the tool's outline
constexpr uint32_t rows = 8, pieces = 28, sweeps = 223;

double height(double x, double y) {
  return 1.6 + 0.5 * std::sin(1.7 * x) * std::cos(1.3 * y) + 0.2 * std::sin(3.1 * y + x);
}

/// The tool's outline across the x axis where it is at (x, y): a half circle below, straight walls up to the top.
std::array<Vertex, profile_size> profile(double x, double y) {
  constexpr double radius = 0.3, top = 4;
  std::array<Vertex, profile_size> loop;
  const double z = height(x, y);
  for (uint32_t k = 0; k + 2 < profile_size; ++k) {
    const double angle = pi * k / (profile_size - 3);
    loop[k] = {x, y - radius * std::cos(angle), z - radius * std::sin(angle)};
  }
  loop[profile_size - 2] = {x, y + radius, top};
  loop[profile_size - 1] = {x, y - radius, top};
  return loop;
}

/// Between two outlines, seen from x = infinity counter-clockwise.
Mesh sweep(const std::array<Vertex, profile_size>& from, const std::array<Vertex, profile_size>& to) {
  Mesh mesh;
  mesh.vertices.assign(from.begin(), from.end());
  mesh.vertices.insert(mesh.vertices.end(), to.begin(), to.end());
  add_tube(mesh, 2, profile_size, false);
  for (uint32_t k = 1; k + 1 < profile_size; ++k) {
    mesh.triangles.push_back({0, k + 1, k});
    mesh.triangles.push_back({profile_size, profile_size + k, profile_size + k + 1});
  }
  return mesh;
}

}  // namespace

Mesh torus(double radius, double thickness, uint32_t around, uint32_t across) {
  Mesh mesh;
  for (uint32_t i = 0; i < around; ++i)
    for (uint32_t j = 0; j < across; ++j) {
      const double u = 2 * pi * i / around, v = 2 * pi * j / across, distance = radius + thickness * std::cos(v);
      mesh.vertices.push_back({distance * std::cos(u), distance * std::sin(u), -thickness * std::sin(v)});
    }
  add_tube(mesh, around, across, true);
  return mesh;
}

Mesh capsule(double half_length, double radius, uint32_t sides, uint32_t rings) {
  Mesh mesh;
  for (uint32_t r = 1; r <= 2 * rings; ++r) {
    const bool upper = r > rings;
    const double angle = pi / 2 * (upper ? r - rings - 1 : static_cast<double>(r) - rings) / rings;
    for (uint32_t k = 0; k < sides; ++k) {
      const double orientation = 2 * pi * k / sides, distance = radius * std::cos(angle);
      mesh.vertices.push_back({distance * std::cos(orientation), distance * std::sin(orientation),
                               radius * std::sin(angle) + (upper ? half_length : -half_length)});
    }
  }
  add_tube(mesh, 2 * rings, sides, false);
  const auto bottom = static_cast<uint32_t>(mesh.vertices.size()), last = (2 * rings - 1) * sides;
  mesh.vertices.push_back({0, 0, -half_length - radius});
  mesh.vertices.push_back({0, 0, half_length + radius});
  for (uint32_t k = 0; k < sides; ++k) {
    const uint32_t next = (k + 1) % sides;
    mesh.triangles.push_back({bottom, next, k});
    mesh.triangles.push_back({bottom + 1, last + k, last + next});
  }
  return mesh;
}

std::vector<Mesh> nine_cuts() {
  std::vector<Mesh> meshes{icosphere(5)};
  Mesh ring = torus(0.8, 0.25, 64, 32);
  const Mesh ball = scaled(geodesic_sphere(16), 0.4);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    meshes.push_back(ring);
    ring = cycled(std::move(ring));
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) {
      Vertex place{0.01, 0.02, 0.03};
      place[axis] += side;
      meshes.push_back(shifted(ball, place));
    }
  return meshes;
}

std::vector<Mesh> terrain() {
  std::vector<Mesh> meshes{box({0, 0, 0}, {7, 4, 3})};
  for (uint32_t row = 0; row < rows; ++row)
    for (uint32_t i = 0; i < pieces && meshes.size() <= sweeps; ++i) {
      const double y = 0.25 + 0.5 * row;
      const auto x = [](uint32_t k) { return -0.5 + 8.0 * k / pieces; };
      meshes.push_back(sweep(profile(x(i), y), profile(x(i + 1), y)));
    }
  return meshes;
}

std::vector<Mesh> dome(uint32_t capsules) {
  Random random(17);
  std::vector<Mesh> meshes{geodesic_sphere(32)};
  const Mesh tool = capsule(0.05, 0.03, 16, 4);
  while (meshes.size() <= capsules) {
    const Vertex direction = random.in_box(-1, 1);
    const double length = std::hypot(direction[0], direction[1], direction[2]);
    if (length > 1 || length < 0.1) continue;
    const Vertex place{direction[0] / length, direction[1] / length, std::abs(direction[2]) / length};
    meshes.push_back(shifted(rotated(tool, random_rotation(random)), place));
  }
  return meshes;
}

}  // namespace bench
