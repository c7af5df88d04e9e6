#include "extensions/surface/space_cells.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <map>
#include <span>
#include <utility>

#include "core/containers/box_tree.h"
#include "core/exact/pace.h"
#include "core/kernel/disjoint_sets.h"
#include "core/kernel/predicates.h"
#include "core/kernel/ray_crossing.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/prepare.h"

namespace strata {
namespace {

using Index = std::uint32_t;
constexpr Index no_shell = 0xffffffffu;

/// Sides of walls are numbered 2 w in front and 2 w + 1 behind.
Index front_of(Index wall) { return 2 * wall; }
Index back_of(Index wall) { return 2 * wall + 1; }

/// Sides of walls, connected around edges.
class ConnectedSides {
 public:
  ConnectedSides(const Walls& walls, std::size_t vertex_count, const Monitor& monitor)
      : walls_(walls), sides_(2 * walls.size()), sets_(walls.size()) {
    const std::vector<EdgeUse> uses = edge_table(walls.boundary().triangles, vertex_count, monitor);
    for_each_edge(
        uses, [this](std::span<const EdgeUse> around) { go_around(around); }, monitor);
  }

  /// The lowest side of its shell.
  [[nodiscard]] Index shell(Index side) { return sides_.find(side); }
  /// The lowest wall that is connected to a wall over edges.
  [[nodiscard]] Index set(Index wall) { return sets_.find(wall); }

 private:
  /// A wall at an edge, as it is met in going round counter-clockwise with the edge, from its lower vertex to its
  /// higher one, pointing to the eye.
  struct Met {
    int half = 0;  ///< 0: the first wall; 1: within 180 degrees of it; 2: at 180 degrees; 3: beyond
    EdgeUse use{};
    Point apex;  ///< the corner that is not on the edge
  };

  /// A wall's interior is on the left of its sides, so its front is what comes next after it where its side runs from
  /// low to high.
  static Index side_after(const EdgeUse& use) { return use.forward ? front_of(use.triangle) : back_of(use.triangle); }
  static Index side_before(const EdgeUse& use) { return use.forward ? back_of(use.triangle) : front_of(use.triangle); }

  [[nodiscard]] Met met(const EdgeUse& use) const {
    const Triangle& t = walls_.boundary().triangles[use.triangle];
    return {0, use, walls_.point(t[(use.corner + 2U) % 3])};
  }

  /// The angle from wall a to wall b: positive below 180 degrees, zero at 180, negative above.
  [[nodiscard]] Sign turn(const Met& a, const Met& b) const {
    const Sign side = side_of_face(walls_.input(), walls_.face(a.use.triangle), b.apex);
    return a.use.forward ? side : -side;
  }

  void go_around(std::span<const EdgeUse> around) {
    for (const EdgeUse& use : around) sets_.unite(around.front().triangle, use.triangle);
    if (around.size() > 2) around = in_order(around);
    for (std::size_t i = 0; i < around.size(); ++i)
      sides_.unite(side_after(around[i]), side_before(around[(i + 1) % around.size()]));
  }

  std::span<const EdgeUse> in_order(std::span<const EdgeUse> around) {
    met_.clear();
    for (const EdgeUse& use : around) met_.push_back(met(use));
    for (std::size_t i = 1; i < met_.size(); ++i) {
      const Sign s = turn(met_.front(), met_[i]);
      met_[i].half = s == Sign::positive ? 1 : s == Sign::zero ? 2 : 3;
    }
    std::sort(met_.begin(), met_.end(), [this](const Met& a, const Met& b) {
      if (a.half != b.half) return a.half < b.half;
      return (a.half == 1 || a.half == 3) && a.use.triangle != b.use.triangle && turn(a, b) == Sign::positive;
    });
    order_.clear();
    for (const Met& m : met_) order_.push_back(m.use);
    return order_;
  }

  const Walls& walls_;
  DisjointSets<Index> sides_, sets_;
  std::vector<Met> met_;
  std::vector<EdgeUse> order_;
};

/// Lists of numbers by the number of a list, in one array.
class Grouped {
 public:
  Grouped(const std::vector<Index>& list_of, Index lists) : first_(lists + 1, 0), entries_(list_of.size()) {
    for (const Index l : list_of) ++first_[l + 1];
    for (std::size_t l = 0; l < lists; ++l) first_[l + 1] += first_[l];
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t i = 0; i < list_of.size(); ++i) entries_[next[list_of[i]]++] = static_cast<Index>(i);
  }
  [[nodiscard]] std::span<const Index> operator[](std::size_t list) const {
    return std::span(entries_).subspan(first_[list], first_[list + 1] - first_[list]);
  }
  [[nodiscard]] Index count() const { return static_cast<Index>(first_.size() - 1); }

