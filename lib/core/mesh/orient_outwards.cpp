#include <algorithm>
#include <utility>

#include "core/exact/pace.h"
#include "core/kernel/predicates.h"
#include "core/mesh/orient.h"
#include "core/mesh/product_sum.h"

namespace strata {
namespace {

/// A closed sheet that faces outwards, with its box and vertices.
struct Shell {
  std::size_t sheet;
  Vertex lower;
  Vertex upper;
  std::vector<std::uint32_t> vertices;  ///< sorted by z, then number
  std::uint32_t depth = 0;              ///< the number of others inside which it lies
};

/// Exact predicates of four or three vertices.
class Exactly {
 public:
  explicit Exactly(std::span<const Vertex> vertices) : vertices_(vertices) { input_.add(vertices, {}); }

  /// Orientation of a, b, p seen from positive x, in the plane of y and z.
  [[nodiscard]] int turn_yz(std::uint32_t a, std::uint32_t b, std::uint32_t p) const {
    const auto point = [&](std::uint32_t v) { return Point::free(vertices_[v]); };
    return to_int(orient2d(input_, Projection{1, 2}, point(a), point(b), point(p)));
  }

  [[nodiscard]] int side(const Triangle& t, std::uint32_t p) const {
    return to_int(orient3d(input_, t[0], t[1], t[2], p));
  }

