#include "core/round/rounding.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <optional>

#include "core/containers/collect.h"
#include "core/containers/huge_pages.h"

namespace strata {
namespace {

template <class Body>
void for_each_index(std::size_t count, std::size_t at_once, const Monitor& monitor, const Body& body) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, at_once), [&](const auto& range) {
    monitor.check();
    for (std::size_t i = range.begin(); i != range.end(); ++i) body(i);
  });
}

}  // namespace

std::vector<Vertex> round_to_doubles(const InputComplex& input, const Boundary& boundary, const Monitor& monitor) {
  std::vector<Vertex> rounded;
  resize_fresh(rounded, boundary.inputs.size() + boundary.constructed.size());
  for_each_index(boundary.inputs.size(), 1024, monitor,
                 [&](std::size_t i) { rounded[i] = input.vertex(boundary.inputs[i]); });
  for_each_index(boundary.constructed.size(), 64, monitor, [&](std::size_t i) {
    rounded[boundary.inputs.size() + i] = nearest_doubles(input, boundary.points.constructed(boundary.constructed[i]));
  });
  return rounded;
}

std::vector<ExactVertex> exact_positions(const InputComplex& input, const Boundary& boundary,
                                         const std::vector<Vertex>& rounded, const Monitor& monitor) {
  const auto is_input = [&](std::uint32_t i) { return i < boundary.inputs.size(); };
  const std::vector<std::uint32_t> candidates =
      collect(rounded.size(), [&](std::uint32_t i) { return !is_input(i) || !input.has_doubles(boundary.inputs[i]); });
  std::vector<std::optional<RationalPoint>> positions(candidates.size());
  for_each_index(candidates.size(), 64, monitor, [&](std::size_t n) {
    const std::uint32_t i = candidates[n];
    const PointId id = is_input(i) ? boundary.inputs[i] : boundary.constructed[i - boundary.inputs.size()];
    RationalPoint exact = exact_position(input, boundary.points.point(id));
    for (std::size_t k = 0; k < 3; ++k)
      if (exact[k] != to_rational(rounded[i][k])) {
        positions[n] = std::move(exact);
        return;
      }
  });
  std::vector<ExactVertex> result;
  for (std::size_t n = 0; n < positions.size(); ++n)
    if (positions[n]) result.push_back({candidates[n], std::move(*positions[n])});
  return result;
}

}  // namespace strata
