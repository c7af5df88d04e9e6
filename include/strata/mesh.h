#pragma once
/// Triangle meshes as plain arrays, with coordinates in doubles or in rationals.
///
/// Coordinates are in model units and are taken exactly as given. No type here has an invariant; what a mesh must be is
/// said where it is used.
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

/// The exact place of one vertex whose coordinates are not three doubles.
struct ExactVertex {
  std::uint32_t vertex = 0;
  RationalPoint position;
};

/// A triangle mesh whose vertices are rationals. `mesh` holds every coordinate rounded to the nearest double;
/// `exact` lists the vertices for which that changed something, in increasing order of index.
struct ExactMesh {
  Mesh mesh;
  std::vector<ExactVertex> exact;

  [[nodiscard]] RationalPoint position(std::uint32_t vertex) const;  ///< O(log exact.size()).
};

/// An exact mesh that someone else owns; valid as long as the arrays it looks at.
struct ExactMeshView {
  MeshView mesh;
  std::span<const ExactVertex> exact;

  ExactMeshView() = default;
  ExactMeshView(MeshView m, std::span<const ExactVertex> e) : mesh(m), exact(e) {}
  ExactMeshView(const ExactMesh& m) : mesh(m.mesh), exact(m.exact) {}  // NOLINT: a view of a mesh is implicit

  [[nodiscard]] RationalPoint position(std::uint32_t vertex) const;  ///< O(log exact.size()).
};

/// Where an output triangle comes from: operand and face number there, both from 0.
struct Source {
  std::uint32_t operand = 0;
  std::uint32_t face = 0;
  friend bool operator==(const Source&, const Source&) = default;
};

}  // namespace strata
