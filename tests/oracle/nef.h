#pragma once
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "strata/csg/options.h"
#include "strata/mesh/canonical.h"
#include "strata/mesh/exact_mesh.h"

namespace strata::oracle {

/// CGAL refused or contradicted itself: the oracle has no answer. An outcome of its own, never a pass.
class OracleFailed : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Ways to one and the same solid. CGAL 5.5 sometimes crashes or answers wrongly on one of them.
enum class Way {
  regularize_once,   ///< operands in order, regularized at the end: results differ by nowhere dense sets until then
  regularize_often,  ///< operands in order, regularized after every step
  backwards,         ///< the operands in reverse (a difference: what is taken away in reverse)
};

/// A regular solid as a CGAL Nef polyhedron.
///
/// Built without any code of the library: every closed, manifold and embedded sheet of the boundary becomes a
/// polyhedron and these are joined by symmetric difference, because a point is inside exactly when it is inside
/// an odd number of sheets (winding numbers are 0 and 1). A boundary that cannot be divided into such sheets is
/// joined from the tetrahedra over its faces, by the same parity. Hence cavities, parts that touch, and edges and
/// vertices shared by several sheets need no case of their own.
class NefSolid {
 public:
  /// The solid bounded by `mesh`: closed, winding numbers 0 and 1. Throws OracleFailed.
  explicit NefSolid(const ExactMesh& mesh);

  /// The same solid by parity of tetrahedra alone; slow, an independent second way. Throws OracleFailed.
  [[nodiscard]] static NefSolid from_tetrahedra(const ExactMesh& mesh);

  /// Boundary facets, outwards, interior on the left. Throws OracleFailed.
  [[nodiscard]] std::vector<ExactFacet> facets() const;

  /// Regularized: the closure of the interior. Throws OracleFailed.
  friend NefSolid nef_combine(Operation operation, std::span<const NefSolid> operands, Way way);

 private:
  struct Data;
  explicit NefSolid(std::shared_ptr<const Data> data);
  std::shared_ptr<const Data> data_;
};

[[nodiscard]] NefSolid nef_combine(Operation operation, std::span<const NefSolid> operands,
                                   Way way = Way::regularize_once);

/// Canonical form of the regularized Boolean, by CGAL. Throws OracleFailed.
[[nodiscard]] CanonicalForm nef_boolean(Operation operation, std::span<const ExactMesh> operands,
                                        Way way = Way::regularize_once);

/// Signed volume enclosed by facets: sum over the triangles of a fan of every loop. Exact.
[[nodiscard]] Rational facet_volume(const std::vector<ExactFacet>& facets);

}  // namespace strata::oracle
