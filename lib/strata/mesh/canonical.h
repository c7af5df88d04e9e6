#pragma once
#include <array>
#include <compare>
#include <cstdint>
#include <string>
#include <vector>

#include "strata/exact/rational.h"
#include "strata/mesh/exact_mesh.h"

namespace strata {

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

/// The one description of a regular solid that does not depend on how its boundary is triangulated:
/// maximal planar facets, exact vertices in lexicographic order. Two solids are equal as point sets exactly
/// when their canonical forms are equal.
struct CanonicalForm {
  std::vector<RationalPoint> vertices;
  std::vector<CanonicalFacets> planes;

  [[nodiscard]] std::size_t facet_count() const;  ///< connected facets: the outer loops
  [[nodiscard]] std::size_t edge_count() const;   ///< sides of all loops, undirected, each counted once
  [[nodiscard]] std::string text() const;         ///< a complete, readable dump
  [[nodiscard]] std::uint64_t hash() const;
  friend bool operator==(const CanonicalForm& a, const CanonicalForm& b);
};

/// A planar polygon with holes: loops of exact points, the interior on the left seen from outside.
using ExactFacet = std::vector<std::vector<RationalPoint>>;

/// Canonical form of a closed boundary.
/// Facets may be triangles or polygons, split anyhow, with vertices inside each other's sides (T-junctions);
/// overlapping parts of opposite orientation cancel. Degenerate (zero-area) facets are ignored.
/// O(n log n) exact comparisons.
[[nodiscard]] CanonicalForm canonical_form(const ExactMesh& mesh);
[[nodiscard]] CanonicalForm canonical_form(const std::vector<ExactFacet>& facets);

}  // namespace strata
