#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <compare>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/containers/collect.h"
#include "core/mesh/defect_list.h"
#include "core/mesh/equal_vertices.h"
#include "core/mesh/prepare.h"
#include "core/mesh/prepare_steps.h"
#include "core/mesh/vertex_stars.h"
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
  monitor.check();
  for (const std::uint32_t i : collect(mesh.faces.triangles.size(), [&](std::uint32_t f) { return is_zero(f); })) {
    const std::uint32_t face = mesh.faces.sources[i];
    list.add(centre(mesh.view(), mesh.faces.triangles[i]), {face},
             [&] { return "face " + std::to_string(face) + " has zero area"; });
  }
  list.append_to(defects);
}

/// A triangle at its lowest vertex.
struct Wedge {
  std::uint32_t next, last;  ///< its other vertices, in its sense
  std::uint32_t triangle;

  [[nodiscard]] bool repeats(const Wedge& other) const { return next == other.next && last == other.last; }
  friend auto operator<=>(const Wedge&, const Wedge&) = default;
};

/// Sorted, those of triangles whose lowest vertex this is.
void list_wedges(const VertexStars& stars, std::span<const Triangle> triangles, std::uint32_t vertex,
                 std::vector<Wedge>& wedges) {
  wedges.clear();
  for (const std::uint32_t f : stars.at(vertex)) {
    const Triangle& t = triangles[f];
    const std::size_t corner = t[0] == vertex ? 0 : t[1] == vertex ? 1 : 2;
    const Wedge wedge{t[(corner + 1) % 3], t[(corner + 2) % 3], f};
    if (vertex < wedge.next && vertex < wedge.last) wedges.push_back(wedge);
  }
  std::sort(wedges.begin(), wedges.end());
}

void find_duplicates(const SoundMesh& mesh, std::vector<Defect>& defects, std::size_t listed, const Monitor& monitor) {
  DefectList list(DefectKind::duplicate_face, Severity::error,
                  "remove all but one of these faces (input class repair does)", listed);
  const std::span<const Triangle> triangles = mesh.faces.triangles;
  const VertexStars stars(triangles, mesh.vertices.size(), monitor);
  const auto repeats = [](const Wedge& a, const Wedge& b) { return a.repeats(b); };
  tbb::enumerable_thread_specific<std::vector<Wedge>> of_thread;
  const std::vector<std::uint32_t> vertices = collect(mesh.vertices.size(), [&](std::uint32_t v) {
    std::vector<Wedge>& wedges = of_thread.local();
    list_wedges(stars, triangles, v, wedges);
    return std::adjacent_find(wedges.begin(), wedges.end(), repeats) != wedges.end();
  });
  std::vector<Wedge> wedges;
  for (const std::uint32_t v : vertices) {
    monitor.check();
    list_wedges(stars, triangles, v, wedges);
    for (std::size_t i = 1; i < wedges.size(); ++i) {
      if (!wedges[i].repeats(wedges[i - 1])) continue;
      const std::uint32_t first = mesh.faces.sources[wedges[i - 1].triangle],
                          second = mesh.faces.sources[wedges[i].triangle];
      list.add(centre(mesh.view(), triangles[wedges[i].triangle]), {first, second}, [&] {
        return "face " + std::to_string(second) + " repeats face " + std::to_string(first) +
               ", same vertices in the same sense";
      });
    }
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
  require_increasing_vertices(given);
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
