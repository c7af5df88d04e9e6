#include "strata/cells/cell_tree.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/parallel_reduce.h>

#include <cmath>
#include <limits>
#include <optional>

#include "strata/cells/walk.h"

namespace strata {

/// A node while the tree grows: pointers, so that subtrees grow independently.
struct CellTree::Branch {
  Cell cell;
  int axis = -1;
  std::int32_t split = 0;
  std::unique_ptr<Branch> below, above;
};

namespace {

constexpr std::size_t parallel_threshold = 4096;
constexpr int deepest = 64;

struct Bounds {
  Carriers::Coordinates lower, upper;

  Bounds() {
    lower.fill(std::numeric_limits<double>::infinity());
    upper.fill(-std::numeric_limits<double>::infinity());
  }
  void add(const Carriers::Coordinates& p) {
    for (std::size_t i = 0; i < 3; ++i) {
      lower[i] = std::min(lower[i], p[i]);
      upper[i] = std::max(upper[i], p[i]);
    }
  }
  void add(const Bounds& b) {
    add(b.lower);
    add(b.upper);
  }
};

/// Bounds of the vertices that faces use. A rational vertex counts by its nearest doubles: rounding is monotone too, so
/// the grid's argument holds for the composition.
Bounds bounds_of(const Carriers& carriers, std::uint32_t operand) {
  const auto points = carriers.points(operand);
  const auto faces = carriers.faces(operand);
  return tbb::parallel_reduce(
      tbb::blocked_range<std::size_t>(0, faces.size(), 1 << 14), Bounds{},
      [&](const auto& range, Bounds b) {
        for (std::size_t i = range.begin(); i != range.end(); ++i)
          for (const std::uint32_t v : faces[i]) b.add(points[v]);
        return b;
      },
      [](Bounds a, const Bounds& b) {
        a.add(b);
        return a;
      });
}

Bounds bounds_of(const Carriers& carriers) {
  Bounds all;
  for (std::uint32_t o = 0; o < carriers.operand_count(); ++o)
    if (carriers.face_count(o) != 0) all.add(bounds_of(carriers, o));
  if (!(all.lower[0] <= all.upper[0])) all.lower = all.upper = {0, 0, 0};
  return all;
}

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

/// Where to cut a cell: below are grid coordinates < split, above are those >= split.
struct Cut {
  int axis = 0;
  std::int32_t split = 0;
};

/// Grows the tree below one branch.
class Grower {
 public:
  Grower(const Carriers& carriers, const Grid& grid, const CellOptions& options)
      : carriers_(carriers), grid_(grid), options_(options) {}

  template <class Branch>
  void grow(Branch& branch, int depth) const {
    Cell& cell = branch.cell;
    cell.mixed = is_mixed(cell.faces);
    if (!cell.mixed || cell.faces.size() <= options_.leaf_faces || depth >= deepest) return;
    for (const Cut& cut : cuts(cell)) {
      if (!divide(branch, cut)) continue;
      const auto below = [&] { grow(*branch.below, depth + 1); };
      const auto above = [&] { grow(*branch.above, depth + 1); };
      if (branch.below->cell.faces.size() + branch.above->cell.faces.size() > parallel_threshold) {
        tbb::parallel_invoke(below, above);
      } else {
        below();
        above();
      }
      return;
    }
  }

 private:
  [[nodiscard]] bool is_mixed(const std::vector<CellFace>& faces) const {
    if (faces.empty()) return false;
    return options_.self ||
           carriers_.operand_of_face(faces.front().face) != carriers_.operand_of_face(faces.back().face);
  }

  /// The box in which faces of different operands can meet: exact for two operands, the whole content otherwise.
  [[nodiscard]] std::pair<GridBox, bool> interest(const Cell& cell) const {
    const std::uint32_t first = carriers_.operand_of_face(cell.faces.front().face);
    const std::uint32_t last = carriers_.operand_of_face(cell.faces.back().face);
    const std::uint32_t end_of_first = carriers_.first_face(first) + carriers_.face_count(first);
    GridBox a = empty_box(), b = empty_box();
    bool two = !options_.self;
    for (const CellFace& f : cell.faces) {
      const GridBox part = common(f.box, closed(cell.box));
      if (f.face < end_of_first) {
        include(a, part);
      } else {
        include(b, part);
        two = two && f.face >= carriers_.first_face(last);
      }
    }
    if (two) return {common(a, b), true};
    include(a, b);
    return {a, false};
  }

