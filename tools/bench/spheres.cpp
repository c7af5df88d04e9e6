#include "spheres.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <vector>

#include "random.h"
#include "subdivision.h"
#include "vectors.h"

namespace bench {
namespace {

using std::uint32_t;

double length(const Vertex& v) { return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

Vertex on_sphere(const Vertex& v) { return scaled(v, 1 / length(v)); }

Mesh icosahedron() {
  const double g = std::numbers::phi;
  Mesh mesh;
  for (const double s : {1.0, -1.0})
    for (const double t : {g, -g}) mesh.vertices.insert(mesh.vertices.end(), {{0, s, t}, {s, t, 0}, {t, 0, s}});
  for (Vertex& v : mesh.vertices) v = on_sphere(v);
  // Numbers: 0 (0,1,g)  1 (1,g,0)  2 (g,0,1)  3 (0,1,-g)  4 (1,-g,0)  5 (-g,0,1), and 6 to 11 the same with -s:
  // 6 (0,-1,g)  7 (-1,g,0)  8 (g,0,-1)  9 (0,-1,-g)  10 (-1,-g,0)  11 (-g,0,-1).
  mesh.triangles = {{0, 2, 1}, {0, 1, 7},  {0, 7, 5},  {0, 5, 6},   {0, 6, 2},   {1, 2, 8},  {1, 8, 3},
                    {1, 3, 7}, {7, 3, 11}, {7, 11, 5}, {5, 11, 10}, {5, 10, 6},  {6, 10, 4}, {6, 4, 2},
                    {2, 4, 8}, {9, 8, 4},  {9, 3, 8},  {9, 11, 3},  {9, 10, 11}, {9, 4, 10}};
  return mesh;
}

/// The lattice of `frequency` parts per side on every face of the icosahedron; what faces share is numbered once.
class Lattice {
 public:
  explicit Lattice(uint32_t frequency) : corners_(icosahedron()), frequency_(frequency) {
    const uint32_t per_side = frequency - 1;
    uint32_t next = 12;
    for (const Triangle& face : corners_.triangles)
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [low, high] = std::minmax(face[k], face[(k + 1) % 3]);
        if (first_on_side_.try_emplace({low, high}, next).second) next += per_side;
      }
    mesh_.vertices.resize(std::size_t{10} * frequency * frequency + 2);
    first_inside_ = next;
    for (const Triangle& face : corners_.triangles) add(face);
  }

  Mesh take() { return std::move(mesh_); }

 private:
  /// The points of a face in rows: row i is i steps away from the face's first corner and has i + 1 points.
  void add(const Triangle& face) {
    std::vector<std::vector<uint32_t>> rows;
    for (uint32_t i = 0; i <= frequency_; ++i) {
      rows.emplace_back();
      for (uint32_t j = 0; j <= i; ++j) rows[i].push_back(place(face, {frequency_ - i, i - j, j}));
    }
    for (uint32_t i = 0; i < frequency_; ++i)
      for (uint32_t j = 0; j <= i; ++j) {
        mesh_.triangles.push_back({rows[i][j], rows[i + 1][j], rows[i + 1][j + 1]});
        if (j < i) mesh_.triangles.push_back({rows[i][j], rows[i + 1][j + 1], rows[i][j + 1]});
      }
  }

  /// The number of the point with these steps away from the sides opposite the corners; sets its coordinates.
  uint32_t place(const Triangle& face, const std::array<uint32_t, 3>& steps) {
    const uint32_t number = number_of(face, steps);
    Vertex& v = mesh_.vertices[number];
    v = {};
    for (std::size_t corner = 0; corner < 3; ++corner)
      for (std::size_t k = 0; k < 3; ++k) v[k] += steps[corner] * corners_.vertices[face[corner]][k];
    v = on_sphere(v);
    return number;
  }

  uint32_t number_of(const Triangle& face, const std::array<uint32_t, 3>& steps) {
    for (std::size_t k = 0; k < 3; ++k)
      if (steps[k] == frequency_) return face[k];
    for (std::size_t k = 0; k < 3; ++k) {
      if (steps[k] != 0) continue;
      const std::size_t a = (k + 1) % 3;
      const std::size_t b = (k + 2) % 3;
      return face[a] < face[b] ? first_on_side_.at({face[a], face[b]}) + steps[b] - 1
                               : first_on_side_.at({face[b], face[a]}) + steps[a] - 1;
    }
    return first_inside_++;
  }

  Mesh corners_;
  uint32_t frequency_;
  std::map<std::pair<uint32_t, uint32_t>, uint32_t> first_on_side_;
  uint32_t first_inside_ = 0;
  Mesh mesh_;
};

}  // namespace

Mesh icosphere(unsigned levels) {
  Mesh mesh = icosahedron();
  for (unsigned i = 0; i < levels; ++i) {
    mesh = halved(mesh);
    for (Vertex& v : mesh.vertices) v = on_sphere(v);
  }
  return mesh;
}

Mesh geodesic_sphere(uint32_t frequency) { return Lattice(frequency).take(); }

Mesh with_noise(Mesh mesh, double amplitude, std::uint64_t seed) {
  Random random(seed);
  for (Vertex& v : mesh.vertices) v = scaled(v, 1 + amplitude * random.uniform(-1, 1));
  return mesh;
}

Mesh bumpy_sphere(uint32_t frequency) {
  Mesh mesh = geodesic_sphere(frequency);
  for (Vertex& v : mesh.vertices)
    v = scaled(v, 1 + 0.1 * std::sin(9 * v[0]) * std::sin(10 * v[1]) * std::sin(11 * v[2]));
  return mesh;
}

}  // namespace bench
