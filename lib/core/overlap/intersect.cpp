#include "core/overlap/intersect.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "core/exact/invariants.h"
#include "core/overlap/constraint_order.h"
#include "core/overlap/coplanar.h"
#include "core/overlap/filtered_face.h"
#include "core/overlap/meeting.h"
#include "core/overlap/validate.h"

namespace strata {
namespace {

/// The pairs of faces of which the first, in the order of the sweep, is one of these.
struct PartOfCell {
  const Cell* cell;
  std::size_t first, last;
};

/// Where many faces cannot be told apart, all pairs may be in one cell: large cells are shared out.
std::vector<PartOfCell> parts_of(const std::vector<const Cell*>& cells) {
  constexpr std::size_t at_once = 256;
  std::vector<PartOfCell> parts;
  for (const Cell* const cell : cells)
    for (std::size_t i = 0; i < cell->faces.size(); i += at_once)
      parts.push_back({cell, i, std::min(i + at_once, cell->faces.size())});
  return parts;
}

/// The pairs of one cell. Faces are swept along the axis along which they are shortest, so that only those that overlap
/// there are compared. The comparison runs over plain arrays, several faces at a time where the processor supports it.
class CellPairs {
 public:
  explicit CellPairs(const Candidates& candidates)
      : input_(candidates.input()), cells_(candidates.cells()), self_(input_.may_self_intersect()) {}

  void find(const PartOfCell& part, PairIntersections& intersections) {
    const Cell& cell = *part.cell;
    load(cell);
    for (std::size_t i = part.first; i < part.last; ++i) {
      const auto later = order_.begin() + static_cast<std::ptrdiff_t>(i) + 1;
      const auto end =
          static_cast<std::size_t>(std::upper_bound(later, order_.end(), upper_[0][i],
                                                    [](std::int32_t x, const SweepKey& p) { return x < p.lower; }) -
                                   order_.begin());
      compare(i, end);
      for (std::size_t j = i + 1; j < end; ++j) {
        if (is_pair_[j] == 0) continue;
        const CellFace &a = cell.faces[order_[i].index], &b = cell.faces[order_[j].index];
        if (cells_.owns(cell, a, b)) test(i, j, intersections);
      }
    }
  }

 private:
  struct SweepKey {
    std::int32_t lower;   ///< along the axis of the sweep
    std::uint32_t index;  ///< in the cell
    friend bool operator<(const SweepKey& a, const SweepKey& b) {
      return a.lower < b.lower || (a.lower == b.lower && a.index < b.index);
    }
  };

  void load(const Cell& cell) {
    const std::size_t count = cell.faces.size();
    const std::size_t sweep = shortest_axis(cell), u = (sweep + 1) % 3, v = (sweep + 2) % 3;
    order_.clear();
    for (std::uint32_t i = 0; i < count; ++i) order_.push_back({cell.faces[i].box.lower[sweep], i});
    std::sort(order_.begin(), order_.end());
    for (auto* array : {&lower_[0], &lower_[1], &upper_[0], &upper_[1], &upper_[2], &operand_, &is_pair_})
      array->resize(count);
    filtered_.assign(count, std::nullopt);
    for (std::size_t k = 0; k < count; ++k) {
      const CellFace& f = cell.faces[order_[k].index];
      lower_[0][k] = f.box.lower[u];
      lower_[1][k] = f.box.lower[v];
      upper_[0][k] = f.box.upper[sweep];
      upper_[1][k] = f.box.upper[u];
      upper_[2][k] = f.box.upper[v];
      operand_[k] = static_cast<std::int32_t>(input_.operand_of_face(f.face));
    }
    faces_ = &cell.faces;
  }

  /// The axis along which the faces' boxes are shortest in total.
  [[nodiscard]] static std::size_t shortest_axis(const Cell& cell) {
    std::array<std::int64_t, 3> length{};
    for (const CellFace& f : cell.faces)
      for (std::size_t axis = 0; axis < 3; ++axis) length[axis] += f.box.upper[axis] - f.box.lower[axis];
    return static_cast<std::size_t>(std::min_element(length.begin(), length.end()) - length.begin());
  }

  /// Finds the faces i + 1 to end - 1 that overlap face i along the other axes and are to be tested with it.
  void compare(std::size_t i, std::size_t end) {
    const std::int32_t u0 = lower_[0][i], u1 = upper_[1][i], v0 = lower_[1][i], v1 = upper_[2][i];
    const std::int32_t own = self_ ? -1 : operand_[i];
    const std::int32_t *lu = lower_[0].data(), *uu = upper_[1].data(), *lv = lower_[1].data(), *uv = upper_[2].data(),
                       *operand = operand_.data();
    std::int32_t* const is_pair = is_pair_.data();
    for (std::size_t j = i + 1; j < end; ++j)
      is_pair[j] = static_cast<std::int32_t>(lu[j] <= u1) & static_cast<std::int32_t>(uu[j] >= u0) &
                   static_cast<std::int32_t>(lv[j] <= v1) & static_cast<std::int32_t>(uv[j] >= v0) &
                   static_cast<std::int32_t>(operand[j] != own);
  }

  void test(std::size_t i, std::size_t j, PairIntersections& intersections) {
    ++intersections.pairs_tested;
    const FilteredFace &a = filtered(i), &b = filtered(j);
    const bool ordered = a.face < b.face;
    if (meet_faces(input_, ordered ? a : b, ordered ? b : a, intersections)) ++intersections.pairs_meeting;
  }

  const FilteredFace& filtered(std::size_t k) {
    auto& f = filtered_[k];
    if (!f) f.emplace(input_, static_cast<std::uint32_t>(operand_[k]), (*faces_)[order_[k].index].face);
    return *f;
  }

