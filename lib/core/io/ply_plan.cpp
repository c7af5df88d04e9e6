#include "core/io/ply_plan.h"

#include <algorithm>
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
    plan.uses[*place].kind = PlyUse::Kind::coordinate;
    plan.uses[*place].components = 3;
    plan.uses[*place].component = k;
  }
}

void find_list(const PlyHeader& header, PlyElementPlan& plan) {
  const auto& properties = plan.element->properties;
  auto place = plan.element->find("vertex_indices");
  if (!place) place = plan.element->find("vertex_index");
  if (!place || !properties[*place].list_count)
    fail_at_start(header, "expected a list 'vertex_indices' of the element '" + plan.element->name + "'");
  plan.uses[*place].kind = PlyUse::Kind::indices;
  const PlyProperty& list = properties[*place];
  plan.is_usual_list = properties.size() == 1 && list.list_count == PlyScalar::uint8 &&
                       (list.type == PlyScalar::int32 || list.type == PlyScalar::uint32);
}

std::vector<PlyUse> unused(const PlyElement& element) {
  std::vector<PlyUse> uses(element.properties.size());
  std::size_t offset = 0;
  for (std::size_t i = 0; i < uses.size(); ++i) {
    uses[i].offset = offset;
    offset += size_of(element.properties[i].list_count.value_or(element.properties[i].type));
  }
  return uses;
}

PlyElementPlan plan_element(const PlyHeader& header, const PlyElement& element) {
  PlyElementPlan plan{.element = &element, .role = role_of(element), .uses = unused(element)};
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

/// Values of faces are those of one element: strips are no faces of which each has values, and those of several
/// elements would have gaps.
void find_channels(PlyPlan& plan) {
  const auto has_faces = [](const PlyElementPlan& e) { return e.role == PlyRole::faces || e.role == PlyRole::strips; };
  const bool are_apart = std::count_if(plan.elements.begin(), plan.elements.end(), has_faces) > 1;
  PlyChannels channels;
  for (PlyElementPlan& e : plan.elements) {
    if (e.role == PlyRole::points)
      channels.add(*e.element, Element::vertex, e.uses);
    else if (e.role == PlyRole::faces && !are_apart)
      channels.add(*e.element, Element::face, e.uses);
    else if (e.role == PlyRole::none)
      channels.leave_out(*e.element);
    else
      channels.leave_out_properties(*e.element, e.uses);
  }
  plan.notes = channels.notes();
  plan.channels = channels.take();
  plan.has_corners = std::any_of(plan.channels.begin(), plan.channels.end(),
                                 [](const PlyChannel& c) { return c.channel.element == Element::corner; });
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
  find_channels(plan);
  return plan;
}

}  // namespace strata::io
