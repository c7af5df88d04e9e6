#include "core/round/rounding.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <optional>

#include "core/containers/huge_pages.h"

namespace strata {
namespace {

template <class Body>
void for_each_index(std::size_t count, const Monitor& monitor, const Body& body) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 1024), [&](const auto& range) {
    monitor.check();
    for (std::size_t i = range.begin(); i != range.end(); ++i) body(i);
  });
}

}  // namespace

std::vector<Vertex> round_to_doubles(const InputComplex& input, const Boundary& boundary, const Monitor& monitor) {
  std::vector<Vertex> rounded;
  resize_fresh(rounded, boundary.inputs.size() + boundary.constructed.size());
  for_each_index(boundary.inputs.size(), monitor,
                 [&](std::size_t i) { rounded[i] = input.vertex(boundary.inputs[i]); });
  for_each_index(boundary.constructed.size(), monitor, [&](std::size_t i) {
    rounded[boundary.inputs.size() + i] = nearest_doubles(input, boundary.points.constructed(boundary.constructed[i]));
  });
  return rounded;
}

std::vector<ExactVertex> exact_positions(const InputComplex& input, const Boundary& boundary,
                                         const std::vector<Vertex>& rounded, const Monitor& monitor) {
  std::vector<std::optional<RationalPoint>> positions(rounded.size());
  for_each_index(rounded.size(), monitor, [&](std::size_t i) {
    const bool is_input = i < boundary.inputs.size();
    if (is_input && input.has_doubles(boundary.inputs[i])) return;
    const PointId id = is_input ? boundary.inputs[i] : boundary.constructed[i - boundary.inputs.size()];
    RationalPoint exact = exact_position(input, boundary.points.point(id));
    for (std::size_t k = 0; k < 3; ++k)
      if (exact[k] != to_rational(rounded[i][k])) {
        positions[i] = std::move(exact);
        return;
      }
  });
  std::vector<ExactVertex> result;
  for (std::size_t i = 0; i < positions.size(); ++i)
    if (positions[i]) result.push_back({static_cast<std::uint32_t>(i), std::move(*positions[i])});
  return result;
}

}  // namespace strata