 private:
  std::vector<std::size_t> first_;
  std::vector<Index> entries_;
};

/// Numbers the values that `representative` gives for 0 .. n-1, in the order of their first occurrence.
template <class Representative>
std::pair<std::vector<Index>, Index> numbered(std::size_t n, const Representative& representative) {
  std::vector<Index> number(n);
  Index count = 0;
  for (Index i = 0; i < n; ++i) {  // representatives are the lowest members
    const Index r = representative(i);
    number[i] = r == i ? count++ : number[r];
  }
  return {std::move(number), count};
}

/// Shells and connected sets of walls.
class SpaceShells {
 public:
  SpaceShells(const Walls& walls, const ExactMesh& mesh, const Monitor& monitor) : mesh_(mesh), monitor_(monitor) {
    ConnectedSides connected(walls, mesh.mesh.vertices.size(), monitor);
    const auto [set_of_wall, sets] = numbered(walls.size(), [&](Index w) { return connected.set(w); });
    monitor.check();
    auto [shell_of_side, shells] = numbered(2 * walls.size(), [&](Index s) { return connected.shell(s); });
    monitor.check();
    shell_of_side_ = std::move(shell_of_side);
    sides_.emplace(shell_of_side_, shells);
    set_of_shell_.resize(shells);
    for (Index s = 0; s < shell_of_side_.size(); ++s) set_of_shell_[shell_of_side_[s]] = set_of_wall[s / 2];
    shells_of_set_.emplace(set_of_shell_, sets);
    walls_of_set_.emplace(set_of_wall, sets);
    monitor.check();
    outer_.resize(sets);
    tbb::parallel_for(Index{0}, sets, [&](Index k) { outer_[k] = find_outer((*shells_of_set_)[k]); });
  }

  [[nodiscard]] Index count() const { return static_cast<Index>(set_of_shell_.size()); }
  [[nodiscard]] Index sets() const { return static_cast<Index>(outer_.size()); }
  [[nodiscard]] Index of_side(Index side) const { return shell_of_side_[side]; }
  [[nodiscard]] Index set_of(Index shell) const { return set_of_shell_[shell]; }
  /// The shell of a set that bounds it from outside.
  [[nodiscard]] Index outer(Index set) const { return outer_[set]; }
  /// True when a set encloses a bounded cell.
  [[nodiscard]] bool encloses(Index set) const { return (*shells_of_set_)[set].size() > 1; }
  [[nodiscard]] std::span<const Index> walls_of(Index set) const { return (*walls_of_set_)[set]; }

 private:
  /// The only shell whose volume is not positive.
  [[nodiscard]] Index find_outer(std::span<const Index> shells) const {
    for (const Index shell : shells.first(shells.size() - 1))
      if (!has_positive_volume(shell)) return shell;
    return shells.back();
  }
  /// Seen from outside, its triangles are counter-clockwise: those of walls whose back is part of it.
  [[nodiscard]] bool has_positive_volume(Index shell) const {
    std::vector<Triangle> triangles;
    Pace pace(monitor_);
    for (const Index side : (*sides_)[shell]) {
      pace.step();
      Triangle t = mesh_.mesh.triangles[side / 2];
      if (side == front_of(side / 2)) std::swap(t[1], t[2]);
      triangles.push_back(t);
    }
    const MeshView mesh(mesh_.mesh.vertices, triangles);
    return orientation(ExactMeshView(mesh, mesh_.exact), monitor_) == Sign::positive;
  }

  const ExactMesh& mesh_;
  const Monitor& monitor_;
  std::vector<Index> shell_of_side_, set_of_shell_, outer_;
  std::optional<Grouped> sides_, shells_of_set_, walls_of_set_;
};

/// Per set the innermost shell of another set around it, or none.
class Nesting {
 public:
  Nesting(const SpaceShells& shells, const ExactMesh& mesh) : shells_(shells), mesh_(mesh) {
    input_.add(mesh.mesh.vertices, mesh.mesh.triangles, mesh.exact);
    std::vector<Index> walls;
    for (Index k = 0; k < shells.sets(); ++k)
      if (shells.encloses(k)) walls.insert(walls.end(), shells.walls_of(k).begin(), shells.walls_of(k).end());
    const auto box_of = [&](std::span<const Index> items) {
      Box box;
      for (const Index w : items)
        for (const Index v : mesh.mesh.triangles[w]) box.include(mesh.mesh.vertices[v]);
      return box;
    };
    tree_ = BoxTree::by_surface_area(static_cast<Index>(walls.size()), [&](std::span<const Index> items) {
      Box box;
      for (const Index i : items) box.include(box_of({&walls[i], 1}));
      return box;
    });
    walls_ = std::move(walls);
  }

