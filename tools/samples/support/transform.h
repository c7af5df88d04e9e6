#pragma once
#include <array>
#include <span>

#include "strata/mesh.h"
#include "strata/rational.h"

/// Maps of meshes that are exact on doubles, and maps of exact meshes.
namespace strata::test {

[[nodiscard]] Mesh reversed(Mesh mesh);                      ///< every triangle turned over
[[nodiscard]] Mesh merged(std::span<const Mesh> meshes);     ///< all parts in one mesh, nothing welded
[[nodiscard]] Mesh translated(Mesh mesh, const Vertex& by);  ///< rounded as doubles add; exact for lattice shapes
[[nodiscard]] Mesh scaled(Mesh mesh, int exponent);          ///< times 2^exponent; exact without under- or overflow
[[nodiscard]] Mesh scaled(Mesh mesh, const std::array<int, 3>& exponents);  ///< the same, per axis

/// One of the 48 symmetries of the cube: axes permuted (number / 8), then negated (bits of number % 8).
/// Triangles are turned over where the symmetry is a reflection, so that a solid stays a solid.
[[nodiscard]] Mesh turned(const Mesh& mesh, int number);

/// Starts every triangle at another corner and lists triangles and vertices backwards: the same solid.
[[nodiscard]] Mesh relisted(const Mesh& mesh);

[[nodiscard]] ExactMesh exact(const Mesh& mesh);
[[nodiscard]] ExactMesh exact_mesh(std::span<const RationalPoint> points, std::span<const Triangle> triangles);
[[nodiscard]] ExactMesh exact_box(const RationalPoint& lower, const RationalPoint& upper);
[[nodiscard]] ExactMesh translated(const ExactMesh& mesh, const RationalPoint& by);

/// Columns c0 c1 c2 of a linear map and a translation c3. Triangles are turned over where the map reflects.
struct Affine {
  std::array<std::array<Rational, 3>, 4> columns;
};
[[nodiscard]] ExactMesh mapped(const Mesh& mesh, const Affine& map);
[[nodiscard]] ExactMesh mapped(const ExactMesh& mesh, const Affine& map);
[[nodiscard]] Affine product(const Affine& a, const Affine& b);  ///< first b, then a

}  // namespace strata::test
