#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "core/kernel/predicates.h"
#include "strata/mesh.h"
#include "strata/monitor.h"

namespace strata {

/// The normal (b-a) x (c-a) in doubles, and whether it is certain not to vanish.
struct FilteredNormal {
  Vertex normal;
  double scale;  ///< |b-a| |c-a| in the maximum norm
  bool certain;  ///< the exact normal is not zero
};

/// Let e = 2^-53, u = b-a, v = c-a, U and V their largest components as rounded, n = u x v. A difference has relative
/// error e (and no underflow), a product e and 2^-1075 from underflow, the last difference e. So a component n_k = p -
/// q has an error below (|p|+|q|)((1+e)^4 - 1) + 2^-1073 <= 2 U V (4e + 7e^2)(1+2e) + 2^-1073 < 8.01 e U V + 2^-1073.
/// The remainder of the 9 covers rounding in 9 e U V + 2^-1070 below. Infinite or undefined intermediate values make
/// the comparison false.
inline FilteredNormal filtered_normal(const Vertex& a, const Vertex& b, const Vertex& c) {
  constexpr double relative = 9 * 0x1p-53;
  constexpr double absolute = 0x1p-1070;
  const double ux = b[0] - a[0], uy = b[1] - a[1], uz = b[2] - a[2];
  const double vx = c[0] - a[0], vy = c[1] - a[1], vz = c[2] - a[2];
  const double nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
  const double u = std::max(std::max(std::abs(ux), std::abs(uy)), std::abs(uz));
  const double v = std::max(std::max(std::abs(vx), std::abs(vy)), std::abs(vz));
  const double largest = std::max(std::max(std::abs(nx), std::abs(ny)), std::abs(nz));
  return {{nx, ny, nz}, u * v, largest > relative * (u * v) + absolute};
}

/// Decides exactly whether faces have zero area. Views the mesh; indices must be valid and coordinates finite for the
/// faces in question.
class ZeroAreaTest {
 public:
  explicit ZeroAreaTest(ExactMeshView mesh) : mesh_(mesh.mesh), rational_(!mesh.exact.empty()) {
    input_.add(mesh_.vertices, mesh_.triangles, mesh.exact);
  }
  explicit ZeroAreaTest(MeshView mesh) : ZeroAreaTest(ExactMeshView(mesh, {})) {}

  [[nodiscard]] bool exactly(std::size_t face) const { return is_degenerate(input_, static_cast<std::uint32_t>(face)); }
  [[nodiscard]] bool operator()(std::size_t face) const {
    if (rational_) return exactly(face);
    const auto& [a, b, c] = mesh_.triangles[face];
    return !filtered_normal(mesh_.vertices[a], mesh_.vertices[b], mesh_.vertices[c]).certain && exactly(face);
  }

 private:
  MeshView mesh_;
  bool rational_;
  InputComplex input_;
};

/// Triangles with the face of the input that each comes from.
struct SourcedTriangles {
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> sources;

  void add(const Triangle& t, std::uint32_t source) {
    triangles.push_back(t);
    sources.push_back(source);
  }
};

/// The result of the removal of zero-area triangles.
struct Removal {
  std::vector<std::uint32_t> removed;  ///< sources of the triangles removed
  std::uint64_t divided = 0;           ///< triangles of positive area that were divided
};

/// Removes all triangles of zero area and divides their neighbours' edges, so that a closed chain remains closed and
/// covers the same surface. Vertices keep their numbers, except that those of zero-area triangles with equal
/// coordinates become one. See the proof in zero_area.cpp. O(n + k log k) for k zero-area triangles.
Removal remove_zero_area(std::span<const Vertex> vertices, SourcedTriangles& faces, const Monitor& monitor = {});

}  // namespace strata
