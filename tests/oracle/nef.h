#pragma once
#include <array>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "strata/measure.h"
#include "strata/mesh.h"
#include "strata/options.h"

namespace strata::oracle {

/// What two solids have in common, of which no dimension is told again by a lower one: facets of which the interiors
/// are apart, edges on no facet, isolated vertices.
struct NefContact {
  bool interiors_meet = false;
  std::vector<ExactFacet> facets;  ///< seen from either side
  std::vector<std::array<RationalPoint, 2>> edges;
  std::vector<RationalPoint> vertices;
};

/// CGAL refused or contradicted itself: the oracle has no answer. An outcome of its own, never a pass.
class OracleFailed : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Ways to one and the same solid. CGAL 5.5 sometimes crashes or answers wrongly on one of them.
enum class Way {
  in_order,       ///< operands in order, never regularized: the facets between inside and outside are the same
  regularized,    ///< operands in order, CGAL's regularization after every step
  backwards,      ///< the operands in reverse (a difference: what is taken away in reverse)
  other_formula,  ///< every step by two operations that come to the same: a - b as a ^ (a & b), and so on
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

  /// The facets with the inside behind them and the outside in front, outwards, interior on the left: walls and
  /// whatever dangles have the same on both sides and are left out. Throws OracleFailed.
  [[nodiscard]] std::vector<ExactFacet> facets() const;

  /// As a regular solid: facets() gives the boundary of the closure of the interior. Throws OracleFailed.
  friend NefSolid nef_combine(Operation operation, std::span<const NefSolid> operands, Way way);
  friend NefSolid nef_minkowski_sum(const NefSolid& a, const NefSolid& b);
  friend NefContact nef_contact(const NefSolid& a, const NefSolid& b);

 private:
  struct Data;
  explicit NefSolid(std::shared_ptr<const Data> data);
  std::shared_ptr<const Data> data_;
};

[[nodiscard]] NefSolid nef_combine(Operation operation, std::span<const NefSolid> operands, Way way = Way::in_order);

/// By CGAL::minkowski_sum_3. Throws OracleFailed.
[[nodiscard]] NefSolid nef_minkowski_sum(const NefSolid& a, const NefSolid& b);

/// Whether the intersection of the interiors of two solids is not empty; if it is, that of their boundaries. Of the
/// regularizations of both, since sheets that were joined leave walls. Throws OracleFailed.
[[nodiscard]] NefContact nef_contact(const NefSolid& a, const NefSolid& b);

/// Canonical form of the regularized Boolean, by CGAL. Throws OracleFailed.
[[nodiscard]] CanonicalForm nef_boolean(Operation operation, std::span<const ExactMesh> operands,
                                        Way way = Way::in_order);

/// Signed volume enclosed by facets: sum over the triangles of a fan of every loop. Exact.
[[nodiscard]] Rational facet_volume(const std::vector<ExactFacet>& facets);

}  // namespace strata::oracle
