#include "support/subdivision.h"

#include <cstddef>
#include <optional>

namespace strata::test {
namespace {

/// The middle of two points, if it has doubles.
std::optional<Vertex> middle(const Vertex& a, const Vertex& b) {
  Vertex m;
  for (std::size_t i = 0; i < 3; ++i) {
    const double sum = a[i] + b[i];
    if (sum - a[i] != b[i] || sum - b[i] != a[i]) return std::nullopt;
    m[i] = sum / 2;
  }
  return m;
}

std::uint32_t append(Mesh& mesh, const Vertex& v) {
  mesh.vertices.push_back(v);
  return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
}

/// Divides both triangles of an edge at its middle.
void divide_edge(Mesh& mesh, std::uint32_t a, std::uint32_t b) {
  const auto place = middle(mesh.vertices[a], mesh.vertices[b]);
  if (!place) return;
  const std::uint32_t m = append(mesh, *place);
  for (std::size_t t = 0, count = mesh.triangles.size(); t < count; ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const Triangle old = mesh.triangles[t];
      const std::uint32_t from = old[i], to = old[(i + 1) % 3], apex = old[(i + 2) % 3];
      if (!(from == a && to == b) && !(from == b && to == a)) continue;
      mesh.triangles[t] = {from, m, apex};
      mesh.triangles.push_back({m, to, apex});
      break;
    }
}

void divide_triangle(Mesh& mesh, std::size_t t) {
  const auto [a, b, c] = mesh.triangles[t];
  const auto base = middle(mesh.vertices[a], mesh.vertices[b]);
  const auto place = base ? middle(*base, mesh.vertices[c]) : std::nullopt;
  if (!place) return;
  const std::uint32_t m = append(mesh, *place);
  mesh.triangles[t] = {a, b, m};
  mesh.triangles.push_back({b, c, m});
  mesh.triangles.push_back({c, a, m});
}

}  // namespace

Mesh subdivided(Mesh mesh, Random& random, int steps) {
  for (int i = 0; i < steps; ++i) {
    const auto t = static_cast<std::size_t>(random.below(mesh.triangles.size()));
    if (random.once_in(3)) {
      divide_triangle(mesh, t);
    } else {
      const auto k = static_cast<std::size_t>(random.below(3));
      divide_edge(mesh, mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]);
    }
  }
  return mesh;
}

}  // namespace strata::test
