#include "strata/csg/evaluate.h"

#include <utility>

#include "strata/cells/cell_tree.h"
#include "strata/csg/stopwatch.h"
#include "strata/overlap/pairs.h"
#include "strata/select/merge.h"
#include "strata/select/split_faces.h"
#include "strata/select/whole_faces.h"

namespace strata {
namespace {

std::vector<std::uint8_t> touched_faces(const Carriers& carriers, const Meetings& meetings) {
  std::vector<std::uint8_t> touched(carriers.face_count(), 0);
  for (const Constraint& c : meetings.constraints) touched[c.face] = 1;
  return touched;
}

}  // namespace

Boundary evaluate(const Carriers& carriers, const Rule& rule, bool self, const Monitor& monitor, Profile& profile) {
  Stopwatch watch(profile);
  const CellTree cells(carriers, {.self = self, .monitor = monitor});
  watch.lap("cells");
  monitor.report(0.3);
  monitor.check();
  const Meetings meetings = find_meetings(carriers, cells, self, monitor);
  watch.lap("overlap");
  monitor.report(0.55);
  SplitFaces split = split_faces(carriers, cells, rule, meetings.constraints, self, monitor);
  watch.lap("arrange");
  monitor.report(0.8);
  const auto whole = judge_whole_faces(carriers, cells, rule, touched_faces(carriers, meetings), self, monitor);
  watch.lap("layers");
  monitor.report(0.85);
  const PointTable points(split, meetings.equal);
  merge_pieces(carriers, points, split, monitor);
  Boundary boundary = gather_boundary(carriers, whole, split, points);
  watch.lap("select");
  monitor.report(0.9);
  profile.counts = {{"cells", cells.cells().size()},
                    {"pairs_tested", meetings.pairs_tested},
                    {"pairs_meeting", meetings.pairs_meeting},
                    {"split_faces", split.faces.size()}};
  return boundary;
}

}  // namespace strata
