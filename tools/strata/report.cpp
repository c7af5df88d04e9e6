#include "report.h"

#include <sys/resource.h>

#include "core/mesh/prepare.h"
#include "strata/measure.h"

using strata::Defect;
using strata::ExactMesh;

namespace {

bool measurable(const ExactMesh& mesh) {
  const strata::Screening seen = strata::screen(mesh.mesh);
  return seen.finite && seen.indices_valid;
}

}  // namespace

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
  Json facts = {{"vertices", mesh.mesh.vertices.size()},
                {"triangles", mesh.mesh.triangles.size()},
                {"volume", nullptr},
                {"area", nullptr},
                {"components", nullptr},
                {"euler", nullptr},
                {"closed", nullptr}};
  if (!measurable(mesh)) return facts;
  const strata::Topology topology = strata::topology(mesh);
  facts["area"] = strata::area(mesh);
  facts["components"] = topology.components;
  facts["euler"] = topology.euler;
  facts["closed"] = topology.open_edges == 0;
  if (topology.open_edges == 0) facts["volume"] = strata::to_nearest_double(strata::volume(mesh));
  return facts;
}

Json operand_report(const LoadedMesh& operand, std::span<const Defect> defects) {
  Json report = {{"path", operand.path}};
  report.update(measures(operand.mesh));
  report["defects"] = to_json(defects);
  return report;
}

Json result_report(const ExactMesh& mesh, std::optional<bool> rounded_valid) {
  Json report = measures(mesh);
  report["facets"] = strata::canonical_form(mesh).facet_count();
  report["volume_exact"] = strata::volume(mesh).str();
  report["empty"] = mesh.mesh.triangles.empty();
  report["rounded_valid"] = rounded_valid ? Json(*rounded_valid) : Json(nullptr);
  return report;
}

std::vector<Defect> operand_defects(const LoadedMesh& operand, strata::InputClass input) {
  try {
    if (!operand.mesh.exact.empty()) return strata::prepare_exact(operand.mesh).notes;
    switch (input) {
      case strata::InputClass::solid:
        return strata::prepare_closed(operand.mesh.mesh, false).notes;
      case strata::InputClass::overlapping:
        return strata::prepare_closed(operand.mesh.mesh, true).notes;
      case strata::InputClass::repair:
        return strata::prepare_soup(operand.mesh.mesh).notes;
    }
  } catch (const strata::InputError& error) {
    return error.defects();
  }
  return {};
}

Json operand_reports(std::span<const LoadedMesh> operands, strata::InputClass input) {
  Json list = Json::array();
  for (const LoadedMesh& operand : operands) list.push_back(operand_report(operand, operand_defects(operand, input)));
  return list;
}

std::uint64_t peak_bytes() {
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
#ifdef __APPLE__
  return static_cast<std::uint64_t>(usage.ru_maxrss);
#else
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
#endif
}

void write_report(const std::string& where, Json report) {
  report["strata"] = STRATA_VERSION;
  write_text(where, report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}
