#include "planar_partition.h"

#include <map>
#include <utility>
#include <vector>

#include "common/run.h"
#if STRATA_HAS_BSP
#include "strata/bsp.h"
#endif

using namespace strata::planar;

#if STRATA_HAS_BSP
namespace {

using strata::bsp::Partition;
using strata::bsp::PlaneSide;
using strata::bsp::PolygonLoop;

Partition<2> partition_of_filled(const Operand& operand) {
  const Region region = fill(operand);
  std::vector<PolygonLoop> loops;
  for (std::uint32_t l = 0; l < region.loops.size(); ++l) {
    PolygonLoop& loop = loops.emplace_back();
    for (const std::uint32_t v : region.loops.loop(l)) loop.push_back(exact_position(region.loops.places, v));
  }
  return strata::bsp::partition_of(loops);
}

/// Joins sides, head to tail. As many begin as end at every point, so every walk comes back to where it began.
Loops loops_of(const std::vector<PlaneSide>& sides) {
  std::multimap<RationalPlacement, const PlaneSide*> from;
  for (const PlaneSide& side : sides) from.emplace(side.from, &side);
  LoopsBuilder builder;
  while (!from.empty()) {
    for (auto next = from.begin(); next != from.end();) {
      const PlaneSide& side = *next->second;
      builder.add_vertex(side.from);
      from.erase(next);
      next = from.find(side.to);
    }
    builder.end_loop();
  }
  return builder.finish();
}

}  // namespace

Region combine_by_partitions(std::span<const Operand> operands, strata::Operation operation,
                             const strata::Monitor& monitor) {
  Partition<2> result = partition_of_filled(operands.front());
  for (const Operand& operand : operands.subspan(1))
    result = rebuilt_if_deep(combined(operation, result, partition_of_filled(operand), monitor));
  return fill(loops_of(sides_of(result)));
}
#else
Region combine_by_partitions(std::span<const Operand>, strata::Operation, const strata::Monitor&) {
  throw UsageError("--engine bsp needs the extension bsp, which this build of strata does not have");
}
#endif
