#include "extensions/complex/enclosing.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/kernel/predicates.h"
#include "core/kernel/ray_crossing.h"

namespace strata::complex {
namespace {

using Index = std::uint32_t;

struct RayBox {
  std::array<double, 3> lower{HUGE_VAL, HUGE_VAL, HUGE_VAL}, upper{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};

  void add(const Vertex& p) {
    for (std::size_t i = 0; i < 3; ++i) {
      lower[i] = std::min(lower[i], p[i]);
      upper[i] = std::max(upper[i], p[i]);
    }
  }
  /// Rounding is monotone, so a box of rounded points contains all rounded points of the triangle.
  [[nodiscard]] bool is_on_ray(const Vertex& from) const {
    return upper[0] >= from[0] && lower[1] <= from[1] && from[1] <= upper[1] && lower[2] <= from[2] &&
           from[2] <= upper[2];
  }
};

}  // namespace

std::vector<std::uint32_t> enclosing_shells(const Arrangement& arrangement, const Cells& cells,
                                            std::span<const EnclosableSet> sets,
                                            const std::function<std::uint32_t(std::uint32_t)>& shell_of) {
  std::vector<Index> result(sets.size(), none);
  if (sets.size() < 2) return result;
  std::vector<Triangle> triangles;
  for (const Piece& p : arrangement.pieces) triangles.push_back(p.v);
  InputComplex input;
  input.add(cells.points, triangles, cells.exact);
  std::vector<RayBox> boxes(sets.size());
  for (std::size_t i = 0; i < sets.size(); ++i)
    for (const Index p : sets[i].pieces)
      for (const Index v : triangles[p]) boxes[i].add(cells.points[v]);

  std::map<Index, std::size_t> set_of_shell;
  std::vector<std::vector<Index>> around(sets.size());  // shells
  for (std::size_t i = 0; i < sets.size(); ++i) {
    const Point from = make_point(input, SymbolicPoint::weighted(sets[i].pieces.front(), 1));
    const Vertex rounded = nearest_doubles(input, from);
    for (std::size_t j = 0; j < sets.size(); ++j) {
      if (j == i || !boxes[j].is_on_ray(rounded)) continue;
      std::map<Index, int> windings;
      for (const Index p : sets[j].pieces) {
        std::array<Point, 3> corners;
        for (std::size_t c = 0; c < 3; ++c) corners[c] = make_point(input, SymbolicPoint::input(triangles[p][c]));
        const int out = crossing_along_x(input, p, corners, from);
        if (out == 0) continue;
        windings[shell_of(2 * p)] -= out;
        windings[shell_of(2 * p + 1)] += out;
      }
      for (const auto& [shell, winding] : windings)
        if (winding == 1 && shell != sets[j].outer) {
          around[i].push_back(shell);
          set_of_shell.emplace(shell, j);
        }
    }
  }
  for (std::size_t i = 0; i < sets.size(); ++i) {  // shells around a point are nested: the inner ones are in more
    std::size_t most = 0;
    for (const Index shell : around[i])
      if (const std::size_t depth = 1 + around[set_of_shell.at(shell)].size(); depth > most) {
        most = depth;
        result[i] = shell;
      }
  }
  return result;
}

}  // namespace strata::complex
