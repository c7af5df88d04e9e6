#include "support/subdivision.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
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

Mesh box_in_squares(const std::array<int, 3>& lower, const std::array<int, 3>& upper, bool other_diagonal) {
  Mesh mesh;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (const bool is_upper : {false, true})
      for (int i = lower[u]; i < upper[u]; ++i)
        for (int j = lower[v]; j < upper[v]; ++j) {
          const auto at = [&](int x, int y) {
            Vertex p{};
            p[axis] = (is_upper ? upper : lower)[axis];
            p[u] = x;
            p[v] = y;
            const auto place = std::find(mesh.vertices.begin(), mesh.vertices.end(), p);
            const auto number = static_cast<std::uint32_t>(place - mesh.vertices.begin());
            if (place == mesh.vertices.end()) mesh.vertices.push_back(p);
            return number;
          };
          std::array<std::uint32_t, 4> ring{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
          if (other_diagonal) std::rotate(ring.begin(), ring.begin() + 1, ring.end());
          if (!is_upper) std::swap(ring[1], ring[3]);
          mesh.triangles.push_back({ring[0], ring[1], ring[2]});
          mesh.triangles.push_back({ring[0], ring[2], ring[3]});
        }
  }
  return mesh;
}

}  // namespace strata::test