 private:
  std::span<const Vertex> vertices_;
  InputComplex input_;
};

/// Winding number of a triangle's projection along x about a vertex. A point on a side counts as right of it when the
/// side points upwards in z, for every triangle: as if the point were moved infinitesimally towards positive y, and
/// then z.
int winding_yz(std::span<const Vertex> vertices, const Exactly& exactly, const Triangle& t, std::uint32_t p) {
  const double z = vertices[p][2];
  int winding = 0;
  for (int k = 0; k < 3; ++k) {
    const std::uint32_t a = t[k], b = t[(k + 1) % 3];
    const bool a_below = vertices[a][2] <= z, b_below = vertices[b][2] <= z;
    if (a_below && !b_below) winding += exactly.turn_yz(a, b, p) > 0;
    if (!a_below && b_below) winding -= exactly.turn_yz(b, a, p) > 0;
  }
  return winding;
}

Shell make_shell(std::span<const Vertex> vertices, const std::vector<Triangle>& triangles, const Sheets& sheets,
                 std::size_t sheet, Pace& pace) {
  Shell shell{sheet, {}, {}, {}};
  for (const std::uint32_t t : sheets.triangles[sheet]) {
    shell.vertices.insert(shell.vertices.end(), triangles[t].begin(), triangles[t].end());
  }
  auto& list = shell.vertices;
  std::sort(list.begin(), list.end(), [&](std::uint32_t a, std::uint32_t b) {
    pace.step();
    return std::pair(vertices[a][2], a) < std::pair(vertices[b][2], b);
  });
  list.erase(std::unique(list.begin(), list.end()), list.end());
  shell.lower = shell.upper = vertices[list.front()];
  for (const std::uint32_t v : list) {
    for (int i = 0; i < 3; ++i) {
      shell.lower[i] = std::min(shell.lower[i], vertices[v][i]);
      shell.upper[i] = std::max(shell.upper[i], vertices[v][i]);
    }
  }
  return shell;
}

bool box_inside(const Shell& inner, const Shell& outer) {
  for (int i = 0; i < 3; ++i) {
    if (inner.lower[i] < outer.lower[i] || outer.upper[i] < inner.upper[i]) return false;
  }
  return true;
}

/// Winding number of the outer shell about every vertex of the inner one, by the faces beyond it along x.
std::vector<int> windings(std::span<const Vertex> vertices, const std::vector<Triangle>& triangles,
                          const Exactly& exactly, const Shell& inner, const std::vector<std::uint32_t>& outer_faces,
                          const Monitor& monitor) {
  std::vector<int> result(inner.vertices.size(), 0);
  Pace pace(monitor);
  for (const std::uint32_t f : outer_faces) {
    const Triangle& t = triangles[f];
    const auto [low, high] = std::minmax({vertices[t[0]][2], vertices[t[1]][2], vertices[t[2]][2]});
    auto v = std::lower_bound(inner.vertices.begin(), inner.vertices.end(), low,
                              [&](std::uint32_t a, double z) { return vertices[a][2] < z; });
    for (; v != inner.vertices.end() && vertices[*v][2] < high; ++v) {
      pace.step();
      const int winding = winding_yz(vertices, exactly, t, *v);
      if (winding != 0 && winding * exactly.side(t, *v) < 0) result[v - inner.vertices.begin()] += winding;
    }
  }
  return result;
}

bool lies_inside(std::span<const Vertex> vertices, const std::vector<Triangle>& triangles, const Exactly& exactly,
                 const Shell& inner, const Shell& outer, const std::vector<std::uint32_t>& outer_faces,
                 const Monitor& monitor) {
  std::vector<std::uint32_t> of_outer = outer.vertices;
  std::sort(of_outer.begin(), of_outer.end());
  const std::vector<int> winding = windings(vertices, triangles, exactly, inner, outer_faces, monitor);
  bool any = false;
  for (std::size_t i = 0; i < winding.size(); ++i) {
    if (std::binary_search(of_outer.begin(), of_outer.end(), inner.vertices[i])) continue;
    if (winding[i] <= 0) return false;
    any = true;
  }
  return any;
}

/// Counts for every shell the shells inside which it lies. Shells are processed by increasing lower x; those that end
/// before are removed.
void find_depths(std::span<const Vertex> vertices, const std::vector<Triangle>& triangles, const Sheets& sheets,
                 std::vector<Shell>& shells, const Monitor& monitor) {
  const Exactly exactly(vertices);
  std::sort(shells.begin(), shells.end(), [](const Shell& a, const Shell& b) {
    return a.lower[0] != b.lower[0] ? a.lower[0] < b.lower[0] : a.sheet < b.sheet;
  });
  std::vector<const Shell*> active;
  const auto count_if_inside = [&](Shell& inner, const Shell& outer) {
    monitor.check();
    if (box_inside(inner, outer)) {
      inner.depth += lies_inside(vertices, triangles, exactly, inner, outer, sheets.triangles[outer.sheet], monitor);
    }
  };
  for (std::size_t i = 0; i < shells.size(); ++i) {
    std::erase_if(active, [&](const Shell* s) { return s->upper[0] < shells[i].lower[0]; });
    for (const Shell* outer : active) count_if_inside(shells[i], *outer);
    active.push_back(&shells[i]);
  }
  for (std::size_t i = 1; i < shells.size(); ++i) {  // equal lower x: either may be the outer one
    for (std::size_t j = i; j-- > 0 && shells[j].lower[0] == shells[i].lower[0];) count_if_inside(shells[j], shells[i]);
  }
}

void reverse(std::vector<Triangle>& triangles, const std::vector<std::uint32_t>& sheet) {
  for (const std::uint32_t t : sheet) std::swap(triangles[t][1], triangles[t][2]);
}

int volume_sign(std::span<const Vertex> vertices, const std::vector<Triangle>& triangles,
                const std::vector<std::uint32_t>& sheet, Pace& pace) {
  ProductSum volume;
  for (const std::uint32_t f : sheet) {
    pace.step();
    const Triangle& t = triangles[f];
    volume.add_determinant(vertices[t[0]], vertices[t[1]], vertices[t[2]]);
  }
  return volume.sign();
}

}  // namespace

Shells orient_outwards(std::span<const Vertex> vertices, std::vector<Triangle>& triangles, const Sheets& sheets,
                       const std::vector<bool>& trusted, const Monitor& monitor) {
  std::vector<bool> reversed(sheets.triangles.size(), false);
  std::vector<Shell> shells;
  Pace pace(monitor);
  for (std::size_t s = 0; s < sheets.triangles.size(); ++s) {
    if (!sheets.closed[s]) continue;
    const int sign = volume_sign(vertices, triangles, sheets.triangles[s], pace);
    if (sign == 0) continue;
    reversed[s] = sign < 0;
    if (reversed[s]) reverse(triangles, sheets.triangles[s]);
    shells.push_back(make_shell(vertices, triangles, sheets, s, pace));
  }
  Shells result;
  find_depths(vertices, triangles, sheets, shells, monitor);
  for (const Shell& shell : shells) {
    if (shell.depth % 2 == 0) continue;
    if (!trusted.empty() && trusted[shell.sheet] && !reversed[shell.sheet]) continue;
    ++result.cavities;
    reverse(triangles, sheets.triangles[shell.sheet]);
    reversed[shell.sheet] = !reversed[shell.sheet];
  }
  result.reversed = static_cast<std::uint64_t>(std::count(reversed.begin(), reversed.end(), true));
  return result;
}

}  // namespace strata
