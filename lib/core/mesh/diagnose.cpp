#include <algorithm>
#include <utility>

#include "core/exact/pace.h"
#include "core/mesh/defect_list.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/equal_vertices.h"
#include "core/mesh/prepare.h"
#include "core/mesh/prepare_steps.h"
#include "core/mesh/zero_area.h"

namespace strata {
namespace {

/// A point in the interior of a triangle.
Vertex centre(MeshView mesh, const Triangle& t) {
  Vertex p;
  for (int i = 0; i < 3; ++i)
    p[i] = mesh.vertices[t[0]][i] / 3 + mesh.vertices[t[1]][i] / 3 + mesh.vertices[t[2]][i] / 3;
  return p;
}

/// The valid faces as a mesh of their own, with their numbers in the input.
struct SoundMesh {
  std::span<const Vertex> vertices;
  std::span<const ExactVertex> exact;
  SourcedTriangles faces;

  [[nodiscard]] MeshView view() const { return {vertices, faces.triangles}; }
  [[nodiscard]] ExactMeshView exact_view() const { return {view(), exact}; }
};

void find_zero_areas(const SoundMesh& mesh, std::vector<Defect>& defects, std::size_t listed, const Monitor& monitor) {
  const bool rational = !mesh.exact.empty();
  DefectList list(DefectKind::degenerate_triangle, rational ? Severity::error : Severity::note,
                  rational ? "remove the face and divide its neighbours: among rationals that is not done for you"
                           : "nothing to do: zero-area triangles are removed exactly, their neighbours divided",
                  listed);
  const ZeroAreaTest is_zero(mesh.exact_view());
  Pace pace(monitor);
  for (std::size_t i = 0; i < mesh.faces.triangles.size(); ++i) {
    pace.step();
    if (!is_zero(i)) continue;
    const std::uint32_t face = mesh.faces.sources[i];
    list.add(centre(mesh.view(), mesh.faces.triangles[i]), {face},
             [&] { return "face " + std::to_string(face) + " has zero area"; });
  }
  list.append_to(defects);
}

/// The smallest rotation: equal for triangles with the same vertices and orientation.
Triangle rotated(Triangle t) {
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

void find_duplicates(const SoundMesh& mesh, std::vector<Defect>& defects, std::size_t listed, const Monitor& monitor) {
  DefectList list(DefectKind::duplicate_face, Severity::error,
                  "remove all but one of these faces (input class repair does)", listed);
  const auto& triangles = mesh.faces.triangles;
  std::vector<std::uint32_t> order;
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    if (!repeats_vertex(triangles[i])) order.push_back(i);
  }
  Pace pace(monitor);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    pace.step();
    const Triangle s = rotated(triangles[a]), t = rotated(triangles[b]);
    return s != t ? s < t : a < b;
  });
  for (std::size_t i = 1; i < order.size(); ++i) {
    if (rotated(triangles[order[i]]) != rotated(triangles[order[i - 1]])) continue;
    const std::uint32_t first = mesh.faces.sources[order[i - 1]], second = mesh.faces.sources[order[i]];
    list.add(centre(mesh.view(), triangles[order[i]]), {first, second}, [&] {
      return "face " + std::to_string(second) + " repeats face " + std::to_string(first) +
             ", same vertices in the same sense";
    });
  }
  list.append_to(defects);
}

void find_inside_out(const SoundMesh& mesh, std::vector<Defect>& defects, const Monitor& monitor) {
  const Screening facts = screen(mesh.view(), monitor);
  const bool is_inside_out = mesh.exact.empty()
                                 ? facts.orientation < 0
                                 : facts.chain_closed && orientation(mesh.exact_view(), monitor) == Sign::negative;
  if (!is_inside_out) return;
  DefectList list(DefectKind::inside_out, Severity::error, "reverse all faces (input class repair does)");
  list.add({}, {}, [] { return std::string("the volume is negative: faces are clockwise seen from outside"); });
  list.append_to(defects);
}

/// Identifies equal vertices with the first of them.
void weld(SoundMesh& mesh, const Monitor& monitor) {
  const std::vector<std::uint32_t> first = equal_vertices(mesh.exact_view(), monitor);
  for (Triangle& t : mesh.faces.triangles) t = {first[t[0]], first[t[1]], first[t[2]]};
}

/// Removes `repair` and `soup` from the remedies, because they take doubles only.
void leave_out_repair(std::vector<Defect>& defects) {
  for (Defect& d : defects)
    for (const std::string_view mention : {" (input class repair does)", " (input class soup fills holes)"})
      if (d.remedy.ends_with(mention)) d.remedy.resize(d.remedy.size() - mention.size());
}

}  // namespace

std::vector<Defect> diagnose(MeshView mesh, std::size_t listed, const Monitor& monitor) {
  return diagnose(ExactMeshView(mesh, {}), listed, monitor);
}

std::vector<Defect> diagnose(ExactMeshView given, std::size_t listed, const Monitor& monitor) {
  const MeshView mesh = given.mesh;
  std::vector<Defect> defects;
  if (mesh.triangles.empty()) {
    DefectList list(DefectKind::empty_mesh, Severity::note, "nothing to do if the empty solid is meant");
    list.add({}, {}, [] { return std::string("the mesh has no faces"); });
    list.append_to(defects);
    return defects;
  }
  SoundMesh sound{mesh.vertices, given.exact, sound_faces(mesh, Severity::error, defects, listed, monitor)};
  find_zero_areas(sound, defects, listed, monitor);
  if (!screen(sound.view(), monitor)
           .chain_closed) {  // equal vertices that are listed several times do not count as an opening
    weld(sound, monitor);
  }
  find_duplicates(sound, defects, listed, monitor);
  find_open_edges(sound.vertices, sound.faces, defects, listed, monitor);
  find_inside_out(sound, defects, monitor);
  if (!given.exact.empty()) leave_out_repair(defects);
  return defects;
}

}  // namespace strata
