#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "common/stopwatch.h"
#include "common/watch.h"
#include "files.h"
#include "report.h"
#include "strata/check.h"
#include "strata/measure.h"
#include "verbs.h"

namespace {

// {lower, upper} over the vertices with finite coordinates; null when there are none.
Json bounding_box(const strata::Mesh& mesh) {
  std::optional<strata::Vertex> lower;
  std::optional<strata::Vertex> upper;
  for (const strata::Vertex& vertex : mesh.vertices) {
    if (!std::all_of(vertex.begin(), vertex.end(), [](double x) { return std::isfinite(x); })) continue;
    if (!lower) lower = upper = vertex;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      (*lower)[axis] = std::min((*lower)[axis], vertex[axis]);
      (*upper)[axis] = std::max((*upper)[axis], vertex[axis]);
    }
  }
  return lower ? Json{{"lower", *lower}, {"upper", *upper}} : Json(nullptr);
}

/// "color (corner, 4 x byte)".
std::string described(const strata::Channel& c) {
  constexpr std::array<const char*, 3> elements{"vertex", "corner", "face"};
  constexpr std::array<const char*, 4> types{"float", "double", "byte", "integer"};
  return fmt::format("{} ({}, {} x {})", c.name, elements[static_cast<std::size_t>(c.element)], c.components,
                     types[c.values.index()]);
}

void add_attributes(Json& facts, const LoadedMesh& operand) {
  const strata::Attributes& a = operand.attributes;
  facts["unit"] = operand.unit == strata::Unit::none ? Json(nullptr) : Json(strata::name(operand.unit));
  facts["channels"] = Json::array();
  for (const strata::Channel& c : a.channels) facts["channels"].push_back(described(c));
  for (const char* list : {"materials", "images"}) facts[list] = Json::array();
  for (const strata::Material& m : a.materials) facts["materials"].push_back(m.name);
  for (const strata::Image& i : a.images) facts["images"].push_back(i.name);
  facts["objects"] = a.objects;
  facts["groups"] = a.groups;
}

void print_facts(const Json& facts) {
  for (const auto& [key, value] : facts.items()) {
    if (key == "defects" || (key == "unit" && value.is_null()) || (value.is_array() && value.empty())) continue;
    const std::string text = value.is_string() ? value.get<std::string>() : value.is_null() ? "-" : value.dump();
    fmt::print("{:17} {}\n", key, text);
  }
}

}  // namespace

ExitCode run_info(const Settings& settings) {
  Watch watch(settings.timeout);
  Stopwatch stopwatch;
  Json report = {{"operation", "info"}, {"operands", Json::array()}};
  const LoadedMesh operand = std::move(read_operands(settings).front());
  report["seconds"]["read"] = stopwatch.lap();
  const std::vector<strata::Defect> defects = strata::diagnose(operand.mesh);
  Json facts = operand_report(operand, defects, settings);
  facts["bounding_box"] = bounding_box(operand.mesh.mesh);
  add_attributes(facts, operand);
  facts["rational_vertices"] = operand.mesh.exact.size();
  facts["volume_exact"] = facts["volume"].is_null() ? Json(nullptr) : Json(strata::volume(operand.mesh).str());
  report["seconds"]["evaluate"] = stopwatch.lap();
  report["peak_bytes"] = peak_bytes();

  if (settings.report != "-") {
    print_facts(facts);
    for (const strata::Defect& defect : defects) fmt::print("{:17} {}\n", "defect", strata::describe(defect));
  }
  report["operands"] = Json::array({std::move(facts)});
  if (!settings.report.empty()) write_report(settings.report, std::move(report));
  return ExitCode::ok;
}
