#include "core/cells/refinement.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <boost/container/static_vector.hpp>
#include <limits>

#include "core/cells/apart.h"
#include "core/cells/walk.h"

namespace strata {
namespace {

constexpr std::size_t parallel_threshold = 4096;
constexpr int deepest = 64;
/// A cell with so many times the faces of a leaf need not be divided if its faces are apart. Walks in larger cells
/// would take long.
constexpr std::size_t few_leaves = 4;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

void include(GridBox& a, const GridBox& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    a.lower[i] = std::min(a.lower[i], b.lower[i]);
    a.upper[i] = std::max(a.upper[i], b.upper[i]);
  }
}

GridBox empty_box() {
  GridBox b;
  b.lower.fill(std::numeric_limits<std::int32_t>::max());
  b.upper.fill(std::numeric_limits<std::int32_t>::min());
  return b;
}

GridBox common(const GridBox& a, const GridBox& b) {
  GridBox r;
  for (std::size_t i = 0; i < 3; ++i) {
    r.lower[i] = std::max(a.lower[i], b.lower[i]);
    r.upper[i] = std::min(a.upper[i], b.upper[i]);
  }
  return r;
}

bool is_empty(const GridBox& b) {
  return b.lower[0] > b.upper[0] || b.lower[1] > b.upper[1] || b.lower[2] > b.upper[2];
}

/// The last grid coordinates that belong to a cell.
GridBox closed(GridBox cell) {
  for (std::int32_t& x : cell.upper) --x;
  return cell;
}

}  // namespace

struct Refinement::Cuts : boost::container::static_vector<Cut, 6> {};

void Refinement::refine(Branch& root) const {
  measure(root);
  grow(root, 0);
}

bool Refinement::is_apart(Branch& root, std::span<const std::uint32_t> faces) const {
  if (!are_few_and_apart(faces)) return false;
  finish(root, Kind::apart, faces);
  return true;
}

bool Refinement::are_few_and_apart(std::span<const std::uint32_t> faces) const {
  return !options_.self && faces.size() <= few_leaves * options_.leaf_faces && are_apart(input_, faces);
}

bool Refinement::are_few_and_apart(const FaceList& faces) const {
  if (faces.size() > few_leaves * options_.leaf_faces) return false;
  boost::container::small_vector<std::uint32_t, 256> numbers;
  for (const CellFace& f : faces) numbers.push_back(f.face);
  return are_few_and_apart(std::span<const std::uint32_t>(numbers.data(), numbers.size()));
}

void Refinement::grow(Branch& branch, int depth) const {
  if (!is_mixed(branch.faces)) return finish(branch, Kind::of_one_operand);
  if (depth > 0 && are_few_and_apart(branch.faces)) return finish(branch, Kind::apart);
  if (branch.faces.size() > options_.leaf_faces && depth < deepest) {
    for (const Cut& cut : cuts(branch)) {
      if (!divide(branch, cut)) continue;
      const auto below = [&] { grow(*branch.below, depth + 1); };
      const auto above = [&] { grow(*branch.above, depth + 1); };
      if (branch.below->faces.size() + branch.above->faces.size() > parallel_threshold) {
        tbb::parallel_invoke(below, above);
      } else {
        below();
        above();
      }
      return;
    }
  }
  finish(branch, Kind::mixed);
}

void Refinement::finish(Branch& branch, Kind kind, std::span<const std::uint32_t> numbers) const {
  if (kind == Kind::of_one_operand) branch.faces.clear();
  if (kind == Kind::mixed)
    for (const CellFace& f : branch.faces) corners_.add(input_, f.face);
  const auto cell = cells_.push_back({branch.box, branch.origin, std::move(branch.windings), std::move(branch.faces),
                                      numbers, kind != Kind::of_one_operand, kind == Kind::apart});
  branch.cell = static_cast<std::uint32_t>(cell - cells_.begin());
}

/// Finds the boxes of the faces of a branch.
void Refinement::measure(Branch& branch) const {
  branch.content = {empty_box(), empty_box()};
  if (branch.faces.empty()) return;
  const std::uint32_t end = end_of_operand(branch.faces[0].face);
  for (const CellFace& f : branch.faces)
    include(f.face < end ? branch.content.first : branch.content.rest, common(f.box, closed(branch.box)));
}

std::uint32_t Refinement::end_of_operand(std::uint32_t face) const {
  const std::uint32_t o = input_.operand_of_face(face);
  return input_.first_face(o) + input_.face_count(o);
}

bool Refinement::is_mixed(const FaceList& faces) const {
  if (faces.empty()) return false;
  return options_.self || (faces.end() - 1)->face >= end_of_operand(faces[0].face);
}

