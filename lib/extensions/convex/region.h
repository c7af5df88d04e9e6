#pragma once
#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "extensions/convex/cell.h"
#include "extensions/convex/wedges.h"
#include "strata/options.h"

namespace strata::convex {

/// A solid's boundary, prepared for division: triangles, wedges between them, planes that resolve reflex wedges.
struct PreparedBoundary {
  /// Throws std::invalid_argument where a triangle has no area, Cancelled.
  PreparedBoundary(ExactMeshView mesh, const Monitor& monitor);

  HyperplaneTable<3> table;
  bsp::BoxPlanes box;                 ///< the solid is strictly within
  std::vector<bsp::Facet<3>> facets;  ///< the triangles
  std::vector<Wedge> wedges;
  std::vector<std::vector<std::uint32_t>> cut_planes;  ///< by wedge (`cut_planes`)

  [[nodiscard]] std::uint32_t plane_of(std::uint32_t triangle) const { return facets[triangle].piece.hyperplane; }
};

/// The part of a triangle of the boundary in a region.
struct Face {
  std::uint32_t triangle = 0;
  const bsp::Piece<3>* part = nullptr;  ///< the facet of the boundary, or of a workspace
};

/// A wedge whose edge passes through a region, or along its walls with both faces inside.
struct Edge {
  std::uint32_t wedge = 0;
  std::array<HyperplaneMeet<3>, 2> ends;
};

/// A convex part of space and the parts of a solid's boundary in it.
struct Region {
  Cell cell;
  std::vector<Face> faces;
  std::vector<Edge> edges;
};

/// Data shared by the regions of one boundary during division: parts of faces, and memory for marks, which is reused
/// from call to call. Regions are valid as long as it exists. For one thread.
struct Workspace {
  explicit Workspace(const PreparedBoundary& boundary);

  std::deque<bsp::Piece<3>> parts;
  std::vector<bsp::Lie> lies;            ///< by triangle
  std::vector<std::uint32_t> parents;    ///< by triangle
  std::vector<std::uint32_t> of_planes;  ///< by plane; zeros between calls
};

/// The whole box about the solid.
[[nodiscard]] Region whole_region(const PreparedBoundary& boundary, CellMaker& maker);

/// Both sides of a plane through a region. A side without faces is inside or outside as a whole.
struct RegionSides {
  Region minus, plus;
  bool is_minus_inside = true, is_plus_inside = true;  ///< of sides without faces
};

/// Divides a region by a plane that contains one of its reflex edges or some of its faces. Edges in the plane are
/// resolved and left out, unless their wedge is on one side as a whole. O(size).
[[nodiscard]] RegionSides split(const PreparedBoundary& boundary, CellMaker& maker, Workspace& workspace,
                                const Region& region, std::uint32_t plane);

/// A plane that divides a region well: among some planes through its reflex edges, the one that resolves most of them
/// and divides few edges and faces; without reflex edges, a plane of a face between connected components of the
/// boundary. Nullopt if the boundary is connected and has no reflex edges: then the part of the region inside the solid
/// is convex. O(size * candidates), of which there are at most 128.
[[nodiscard]] std::optional<std::uint32_t> choose_cut(const PreparedBoundary& boundary, Workspace& workspace,
                                                      const Region& region);

/// The part of a region inside the solid, where `choose_cut` finds nothing to divide. O(faces * facets of the cell +
/// squares of sides of facets).
[[nodiscard]] Cell inside_of(const PreparedBoundary& boundary, CellMaker& maker, const Region& region,
                             const Monitor& monitor);

}  // namespace strata::convex
