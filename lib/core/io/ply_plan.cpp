#include "core/io/ply_plan.h"

#include <string>

namespace strata::io {
namespace {

[[noreturn]] void fail_at_start(const PlyHeader& header, std::string reason) {
  if (header.order) fail_at_byte(0, std::move(reason));
  fail_at_line(0, std::move(reason));
}

PlyRole role_of(const PlyElement& element) {
  if (element.name == "vertex") return PlyRole::points;
  if (element.name == "face") return PlyRole::faces;
  if (element.name == "tristrips") return PlyRole::strips;
  return PlyRole::none;
}

void find_axes(const PlyHeader& header, PlyElementPlan& plan) {
  for (std::size_t k = 0; k < 3; ++k) {
    const std::string name(1, "xyz"[k]);
    const auto place = plan.element->find(name);
    if (!place || plan.element->properties[*place].list_count)
      fail_at_start(header, "expected a property " + name + " of the element 'vertex'");
    plan.axes[k] = *place;
  }
}

void find_list(const PlyHeader& header, PlyElementPlan& plan) {
  const auto& properties = plan.element->properties;
  auto place = plan.element->find("vertex_indices");
  if (!place) place = plan.element->find("vertex_index");
  if (!place || !properties[*place].list_count)
    fail_at_start(header, "expected a list 'vertex_indices' of the element '" + plan.element->name + "'");
  plan.list = *place;
  const PlyProperty& list = properties[*place];
  plan.is_usual_list = properties.size() == 1 && list.list_count == PlyScalar::uint8 &&
                       (list.type == PlyScalar::int32 || list.type == PlyScalar::uint32);
}

PlyElementPlan plan_element(const PlyHeader& header, const PlyElement& element) {
  PlyElementPlan plan{.element = &element, .role = role_of(element)};
  switch (plan.role) {
    case PlyRole::points:
      find_axes(header, plan);
      break;
    case PlyRole::faces:
    case PlyRole::strips:
      find_list(header, plan);
      break;
    case PlyRole::none:
      break;
  }
  return plan;
}

}  // namespace

PlyPlan plan_ply(const PlyHeader& header) {
  PlyPlan plan;
  bool has_vertices = false;
  for (const PlyElement& element : header.elements) {
    if (element.name == "vertex") {
      if (has_vertices) fail("two elements are called 'vertex'");
      has_vertices = true;
      plan.vertex_count = element.count;
    }
    // Vertices without properties are an error, which find_axes reports.
    const bool has_data = !element.properties.empty() || element.name == "vertex";
    if (element.count > 0 && has_data) plan.elements.push_back(plan_element(header, element));
  }
  return plan;
}

}  // namespace strata::io