  [[nodiscard]] std::vector<Index> find(const Monitor& monitor) const {
    std::vector<std::vector<Index>> around(shells_.sets());
    tbb::parallel_for(Index{0}, shells_.sets(), [&](Index k) {
      monitor.check();
      around[k] = shells_around(k);
    });
    // Shells around a set lie within one another, and the inner ones are within more.
    std::vector<Index> innermost(shells_.sets(), no_shell);
    for (Index k = 0; k < shells_.sets(); ++k) {
      std::size_t most = 0;
      for (const Index shell : around[k])
        if (const std::size_t depth = 1 + around[shells_.set_of(shell)].size(); depth > most) {
          most = depth;
          innermost[k] = shell;
        }
    }
    return innermost;
  }

 private:
  /// Rounding is monotone: where a ray meets a triangle, its rounded start sees the box of the rounded corners.
  static bool is_on_ray(const Box& box, const Vertex& from) {
    return box.upper[0] >= from[0] && box.lower[1] <= from[1] && from[1] <= box.upper[1] && box.lower[2] <= from[2] &&
           from[2] <= box.upper[2];
  }

  /// The bounded shells of other sets around a point of a set.
  [[nodiscard]] std::vector<Index> shells_around(Index set) const {
    const Point from = make_point(input_, SymbolicPoint::weighted(shells_.walls_of(set).front(), 1));
    const Vertex rounded = nearest_doubles(input_, from);
    std::map<Index, int> windings;
    tree_.for_each_in([&](const Box& box) { return is_on_ray(box, rounded); },
                      [&](Index i) {
                        count_crossing(walls_[i], set, from, rounded, windings);
                        return true;
                      });
    std::vector<Index> around;
    for (const auto& [shell, winding] : windings)
      if (winding == 1 && shell != shells_.outer(shells_.set_of(shell))) around.push_back(shell);
    return around;
  }

  void count_crossing(Index wall, Index set, const Point& from, const Vertex& rounded,
                      std::map<Index, int>& windings) const {
    const Index behind = shells_.of_side(back_of(wall)), in_front = shells_.of_side(front_of(wall));
    if (behind == in_front || shells_.set_of(behind) == set) return;
    const Triangle& t = mesh_.mesh.triangles[wall];
    Box box;
    for (const Index v : t) box.include(mesh_.mesh.vertices[v]);
    if (!is_on_ray(box, rounded)) return;
    std::array<Point, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) corners[i] = make_point(input_, SymbolicPoint::input(t[i]));
    const int crossing = crossing_along_x(input_, wall, corners, from);
    if (crossing == 0) return;
    windings[behind] += crossing;
    windings[in_front] -= crossing;
  }

  const SpaceShells& shells_;
  const ExactMesh& mesh_;
  InputComplex input_;
  std::vector<Index> walls_;
  BoxTree tree_;
};

}  // namespace

SpaceCells find_cells(const Walls& walls, const ExactMesh& mesh, const Monitor& monitor) {
  const SpaceShells shells(walls, mesh, monitor);
  std::vector<Index> cell(shells.count(), no_shell);
  SpaceCells result;
  for (Index s = 0; s < shells.count(); ++s)
    if (s != shells.outer(shells.set_of(s))) cell[s] = result.count++;
  std::vector<Index> around(shells.sets(), no_shell);
  if (shells.sets() > 1 && result.count > 1) around = Nesting(shells, mesh).find(monitor);
  for (Index k = 0; k < shells.sets(); ++k) cell[shells.outer(k)] = around[k] == no_shell ? 0 : cell[around[k]];
  monitor.check();
  for (Index w = 0; w < walls.size(); ++w)
    result.of_wall.push_back({cell[shells.of_side(front_of(w))], cell[shells.of_side(back_of(w))]});
  return result;
}

}  // namespace strata
