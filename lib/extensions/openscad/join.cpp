#include "extensions/openscad/join.h"

#include <algorithm>
#include <utility>

namespace strata::openscad {
namespace {

Part combined(const std::vector<Part>& shapes, Operation operation, const Monitor& monitor) {
  std::vector<planar::Operand> operands;
  for (const Part& p : shapes) operands.emplace_back(p.shape());
  return Part::of(planar::combine(operands, operation, monitor));
}

std::vector<Expression> expressions_of(const std::vector<Part>& solids) {
  std::vector<Expression> terms;
  for (const Part& p : solids) terms.push_back(p.solid());
  return terms;
}

void drop_empty(std::vector<Part>& parts, std::size_t first) {
  parts.erase(std::remove_if(parts.begin() + static_cast<std::ptrdiff_t>(first), parts.end(),
                             [](const Part& p) { return p.is_empty(); }),
              parts.end());
}

}  // namespace

std::vector<Part> of_one_dimension(std::vector<Part> parts, const Place& place, Report& report) {
  const auto first = std::find_if(parts.begin(), parts.end(), [](const Part& p) { return !p.is_empty(); });
  if (first == parts.end()) return parts;
  const bool are_shapes = first->is_shape();
  for (Part& p : parts) {
    if (are_shapes ? !p.is_solid() : !p.is_shape()) continue;
    report.note(place, are_shapes ? "a solid among shapes is passed over" : "a shape among solids is passed over");
    p = {};
  }
  return parts;
}

Part union_of(std::vector<Part> parts, const Monitor& monitor) {
  drop_empty(parts, 0);
  if (parts.empty()) return {};
  if (parts.size() == 1) return std::move(parts.front());
  if (parts.front().is_shape()) return combined(parts, Operation::union_, monitor);
  const bool is_union = std::all_of(parts.begin(), parts.end(), [](const Part& p) { return p.is_union(); });
  return Part::of(Expression::any(expressions_of(parts)), is_union);
}

Part intersection_of(std::vector<Part> parts, const Monitor& monitor) {
  if (parts.empty() || std::any_of(parts.begin(), parts.end(), [](const Part& p) { return p.is_empty(); })) return {};
  if (parts.size() == 1) return std::move(parts.front());
  if (parts.front().is_shape()) return combined(parts, Operation::intersection, monitor);
  return Part::of(Expression::all(expressions_of(parts)), false);
}

Part difference_of(std::vector<Part> parts, const Monitor& monitor) {
  if (parts.empty() || parts.front().is_empty()) return {};
  drop_empty(parts, 1);
  if (parts.size() == 1) return std::move(parts.front());
  if (parts.front().is_shape()) return combined(parts, Operation::difference, monitor);
  std::vector<Expression> terms = expressions_of(parts);
  for (std::size_t i = 1; i < terms.size(); ++i) terms[i] = ~terms[i];
  return Part::of(Expression::all(terms), false);
}

}  // namespace strata::openscad
