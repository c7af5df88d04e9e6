#include "core/round/rounding.h"

#include <cmath>
#include <optional>

#include "core/containers/collect.h"
#include "core/containers/for_each_index.h"
#include "core/containers/huge_pages.h"
#include "core/exact/big_integer.h"
#include "core/kernel/predicates.h"

namespace strata {
namespace {

RationalPoint exact_position(const InputComplex& input, const Boundary& boundary, std::uint32_t vertex) {
  if (vertex < boundary.inputs.size())
    if (const RationalPoint* given = input.exact(boundary.inputs[vertex])) return *given;
  return exact_position(input, boundary.points.point(boundary.point(vertex)));
}

/// The vertices that may not be three doubles.
std::vector<std::uint32_t> candidates_for_rounding(const InputComplex& input, const Boundary& boundary) {
  return collect(boundary.inputs.size() + boundary.constructed.size(), [&](std::uint32_t v) {
    return v >= boundary.inputs.size() || !input.has_doubles(boundary.inputs[v]);
  });
}

bool is_other_than(const Vertex& rounded, const RationalPoint& exact) {
  for (std::size_t k = 0; k < 3; ++k)
    if (!is_dyadic(exact[k]) || exact[k] != to_rational(rounded[k])) return true;
  return false;
}

/// A coordinate is farther from the nearest double than its approximation is off.
bool surely_differs(const Point& point, const Vertex& nearest) {
  if (point.name.kind == SymbolicPoint::Kind::free) return false;
  for (std::size_t k = 0; k < 3; ++k) {
    const DoubleDouble& x = point.fine[k];
    if (x.value == nearest[k] && std::abs(x.low) > x.error * Bounded::slack) return true;
  }
  return false;
}

}  // namespace

std::vector<Vertex> round_to_doubles(const InputComplex& input, const Boundary& boundary, const Monitor& monitor) {
  std::vector<Vertex> rounded;
  resize_fresh(rounded, boundary.inputs.size() + boundary.constructed.size());
  for_each_index(boundary.inputs.size(), 1024, monitor,
                 [&](std::size_t i) { rounded[i] = input.vertex(boundary.inputs[i]); });
  for_each_index(boundary.constructed.size(), 8, monitor, [&](std::size_t i) {
    rounded[boundary.inputs.size() + i] = nearest_doubles(input, boundary.points.constructed(boundary.constructed[i]));
  });
  return rounded;
}

bool are_equal(const InputComplex& input, const Boundary& boundary, std::uint32_t a, std::uint32_t b) {
  return equal(input, boundary.points.point(boundary.point(a)), boundary.points.point(boundary.point(b)));
}

std::vector<std::uint32_t> rounded_vertices(const InputComplex& input, const Boundary& boundary,
                                            const std::vector<Vertex>& rounded, const Monitor& monitor) {
  const std::vector<std::uint32_t> candidates = candidates_for_rounding(input, boundary);
  std::vector<char> differs(candidates.size(), 1);
  for_each_index(candidates.size(), 256, monitor, [&](std::size_t n) {
    const std::uint32_t v = candidates[n];
    if (v < boundary.inputs.size()) return;
    const Point& point = boundary.points.constructed(boundary.point(v));
    if (!surely_differs(point, rounded[v]))
      differs[n] = is_other_than(rounded[v], exact_position(input, point)) ? 1 : 0;
  });
  std::vector<std::uint32_t> result;
  for (std::size_t n = 0; n < candidates.size(); ++n)
    if (differs[n] != 0) result.push_back(candidates[n]);
  return result;
}

std::vector<ExactVertex> exact_positions(const InputComplex& input, const Boundary& boundary,
                                         std::span<const Vertex> rounded, const Monitor& monitor) {
  const std::vector<std::uint32_t> candidates = candidates_for_rounding(input, boundary);
  std::vector<std::optional<RationalPoint>> positions(candidates.size());
  for_each_index(candidates.size(), 64, monitor, [&](std::size_t n) {
    RationalPoint exact = exact_position(input, boundary, candidates[n]);
    if (is_other_than(rounded[candidates[n]], exact)) positions[n] = std::move(exact);
  });
  std::vector<ExactVertex> result;
  result.reserve(positions.size());
  for (std::size_t n = 0; n < positions.size(); ++n)
    if (positions[n]) result.push_back({candidates[n], std::move(*positions[n])});
  return result;
}

}  // namespace strata
