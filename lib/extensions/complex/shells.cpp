#include "extensions/complex/shells.h"

#include <algorithm>
#include <map>
#include <utility>

#include "core/kernel/disjoint_sets.h"
#include "core/kernel/predicates.h"
#include "core/mesh/prepare.h"
#include "extensions/complex/enclosing.h"

namespace strata::complex {
namespace {

using Index = std::uint32_t;

/// Processes all wings around every edge. Sides of pieces are numbered 2 p above and 2 p + 1 below.
class Shells {
 public:
  Shells(const Arrangement& arrangement, const Cells& cells)
      : arrangement_(arrangement),
        cells_(cells),
        shells_(2 * arrangement.pieces.size()),
        sets_(arrangement.pieces.size()),
        planes_(arrangement.input.face_count()) {
    for (const auto& [f, g] : arrangement.coplanar) planes_.unite(f, g);
    for (std::size_t i = 0, last = 0; i < cells.wings.size(); i = last) {
      while (last < cells.wings.size() && cells.wings[last].edge == cells.wings[i].edge) ++last;
      go_around(std::span(cells.wings).subspan(i, last - i));
    }
  }

  [[nodiscard]] Index shell(Index side) { return shells_.find(side); }
  [[nodiscard]] Index set(Index piece) { return sets_.find(piece); }
  [[nodiscard]] Index plane(Index piece) { return planes_.find(arrangement_.pieces[piece].face); }

 private:
  /// The angle about the edge from wing i to the interior of wing j: positive below 180 degrees.
  [[nodiscard]] Sign orientation(const Wing& i, const Wing& j) {
    const Index f = arrangement_.pieces[i.face].face, g = arrangement_.pieces[j.face].face;
    if (planes_.find(f) == planes_.find(g)) return Sign::zero;
    const auto& v = arrangement_.pieces[j.face].v;
    const auto& ends = cells_.edges[j.edge];
    const Index apex = v[0] != ends[0] && v[0] != ends[1] ? v[0] : v[1] != ends[0] && v[1] != ends[1] ? v[1] : v[2];
    const Point p = arrangement_.points.point(arrangement_.vertices[apex]);
    const Sign side = side_of_face(arrangement_.input, f, p);
    if (side == Sign::zero) planes_.unite(f, g);
    return i.left == (arrangement_.is_reversed[f] == 0) ? side : -side;
  }

  void go_around(std::span<const Wing> wings) {
    order_.clear();
    for (const Wing& w : wings) {
      sets_.unite(wings.front().face, w.face);
      const Sign s = order_.empty() ? Sign::zero : orientation(wings.front(), w);
      order_.emplace_back(order_.empty() ? 0 : s == Sign::positive ? 1 : s == Sign::zero ? 2 : 3, w);
    }
    std::sort(order_.begin(), order_.end(), [this](const auto& a, const auto& b) {
      if (a.first != b.first) return a.first < b.first;
      return (a.first == 1 || a.first == 3) && orientation(a.second, b.second) == Sign::positive;
    });
    find_opposite();
    for (std::size_t i = 0; i < order_.size(); ++i) {
      const Wing &w = order_[i].second, &next = order_[(i + 1) % order_.size()].second;
      shells_.unite(2 * w.face + (w.left ? 0 : 1), 2 * next.face + (next.left ? 1 : 0));
    }
  }

  /// Records pairs of wings 180 degrees apart, which lie in one plane. Opposites are in the same order as wings.
  void find_opposite() {
    const std::size_t n = order_.size();
    for (std::size_t i = 0, j = 1; i < n; ++i) {
      j = std::max(j, i + 1);
      while (j < i + n && orientation(order_[i].second, order_[j % n].second) == Sign::positive) ++j;
    }
  }

  const Arrangement& arrangement_;
  const Cells& cells_;
  DisjointSets<Index> shells_, sets_, planes_;
  std::vector<std::pair<int, Wing>> order_;
};

/// Sides as triangles with their outer side away from the volume, and the vertices that they use.
ExactMesh mesh_of(const Arrangement& arrangement, const Cells& cells, std::span<const Index> sides) {
  std::vector<Index> used;
  for (const Index s : sides)
    for (const Index v : arrangement.pieces[s / 2].v) used.push_back(v);
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  const auto number = [&](Index v) {
    return static_cast<Index>(std::lower_bound(used.begin(), used.end(), v) - used.begin());
  };
  ExactMesh mesh;
  auto rational = cells.exact.begin();
  for (const Index v : used) {
    rational =
        std::lower_bound(rational, cells.exact.end(), v, [](const ExactVertex& e, Index w) { return e.vertex < w; });
    if (rational != cells.exact.end() && rational->vertex == v) mesh.exact.push_back({number(v), rational->position});
    mesh.mesh.vertices.push_back(cells.points[v]);
  }
  for (const Index s : sides) {
    auto [a, b, c] = arrangement.pieces[s / 2].v;
    if (s % 2 == 0) std::swap(b, c);
    mesh.mesh.triangles.push_back({number(a), number(b), number(c)});
  }
  return mesh;
}

}  // namespace

Volumes find_volumes(const Arrangement& arrangement, const Cells& cells) {
  const auto pieces = static_cast<Index>(arrangement.pieces.size());
  Shells shells(arrangement, cells);
  std::map<Index, std::vector<Index>> sides_of;  // shell -> sides
  for (Index s = 0; s < 2 * pieces; ++s) sides_of[shells.shell(s)].push_back(s);
  std::map<Index, std::vector<Index>> shells_of;  // set -> shells
  for (const auto& [shell, sides] : sides_of) shells_of[shells.set(sides.front() / 2)].push_back(shell);

  Volumes result;
  std::vector<Index> volume(2 * std::size_t{pieces}, none);  // per shell
  std::vector<EnclosableSet> sets;
  for (const auto& [set, list] : shells_of) {
    EnclosableSet& s = sets.emplace_back();
    for (const Index shell : list)
      if (s.outer == none &&
          (list.size() == 1 || orientation(mesh_of(arrangement, cells, sides_of[shell])) != Sign::positive)) {
        s.outer = shell;
      } else {
        volume[shell] = result.count++;
      }
  }
  std::map<Index, Index> number;
  for (const auto& [set, list] : shells_of) number.emplace(set, static_cast<Index>(number.size()));
  for (Index p = 0; p < pieces; ++p) sets[number.at(shells.set(p))].pieces.push_back(p);
  const auto shell_of = [&](Index side) { return shells.shell(side); };
  const std::vector<Index> around = enclosing_shells(arrangement, cells, sets, shell_of);
  for (std::size_t i = 0; i < sets.size(); ++i) volume[sets[i].outer] = around[i] == none ? 0 : volume[around[i]];

  for (Index p = 0; p < pieces; ++p) {
    result.sides.push_back({volume[shells.shell(2 * p)], volume[shells.shell(2 * p + 1)]});
    result.plane.push_back(shells.plane(p));
  }
  return result;
}

}  // namespace strata::complex
