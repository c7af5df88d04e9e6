#include "core/csg/inspection.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "core/csg/shell_windings.h"
#include "core/exact/finite.h"
#include "core/mesh/defect_list.h"
#include "core/mesh/equal_vertices.h"
#include "core/mesh/gathered_mesh.h"
#include "core/mesh/prepare.h"
#include "core/overlap/embedded_stars.h"
#include "core/overlap/starlike.h"

namespace strata {
namespace {

std::string sentence(const SelfIntersection& s, std::uint32_t face, std::uint32_t other) {
  return "faces " + std::to_string(face) + " and " + std::to_string(other) +
         (s.is_coplanar ? " overlap in one plane" : " meet away from shared edges and vertices");
}

std::string sentence(std::uint32_t face, std::int32_t above) {
  return "the outer side of face " + std::to_string(face) + " has winding number " + std::to_string(above) +
         " and the inner side " + std::to_string(above + 1) + "; a solid has 0 and 1";
}

}  // namespace

// Faces that share equal vertices of different numbers intersect by these. So where nothing does, no vertices are
// equal, and only where something does, they are looked for.
Inspection::Inspection(ExactMeshView mesh, const Monitor& monitor, Keeps keeps) : mesh_(mesh) {
  std::vector<PairIntersections>* const met = keeps == Keeps::intersections ? &met_ : nullptr;
  const InputComplex complex = complex_of(mesh);
  stars_.emplace(complex, monitor);
  SelfIntersectionSearch search(complex, &*stars_);
  if (search.find(monitor, 1).empty()) {
    find_windings(mesh, complex, monitor);
    return;
  }

  const OnFirstVertices joined(mesh, monitor);
  if (joined.are_given()) {
    intersections_ = search.find(monitor, SelfIntersectionSearch::all, met);
    return;
  }
  const ExactMeshView on_first({mesh.mesh.vertices, joined.triangles()}, mesh.exact);
  const InputComplex complex_on_first = complex_of(on_first);
  stars_.emplace(complex_on_first, monitor);
  intersections_ = find_self_intersections(complex_on_first, &*stars_, monitor, SelfIntersectionSearch::all, met);
  if (intersections_.empty()) find_windings(on_first, complex_on_first, monitor);
}

void Inspection::find_windings(ExactMeshView mesh, const InputComplex& complex, const Monitor& monitor) {
  shells_ = find_shells(complex, *stars_);
  above_ = windings_above(mesh, shells_, monitor);
}

bool Inspection::finds_nothing() const {
  return intersections_.empty() && std::all_of(above_.begin(), above_.end(), [](int w) { return w == 0; });
}

std::vector<Defect> Inspection::defects(Severity severity, const std::vector<std::uint32_t>& source,
                                        std::size_t listed) const {
  const bool is_note = severity == Severity::note;
  const auto remedy = [&](const char* of_error) {
    return is_note ? "resolved: inside is where the winding number is positive" : of_error;
  };
  const auto number = [&](std::uint32_t f) { return source.empty() ? f : source[f]; };
  std::vector<Defect> defects;

  DefectList crossings(DefectKind::self_intersection, severity,
                       remedy("declare the input as overlapping, which resolves intersections exactly"), listed);
  for (const SelfIntersection& s : intersections_)
    crossings.add(s.at, {number(s.face), number(s.other)},
                  [&] { return sentence(s, number(s.face), number(s.other)); });
  crossings.append_to(defects);

  DefectList wrong(DefectKind::inside_out, severity,
                   remedy("reverse the faces of the shell, or declare the input as repair"), listed);
  for (std::uint32_t f = 0; f < shells_.of_face.size(); ++f)
    if (const std::int32_t above = above_[shells_.of_face[f]]; above != 0)
      wrong.add(mesh_.mesh.vertices[mesh_.mesh.triangles[f][0]], {number(f)},
                [&] { return sentence(number(f), above); });
  wrong.append_to(defects);
  return defects;
}

namespace {

bool needs_no_preparation(const Screening& facts) {
  return facts.finite && facts.indices_valid && facts.chain_closed && !facts.degenerate && facts.orientation > 0;
}

bool is_solid_by_number(MeshView mesh, const Monitor& monitor) {
  const InputComplex complex = complex_of(mesh);
  const EmbeddedStars stars(complex, monitor);
  return find_self_intersections(complex, &stars, monitor, 1).empty() &&
         windings_are_those_of_a_solid(mesh, &stars, monitor);
}

bool are_usable(MeshView mesh) {
  const auto is_valid = [&](const Triangle& t) { return std::max({t[0], t[1], t[2]}) < mesh.vertices.size(); };
  return std::all_of(mesh.triangles.begin(), mesh.triangles.end(), is_valid) &&
         std::all_of(mesh.vertices.begin(), mesh.vertices.end(), is_finite);
}

}  // namespace

FirstLook look_at(MeshView mesh, const Monitor& monitor, Inspection::Keeps keeps, const Screening* known) {
  if (mesh.triangles.empty()) return {};
  if (is_found_starlike(mesh, monitor)) return {true, {}, {}};
  const auto facts_of = [&](MeshView same) { return known != nullptr ? *known : screen(same, monitor); };
  if (is_scattered(mesh) && are_usable(mesh)) {
    const Mesh local = gathered(mesh, monitor);
    const Screening facts = facts_of(local);
    return {needs_no_preparation(facts) && is_solid_by_number(local, monitor), {}, facts.bounds};
  }
  const Screening facts = facts_of(mesh);
  if (!needs_no_preparation(facts)) return {};
  Inspection inspection({mesh, {}}, monitor, keeps);
  if (inspection.finds_nothing()) return {true, {}, facts.bounds};
  return {false, std::move(inspection), facts.bounds};
}

bool windings_are_those_of_a_solid(MeshView mesh, const EmbeddedStars* stars, const Monitor& monitor) {
  const ExactMeshView view(mesh, {});
  const InputComplex complex = complex_of(view);
  const Shells shells = find_shells(complex, stars != nullptr ? *stars : EmbeddedStars(complex, monitor));
  const std::vector<std::int32_t> above = windings_above(view, shells, monitor);
  return std::all_of(above.begin(), above.end(), [](int w) { return w == 0; });
}

bool is_embedded_by_number(ExactMeshView mesh, const Monitor& monitor) {
  const InputComplex complex = complex_of(mesh);
  std::optional<EmbeddedStars> stars;
  if (chain_is_closed(mesh.mesh)) stars.emplace(complex, monitor);
  return find_self_intersections(complex, stars ? &*stars : nullptr, monitor, 1).empty();
}

}  // namespace strata
