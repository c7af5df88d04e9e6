#include "core/cells/space.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace strata {
namespace {

/// Bounds of the vertices that faces use.
Box bounds_of_operand(const InputComplex& input, std::uint32_t operand) {
  if (const Box* known = input.bounds(operand)) return *known;
  const auto points = input.points(operand);
  const auto faces = input.faces(operand);
  return tbb::parallel_reduce(
      tbb::blocked_range<std::size_t>(0, faces.size(), 1 << 14), Box(),
      [&](const auto& range, Box b) {
        for (std::size_t i = range.begin(); i != range.end(); ++i)
          for (const std::uint32_t v : faces[i]) b.include(points[v]);
        return b;
      },
      [](Box a, const Box& b) {
        a.include(b);
        return a;
      });
}

/// The box around everything that the bounds of two operands share.
Box shared_bounds(std::vector<Box> operands) {
  std::sort(operands.begin(), operands.end(), [](const Box& a, const Box& b) { return a.lower[0] < b.lower[0]; });
  Box shared;
  for (std::size_t i = 0; i < operands.size(); ++i)
    for (std::size_t j = i + 1; j < operands.size() && operands[j].lower[0] <= operands[i].upper[0]; ++j) {
      const Box &a = operands[i], &b = operands[j];
      if (!a.overlaps(b)) continue;
      Box both;
      for (std::size_t k = 0; k < 3; ++k) {
        both.lower[k] = std::max(a.lower[k], b.lower[k]);
        both.upper[k] = std::min(a.upper[k], b.upper[k]);
      }
      shared.include(both);
    }
  return shared;
}

}  // namespace

Space find_space(const InputComplex& input, bool self) {
  std::vector<Box> operands(input.operand_count());
  tbb::parallel_for(std::uint32_t{0}, input.operand_count(),
                    [&](std::uint32_t o) { operands[o] = bounds_of_operand(input, o); });
  Box all;
  for (const Box& b : operands) all.include(b);
  Space space;
  const Box shared = self ? all : shared_bounds(std::move(operands));
  space.empty = shared.empty();
  if (space.empty) return space;
  space.grid = Grid(all.lower, all.upper);
  space.corner = shared.lower;
  space.interest.lower = space.grid.at(shared.lower);
  space.interest.upper = space.grid.at(shared.upper);
  for (std::int32_t& x : space.interest.upper) ++x;
  // In the sense of walk.h, a point on the upper x side of everything is outside. A rational point may lie above its
  // nearest double, but below the next one.
  space.beyond = input.has_rationals() ? std::nextafter(all.upper[0], HUGE_VAL) : all.upper[0];
  return space;
}

}  // namespace strata
