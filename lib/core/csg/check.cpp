#include "strata/check.h"

#include <algorithm>

#include "core/csg/arena.h"
#include "core/csg/found_class.h"
#include "core/csg/inspection.h"
#include "core/mesh/equal_vertices.h"
#include "core/mesh/prepare.h"
#include "core/mesh/zero_area.h"

namespace strata {
namespace {

template <class Body>
auto in_arena(const Options& options, const ExactMeshView& mesh, const Body& body) {
  const Arena arena = arena_for(options, mesh.mesh.triangles.size());
  return arena.execute(body);
}

bool is_error(const Defect& d) { return d.severity == Severity::error; }

/// True when coordinates are finite, indices in range, and areas positive.
bool has_sound_faces(ExactMeshView mesh) {
  const Screening facts = screen(mesh.mesh);
  if (!facts.finite || !facts.indices_valid) return false;
  if (mesh.exact.empty()) return !facts.degenerate;
  const ZeroAreaTest is_zero(mesh);
  for (std::size_t f = 0; f < mesh.mesh.triangles.size(); ++f)
    if (is_zero(f)) return false;
  return true;
}

}  // namespace

std::vector<Defect> check(MeshView mesh, const Options& options, std::size_t listed) {
  return check(ExactMeshView(mesh, {}), options, listed);
}

std::vector<Defect> check(ExactMeshView mesh, const Options& options, std::size_t listed) {
  return in_arena(options, mesh, [&] {
    const Monitor monitor(options.cancel);
    const FirstLook look = mesh.exact.empty() ? look_at(mesh.mesh, monitor) : FirstLook{};
    if (look.is_solid) return std::vector<Defect>{};
    if (look.all) return look.all->defects(Severity::error, {}, listed);
    std::vector<Defect> defects = diagnose(mesh, listed);
    if (std::any_of(defects.begin(), defects.end(), is_error) || mesh.mesh.triangles.empty()) return defects;
    const Prepared prepared = mesh.exact.empty() ? prepare_closed(mesh.mesh, true) : prepare_exact(mesh);
    const ExactMeshView ready(prepared.mesh ? MeshView(*prepared.mesh) : mesh.mesh, mesh.exact);
    const auto more = Inspection(ready, monitor).defects(Severity::error, prepared.source_face, listed);
    defects.insert(defects.end(), more.begin(), more.end());
    return defects;
  });
}

std::vector<Defect> defects_as_operand(const ExactMesh& mesh, InputClass input, const Options& options) try {
  return in_arena(options, mesh, [&] {
    const Operand operand{mesh.mesh, mesh.exact};
    std::vector<Defect> notes = input == InputClass::automatic
                                    ? find_class({&operand, 1}, Monitor(options.cancel)).notes
                                    : std::vector<Defect>{};
    Options as_operand = options;
    as_operand.input = input;
    const std::vector<Defect> prepared = prepare(mesh, as_operand).notes;
    notes.insert(notes.end(), prepared.begin(), prepared.end());
    return notes;
  });
} catch (const InputError& error) {
  return error.defects();
}

bool is_embedded(MeshView mesh, const Options& options) { return is_embedded(ExactMeshView(mesh, {}), options); }

bool is_embedded(ExactMeshView mesh, const Options& options) {
  return in_arena(options, mesh, [&] {
    const Monitor monitor(options.cancel);
    if (!has_sound_faces(mesh)) return false;
    if (is_embedded_by_number(mesh, monitor)) return true;
    const OnFirstVertices welded(mesh, monitor);
    return !welded.are_given() &&
           is_embedded_by_number({{mesh.mesh.vertices, welded.triangles()}, mesh.exact}, monitor);
  });
}

}  // namespace strata
