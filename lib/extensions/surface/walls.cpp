#include "extensions/surface/walls.h"

#include <utility>

#include "core/kernel/predicates.h"
#include "core/overlap/intersect.h"
#include "core/round/rounding.h"
#include "core/select/label.h"
#include "core/select/subdivide.h"
#include "core/winding/local_windings.h"

namespace strata {
namespace {

InputComplex complex_of(std::span<const Surface> surfaces) {
  InputComplex complex(SelfIntersections::possible);
  for (const Surface& s : surfaces) {
    const ExactMesh& mesh = s.exact_mesh();
    complex.add(mesh.mesh.vertices, mesh.mesh.triangles, mesh.exact);
  }
  return complex;
}

/// All faces, divided: the stages of a Boolean, with a rule that keeps everything.
Boundary divide(const Candidates& candidates, const Monitor& monitor) {
  const InputComplex& input = candidates.input();
  const LocalWindings unused(input, candidates.cells());
  const Rule rule = Rule::every_wall();
  const Classifier classifier{rule, unused};
  Subdivision subdivision = subdivide(input, intersect(candidates, monitor), classifier, monitor);
  const std::vector<Verdict> verdicts = label(input, subdivision, classifier, monitor);
  return extract(input, verdicts, std::move(subdivision), monitor);
}

}  // namespace

Walls::Walls(std::span<const Surface> surfaces, const Monitor& monitor)
    : candidates_(find_candidates(complex_of(surfaces), monitor)), boundary_(divide(candidates_, monitor)) {}

Source Walls::source(std::uint32_t face) const {
  const std::uint32_t operand = input().operand_of_face(face);
  return {operand, face - input().first_face(operand)};
}

bool Walls::is_reversed(const Cover& cover) const {
  return same_orientation(input(), face(cover.triangle), cover.face) == Sign::negative;
}

ExactMesh Walls::mesh(const Monitor& monitor) const {
  ExactMesh mesh;
  mesh.mesh.vertices = round_to_doubles(input(), boundary_, monitor);
  mesh.exact = exact_positions(input(), boundary_, mesh.mesh.vertices, monitor);
  mesh.mesh.triangles = boundary_.triangles;
  return mesh;
}

}  // namespace strata
