#include "support/shapes.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "support/transform.h"

namespace strata::test {
namespace {

/// Collects lattice points as vertices, each once.
class LatticeMesh {
 public:
  std::uint32_t vertex(const std::array<int, 3>& p) {
    const auto [place, fresh] = numbers_.try_emplace(p, static_cast<std::uint32_t>(mesh_.vertices.size()));
    if (fresh) mesh_.vertices.push_back({double(p[0]), double(p[1]), double(p[2])});
    return place->second;
  }

  void triangle(const std::array<int, 3>& a, const std::array<int, 3>& b, const std::array<int, 3>& c) {
    const Triangle t{vertex(a), vertex(b), vertex(c)};
    mesh_.triangles.push_back(t);
  }

  [[nodiscard]] Mesh take() { return std::move(mesh_); }

 private:
  std::map<std::array<int, 3>, std::uint32_t> numbers_;
  Mesh mesh_;
};

/// The square of cell p on its side along `axis`, outwards: at the cell's upper end or its lower one.
void add_cell_side(LatticeMesh& mesh, std::array<int, 3> p, int axis, bool upper) {
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  if (upper) ++p[axis];
  std::array<std::array<int, 3>, 4> q{p, p, p, p};
  ++q[1][u], ++q[2][u], ++q[2][v], ++q[3][v];
  if (!upper) std::swap(q[1], q[3]);
  mesh.triangle(q[0], q[1], q[2]);
  mesh.triangle(q[0], q[2], q[3]);
}

using LatticeTetrahedron = std::array<std::array<int, 3>, 4>;

/// The six tetrahedra of a unit cube along its main diagonal, positively oriented.
std::vector<LatticeTetrahedron> kuhn_tetrahedra(const std::array<int, 3>& corner) {
  std::vector<LatticeTetrahedron> tetrahedra;
  std::array<int, 3> order{0, 1, 2};
  do {
    LatticeTetrahedron t;
    t[0] = corner;
    for (std::size_t i = 0; i < 3; ++i) {
      t[i + 1] = t[i];
      ++t[i + 1][order[i]];
    }
    const bool even = (order[1] - order[0] + 3) % 3 == 1;
    if (!even) std::swap(t[1], t[2]);
    tetrahedra.push_back(t);
  } while (std::next_permutation(order.begin(), order.end()));
  return tetrahedra;
}

/// Adds the faces that only one of the tetrahedra has.
Mesh boundary_of(const std::vector<LatticeTetrahedron>& tetrahedra) {
  static constexpr std::array<std::array<int, 3>, 4> outward_faces{{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};
  std::map<std::array<std::array<int, 3>, 3>, int> count;
  const auto corners = [](const LatticeTetrahedron& t, const std::array<int, 3>& face) {
    return std::array<std::array<int, 3>, 3>{t[face[0]], t[face[1]], t[face[2]]};
  };
  const auto key = [&](const LatticeTetrahedron& t, const std::array<int, 3>& face) {
    auto k = corners(t, face);
    std::sort(k.begin(), k.end());
    return k;
  };
  for (const auto& t : tetrahedra) {
    for (const auto& face : outward_faces) ++count[key(t, face)];
  }
  LatticeMesh mesh;
  for (const auto& t : tetrahedra) {
    for (const auto& face : outward_faces) {
      if (count[key(t, face)] != 1) continue;
      const auto c = corners(t, face);
      mesh.triangle(c[0], c[1], c[2]);
    }
  }
  return mesh.take();
}

Mesh subdivided(const Mesh& mesh) {
  Mesh finer;
  finer.vertices = mesh.vertices;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const auto [place, fresh] = middles.try_emplace(std::minmax(a, b), std::uint32_t(finer.vertices.size()));
    if (fresh) {
      Vertex m{};
      for (int k = 0; k < 3; ++k) m[k] = finer.vertices[a][k] + finer.vertices[b][k];
      const double length = std::sqrt(m[0] * m[0] + m[1] * m[1] + m[2] * m[2]);
      finer.vertices.push_back({m[0] / length, m[1] / length, m[2] / length});
    }
    return place->second;
  };
  for (const auto& [a, b, c] : mesh.triangles) {
    const std::uint32_t ab = middle(a, b);
    const std::uint32_t bc = middle(b, c);
    const std::uint32_t ca = middle(c, a);
    for (const Triangle& t : {Triangle{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
      finer.triangles.push_back(t);
  }
  return finer;
}

Mesh unit_icosahedron() {
  const double s = std::sqrt((5 - std::sqrt(5.0)) / 10);
  const double l = std::sqrt((5 + std::sqrt(5.0)) / 10);
  std::vector<Vertex> points;
  for (const double x : {-s, s}) {
    for (const double y : {-l, l}) {
      points.insert(points.end(), {Vertex{0, x, y}, Vertex{x, y, 0}, Vertex{y, 0, x}});
    }
  }
  return convex_hull(points);
}

}  // namespace

Mesh box(const Vertex& lower, const Vertex& upper) {
  Mesh mesh = cell_solid(CellGrid(1, 1, 1, true));
  for (Vertex& v : mesh.vertices) {
    for (int k = 0; k < 3; ++k) v[k] = v[k] == 0 ? lower[k] : upper[k];
  }
  return mesh;
}

Mesh tetrahedron(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& d) {
  return convex_hull(std::array{a, b, c, d});
}

Mesh octahedron(const Vertex& centre, double radius) {
  std::vector<Vertex> points;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double r : {-radius, radius}) {
      points.push_back(centre);
      points.back()[axis] += r;
    }
  }
  return convex_hull(points);
}

Mesh icosphere(const Vertex& centre, double radius, int level) {
  Mesh mesh = unit_icosahedron();
  for (int i = 0; i < level; ++i) mesh = subdivided(mesh);
  for (Vertex& v : mesh.vertices) {
    for (int k = 0; k < 3; ++k) v[k] = centre[k] + radius * v[k];
  }
  return mesh;
}

Mesh prism(std::span<const std::array<double, 2>> polygon, double bottom, double top) {
  std::vector<Vertex> points;
  for (const auto& [x, y] : polygon) points.insert(points.end(), {Vertex{x, y, bottom}, Vertex{x, y, top}});
  return convex_hull(points);
}

Mesh pyramid(std::span<const std::array<double, 2>> polygon, double base, const Vertex& apex) {
  std::vector<Vertex> points{apex};
  for (const auto& [x, y] : polygon) points.push_back({x, y, base});
  return convex_hull(points);
}

CellGrid::CellGrid(int nx, int ny, int nz, bool full)
    : size{nx, ny, nz}, filled(static_cast<std::size_t>(nx) * ny * nz, full) {}

std::size_t CellGrid::number(int i, int j, int k) const {
  return static_cast<std::size_t>(i) + static_cast<std::size_t>(size[0]) * (j + static_cast<std::size_t>(size[1]) * k);
}

bool CellGrid::at(int i, int j, int k) const {
  if (i < 0 || j < 0 || k < 0 || i >= size[0] || j >= size[1] || k >= size[2]) return false;
  return filled[number(i, j, k)];
}

Mesh cell_solid(const CellGrid& grid) {
  LatticeMesh mesh;
  std::array<int, 3> p{};
  for (p[2] = 0; p[2] < grid.size[2]; ++p[2]) {
    for (p[1] = 0; p[1] < grid.size[1]; ++p[1]) {
      for (p[0] = 0; p[0] < grid.size[0]; ++p[0]) {
        if (!grid.at(p[0], p[1], p[2])) continue;
        for (int axis = 0; axis < 3; ++axis) {
          for (const int step : {-1, 1}) {
            std::array<int, 3> q = p;
            q[axis] += step;
            if (!grid.at(q[0], q[1], q[2])) add_cell_side(mesh, p, axis, step > 0);
          }
        }
      }
    }
  }
  return mesh.take();
}

Mesh kuhn_solid(std::array<int, 3> size, const std::vector<bool>& taken) {
  std::vector<LatticeTetrahedron> tetrahedra;
  auto flag = taken.begin();
  for (int k = 0; k < size[2]; ++k) {
    for (int j = 0; j < size[1]; ++j) {
      for (int i = 0; i < size[0]; ++i) {
        for (const auto& t : kuhn_tetrahedra({i, j, k})) {
          if (*flag++) tetrahedra.push_back(t);
        }
      }
    }
  }
  return boundary_of(tetrahedra);
}

Mesh kuhn_solid(Random& random, std::array<int, 3> size, std::uint64_t one_in) {
  std::vector<bool> taken(static_cast<std::size_t>(size[0] * size[1] * size[2]) * 6);
  for (std::size_t i = 0; i < taken.size(); ++i) taken[i] = random.once_in(one_in);
  if (std::find(taken.begin(), taken.end(), true) == taken.end()) taken.front() = true;
  return kuhn_solid(size, taken);
}

Mesh l_shape() {
  CellGrid grid(2, 2, 1, true);
  grid.filled[grid.number(1, 1, 0)] = false;
  return cell_solid(grid);
}

Mesh box_with_hole() {
  CellGrid grid(3, 3, 1, true);
  grid.filled[grid.number(1, 1, 0)] = false;
  return cell_solid(grid);
}

Mesh box_with_cavity(double width) {
  const double low = 2 - width / 2;
  const double high = 2 + width / 2;
  return merged(std::array{box({0, 0, 0}, {4, 4, 4}), reversed(box({low, low, low}, {high, high, high}))});
}

Mesh edge_sharing_cells() {
  CellGrid grid(2, 2, 1, false);
  grid.filled[grid.number(0, 0, 0)] = grid.filled[grid.number(1, 1, 0)] = true;
  return cell_solid(grid);
}

Mesh vertex_sharing_cells() {
  CellGrid grid(2, 2, 2, false);
  grid.filled[grid.number(0, 0, 0)] = grid.filled[grid.number(1, 1, 1)] = true;
  return cell_solid(grid);
}

Mesh cube_grid(int n) { return cell_solid(CellGrid(n, n, n, true)); }

}  // namespace strata::test
