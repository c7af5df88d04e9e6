#include <tbb/parallel_for.h>

#include <atomic>
#include <cmath>
#include <stdexcept>

#include "core/exact/pace.h"
#include "core/kernel/predicates.h"
#include "core/kernel/rational_point.h"
#include "extensions/scene/scene_data.h"
#include "strata/errors.h"

namespace strata {
namespace {

Defect defect(DefectKind kind, const char* message, std::vector<std::uint32_t> faces = {}) {
  Defect d;
  d.kind = kind;
  d.message = message;
  d.faces = std::move(faces);
  d.remedy = "make a Solid of the mesh first; it names all defects and can repair some";
  return d;
}

void check_arrays(const Mesh& mesh, std::size_t solid, Pace& pace) {
  for (const Vertex& v : mesh.vertices)
    if (!std::isfinite(v[0]) || !std::isfinite(v[1]) || !std::isfinite(v[2]))
      throw InputError({defect(DefectKind::non_finite_coordinate, "a coordinate is not a finite number")}, solid);
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    pace.step();
    for (const std::uint32_t v : mesh.triangles[f])
      if (v >= mesh.vertices.size())
        throw InputError({defect(DefectKind::index_out_of_range, "a face names a vertex that does not exist",
                                 {static_cast<std::uint32_t>(f)})},
                         solid);
  }
}

void check_faces(const InputComplex& input, const Monitor& monitor) {
  std::atomic<std::uint32_t> worst{input.face_count()};
  tbb::parallel_for(std::uint32_t{0}, input.face_count(), [&](std::uint32_t f) {
    monitor.check();
    if (!is_degenerate(input, f)) return;
    std::uint32_t w = worst.load();
    while (f < w && !worst.compare_exchange_weak(w, f)) {
    }
  });
  if (worst == input.face_count()) return;
  const std::uint32_t solid = input.operand_of_face(worst);
  throw InputError({defect(DefectKind::degenerate_triangle, "a face has no area", {worst - input.first_face(solid)})},
                   solid);
}

}  // namespace

std::uint32_t Scene::solid_count() const { return data_->input.operand_count(); }
std::uint32_t Scene::face_count() const { return data_->input.face_count(); }
const ExactMesh& Scene::solid(std::uint32_t i) const { return data_->solids[i]; }
std::uint32_t Scene::solid_of(std::uint32_t face) const { return data_->input.operand_of_face(face); }
std::uint32_t Scene::local(std::uint32_t face) const {
  return face - data_->input.first_face(data_->input.operand_of_face(face));
}
std::uint32_t Scene::vertex_count() const { return data_->input.vertex_count(); }
const Vertex& Scene::vertex(std::uint32_t v) const { return data_->input.vertex(v); }
RationalPoint Scene::position(std::uint32_t v) const {
  if (const RationalPoint* exact = data_->input.exact(v)) return *exact;
  const Vertex& p = vertex(v);
  return to_rational(p);
}
Triangle Scene::face(std::uint32_t face) const { return data_->input.face(face); }

Scene::Scene(std::vector<ExactMesh> solids, const Monitor& monitor)
    : data_(Shared<Data>::make(std::move(solids), monitor)) {}

Scene::Data::Data(std::vector<ExactMesh> listed, const Monitor& monitor) : solids(std::move(listed)) {
  Pace pace(monitor);
  std::uint64_t vertices = 0, faces = 0;
  for (std::size_t i = 0; i < solids.size(); ++i) {
    const Mesh& mesh = solids[i].mesh;
    check_arrays(mesh, i, pace);
    vertices += mesh.vertices.size();
    faces += mesh.triangles.size();
  }
  if (vertices > 0xfffffffdu || faces > 0xfffffffdu)
    throw std::length_error("a scene of more than 2^32 - 3 vertices or faces");
  for (const ExactMesh& s : solids) input.add(s.mesh.vertices, s.mesh.triangles, s.exact);
  check_faces(input, monitor);
}

}  // namespace strata
