#pragma once
#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

#include "strata/mesh.h"

namespace strata::test {

/// Vertices and faces in random order, faces with random first corners.
inline Mesh shuffled(const Mesh& mesh, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<std::uint32_t> number(mesh.vertices.size());
  std::iota(number.begin(), number.end(), 0U);
  std::shuffle(number.begin(), number.end(), random);
  Mesh result{std::vector<Vertex>(number.size()), {}};
  for (std::size_t v = 0; v < number.size(); ++v) result.vertices[number[v]] = mesh.vertices[v];
  for (Triangle t : mesh.triangles) {
    std::rotate(t.begin(), t.begin() + random() % 3, t.end());
    result.triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
  }
  std::shuffle(result.triangles.begin(), result.triangles.end(), random);
  return result;
}

}  // namespace strata::test
