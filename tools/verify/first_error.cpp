#include "verify/first_error.h"

#include "strata/check.h"

namespace verify {

std::string first_error(const strata::ExactMesh& mesh) {
  if (mesh.mesh.triangles.empty()) return {};
  strata::Options options;
  options.threads = 1;
  const auto defects = mesh.exact.empty() ? strata::check(strata::MeshView(mesh.mesh), options)
                                          : strata::check(strata::ExactMeshView(mesh), options);
  for (const strata::Defect& d : defects)
    if (d.severity == strata::Severity::error) return strata::describe(d);
  return {};
}

}  // namespace verify