/// Best first: a plane that separates two operands; a plane that cuts off space in which no faces can meet; the middles
/// of the sides, longest first.
Refinement::Cuts Refinement::cuts(const Branch& branch) const {
  const bool two = !options_.self && input_.operand_of_face(branch.faces.begin()->face) + 1 ==
                                         input_.operand_of_face((branch.faces.end() - 1)->face);
  GridBox box = branch.content.first;
  Cuts r;
  if (two) {
    box = common(branch.content.first, branch.content.rest);
    for (int i = 0; i < 3; ++i)
      if (box.lower[at(i)] > box.upper[at(i)]) r.push_back({i, box.lower[at(i)]});
    if (is_empty(box)) return r;
  } else {
    include(box, branch.content.rest);
  }
  double best = 0.25;
  for (int i = 0; i < 3; ++i) {
    const double side = static_cast<double>(branch.box.upper[at(i)]) - branch.box.lower[at(i)];
    const double low = (box.lower[at(i)] - static_cast<double>(branch.box.lower[at(i)])) / side;
    const double high = (branch.box.upper[at(i)] - static_cast<double>(box.upper[at(i)])) / side;
    if (std::max(low, high) <= best) continue;
    best = std::max(low, high);
    r.assign(1, low >= high ? Cut{i, box.lower[at(i)]} : Cut{i, box.upper[at(i)] + 1});
  }
  std::array<int, 3> order{0, 1, 2};
  const auto length = [&](int i) { return box.upper[at(i)] - box.lower[at(i)]; };
  std::stable_sort(order.begin(), order.end(), [&](int i, int j) { return length(i) > length(j); });
  for (const int i : order) r.push_back({i, static_cast<std::int32_t>(box.lower[at(i)] + (length(i) + 1) / 2)});
  return r;
}

/// Divides a cell in two. Returns false and changes nothing when the cut would not help or no origin can be placed.
bool Refinement::divide(Branch& branch, const Cut& cut) const {
  const std::size_t a = at(cut.axis), n = branch.faces.size();
  options_.monitor.check();
  if (cut.split <= branch.box.lower[a] || cut.split >= branch.box.upper[a]) return false;
  const bool origin_below = grid_.at(cut.axis, branch.origin[a]) < cut.split;
  GridBox other = branch.box;
  (origin_below ? other.lower : other.upper)[a] = cut.split;
  const auto moved = place_origin(branch.origin, other, cut.axis);
  if (!moved) return false;

  auto low = std::make_unique<Branch>(), high = std::make_unique<Branch>();
  low->box = high->box = branch.box;
  low->box.upper[a] = high->box.lower[a] = cut.split;
  low->faces = FaceList(n);
  high->faces = FaceList(n);
  const Windings windings = share(branch, cut, *moved, *low, *high);
  for (Branch* half : {low.get(), high.get()})  // whose first operand has changed
    if (half->faces.size() > 0 && half->faces.begin()->face >= end_of_operand(branch.faces.begin()->face))
      measure(*half);
  if (!is_worthwhile(n, low->faces, high->faces)) return false;

  Branch& stays = origin_below ? *low : *high;
  Branch& moves = origin_below ? *high : *low;
  stays.origin = branch.origin;
  stays.windings = branch.windings;
  moves.origin = *moved;
  moves.windings = windings == *branch.windings ? branch.windings : std::make_shared<const Windings>(windings);
  branch.below = std::move(low);
  branch.above = std::move(high);
  branch.axis = cut.axis;
  branch.split = cut.split;
  branch.faces.clear();
  branch.windings.reset();
  return true;
}

/// A cut of a large cell is good when it removes faces from either side or many from one. In small cells all pairs are
/// about to be compared: there a cut is good when it leaves clearly fewer pairs. It does not where many sheets lie on
/// one another.
bool Refinement::is_worthwhile(std::size_t n, const FaceList& low, const FaceList& high) const {
  const std::size_t most = std::max(low.size(), high.size()), least = std::min(low.size(), high.size());
  if (n > 1024) return most < n || least * 4 <= n * 3;
  const auto pairs = [&](const FaceList& faces) {
    return is_mixed(faces) ? static_cast<double>(faces.size()) * static_cast<double>(faces.size()) : 0;
  };
  return pairs(low) + pairs(high) < 0.9 * static_cast<double>(n) * static_cast<double>(n);
}

/// One pass over the faces of a cell: distributes them to the halves, measures the boxes of their faces, and walks from
/// the cell's origin to a new one. Returns the winding numbers there.
Windings Refinement::share(const Branch& branch, const Cut& cut, const InputComplex::Coordinates& to, Branch& low,
                           Branch& high) const {
  const std::size_t a = at(cut.axis);
  const GridBox low_box = closed(low.box), high_box = closed(high.box);
  const GridBox way = GridBox::between(grid_.at(branch.origin), grid_.at(to));
  const std::uint32_t first_low = end_of_operand(branch.faces.begin()->face);
  Windings windings = *branch.windings;
  for (const CellFace& f : branch.faces) {
    const bool is_first = f.face < first_low;
    if (f.box.lower[a] < cut.split) {
      low.faces.push_back(f);
      include(is_first ? low.content.first : low.content.rest, common(f.box, low_box));
    }
    if (f.box.upper[a] >= cut.split) {
      high.faces.push_back(f);
      include(is_first ? high.content.first : high.content.rest, common(f.box, high_box));
    }
    if (f.box.overlaps(way))
      windings.add(input_.operand_of_face(f.face), crossing_along_axis(input_, f.face, branch.origin, to, cut.axis));
  }
  return windings;
}

/// The origin moved along one axis into the interior of a box, unless doubles are too coarse there.
std::optional<InputComplex::Coordinates> Refinement::place_origin(InputComplex::Coordinates origin, const GridBox& box,
                                                                  int axis) const {
  const std::size_t a = at(axis);
  // Not the middle: inputs are often symmetric, and an origin in a face's plane costs an exact evaluation.
  const double g = box.lower[a] + (static_cast<double>(box.upper[a]) - box.lower[a]) * 0.4638;
  origin[a] = grid_.inverse(axis, static_cast<std::int32_t>(g));
  const std::int32_t placed = grid_.at(axis, origin[a]);
  if (placed < box.lower[a] || placed >= box.upper[a]) return std::nullopt;
  return origin;
}

}  // namespace strata
