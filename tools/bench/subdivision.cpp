#include "subdivision.h"

#include <algorithm>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "vectors.h"

namespace bench {
namespace {

using std::uint32_t;

/// The undirected sides of a mesh, numbered, and the triangles of the split mesh: side s has its vertex at V + s.
struct Split {
  explicit Split(const Mesh& mesh) {
    std::unordered_map<std::uint64_t, uint32_t> numbers;
    numbers.reserve(3 * mesh.triangles.size() / 2);
    triangles.reserve(4 * mesh.triangles.size());
    const auto first = static_cast<uint32_t>(mesh.vertices.size());
    const auto middle = [&](uint32_t a, uint32_t b) {
      const auto [low, high] = std::minmax(a, b);
      const auto number = static_cast<uint32_t>(sides.size());
      const auto [place, is_new] = numbers.try_emplace(std::uint64_t{low} << 32 | high, number);
      if (is_new) sides.push_back({low, high});
      return first + place->second;
    };
    for (const auto& [a, b, c] : mesh.triangles) {
      const uint32_t ab = middle(a, b);
      const uint32_t bc = middle(b, c);
      const uint32_t ca = middle(c, a);
      triangles.insert(triangles.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
  }

  std::vector<std::array<uint32_t, 2>> sides;
  std::vector<Triangle> triangles;
};

/// A vertex among its neighbours, moved by Warren's weights.
Vertex smoothed(const Vertex& v, const Vertex& neighbour_sum, uint32_t neighbours) {
  const double n = neighbours;
  const double weight = neighbours == 3 ? 3.0 / 16 : 3 / (8 * n);
  return sum(scaled(v, 1 - n * weight), weight, neighbour_sum);
}

}  // namespace

Mesh halved(const Mesh& mesh) {
  Split split(mesh);
  Mesh result{mesh.vertices, std::move(split.triangles)};
  for (const auto& [a, b] : split.sides) {
    result.vertices.push_back(sum(scaled(mesh.vertices[a], 0.5), 0.5, mesh.vertices[b]));
  }
  return result;
}

Mesh loop_subdivided(const Mesh& mesh) {
  Split split(mesh);
  const std::size_t count = mesh.vertices.size();
  std::vector<Vertex> neighbour_sum(count, Vertex{});
  std::vector<uint32_t> neighbours(count, 0);
  for (const auto& [a, b] : split.sides) {
    neighbour_sum[a] = sum(neighbour_sum[a], 1, mesh.vertices[b]);
    neighbour_sum[b] = sum(neighbour_sum[b], 1, mesh.vertices[a]);
    ++neighbours[a];
    ++neighbours[b];
  }
  Mesh result{mesh.vertices, std::move(split.triangles)};
  for (std::size_t i = 0; i < count; ++i) {
    result.vertices[i] = smoothed(mesh.vertices[i], neighbour_sum[i], neighbours[i]);
  }
  for (const auto& [a, b] : split.sides) {
    result.vertices.push_back(sum(scaled(mesh.vertices[a], 0.375), 0.375, mesh.vertices[b]));
  }
  // What lies opposite a side counts an eighth: the k-th four new triangles tell the middles of the k-th old one.
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    const auto& [a, b, c] = mesh.triangles[k];
    const auto& [ab, bc, ca] = result.triangles[4 * k + 3];
    result.vertices[ab] = sum(result.vertices[ab], 0.125, mesh.vertices[c]);
    result.vertices[bc] = sum(result.vertices[bc], 0.125, mesh.vertices[a]);
    result.vertices[ca] = sum(result.vertices[ca], 0.125, mesh.vertices[b]);
  }
  return result;
}

}  // namespace bench
