#include "strata/check.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "core/csg/arena.h"
#include "core/mesh/defect_list.h"
#include "core/mesh/equal_vertices.h"
#include "core/mesh/prepare.h"
#include "core/overlap/candidates.h"
#include "core/overlap/intersect.h"
#include "core/winding/local_windings.h"

namespace strata {
namespace {

/// The mesh with every triangle on the first of its equal vertices. Sheets that touch in a vertex then share it.
std::vector<Triangle> on_first_vertices(ExactMeshView mesh) {
  const auto first = equal_vertices(mesh);
  std::vector<Triangle> triangles(mesh.mesh.triangles.begin(), mesh.mesh.triangles.end());
  for (Triangle& t : triangles)
    for (std::uint32_t& v : t) v = first[v];
  return triangles;
}

/// A mesh as an input complex whose faces are all compared. `triangles` must outlive it.
InputComplex complex_of(ExactMeshView mesh, const std::vector<Triangle>& triangles) {
  InputComplex complex(SelfIntersections::possible);
  complex.add(mesh.mesh.vertices, triangles, mesh.exact);
  return complex;
}

/// The intersections of faces of a mesh other than shared edges and vertices, and the shells that do not enclose what
/// is inside them. Requires a closed mesh without degenerate triangles. `source` maps to the caller's face numbers;
/// empty: the same numbers.
class Inspection {
 public:
  Inspection(ExactMeshView mesh, const std::vector<std::uint32_t>& source, const Monitor& monitor)
      : triangles_(on_first_vertices(mesh)),
        candidates_(find_candidates(complex_of(mesh, triangles_), monitor)),
        input_(candidates_.input()),
        source_(source),
        monitor_(monitor) {}

  [[nodiscard]] std::vector<Defect> find() const {
    std::vector<Defect> defects = self_intersections(intersect(candidates_, monitor_));
    if (defects.empty()) defects = wrong_shells();
    return defects;
  }

 private:
  [[nodiscard]] std::uint32_t source(std::uint32_t f) const { return source_.empty() ? f : source_[f]; }

  [[nodiscard]] std::vector<Defect> self_intersections(const Intersections& intersections) const {
    DefectList list(DefectKind::self_intersection, Severity::error,
                    "declare the input as overlapping, which resolves intersections exactly");
    std::uint32_t f = 0, g = 0;
    for (const Constraint& c : intersections.constraints) {
      if (c.other < c.face || (list.count() > 0 && c.face == f && c.other == g)) continue;
      f = c.face;
      g = c.other;
      const Point p = intersections.points.point(c.tail);
      list.add(Vertex{p.at[0].value, p.at[1].value, p.at[2].value}, {source(f), source(g)}, [&] {
        return "faces " + std::to_string(source(f)) + " and " + std::to_string(source(g)) +
               (c.kind == ConstraintKind::coplanar ? " overlap in one plane"
                                                   : " meet away from shared edges and vertices");
      });
    }
    std::vector<Defect> defects;
    list.append_to(defects);
    return defects;
  }

  /// Without self-intersections, a face is right when the winding number just above it is 0.
  [[nodiscard]] std::vector<Defect> wrong_shells() const {
    const LocalWindings windings(input_, candidates_.cells());
    std::vector<std::int32_t> above(triangles_.size());
    tbb::parallel_for(std::uint32_t{0}, input_.face_count(), [&](std::uint32_t f) {
      monitor_.check();
      above[f] = windings.above(f, make_point(input_, SymbolicPoint::weighted(f, 1)), {&f, 1})[0];
    });
    DefectList list(DefectKind::inside_out, Severity::error,
                    "reverse the faces of the shell, or declare the input as repair");
    for (std::uint32_t f = 0; f < above.size(); ++f) {
      if (above[f] == 0) continue;
      list.add(input_.vertex(input_.face(f)[0]), {source(f)}, [&] {
        return "the outer side of face " + std::to_string(source(f)) + " has winding number " +
               std::to_string(above[f]) + " and the inner side " + std::to_string(above[f] + 1) +
               "; a solid has 0 and 1";
      });
    }
    std::vector<Defect> defects;
    list.append_to(defects);
    return defects;
  }

  std::vector<Triangle> triangles_;
  Candidates candidates_;
  const InputComplex& input_;
  const std::vector<std::uint32_t>& source_;
  const Monitor& monitor_;
};

template <class Body>
auto in_arena(const Options& options, const Body& body) {
  tbb::task_arena arena = arena_for(options);
  return arena.execute(body);
}

bool is_error(const Defect& d) { return d.severity == Severity::error; }

}  // namespace

std::vector<Defect> check(MeshView mesh, const Options& options) { return check(ExactMeshView(mesh, {}), options); }

std::vector<Defect> check(ExactMeshView mesh, const Options& options) {
  return in_arena(options, [&] {
    std::vector<Defect> defects = diagnose(mesh);
    if (std::any_of(defects.begin(), defects.end(), is_error) || mesh.mesh.triangles.empty()) return defects;
    const Monitor monitor(options.cancel);
    const Prepared prepared = mesh.exact.empty() ? prepare_closed(mesh.mesh, true) : prepare_exact(mesh);
    const ExactMeshView ready(prepared.mesh ? MeshView(*prepared.mesh) : mesh.mesh, mesh.exact);
    const auto more = Inspection(ready, prepared.source_face, monitor).find();
    defects.insert(defects.end(), more.begin(), more.end());
    return defects;
  });
}

std::vector<Defect> defects_as_operand(const ExactMesh& mesh, InputClass input) try {
  return prepare(mesh, input).notes;
} catch (const InputError& error) {
  return error.defects();
}

bool is_embedded(MeshView mesh, const Options& options) { return is_embedded(ExactMeshView(mesh, {}), options); }

bool is_embedded(ExactMeshView mesh, const Options& options) {
  return in_arena(options, [&] {
    for (const Defect& d : diagnose(mesh))
      if (d.kind == DefectKind::degenerate_triangle || d.kind == DefectKind::duplicate_face ||
          d.kind == DefectKind::non_finite_coordinate || d.kind == DefectKind::index_out_of_range)
        return false;
    const Monitor monitor(options.cancel);
    const std::vector<Triangle> triangles = on_first_vertices(mesh);
    return intersect(find_candidates(complex_of(mesh, triangles), monitor), monitor).pairs_meeting == 0;
  });
}

}  // namespace strata
