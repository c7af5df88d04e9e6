#include "extensions/contact/face_proof.h"

#include "core/kernel/predicates.h"
#include "extensions/contact/common_points.h"

namespace strata::contact {
namespace {

bool has_vertex_below(const InputComplex& input, const FilteredFace& plane, const FilteredFace& face) {
  const Signs quick = plane.sides_of(face);
  for (const Sign s : quick)
    if (s == Sign::negative) return true;
  const auto& [a, b, c] = plane.vertices;
  for (std::size_t i = 0; i < 3; ++i)
    if (quick[i] == Sign::zero && orient3d(input, a, b, c, face.vertices[i]) == Sign::negative) return true;
  return false;
}

}  // namespace

std::optional<SoleFaces> prove_interference(const InputComplex& input, const FilteredFace& f, const FilteredFace& g,
                                            const PairIntersections& intersections) {
  const auto when = [](bool holds, SoleFaces sole) { return holds ? std::optional(sole) : std::nullopt; };
  if (are_coplanar(intersections))
    return when(same_orientation(input, f.face, g.face) == Sign::positive && share_area(input, intersections),
                {.first = true, .second = true});
  const Constraint &on_f = intersections.constraints.front(), &on_g = intersections.constraints.back();
  if (on_f.kind == ConstraintKind::point) return std::nullopt;
  if (!on_f.line.edge) return SoleFaces{.first = true, .second = true, .either = true};
  if (on_f.kind == on_g.kind) return std::nullopt;
  // One face is below the other with an edge in the other's interior, unless the other one has an edge on that edge and
  // is above.
  if (on_f.kind == ConstraintKind::touch) return when(has_vertex_below(input, g, f), {.first = true});
  return when(has_vertex_below(input, f, g), {.second = true});
}

}  // namespace strata::contact
