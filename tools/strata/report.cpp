#include "report.h"

#include <algorithm>
#include <cmath>

#include "common/tell.h"
#include "strata/check.h"
#include "strata/measure.h"

using strata::Defect;
using strata::ExactMesh;

namespace {

bool is_measurable(const ExactMesh& mesh) {
  const std::vector<strata::Vertex>& vertices = mesh.mesh.vertices;
  const auto is_finite = [](const strata::Vertex& v) {
    return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
  };
  const bool are_all_finite = std::ranges::all_of(vertices, is_finite);
  return std::ranges::all_of(mesh.mesh.triangles, [&](const strata::Triangle& t) {
    return std::ranges::all_of(
        t, [&](std::uint32_t v) { return v < vertices.size() && (are_all_finite || is_finite(vertices[v])); });
  });
}

/// Null for a mesh that cannot be measured.
Json to_json(std::uint64_t vertices, std::uint64_t triangles, const strata::Measures* measures) {
  Json facts = {{"vertices", vertices},  {"triangles", triangles}, {"volume", nullptr}, {"area", nullptr},
                {"components", nullptr}, {"euler", nullptr},       {"closed", nullptr}};
  if (measures == nullptr) return facts;
  facts["area"] = measures->area;
  facts["components"] = measures->topology.components;
  facts["euler"] = measures->topology.euler;
  facts["closed"] = measures->topology.open_edges == 0;
  if (measures->volume) facts["volume"] = *measures->volume;
  return facts;
}

strata::Measures measure(const ExactMesh& mesh, const Settings& settings, bool count_facets) {
  strata::Options options;
  options.threads = settings.threads;
  return strata::measure(mesh, options, count_facets);
}

}  // namespace

void print_notes(std::span<const Defect> notes, const Settings& settings) {
  if (settings.quiet) return;
  for (const Defect& note : notes) tell("strata: {}\n", strata::describe(note));
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

Json measures(const ExactMesh& mesh, const Settings& settings) {
  const std::size_t vertices = mesh.mesh.vertices.size(), triangles = mesh.mesh.triangles.size();
  if (!is_measurable(mesh)) return to_json(vertices, triangles, nullptr);
  const strata::Measures measures = measure(mesh, settings, false);
  return to_json(vertices, triangles, &measures);
}

Json operand_report(const LoadedMesh& operand, std::span<const Defect> defects, const Settings& settings) {
  Json report = {{"path", operand.path}};
  report.update(measures(operand.mesh, settings));
  report["defects"] = to_json(defects);
  return report;
}

strata::MeasuredBoundary measured(const ExactMesh& mesh, const Settings& settings) {
  return {mesh.mesh.vertices.size(), mesh.mesh.triangles.size(), measure(mesh, settings, true)};
}

Json result_report(const strata::MeasuredBoundary& result, std::optional<bool> rounded_valid) {
  const strata::Measures& measures = result.measures;
  Json report = to_json(result.vertices, result.triangles, &measures);
  report["touching_edges"] = measures.topology.non_manifold_edges;
  report["touching_vertices"] = measures.topology.non_manifold_vertices;
  report["facets"] = measures.facets;
  report["volume_exact"] = measures.exact_volume ? Json(measures.exact_volume->str()) : Json(nullptr);
  report["empty"] = result.triangles == 0;
  report["rounded_valid"] = rounded_valid ? Json(*rounded_valid) : Json(nullptr);
  return report;
}

Json operand_reports(std::span<const LoadedMesh> operands, const Settings& settings) {
  Json list = Json::array();
  for (const LoadedMesh& operand : operands)
    list.push_back(operand_report(operand, strata::defects_as_operand(operand.mesh, settings.input), settings));
  return list;
}

Json operand_reports(std::span<const LoadedMesh> operands, std::span<const Defect> notes, const Settings& settings) {
  if (!notes.empty()) return operand_reports(operands, settings);  // notes do not say whose they are
  Json list = Json::array();
  for (const LoadedMesh& operand : operands) list.push_back(operand_report(operand, {}, settings));
  return list;
}
