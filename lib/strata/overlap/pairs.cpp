#include "strata/overlap/pairs.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include "strata/overlap/filtered_face.h"
#include "strata/overlap/meeting.h"

namespace strata {
namespace {

/// A face of a cell, ready to be swept.
struct SweptFace {
  CellFace in_cell;
  std::uint32_t operand = 0;
  FilteredFace filtered;
};

/// The pairs of one cell. Faces are swept along x, so that only those that overlap there are compared.
class CellPairs {
 public:
  CellPairs(const Carriers& carriers, const CellTree& cells, bool self)
      : carriers_(carriers), cells_(cells), self_(self) {}

  void find(const Cell& cell, Meetings& meetings) {
    load(cell);
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      const SweptFace& a = faces_[i];
      for (std::size_t j = i + 1; j < faces_.size() && faces_[j].in_cell.box.lower[0] <= a.in_cell.box.upper[0]; ++j) {
        const SweptFace& b = faces_[j];
        if ((self_ || a.operand != b.operand) && a.in_cell.box.overlaps(b.in_cell.box) &&
            cells_.owns(cell, a.in_cell, b.in_cell))
          test(a, b, meetings);
      }
    }
  }

 private:
  void load(const Cell& cell) {
    faces_.clear();
    for (const CellFace& f : cell.faces) {
      SweptFace& s = faces_.emplace_back();
      s.in_cell = f;
      s.operand = carriers_.operand_of_face(f.face);
      s.filtered = FilteredFace(carriers_, s.operand, f.face);
    }
    std::sort(faces_.begin(), faces_.end(), [](const SweptFace& a, const SweptFace& b) {
      return std::tie(a.in_cell.box.lower[0], a.in_cell.face) < std::tie(b.in_cell.box.lower[0], b.in_cell.face);
    });
  }

  void test(const SweptFace& a, const SweptFace& b, Meetings& meetings) const {
    ++meetings.pairs_tested;
    const bool ordered = a.in_cell.face < b.in_cell.face;
    const FilteredFace &f = (ordered ? a : b).filtered, &g = (ordered ? b : a).filtered;
    if (meet_faces(carriers_, f, g, meetings)) ++meetings.pairs_meeting;
  }

  const Carriers& carriers_;
  const CellTree& cells_;
  bool self_;
  std::vector<SweptFace> faces_;
};

/// The cells in which faces may meet. Cells come in any order, these by their places.
std::vector<const Cell*> mixed_cells(const CellTree& cells) {
  std::vector<const Cell*> mixed;
  for (const Cell& cell : cells.cells())
    if (cell.mixed) mixed.push_back(&cell);
  std::sort(mixed.begin(), mixed.end(), [](const Cell* a, const Cell* b) { return a->box.lower < b->box.lower; });
  return mixed;
}

/// What all cells found, constraints sorted by face and other face. All constraints of a pair come from one cell, in
/// one run.
Meetings gathered(std::vector<Meetings> per_cell, PointTable& points, const Monitor& monitor) {
  struct Key {
    std::uint64_t faces;
    std::uint32_t cell, index;
  };
  Meetings all;
  std::vector<Key> keys;
  std::vector<PointName> names;     // of points, by cell; what several cells found occurs several times
  std::vector<std::size_t> shift;  // per cell
  for (std::uint32_t c = 0; c < per_cell.size(); ++c) {
    const Meetings& m = per_cell[c];
    for (std::uint32_t i = 0; i < m.constraints.size(); ++i)
      keys.push_back({std::uint64_t{m.constraints[i].face} << 32 | m.constraints[i].other, c, i});
    shift.push_back(names.size());
    names.insert(names.end(), m.constructed.begin(), m.constructed.end());
    all.equal.insert(all.equal.end(), m.equal.begin(), m.equal.end());
    all.pairs_tested += m.pairs_tested;
    all.pairs_meeting += m.pairs_meeting;
  }
  // The same two vertices meet in many pairs of faces.
  tbb::parallel_sort(all.equal.begin(), all.equal.end());
  all.equal.erase(std::unique(all.equal.begin(), all.equal.end()), all.equal.end());
  tbb::parallel_sort(keys.begin(), keys.end(), [](const Key& a, const Key& b) {
    return std::tie(a.faces, a.cell, a.index) < std::tie(b.faces, b.cell, b.index);
  });
  const PointId first = points.first();
  const std::vector<PointId> numbers = points.add(names, monitor);
  all.constraints.resize(keys.size());
  tbb::parallel_for(std::size_t{0}, keys.size(), [&](std::size_t i) {
    Constraint& c = all.constraints[i];
    c = per_cell[keys[i].cell].constraints[keys[i].index];
    for (PointId* p : {&c.tail, &c.head})
      if (*p >= first) *p = numbers[*p - first + shift[keys[i].cell]];
  });
  return all;
}

}  // namespace

Meetings find_meetings(const Carriers& carriers, const CellTree& cells, bool self, PointTable& points,
                       const Monitor& monitor) {
  const std::vector<const Cell*> mixed = mixed_cells(cells);
  std::vector<Meetings> per_cell(mixed.size());
  tbb::enumerable_thread_specific<CellPairs> pairs([&] { return CellPairs(carriers, cells, self); });
  tbb::parallel_for(std::size_t{0}, per_cell.size(), [&](std::size_t i) {
    monitor.check();
    pairs.local().find(*mixed[i], per_cell[i]);
  });
  return gathered(std::move(per_cell), points, monitor);
}

}  // namespace strata
