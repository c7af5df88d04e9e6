#include "core/kernel/validate.h"

#include <algorithm>
#include <cmath>

#include "core/exact/invariants.h"
#include "core/kernel/predicates.h"

namespace strata {
namespace {

constexpr std::size_t sample = 64;

bool is_in(const Box& box, const InputComplex::Coordinates& p) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (p[axis] < box.lower[axis] || p[axis] > box.upper[axis]) return false;
  return true;
}

/// False when later checks cannot use the indices.
bool corners_exist(const InputComplex& input, std::uint32_t operand, Violations& violations) {
  const auto faces = input.faces(operand);
  const auto points = input.points(operand);
  const Box* bounds = input.bounds(operand);
  bool exist = true;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const auto& v = faces[f];
    if (std::any_of(v.begin(), v.end(), [&](std::uint32_t i) { return i >= points.size(); })) {
      violations.add("face ", f, " of operand ", operand, " has a corner that does not exist");
      exist = false;
      continue;
    }
    if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0])
      violations.add("face ", f, " of operand ", operand, " has one corner twice");
    for (const std::uint32_t i : v) {
      if (!std::all_of(points[i].begin(), points[i].end(), [](double x) { return std::isfinite(x); }))
        violations.add("vertex ", i, " of operand ", operand, " has a coordinate that is not finite");
      else if (bounds != nullptr && !is_in(*bounds, points[i]))
        violations.add("vertex ", i, " of operand ", operand, " is outside of the box that was given");
    }
  }
  return exist;
}

void check_areas(const InputComplex& input, Violations& violations) {
  for_sample(input.face_count(), sample, [&](std::size_t f) {
    if (is_degenerate(input, static_cast<std::uint32_t>(f))) violations.add("face ", f, " has no area");
  });
}

void check_identified(const InputComplex& input, Violations& violations) {
  if (!input.has_identified()) return;
  std::vector<std::uint32_t> others;
  for (std::uint32_t v = 0; v < input.vertex_count(); ++v)
    if (input.identified(v) != v) others.push_back(v);
  for_sample(others.size(), sample, [&](std::size_t i) {
    const std::uint32_t v = others[i], low = input.identified(v);
    if (!equal(input, make_point(input, SymbolicPoint::input(v)), make_point(input, SymbolicPoint::input(low))))
      violations.add("vertices ", low, " and ", v, " are identified and not at one place");
  });
}

}  // namespace

std::vector<std::string> validate(const InputComplex& input) {
  Violations violations;
  bool exist = true;
  for (std::uint32_t o = 0; o < input.operand_count(); ++o) exist = corners_exist(input, o, violations) && exist;
  if (!exist || !violations.empty()) return std::move(violations).list();
  check_areas(input, violations);
  check_identified(input, violations);
  return std::move(violations).list();
}

}  // namespace strata