  /// Candidates, best first: a plane that separates the operands; a plane that cuts off space where nothing can meet;
  /// the middles of the sides, longest first.
  [[nodiscard]] std::vector<Cut> cuts(const Cell& cell) const {
    const auto [box, two] = interest(cell);
    std::vector<Cut> r;
    if (two)
      for (int i = 0; i < 3; ++i) {
        const auto a = static_cast<std::size_t>(i);
        if (box.lower[a] > box.upper[a]) r.push_back({i, box.lower[a]});
      }
    if (is_empty(box)) return r;
    double best = 0.25;
    for (int i = 0; i < 3; ++i) {
      const auto a = static_cast<std::size_t>(i);
      const double side = static_cast<double>(cell.box.upper[a]) - cell.box.lower[a];
      const double low = (box.lower[a] - static_cast<double>(cell.box.lower[a])) / side;
      const double high = (cell.box.upper[a] - static_cast<double>(box.upper[a])) / side;
      if (std::max(low, high) <= best) continue;
      best = std::max(low, high);
      r.assign(1, low >= high ? Cut{i, box.lower[a]} : Cut{i, box.upper[a] + 1});
    }
    std::array<int, 3> order{0, 1, 2};
    const auto length = [&](int i) {
      return box.upper[static_cast<std::size_t>(i)] - box.lower[static_cast<std::size_t>(i)];
    };
    std::stable_sort(order.begin(), order.end(), [&](int i, int j) { return length(i) > length(j); });
    for (const int i : order)
      r.push_back({i, static_cast<std::int32_t>(box.lower[static_cast<std::size_t>(i)] + (length(i) + 1) / 2)});
    return r;
  }

  /// Cuts a cell in two. False, and nothing changed, when the cut would not help or no origin can be placed.
  template <class Branch>
  [[nodiscard]] bool divide(Branch& branch, const Cut& cut) const {
    Cell& cell = branch.cell;
    const auto a = static_cast<std::size_t>(cut.axis);
    if (cut.split <= cell.box.lower[a] || cut.split >= cell.box.upper[a]) return false;
    std::size_t below = 0, above = 0;
    for (const CellFace& f : cell.faces) {
      below += f.box.lower[a] < cut.split;
      above += f.box.upper[a] >= cut.split;
    }
    const std::size_t n = cell.faces.size();
    if (std::max(below, above) == n && std::min(below, above) * 4 > n * 3) return false;
    const bool origin_below = grid_.at(cut.axis, cell.origin[a]) < cut.split;
    GridBox other = cell.box;
    (origin_below ? other.lower : other.upper)[a] = cut.split;
    const auto moved = place_origin(cell.origin, other, cut.axis);
    if (!moved) return false;

    branch.below = std::make_unique<Branch>();
    branch.above = std::make_unique<Branch>();
    Cell& low = branch.below->cell;
    Cell& high = branch.above->cell;
    low.box = high.box = cell.box;
    low.box.upper[a] = high.box.lower[a] = cut.split;
    low.faces.reserve(below);
    high.faces.reserve(above);
    for (const CellFace& f : cell.faces) {
      if (f.box.lower[a] < cut.split) low.faces.push_back(f);
      if (f.box.upper[a] >= cut.split) high.faces.push_back(f);
    }
    Cell& stays = origin_below ? low : high;
    Cell& moves = origin_below ? high : low;
    stays.origin = cell.origin;
    stays.windings = cell.windings;
    moves.origin = *moved;
    moves.windings = walk(cell, *moved, cut.axis);
    branch.axis = cut.axis;
    branch.split = cut.split;
    cell.faces = {};
    cell.windings.reset();
    return true;
  }

