#pragma once
/// Volume, area, topology, and the canonical form that makes solids comparable.
///
/// All functions are pure: they may be called from many threads at once, also for one mesh.
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "strata/mesh.h"
#include "strata/monitor.h"
#include "strata/options.h"
#include "strata/rational.h"

namespace strata {

/// Facts about a mesh that do not depend on its triangulation (but `open_edges`). Vertices with equal coordinates are
/// one vertex; triangles that repeat a vertex are left out.
struct Topology {
  std::uint64_t components = 0;             ///< connected over shared vertices (equal coordinates are one vertex)
  std::int64_t euler = 0;                   ///< V - E + F over used vertices, undirected edges and triangles
  std::uint64_t non_manifold_edges = 0;     ///< edges with more than two triangles
  std::uint64_t non_manifold_vertices = 0;  ///< vertices whose triangles do not form one fan over manifold edges
  std::uint64_t open_edges = 0;             ///< edges whose directed occurrences do not cancel
};

/// Signed volume: sum of det(a, b, c) / 6 over the triangles. Exact; positive when normals point outwards. Requires
/// indices in range and finite coordinates. Of a mesh that is not closed it depends on the origin. Laws: additive for
/// solids with disjoint interiors; multiplied by det under affine maps. O(n), on integers of fixed width where
/// coordinates allow it.
[[nodiscard]] Rational volume(ExactMeshView mesh);

/// The double nearest to `volume`, ties to even. Vertices are taken as sums of two doubles, whose error is bounded;
/// quotients are computed only where that does not decide, as for solids thinner than some 1e-10 of their size. O(n).
[[nodiscard]] double nearest_volume(ExactMeshView mesh);

/// Surface area, correct to a few units in the last place of a double. Requires indices in range and finite
/// coordinates. O(n).
[[nodiscard]] double area(const ExactMesh& mesh);

/// Requires indices in range. Any mesh: it need not be closed. O(n log d) for vertices of degree d.
[[nodiscard]] Topology topology(const ExactMesh& mesh);

/// What can be said about one mesh, from a few passes.
struct Measures {
  Topology topology;
  std::optional<double> volume;          ///< the nearest double; none if the mesh is not closed
  std::optional<Rational> exact_volume;  ///< of a closed mesh of which no more than 1,000 vertices are rational
  double area = 0;
  /// 0 if not counted. Sets of coplanar triangles of one orientation, connected over whole edges. Of the boundary of a
  /// solid whose triangles meet in whole edges these are the facets of its canonical form.
  std::uint64_t facets = 0;
};

/// The functions above at once, in parallel. Requires indices in range and finite coordinates. Of the options,
/// `threads` and `cancel` count; the result does not depend on threads. Throws Cancelled. O(n log d), and k^2 for k
/// triangles at one edge. Counting facets takes about half as long again.
[[nodiscard]] Measures measure(const ExactMesh& mesh, const Options& options = {}, bool count_facets = true);

/// An oriented plane a x + b y + c z = d with coprime integer coefficients; (a, b, c) points outwards.
struct CanonicalPlane {
  std::array<Integer, 4> coefficients;
  friend bool operator==(const CanonicalPlane&, const CanonicalPlane&) = default;
};

/// The boundary of all facets in one oriented plane: closed polygons with the interior on the left, seen from
/// outside. No vertex lies inside a straight side; polygons start at their smallest vertex and are sorted.
struct CanonicalFacets {
  CanonicalPlane plane;
  std::vector<std::vector<std::uint32_t>> loops;  ///< indices into CanonicalForm::vertices
};

/// The one description of a regular solid that does not depend on how its boundary is triangulated: maximal planar
/// facets, exact vertices in lexicographic order. Law: two solids are equal as point sets exactly when their canonical
/// forms are equal.
struct CanonicalForm {
  std::vector<RationalPoint> vertices;
  std::vector<CanonicalFacets> planes;

  [[nodiscard]] std::size_t facet_count() const;  ///< connected facets: the outer loops
  [[nodiscard]] std::size_t edge_count() const;   ///< sides of all loops, undirected, each counted once
  [[nodiscard]] std::string text() const;         ///< a complete, readable dump
  [[nodiscard]] std::uint64_t hash(
      const Monitor& monitor = {}) const;  ///< equal for equal forms; the same on every machine
  friend bool operator==(const CanonicalForm& a, const CanonicalForm& b);
};

/// A planar polygon with holes: loops of exact points, the interior on the left seen from outside.
using ExactFacet = std::vector<std::vector<RationalPoint>>;

/// Canonical form of a closed boundary. Facets may be triangles or polygons, split anyhow, with vertices inside each
/// other's sides (T-junctions); overlapping parts of opposite orientation cancel. Degenerate (zero-area) facets are
/// ignored. Requires that what is given is the boundary of a regular solid; for other closed surfaces the form is
/// unspecified. Throws Cancelled. O(n log n) exact comparisons.
[[nodiscard]] CanonicalForm canonical_form(const ExactMesh& mesh, const Monitor& monitor = {});
[[nodiscard]] CanonicalForm canonical_form(const std::vector<ExactFacet>& facets, const Monitor& monitor = {});

}  // namespace strata
