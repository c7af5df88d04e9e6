#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace strata {

/// Coordinates in model units, taken exactly as given.
using Vertex = std::array<double, 3>;

/// Vertex indices, counter-clockwise seen from outside: the outward normal is (b-a) x (c-a).
using Triangle = std::array<std::uint32_t, 3>;

/// A triangle mesh as plain arrays. No invariant: any indices, any coordinates.
struct Mesh {
  std::vector<Vertex> vertices;
  std::vector<Triangle> triangles;

  friend bool operator==(const Mesh&, const Mesh&) = default;
};

/// A mesh that someone else owns; valid as long as the arrays it looks at.
struct MeshView {
  std::span<const Vertex> vertices;
  std::span<const Triangle> triangles;

  MeshView() = default;
  MeshView(std::span<const Vertex> v, std::span<const Triangle> t) : vertices(v), triangles(t) {}
  MeshView(const Mesh& m) : vertices(m.vertices), triangles(m.triangles) {}  // NOLINT: a view of a mesh is implicit
};

}  // namespace strata
