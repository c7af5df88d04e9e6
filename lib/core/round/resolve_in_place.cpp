#include "core/round/resolve_in_place.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include "core/kernel/input_complex.h"
#include "core/mesh/edge_table.h"
#include "core/overlap/intersect.h"
#include "core/round/rounding.h"
#include "core/select/extract.h"
#include "core/select/label.h"
#include "core/select/subdivide.h"
#include "core/winding/ray_windings.h"

namespace strata {
namespace {

using Index = std::uint32_t;
constexpr Index no_face = std::numeric_limits<Index>::max();

/// The first face of each patch that is not known, in the order of the patches; none for others.
std::vector<Index> first_faces(const FacePatches& patches) {
  std::vector<Index> first(patches.is_known.size(), no_face);
  for (std::size_t n = 0; n < patches.faces.size(); ++n)
    if (Index& f = first[patches.patch[n]]; f == no_face && !patches.is_known[patches.patch[n]]) f = patches.faces[n];
  return first;
}

class Resolving {
 public:
  Resolving(MovingMesh& mesh, std::span<const std::pair<Index, Index>> crossings, const FacePatches& patches,
            const Monitor& monitor)
      : mesh_(mesh), monitor_(monitor), complex_(complex_of(mesh.mesh())) {
    std::vector<SelfIntersection> pairs;
    for (const auto& [face, other] : crossings) {
      pairs.push_back({face, other});
      gone_.insert(gone_.end(), {face, other});
    }
    std::sort(gone_.begin(), gone_.end());
    gone_.erase(std::unique(gone_.begin(), gone_.end()), gone_.end());
    Intersections intersections = intersect(complex_, pairs, monitor);

    const std::vector<Index> first = first_faces(patches);
    std::vector<Index> asked = gone_;
    std::copy_if(first.begin(), first.end(), std::back_inserter(asked), [](Index f) { return f != no_face; });
    const RayWindings windings(complex_, asked);
    const Rule rule = Rule::of_one(Inside::winding);
    const Classifier classifier{rule, windings};
    Subdivision subdivision = subdivide(complex_, std::move(intersections), classifier, monitor);

    std::vector<Verdict> verdicts(complex_.face_count(), Verdict::drop);
    for (const Index f : faces_without_constraints(subdivision)) verdicts[f] = label(complex_, f, classifier);
    take_out(patches, first, classifier);
    pieces_ = extract(complex_, verdicts, std::move(subdivision), monitor);
  }

  [[nodiscard]] std::optional<std::vector<VertexMove>> finish(const GridRounding& grid) && {
    const std::vector<PartOfTriangle> parts = parts_of_mesh();
    if (!fit(parts)) return std::nullopt;
    const std::vector<Vertex> points = round_to_doubles(complex_, pieces_, monitor_);
    std::vector<bool> is_rounded(points.size(), false);
    for (const Index v : rounded_vertices(complex_, pieces_, points, monitor_)) is_rounded[v] = true;

    std::vector<VertexMove> moves;
    for (std::size_t v = pieces_.inputs.size(); v < points.size(); ++v) {
      const Index number = mesh_.add_vertex(points[v]);
      if (is_rounded[v] || !grid.holds(points[v]))
        moves.push_back(move_to_grid(number, points[v], is_rounded[v], grid));
    }
    mesh_.resolve(gone_, parts);
    return moves;
  }

 private:
  /// Faces that cross others only where vertices are.
  [[nodiscard]] std::vector<Index> faces_without_constraints(const Subdivision& subdivision) const {
    std::vector<Index> divided, others;
    for (const SubdividedFace& s : subdivision.faces) divided.push_back(s.face);
    std::set_difference(gone_.begin(), gone_.end(), divided.begin(), divided.end(), std::back_inserter(others));
    return others;
  }

  /// Faces of patches that do not bound the set are gone.
  void take_out(const FacePatches& patches, const std::vector<Index>& first, const Classifier& classifier) {
    std::vector<bool> is_dropped(first.size(), false);
    for (std::size_t p = 0; p < first.size(); ++p) {
      monitor_.check();
      is_dropped[p] = first[p] != no_face && label(complex_, first[p], classifier) == Verdict::drop;
    }
    for (std::size_t n = 0; n < patches.faces.size(); ++n)
      if (is_dropped[patches.patch[n]]) gone_.push_back(patches.faces[n]);
    std::sort(gone_.begin(), gone_.end());
  }

  /// By numbers of the mesh. New vertices come after its own.
  [[nodiscard]] std::vector<PartOfTriangle> parts_of_mesh() const {
    const auto number = [&](Index v) {
      const std::size_t inputs = pieces_.inputs.size();
      return v < inputs ? pieces_.inputs[v] : static_cast<Index>(complex_.vertex_count() + (v - inputs));
    };
    std::vector<PartOfTriangle> parts;
    for (std::size_t n = 0; n < pieces_.triangles.size(); ++n) {
      const auto& [a, b, c] = pieces_.triangles[n];
      parts.push_back({{number(a), number(b), number(c)}, pieces_.sources[n].face});
    }
    return parts;
  }

  /// Does what is put in have the boundary of what is taken out?
  [[nodiscard]] bool fit(std::span<const PartOfTriangle> parts) const {
    std::vector<Triangle> chain;
    for (const PartOfTriangle& part : parts) chain.push_back(part.corners);
    for (const Index f : gone_) {
      const auto& [a, b, c] = mesh_.mesh().triangles[f];
      chain.push_back({a, c, b});
    }
    const std::size_t vertices = complex_.vertex_count() + pieces_.constructed.size();
    bool is_closed = true;
    for_each_edge(edge_table(chain, vertices),
                  [&](std::span<const EdgeUse> uses) { is_closed = is_closed && net_uses(uses) == 0; });
    return is_closed;
  }

  MovingMesh& mesh_;
  const Monitor& monitor_;
  InputComplex complex_;
  std::vector<Index> gone_;  ///< by increasing number
  Boundary pieces_{
      .inputs = {}, .constructed = {}, .triangles = {}, .sources = {}, .covers = {}, .points = PointTable(complex_)};
};

}  // namespace

std::optional<std::vector<VertexMove>> resolve_in_place(MovingMesh& mesh,
                                                        std::span<const std::pair<Index, Index>> crossings,
                                                        const FacePatches& patches, const GridRounding& grid,
                                                        const Monitor& monitor) {
  return Resolving(mesh, crossings, patches, monitor).finish(grid);
}

}  // namespace strata
