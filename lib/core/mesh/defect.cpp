#include <algorithm>
#include <utility>

#include "core/exact/number_text.h"
#include "strata/errors.h"

namespace strata {
namespace {

/// Defects for which the mesh is refused first, then those that were resolved.
std::vector<Defect>& errors_first(std::vector<Defect>& defects) {
  std::stable_partition(defects.begin(), defects.end(), [](const Defect& d) { return d.severity == Severity::error; });
  return defects;
}

std::string summary(const std::vector<Defect>& defects, std::size_t operand) {
  std::string text = "operand " + std::to_string(operand) + ": ";
  if (defects.empty()) return text + "invalid input";
  text += describe(defects.front());
  if (defects.size() > 1) text += " (and " + std::to_string(defects.size() - 1) + " more)";
  return text;
}

}  // namespace

std::string_view name(DefectKind kind) {
  switch (kind) {
    case DefectKind::non_finite_coordinate:
      return "non-finite coordinate";
    case DefectKind::index_out_of_range:
      return "index out of range";
    case DefectKind::degenerate_triangle:
      return "degenerate triangle";
    case DefectKind::duplicate_face:
      return "duplicate face";
    case DefectKind::open_edge:
      return "open edge";
    case DefectKind::inconsistent_orientation:
      return "inconsistent orientation";
    case DefectKind::self_intersection:
      return "self-intersection";
    case DefectKind::inside_out:
      return "inside-out";
    case DefectKind::empty_mesh:
      return "empty mesh";
  }
  return "unknown defect";
}

std::string_view name(Severity severity) {
  switch (severity) {
    case Severity::note:
      return "note";
    case Severity::error:
      return "error";
  }
  return "unknown severity";
}

std::string describe(const Defect& defect) {
  std::string text{name(defect.kind)};
  if (!defect.message.empty()) text += ": " + defect.message;
  if (defect.where) {
    const auto& [x, y, z] = *defect.where;
    text += " at (" + number_text(x) + ", " + number_text(y) + ", " + number_text(z) + ")";
  }
  if (!defect.faces.empty()) {
    text += defect.faces.size() == 1 ? ", face " : ", faces ";
    for (std::size_t i = 0; i < defect.faces.size(); ++i) text += (i ? ", " : "") + std::to_string(defect.faces[i]);
  }
  if (!defect.remedy.empty()) text += "; " + defect.remedy;
  return text;
}

InputError::InputError(std::vector<Defect> defects, std::size_t operand)
    : std::runtime_error(summary(errors_first(defects), operand)), defects_(std::move(defects)), operand_(operand) {}

}  // namespace strata
