#include "strata/overlap/pairs.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include "strata/overlap/meeting.h"

namespace strata {
namespace {

/// The pairs of one cell. Faces are swept along x, so that only those that overlap there are compared.
class CellPairs {
 public:
  CellPairs(const Carriers& carriers, const CellTree& cells, const Cell& cell, bool self, Meetings& meetings)
      : carriers_(carriers), cells_(cells), cell_(cell), self_(self), meetings_(meetings) {}

  void find() {
    struct Swept {
      CellFace face;
      std::uint32_t operand;
    };
    std::vector<Swept> faces;
    faces.reserve(cell_.faces.size());
    std::uint32_t operand = 0, end = 0;
    for (const CellFace& f : cell_.faces) {  // by increasing face, hence by operand
      if (f.face >= end) {
        operand = carriers_.operand_of_face(f.face);
        end = carriers_.first_face(operand) + carriers_.face_count(operand);
      }
      faces.push_back({f, operand});
    }
    std::sort(faces.begin(), faces.end(), [](const Swept& a, const Swept& b) {
      return std::tie(a.face.box.lower[0], a.face.face) < std::tie(b.face.box.lower[0], b.face.face);
    });
    for (std::size_t i = 0; i < faces.size(); ++i)
      for (std::size_t j = i + 1; j < faces.size() && faces[j].face.box.lower[0] <= faces[i].face.box.upper[0]; ++j)
        if (self_ || faces[i].operand != faces[j].operand) test(faces[i].face, faces[j].face);
  }

 private:
  void test(const CellFace& a, const CellFace& b) {
    if (!a.box.overlaps(b.box)) return;
    if (!cells_.owns(cell_, a, b)) return;
    ++meetings_.pairs_tested;
    if (meet_faces(carriers_, std::min(a.face, b.face), std::max(a.face, b.face), meetings_)) ++meetings_.pairs_meeting;
  }

  const Carriers& carriers_;
  const CellTree& cells_;
  const Cell& cell_;
  bool self_;
  Meetings& meetings_;
};

/// What all cells found, constraints sorted by face and other face. All constraints of a pair come from one cell, in
/// one run; so their order does not depend on the order of the cells.
Meetings gathered(std::vector<Meetings> per_cell) {
  struct Key {
    std::uint64_t faces;
    std::uint32_t cell, index;
  };
  Meetings all;
  std::vector<Key> keys;
  for (std::uint32_t c = 0; c < per_cell.size(); ++c) {
    const Meetings& m = per_cell[c];
    for (std::uint32_t i = 0; i < m.constraints.size(); ++i) {
      keys.push_back({std::uint64_t{m.constraints[i].face} << 32 | m.constraints[i].other, c, i});
      all.any_contact = all.any_contact || m.constraints[i].kind != ConstraintKind::crossing;
    }
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
  all.constraints.resize(keys.size());
  tbb::parallel_for(std::size_t{0}, keys.size(),
                    [&](std::size_t i) { all.constraints[i] = per_cell[keys[i].cell].constraints[keys[i].index]; });
  return all;
}

}  // namespace

Meetings find_meetings(const Carriers& carriers, const CellTree& cells, bool self, const Monitor& monitor) {
  std::vector<Meetings> per_cell(cells.cells().size());
  tbb::parallel_for(std::size_t{0}, per_cell.size(), [&](std::size_t i) {
    const Cell& cell = cells.cells()[i];
    if (!cell.mixed) return;
    monitor.check();
    CellPairs(carriers, cells, cell, self, per_cell[i]).find();
  });
  return gathered(std::move(per_cell));
}

}  // namespace strata
