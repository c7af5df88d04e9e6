#include "report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "strata/check.h"
#include "strata/measure.h"

using strata::Defect;
using strata::ExactMesh;

namespace {

bool measurable(const ExactMesh& mesh) {
  const auto is_finite = [](double x) { return std::isfinite(x); };
  for (const strata::Triangle& t : mesh.mesh.triangles)
    for (const std::uint32_t v : t)
      if (v >= mesh.mesh.vertices.size() || !std::ranges::all_of(mesh.mesh.vertices[v], is_finite)) return false;
  return true;
}

/// Without a topology: of a mesh that cannot be measured.
Json measures(const ExactMesh& mesh, const std::optional<strata::Topology>& topology) {
  Json facts = {{"vertices", mesh.mesh.vertices.size()},
                {"triangles", mesh.mesh.triangles.size()},
                {"volume", nullptr},
                {"area", nullptr},
                {"components", nullptr},
                {"euler", nullptr},
                {"closed", nullptr}};
  if (!topology) return facts;
  facts["area"] = strata::area(mesh);
  facts["components"] = topology->components;
  facts["euler"] = topology->euler;
  facts["closed"] = topology->open_edges == 0;
  if (topology->open_edges == 0) facts["volume"] = strata::to_nearest_double(strata::volume(mesh));
  return facts;
}

}  // namespace

void print_notes(std::span<const Defect> notes, const Settings& settings) {
  if (settings.quiet) return;
  for (const Defect& note : notes) fmt::print(stderr, "strata: {}\n", strata::describe(note));
}

Json to_json(const Defect& defect) {
  return {{"kind", strata::name(defect.kind)},
          {"severity", strata::name(defect.severity)},
          {"where", defect.where ? Json(*defect.where) : Json(nullptr)},
          {"faces", defect.faces},
          {"count", defect.count},
          {"message", defect.message},
          {"remedy", defect.remedy}};
}

Json to_json(std::span<const Defect> defects) {
  Json list = Json::array();
  for (const Defect& defect : defects) list.push_back(to_json(defect));
  return list;
}

Json measures(const ExactMesh& mesh) {
  return measurable(mesh) ? measures(mesh, strata::topology(mesh)) : measures(mesh, std::nullopt);
}

Json operand_report(const LoadedMesh& operand, std::span<const Defect> defects) {
  Json report = {{"path", operand.path}};
  report.update(measures(operand.mesh));
  report["defects"] = to_json(defects);
  return report;
}

Json result_report(const ExactMesh& mesh, std::optional<bool> rounded_valid) {
  const strata::Topology topology = strata::topology(mesh);
  Json report = measures(mesh, topology);
  report["touching_edges"] = topology.non_manifold_edges;
  report["touching_vertices"] = topology.non_manifold_vertices;
  report["facets"] = strata::canonical_form(mesh).facet_count();
  report["volume_exact"] = strata::volume(mesh).str();
  report["empty"] = mesh.mesh.triangles.empty();
  report["rounded_valid"] = rounded_valid ? Json(*rounded_valid) : Json(nullptr);
  return report;
}

Json operand_reports(std::span<const LoadedMesh> operands, strata::InputClass input) {
  Json list = Json::array();
  for (const LoadedMesh& operand : operands)
    list.push_back(operand_report(operand, strata::defects_as_operand(operand.mesh, input)));
  return list;
}
