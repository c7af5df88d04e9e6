#include "judge.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace bench {
namespace {

using std::uint32_t;
using strata::MeshView;
using strata::Triangle;
using strata::Vertex;

bool well_formed(MeshView mesh) {
  const auto finite = [](const Vertex& v) {
    return std::all_of(v.begin(), v.end(), [](double x) { return std::isfinite(x); });
  };
  const auto in_range = [&](const Triangle& t) {
    return std::all_of(t.begin(), t.end(), [&](uint32_t v) { return v < mesh.vertices.size(); });
  };
  return std::all_of(mesh.vertices.begin(), mesh.vertices.end(), finite) &&
         std::all_of(mesh.triangles.begin(), mesh.triangles.end(), in_range);
}

/// For every vertex the number of the first one in lexicographic order that has its coordinates.
std::vector<uint32_t> same_place(std::span<const Vertex> vertices) {
  std::vector<uint32_t> order(vertices.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return vertices[a] < vertices[b]; });
  std::vector<uint32_t> representative(vertices.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool repeats = i > 0 && vertices[order[i]] == vertices[order[i - 1]];
    representative[order[i]] = repeats ? representative[order[i - 1]] : order[i];
  }
  return representative;
}

/// Every undirected side is passed as often in one direction as in the other.
bool closed(MeshView mesh) {
  const std::vector<uint32_t> place = same_place(mesh.vertices);
  std::vector<std::uint64_t> forth;
  std::vector<std::uint64_t> back;
  for (const Triangle& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const uint32_t a = place[t[k]];
      const uint32_t b = place[t[(k + 1) % 3]];
      if (a < b) forth.push_back(std::uint64_t{a} << 32 | b);
      if (b < a) back.push_back(std::uint64_t{b} << 32 | a);
    }
  std::sort(forth.begin(), forth.end());
  std::sort(back.begin(), back.end());
  return forth == back;
}

/// Of tetrahedra over the triangles; their common apex lies in the mesh, so that far-away meshes lose no digits.
double volume(MeshView mesh) {
  if (mesh.triangles.empty()) return 0;
  const Vertex apex = mesh.vertices[mesh.triangles.front()[0]];
  long double six = 0;
  for (const Triangle& t : mesh.triangles) {
    std::array<std::array<long double, 3>, 3> p{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k) p[i][k] = static_cast<long double>(mesh.vertices[t[i]][k]) - apex[k];
    const auto& [a, b, c] = p;
    six += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return static_cast<double>(six / 6);
}

}  // namespace

Verdict judge(MeshView mesh) {
  Verdict verdict;
  verdict.vertices = mesh.vertices.size();
  verdict.triangles = mesh.triangles.size();
  verdict.well_formed = well_formed(mesh);
  if (!verdict.well_formed) return verdict;
  verdict.closed = closed(mesh);
  verdict.volume = volume(mesh);
  return verdict;
}

}  // namespace bench
