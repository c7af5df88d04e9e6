#include "extensions/contact/face_proof.h"

#include "core/kernel/predicates.h"
#include "extensions/contact/common_points.h"

namespace strata::contact {
namespace {

bool has_vertex_below(const Carriers& carriers, const FilteredFace& plane, const FilteredFace& face) {
  const Signs quick = plane.sides_of(face);
  for (const Sign s : quick)
    if (s == Sign::negative) return true;
  const auto& [a, b, c] = plane.vertices;
  for (std::size_t i = 0; i < 3; ++i)
    if (quick[i] == Sign::zero && orient3d(carriers, a, b, c, face.vertices[i]) == Sign::negative) return true;
  return false;
}

}  // namespace

std::optional<SoleFaces> prove_interference(const Carriers& carriers, const FilteredFace& f, const FilteredFace& g,
                                            const Meetings& meetings) {
  const auto when = [](bool holds, SoleFaces sole) { return holds ? std::optional(sole) : std::nullopt; };
  if (are_coplanar(meetings))
    return when(same_orientation(carriers, f.face, g.face) == Sign::positive && share_area(carriers, meetings),
                {.first = true, .second = true});
  const Constraint &on_f = meetings.constraints.front(), &on_g = meetings.constraints.back();
  if (on_f.kind == ConstraintKind::point) return std::nullopt;
  if (!on_f.line.edge) return SoleFaces{.first = true, .second = true, .either = true};
  if (on_f.kind == on_g.kind) return std::nullopt;
  // One face hangs below the other by an edge: inside of it, unless that one stands upon the edge by one of its own.
  if (on_f.kind == ConstraintKind::touch) return when(has_vertex_below(carriers, g, f), {.first = true});
  return when(has_vertex_below(carriers, f, g), {.second = true});
}

}  // namespace strata::contact
