#pragma once
#include <array>
#include <span>
#include <vector>

#include "strata/mesh.h"
#include "support/random.h"

/// Small solids for tests. All are closed, oriented outwards, with winding numbers 0 and 1; edges and vertices may be
/// shared by several sheets where it says so, and are then written once.
namespace strata::test {

[[nodiscard]] Mesh box(const Vertex& lower, const Vertex& upper);
[[nodiscard]] Mesh tetrahedron(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& d);
[[nodiscard]] Mesh octahedron(const Vertex& centre, double radius);

/// Regular-looking sphere of 20 * 4^level triangles; its vertices are no nice numbers.
[[nodiscard]] Mesh icosphere(const Vertex& centre, double radius, int level);

/// Convex polygon in the plane z = bottom, extruded to z = top.
[[nodiscard]] Mesh prism(std::span<const std::array<double, 2>> polygon, double bottom, double top);

/// Apex over a convex polygon in the plane z = base.
[[nodiscard]] Mesh pyramid(std::span<const std::array<double, 2>> polygon, double base, const Vertex& apex);

/// Convex hull, exact; coplanar triangles share their facet as a fan. Empty when the points are coplanar.
/// O(n^4): for a dozen points.
[[nodiscard]] Mesh convex_hull(std::span<const Vertex> points);

/// Cells of a box of nx * ny * nz unit cubes at the origin; cell (i, j, k) is number i + nx (j + ny k).
struct CellGrid {
  std::array<int, 3> size{};
  std::vector<bool> filled;

  CellGrid(int nx, int ny, int nz, bool full);
  [[nodiscard]] std::size_t number(int i, int j, int k) const;
  [[nodiscard]] bool at(int i, int j, int k) const;  ///< false outside
};

/// The union of the filled cells. Edges and vertices may be shared by several sheets.
[[nodiscard]] Mesh cell_solid(const CellGrid& grid);

/// The union of random tetrahedra of the Kuhn subdivision (six in every unit cube) of nx * ny * nz cubes.
/// `one_in`: how rarely a tetrahedron is taken. Edges and vertices may be shared by several sheets.
[[nodiscard]] Mesh kuhn_solid(Random& random, std::array<int, 3> size, std::uint64_t one_in);

/// The union of the taken tetrahedra of that subdivision: six flags for every cube, cubes as in CellGrid.
[[nodiscard]] Mesh kuhn_solid(std::array<int, 3> size, const std::vector<bool>& taken);

[[nodiscard]] Mesh l_shape();                      ///< three unit cells
[[nodiscard]] Mesh box_with_hole();                ///< a 3 x 3 x 1 box with a hole through its middle cell
[[nodiscard]] Mesh box_with_cavity(double width);  ///< [0, 4]^3 without a box of that width in its middle
[[nodiscard]] Mesh edge_sharing_cells();           ///< two unit cells that share an edge
[[nodiscard]] Mesh vertex_sharing_cells();         ///< two unit cells that share a vertex
[[nodiscard]] Mesh cube_grid(int n);               ///< [0, n]^3 with n * n squares on every side

}  // namespace strata::test