  const InputComplex& input_;
  const CellTree& cells_;
  bool self_;
  const FaceList* faces_ = nullptr;
  /// The faces of the cell in the order of the sweep.
  std::vector<SweepKey> order_;
  std::array<std::vector<std::int32_t>, 2> lower_;  ///< across the axis of the sweep
  std::array<std::vector<std::int32_t>, 3> upper_;  ///< along it and across
  std::vector<std::int32_t> operand_, is_pair_;
  std::vector<std::optional<FilteredFace>> filtered_;  ///< filled when a face is needed
};

/// The cells in which faces may meet. The cells themselves are in any order; these are sorted by their lower corners.
std::vector<const Cell*> mixed_cells(const CellTree& cells) {
  std::vector<const Cell*> mixed;
  for (const Cell& cell : cells.cells())
    if (cell.mixed && !cell.apart) mixed.push_back(&cell);
  std::sort(mixed.begin(), mixed.end(), [](const Cell* a, const Cell* b) { return a->box.lower < b->box.lower; });
  return mixed;
}

/// The intersections of all parts of cells, with constraints sorted by face and other face. All constraints of a pair
/// come from one part and are consecutive.
Intersections gathered(const std::vector<PairIntersections>& per_part, const InputComplex& input,
                       const Monitor& monitor) {
  Intersections all{.constraints = {}, .equal = {}, .points = PointTable(input), .hidden = {}};
  std::vector<std::size_t> first_name{0};  // per part
  for (const PairIntersections& m : per_part) {
    first_name.push_back(first_name.back() + m.constructed.size());
    all.equal.insert(all.equal.end(), m.equal.begin(), m.equal.end());
    all.pairs_tested += m.pairs_tested;
    all.pairs_meeting += m.pairs_meeting;
  }
  // The same two vertices meet in many pairs of faces.
  tbb::parallel_sort(all.equal.begin(), all.equal.end());
  all.equal.erase(std::unique(all.equal.begin(), all.equal.end()), all.equal.end());

  std::vector<SymbolicPoint> names(first_name.back());  // points found in several cells occur several times
  tbb::parallel_for(std::size_t{0}, per_part.size(), [&](std::size_t c) {
    const auto& constructed = per_part[c].constructed;
    std::copy(constructed.begin(), constructed.end(), names.begin() + static_cast<std::ptrdiff_t>(first_name[c]));
  });
  const std::vector<ConstraintPosition> positions = order_by_face(per_part, input.face_count());
  const PointId first = all.points.first();
  const std::vector<PointId> numbers = all.points.add(names, monitor);
  all.constraints.resize(positions.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, positions.size(), 1 << 12), [&](const auto& range) {
    for (std::size_t i = range.begin(); i != range.end(); ++i) {
      Constraint& c = all.constraints[i];
      c = per_part[positions[i].cell].constraints[positions[i].index];
      for (PointId* p : {&c.tail, &c.head})
        if (*p >= first) *p = numbers[*p - first + first_name[positions[i].cell]];
    }
  });
  return all;
}

/// What meets in each part of each cell. `leaves_coplanar`: as in PairIntersections.
std::vector<PairIntersections> met_in_cells(const Candidates& candidates, bool leaves_coplanar,
                                            const Monitor& monitor) {
  const std::vector<PartOfCell> parts = parts_of(mixed_cells(candidates.cells()));
  std::vector<PairIntersections> met(parts.size());
  tbb::enumerable_thread_specific<CellPairs> pairs([&] { return CellPairs(candidates); });
  tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t n) {
    monitor.check();
    met[n].leaves_coplanar = leaves_coplanar;
    pairs.local().find(parts[n], met[n]);
  });
  return met;
}

}  // namespace

Intersections intersect(const Candidates& candidates, const Monitor& monitor) {
  return intersect(candidates.input(), met_in_cells(candidates, false, monitor), monitor);
}

std::vector<PairIntersections> meet_faces_in_general(const Candidates& candidates, const Monitor& monitor) {
  return met_in_cells(candidates, true, monitor);
}

Intersections intersect(const InputComplex& input, std::vector<PairIntersections> met,
                        std::vector<std::uint32_t> hidden, const Monitor& monitor) {
  std::vector<bool> is_hidden(hidden.empty() ? 0 : input.face_count(), false);
  for (const std::uint32_t f : hidden) is_hidden[f] = true;
  tbb::parallel_for(std::size_t{0}, met.size(), [&](std::size_t n) {
    monitor.check();
    for (const auto& [f, g] : met[n].coplanar)
      if ((is_hidden.empty() || !is_hidden[f] || !is_hidden[g]) &&
          meet_coplanar_faces(input, FilteredFace(input, f), FilteredFace(input, g), met[n]))
        ++met[n].pairs_meeting;
  });
  Intersections all = intersect(input, met, monitor);
  all.hidden = std::move(hidden);
  return all;
}

Intersections intersect(const InputComplex& input, std::span<const SelfIntersection> pairs, const Monitor& monitor) {
  constexpr std::size_t at_once = 64;
  std::vector<PairIntersections> parts((pairs.size() + at_once - 1) / at_once);
  tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t n) {
    monitor.check();
    for (const SelfIntersection& p : pairs.subspan(n * at_once, std::min(at_once, pairs.size() - n * at_once))) {
      ++parts[n].pairs_tested;
      if (meet_faces(input, FilteredFace(input, 0, p.face), FilteredFace(input, 0, p.other), parts[n]))
        ++parts[n].pairs_meeting;
    }
  });
  return intersect(input, parts, monitor);
}

Intersections intersect(const InputComplex& input, const std::vector<PairIntersections>& met, const Monitor& monitor) {
  Intersections all = gathered(met, input, monitor);
  ensure("intersect", [&] { return validate(input, all); });
  return all;
}

}  // namespace strata
