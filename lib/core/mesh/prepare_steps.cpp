#include "core/mesh/prepare_steps.h"

#include <algorithm>
#include <string>
#include <utility>

#include "core/exact/finite.h"
#include "core/exact/pace.h"
#include "core/mesh/defect_list.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/equal_vertices.h"

namespace strata {
namespace {

Vertex middle(const Vertex& a, const Vertex& b) {
  return {a[0] / 2 + b[0] / 2, a[1] / 2 + b[1] / 2, a[2] / 2 + b[2] / 2};
}

}  // namespace

SourcedTriangles sound_faces(MeshView mesh, Severity severity, std::vector<Defect>& defects, std::size_t listed,
                             const Monitor& monitor) {
  const bool dropped = severity == Severity::note;
  DefectList out_of_range(DefectKind::index_out_of_range, severity,
                          dropped ? "the face was dropped" : "remove the face or add the missing vertex", listed);
  DefectList non_finite(DefectKind::non_finite_coordinate, severity,
                        dropped ? "the face was dropped" : "give the vertex finite coordinates or remove the face",
                        listed);
  SourcedTriangles sound;
  Pace pace(monitor);
  for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) {
    pace.step();
    const Triangle& t = mesh.triangles[f];
    const auto outside = std::find_if(t.begin(), t.end(), [&](std::uint32_t v) { return v >= mesh.vertices.size(); });
    if (outside != t.end()) {
      out_of_range.add({}, {f}, [&] {
        return "face " + std::to_string(f) + " names vertex " + std::to_string(*outside) + ", the mesh has " +
               std::to_string(mesh.vertices.size());
      });
      continue;
    }
    const auto bad = std::find_if(t.begin(), t.end(), [&](std::uint32_t v) { return !is_finite(mesh.vertices[v]); });
    if (bad != t.end()) {
      non_finite.add(mesh.vertices[*bad], {f},
                     [&] { return "vertex " + std::to_string(*bad) + " has a coordinate that is no finite number"; });
      continue;
    }
    sound.add(t, f);
  }
  out_of_range.append_to(defects);
  non_finite.append_to(defects);
  return sound;
}

std::uint64_t weld(std::span<const Vertex> vertices, std::vector<Triangle>& triangles, const Monitor& monitor) {
  const std::vector<std::uint32_t> first = equal_vertices(vertices, monitor);
  std::uint64_t welded = 0;
  for (std::uint32_t v = 0; v < first.size(); ++v) welded += first[v] != v;
  for (Triangle& t : triangles) t = {first[t[0]], first[t[1]], first[t[2]]};
  return welded;
}

Defect weld_note(std::uint64_t welded) {
  Defect note;
  note.kind = DefectKind::open_edge;
  note.severity = Severity::note;
  note.count = welded;
  note.message =
      std::to_string(welded) + " vertices repeat the coordinates of others; the mesh is closed once they are one";
  note.remedy = "nothing to do: they were taken as one";
  return note;
}

Defect removal_note(MeshView mesh, const Removal& removal) {
  Defect note;
  note.kind = DefectKind::degenerate_triangle;
  note.severity = Severity::note;
  note.count = removal.removed.size();
  const std::uint32_t first = removal.removed.front();
  note.where = mesh.vertices[mesh.triangles[first][0]];
  note.faces.assign(removal.removed.begin(),
                    removal.removed.begin() + std::min<std::ptrdiff_t>(5, removal.removed.size()));
  note.message = std::to_string(removal.removed.size()) + " triangles of zero area were removed, " +
                 std::to_string(removal.divided) + " neighbours divided";
  note.remedy = "nothing to do: the surface is the same";
  return note;
}

void find_open_edges(std::span<const Vertex> vertices, const SourcedTriangles& faces, std::vector<Defect>& defects,
                     std::size_t listed, const Monitor& monitor) {
  DefectList open(DefectKind::open_edge, Severity::error,
                  "add the faces that are missing there, or remove loose ones (input class soup fills holes)", listed);
  DefectList turned(DefectKind::inconsistent_orientation, Severity::error,
                    "reverse the faces that run the same way along the edge (input class repair does)", listed);
  const auto table = edge_table(faces.triangles, vertices.size(), monitor);
  const auto visit = [&](std::span<const EdgeUse> uses) {
    const std::int64_t net = net_uses(uses);
    if (net == 0) return;
    std::vector<std::uint32_t> around;
    for (const EdgeUse& use : uses) around.push_back(faces.sources[use.triangle]);
    const auto message = [&] {
      const auto forward = static_cast<std::int64_t>(uses.size() + net) / 2;
      return "edge between vertices " + std::to_string(uses[0].low) + " and " + std::to_string(uses[0].high) + " has " +
             std::to_string(forward) + (forward == 1 ? " face" : " faces") + " along it and " +
             std::to_string(uses.size() - forward) + " against";
    };
    DefectList& list = uses.size() % 2 == 0 ? turned : open;
    list.add(middle(vertices[uses[0].low], vertices[uses[0].high]), std::move(around), message);
  };
  for_each_edge(table, visit, monitor);
  open.append_to(defects);
  turned.append_to(defects);
}

}  // namespace strata
