#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "core/mesh/prepare.h"
#include "core/overlap/embedded_stars.h"
#include "core/overlap/self_intersections.h"
#include "core/overlap/shells.h"
#include "strata/errors.h"
#include "strata/mesh.h"
#include "strata/monitor.h"

namespace strata {

/// What keeps a closed mesh from being the boundary of a solid: faces that intersect, and shells that do not enclose
/// what is inside them. Requires finite coordinates, valid indices, faces of positive area, and a closed chain. Equal
/// vertices may have different numbers. Runs in the current task arena. The mesh must outlive it. Throws Cancelled.
class Inspection {
 public:
  enum class Keeps : bool { pairs, intersections };

  /// O(n log n + pairs whose boxes overlap).
  Inspection(ExactMeshView mesh, const Monitor& monitor, Keeps keeps = Keeps::pairs);

  /// True when the mesh bounds a solid.
  [[nodiscard]] bool finds_nothing() const;

  /// As errors, or as notes on what is resolved; so many of each kind are listed. `source` maps to the caller's face
  /// numbers; empty: the same numbers.
  [[nodiscard]] std::vector<Defect> defects(Severity severity, const std::vector<std::uint32_t>& source,
                                            std::size_t listed = few_defects) const;

  /// What it knows of intersections, with each vertex as the first of its equals. Requires that it keeps intersections.
  [[nodiscard]] SelfCrossings take_crossings() && {
    return {std::move(*stars_), std::move(intersections_), std::move(met_)};
  }

 private:
  void find_windings(ExactMeshView mesh, const InputComplex& complex, const Monitor& monitor);

  ExactMeshView mesh_;
  std::optional<EmbeddedStars> stars_;
  std::vector<SelfIntersection> intersections_;
  std::vector<PairIntersections> met_;
  Shells shells_;                    ///< if there are no intersections
  std::vector<std::int32_t> above_;  ///< per shell
};

/// What a first look at a mesh finds.
struct FirstLook {
  bool is_solid = false;          ///< it bounds a solid and has none of the defects that preparation resolves
  std::optional<Inspection> all;  ///< what else there is to find, if preparation would not change the mesh
  std::optional<Box> bounds;      ///< of the vertices used, if computed

  /// What preparation makes of the mesh in either case.
  [[nodiscard]] Prepared unchanged() const { return {{}, {}, {}, bounds}; }
};

/// Looks at any mesh. A few streaming passes, and an Inspection. For a scattered mesh (is_scattered) it says only
/// whether it is a solid. `facts`: of this mesh, if known.
[[nodiscard]] FirstLook look_at(MeshView mesh, const Monitor& monitor,
                                Inspection::Keeps keeps = Inspection::Keeps::pairs, const Screening* facts = nullptr);

/// True when the winding numbers of a mesh are 0 and 1. Requires that no faces share a point other than vertices of the
/// same number and their edges, and what an Inspection does. `stars`: of this mesh, or null.
[[nodiscard]] bool windings_are_those_of_a_solid(MeshView mesh, const EmbeddedStars* stars, const Monitor& monitor);

/// True when no faces share a point other than vertices of the same number and their edges. The mesh need not be
/// closed; else the requirements of an Inspection.
[[nodiscard]] bool is_embedded_by_number(ExactMeshView mesh, const Monitor& monitor);

}  // namespace strata
