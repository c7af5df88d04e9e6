#include "strata/overlap/pairs.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "strata/kernel/filtered_plane.h"
#include "strata/overlap/meeting.h"

namespace strata {
namespace {

/// Turn of three points seen along an axis: 1, -1, or 0 when doubles do not tell. Shewchuk's bound (3 + 16 u) u, and
/// 2^-1000 for underflow.
int filtered_turn(const Carriers::Coordinates& p, const Carriers::Coordinates& q, const Carriers::Coordinates& r,
                  std::size_t axis) {
  const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
  const double left = (q[u] - p[u]) * (r[v] - p[v]), right = (q[v] - p[v]) * (r[u] - p[u]), value = left - right;
  constexpr double factor = (3 + 16 * 0x1p-53) * 0x1p-53;
  const double bound = factor * (std::abs(left) + std::abs(right)) + 0x1p-1000;
  return static_cast<int>(value > bound) - static_cast<int>(-value > bound);
}

/// A face of a cell with all that a first look needs.
struct SweptFace {
  CellFace in_cell;
  std::uint32_t operand = 0;
  Carriers::Indices vertices{};
  std::array<Carriers::Coordinates, 3> corners{};
  FilteredPlane plane;

  /// True when all of another face, but for vertices that both have, is strictly on one side of this one's plane.
  [[nodiscard]] bool is_beside(const SweptFace& other) const {
    int above = 0, below = 0, common = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t v = other.vertices[i];
      if (v == vertices[0] || v == vertices[1] || v == vertices[2]) {
        ++common;
      } else {
        const int side = plane.side(other.corners[i]);
        above += side > 0;
        below += side < 0;
      }
    }
    return common < 3 && (above + common == 3 || below + common == 3);
  }

  /// True when, seen along the axis across which this face is widest, the line of one of its edges has the face on one
  /// side and all of the other face strictly on the other one, but for ends of the edge that both have.
  [[nodiscard]] bool is_off(const SweptFace& other) const {
    const std::size_t axis = plane.widest_axis();
    for (std::size_t e = 0; e < 3; ++e) {
      const std::size_t from = e, to = (e + 1) % 3;
      const int own = filtered_turn(corners[from], corners[to], corners[(e + 2) % 3], axis);
      bool off = own != 0;
      for (std::size_t i = 0; i < 3 && off; ++i) {
        const std::uint32_t v = other.vertices[i];
        off = v == vertices[from] || v == vertices[to] ||
              filtered_turn(corners[from], corners[to], other.corners[i], axis) == -own;
      }
      if (off) return true;
    }
    return false;
  }
};

/// The pairs of one cell. Faces are swept along x, so that only those that overlap there are compared.
class CellPairs {
 public:
  CellPairs(const Carriers& carriers, const CellTree& cells, bool self)
      : carriers_(carriers), cells_(cells), self_(self), exact_(!carriers.has_rationals()) {}

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
      s.vertices = carriers_.face(f.face);
      const auto points = carriers_.points(s.operand);
      const auto& t = carriers_.faces(s.operand)[f.face - carriers_.first_face(s.operand)];
      for (std::size_t i = 0; i < 3; ++i) s.corners[i] = points[t[i]];
      if (exact_) s.plane = FilteredPlane(s.corners[0], s.corners[1], s.corners[2]);
    }
    std::sort(faces_.begin(), faces_.end(), [](const SweptFace& a, const SweptFace& b) {
      return std::tie(a.in_cell.box.lower[0], a.in_cell.face) < std::tie(b.in_cell.box.lower[0], b.in_cell.face);
    });
  }

  void test(const SweptFace& a, const SweptFace& b, Meetings& meetings) const {
    ++meetings.pairs_tested;
    if (a.is_beside(b) || b.is_beside(a)) return;
    if (exact_ && (a.is_off(b) || b.is_off(a))) return;
    const auto [f, g] = std::minmax(a.in_cell.face, b.in_cell.face);
    if (meet_faces(carriers_, f, g, meetings)) ++meetings.pairs_meeting;
  }

  const Carriers& carriers_;
  const CellTree& cells_;
  bool self_;
  bool exact_;  ///< vertices are where their doubles say
  std::vector<SweptFace> faces_;
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
  tbb::enumerable_thread_specific<CellPairs> pairs([&] { return CellPairs(carriers, cells, self); });
  tbb::parallel_for(std::size_t{0}, per_cell.size(), [&](std::size_t i) {
    const Cell& cell = cells.cells()[i];
    if (!cell.mixed) return;
    monitor.check();
    pairs.local().find(cell, per_cell[i]);
  });
  return gathered(std::move(per_cell));
}

}  // namespace strata
