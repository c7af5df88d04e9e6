#pragma once
/// Triangle meshes as plain arrays, with coordinates in doubles or in rationals.
///
/// Coordinates are in model units and are taken exactly as given: a double is the number that it stands for. No type
/// here has an invariant; what a mesh must be is said where it is used. Views do not own what they look at. As for all
/// plain data, several threads may read at once.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "strata/rational.h"

namespace strata {

/// Coordinates in model units, taken exactly as given.
using Vertex = std::array<double, 3>;

/// Vertex indices, counter-clockwise seen from outside: the outward normal is (b-a) x (c-a).
using Triangle = std::array<std::uint32_t, 3>;

/// An indexed triangle mesh. No invariant: any indices, any coordinates, vertices that no triangle uses.
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

/// The exact position of one vertex whose coordinates are not three doubles.
struct ExactVertex {
  std::uint32_t vertex = 0;
  RationalPoint position;
};

/// A triangle mesh whose vertices are rationals. `mesh` holds every coordinate rounded to the nearest double, ties to
/// even; `exact` lists the vertices for which that changed something, in increasing order of index. A mesh of doubles
/// is one with an empty list. Functions that need this order and these roundings throw std::invalid_argument without.
struct ExactMesh {
  Mesh mesh;
  std::vector<ExactVertex> exact;

  /// The exact position of a vertex. Requires that it exists. O(log exact.size()).
  [[nodiscard]] RationalPoint position(std::uint32_t vertex) const;
};

/// An exact mesh that someone else owns; valid as long as the arrays it looks at.
struct ExactMeshView {
  MeshView mesh;
  std::span<const ExactVertex> exact;

  ExactMeshView() = default;
  ExactMeshView(MeshView m, std::span<const ExactVertex> e) : mesh(m), exact(e) {}
  ExactMeshView(const ExactMesh& m) : mesh(m.mesh), exact(m.exact) {}  // NOLINT: a view of a mesh is implicit

  [[nodiscard]] RationalPoint position(std::uint32_t vertex) const;  ///< as ExactMesh::position
};

/// The triangle of the input that an output triangle is a part of: number of the operand, and of the triangle there,
/// both from 0. Of several coplanar ones it is one of them; `combine` says which.
struct Source {
  std::uint32_t operand = 0;
  std::uint32_t face = 0;
  friend bool operator==(const Source&, const Source&) = default;
};

}  // namespace strata