  /// The origin moved along one axis well into a box, unless doubles are too coarse there.
  [[nodiscard]] std::optional<Carriers::Coordinates> place_origin(Carriers::Coordinates origin, const GridBox& box,
                                                                  int axis) const {
    const auto a = static_cast<std::size_t>(axis);
    // Off the middle: inputs are often symmetric, and an origin in a face's plane costs an exact evaluation.
    const double at = box.lower[a] + (static_cast<double>(box.upper[a]) - box.lower[a]) * 0.4638;
    origin[a] = grid_.inverse(axis, static_cast<std::int32_t>(at));
    const std::int32_t g = grid_.at(axis, origin[a]);
    if (g < box.lower[a] || g >= box.upper[a]) return std::nullopt;
    return origin;
  }

  /// Winding numbers after a walk from a cell's origin along one axis inside the cell.
  [[nodiscard]] std::shared_ptr<const Windings> walk(const Cell& cell, const Carriers::Coordinates& to, int axis) const {
    const auto from_grid = grid_.at(cell.origin), to_grid = grid_.at(to);
    GridBox way;
    for (std::size_t i = 0; i < 3; ++i) {
      way.lower[i] = std::min(from_grid[i], to_grid[i]);
      way.upper[i] = std::max(from_grid[i], to_grid[i]);
    }
    std::shared_ptr<Windings> changed;
    for (const CellFace& f : cell.faces) {
      if (!f.box.overlaps(way)) continue;
      const int change = crossing_along_axis(carriers_, f.face, cell.origin, to, axis);
      if (change == 0) continue;
      if (!changed) changed = std::make_shared<Windings>(*cell.windings);
      changed->add(carriers_.operand_of_face(f.face), change);
    }
    if (changed) return changed;
    return cell.windings;
  }

  const Carriers& carriers_;
  const Grid& grid_;
  const CellOptions& options_;
};

}  // namespace

CellTree::CellTree(const Carriers& carriers, const CellOptions& options) {
  Branch root;
  const Bounds bounds = bounds_of(carriers);
  grid_ = Grid(bounds.lower, bounds.upper);
  root.cell.box.lower.fill(0);
  root.cell.box.upper.fill(Grid::extent + 1);
  // Just outside: in the sense of walk.h an origin on the upper x side of everything is beyond it. A rational point may
  // lie above its nearest double, but below the next one.
  const double beyond = carriers.has_rationals() ? std::nextafter(bounds.upper[0], HUGE_VAL) : bounds.upper[0];
  root.cell.origin = {beyond, bounds.lower[1] * 0.5 + bounds.upper[1] * 0.5,
                      bounds.lower[2] * 0.5 + bounds.upper[2] * 0.5};
  root.cell.windings = std::make_shared<const Windings>();
  root.cell.faces.resize(carriers.face_count());
  for (std::uint32_t o = 0; o < carriers.operand_count(); ++o) {
    const auto points = carriers.points(o);
    const auto faces = carriers.faces(o);
    const std::uint32_t first = carriers.first_face(o);
    tbb::parallel_for(tbb::blocked_range<std::uint32_t>(0, carriers.face_count(o), 1 << 14), [&](const auto& range) {
      for (std::uint32_t i = range.begin(); i != range.end(); ++i) {
        const auto& t = faces[i];
        root.cell.faces[first + i] = {grid_.box(points[t[0]], points[t[1]], points[t[2]]), first + i};
      }
    });
  }
  Grower(carriers, grid_, options).grow(root, 0);
  collect(root);
}

std::uint32_t CellTree::collect(Branch& branch) {
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back({branch.axis, branch.split, 0, 0});
  if (branch.axis < 0) {
    nodes_[index].below = static_cast<std::uint32_t>(cells_.size());
    cells_.push_back(std::move(branch.cell));
    return index;
  }
  const std::uint32_t below = collect(*branch.below);
  branch.below.reset();
  const std::uint32_t above = collect(*branch.above);
  branch.above.reset();
  nodes_[index].below = below;
  nodes_[index].above = above;
  return index;
}

std::uint32_t CellTree::cell_at(const std::array<std::int32_t, 3>& g) const {
  std::uint32_t i = 0;
  while (nodes_[i].axis >= 0)
    i = g[static_cast<std::size_t>(nodes_[i].axis)] < nodes_[i].split ? nodes_[i].below : nodes_[i].above;
  return nodes_[i].below;
}

}  // namespace strata
