#include "core/csg/evaluate.h"

#include <utility>

#include "core/cells/cell_tree.h"
#include "core/csg/stopwatch.h"
#include "core/kernel/counters.h"
#include "core/overlap/coincidences.h"
#include "core/overlap/pairs.h"
#include "core/select/merge.h"
#include "core/select/split_faces.h"
#include "core/select/whole_faces.h"
#include "core/winding/local_windings.h"

namespace strata {

Evaluated arrange_pieces(InputComplex& input, const Rule& rule, bool self, PointTable& points, const Monitor& monitor,
                         Profile& profile) {
  Stopwatch watch(profile);
  const CellTree cells(input, {.self = self, .monitor = monitor});
  watch.lap("cells");
  monitor.report(0.3);
  monitor.check();
  input.identify(find_coincidences(input, cells, monitor));
  const Intersections intersections = find_intersections(input, cells, self, points, monitor);
  watch.lap("overlap");
  monitor.report(0.55);
  Evaluated result;
  const LocalWindings layers(input, cells);
  result.split = split_faces(input, layers, rule, intersections, self, points, result.pools, monitor);
  watch.lap("arrange");
  monitor.report(0.8);
  result.whole = judge_whole_faces(input, layers, &cells, rule, result.split, self, monitor);
  watch.lap("layers");
  monitor.report(0.85);
  profile.counts = {{"cells", cells.cells().size()},
                    {"pairs_tested", intersections.pairs_tested},
                    {"pairs_meeting", intersections.pairs_meeting}};
  return result;
}

Evaluated evaluate_pieces(InputComplex& input, const Rule& rule, bool self, PointTable& points, const Monitor& monitor,
                          Profile& profile) {
  const TierCounts decided_before = tier_counts_now();
  Evaluated result = arrange_pieces(input, rule, self, points, monitor, profile);
  Stopwatch watch(profile);
  merge_pieces(input, points, result.split, result.pools, monitor);
  watch.lap("merge");
  std::size_t pieces = 0;
  for (const SplitFace& face : result.split) pieces += face.triangles.size();
  for (const auto& [name, count] : {std::pair("points", std::size_t{points.end() - points.first()}),
                                    std::pair("split_faces", result.split.size()), std::pair("pieces", pieces)})
    profile.counts.emplace_back(name, count);
  const TierCounts decided = tier_counts_now();
  for (std::size_t i = 0; i < decided.size(); ++i)
    if (decided[i] != decided_before[i]) profile.counts.emplace_back(tier_names[i], decided[i] - decided_before[i]);
  return result;
}

Boundary evaluate(InputComplex& input, const Rule& rule, bool self, PointTable& points, const Monitor& monitor,
                  Profile& profile) {
  const Evaluated pieces = evaluate_pieces(input, rule, self, points, monitor, profile);
  Stopwatch watch(profile);
  Boundary boundary = gather_boundary(input, pieces.whole, pieces.split, points);
  watch.lap("gather");
  monitor.report(0.9);
  return boundary;
}

}  // namespace strata
