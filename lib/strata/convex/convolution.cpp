#include "strata/convex/convolution.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>

#include "strata/convex/directions.h"
#include "strata/convex/rings.h"
#include "strata/convex/sum_points.h"

namespace strata::convex {
namespace {

constexpr std::uint32_t none = Surface::no_face;

/// A bit per face of one surface and edge of the other.
class BitRows {
 public:
  BitRows(std::size_t rows, std::size_t columns) : words_((columns + 63) / 64), bits_(rows * words_) {}

  [[nodiscard]] bool at(std::size_t row, std::size_t column) const {
    return (bits_[row * words_ + column / 64] >> (column % 64) & 1) != 0;
  }
  void set(std::size_t row, std::size_t column) {
    bits_[row * words_ + column / 64] |= std::uint64_t{1} << (column % 64);
  }
  /// Visits the columns in which two rows differ.
  template <class Visit>
  void differences(std::size_t first, std::size_t second, Visit visit) const {
    for (std::size_t w = 0; w < words_; ++w)
      for (std::uint64_t x = bits_[first * words_ + w] ^ bits_[second * words_ + w]; x != 0; x &= x - 1)
        visit(static_cast<std::uint32_t>(64 * w + static_cast<std::size_t>(std::countr_zero(x))));
  }

 private:
  std::size_t words_;
  std::vector<std::uint64_t> bits_;
};

/// Two edges whose arcs of outward directions cross: their parallelogram is a piece.
struct Crossing {
  std::uint32_t a = 0, b = 0;  ///< edges
  bool left_of_a = false;      ///< the normal of a's left face is on the positive side of b
  bool left_of_b = false;
};

/// By how much the index of a fan changes from the left to the right face of an edge of the other surface.
struct Jump {
  std::uint32_t edge = 0;
  int by = 0;
};

template <class N>
class Convolver {
 public:
  Convolver(const Surface& a, const LatticePoints& on_a, const Surface& b, const LatticePoints& on_b,
            const Monitor& monitor)
      : a_(a),
        b_(b),
        a_directions_(directions_of<N>(a, on_a)),
        b_directions_(directions_of<N>(b, on_b)),
        sums_(a.points, b.points),
        monitor_(monitor) {}

  Convolution run() {
    if (has_rings(a_, a_directions_, b_, b_directions_)) return {{}, true};
    if (!b_.is_convex && has_rings(b_, b_directions_, a_, a_directions_)) return {{}, true};
    find_crossings();
    monitor_.check();
    add_parallelograms();
    // Faces of A at the vertices of B, and faces of B at those of A.
    const auto jumps_of_a = jumps(a_, a_directions_, true);
    const auto jumps_of_b = jumps(b_, b_directions_, false);
    add_faces(
        a_, jumps_of_b, b_, [&](std::size_t fan, std::uint32_t face) { return bound_of_b(fan, face); }, false);
    monitor_.check();
    add_faces(
        b_, jumps_of_a, a_, [&](std::size_t fan, std::uint32_t face) { return bound_of_a(fan, face); }, true);
    Convolution result{std::move(sums_.points()), false};
    result.surface.mesh.triangles = std::move(triangles_);
    return result;
  }

 private:
  // The directions of B are those of B turned by I + E with infinitesimal E, so that nothing is parallel to anything.
  /// Side of a normal of A with respect to an edge of B: scalar product with the edge as turned.
  [[nodiscard]] bool face_of_a_beyond(std::uint32_t face, std::uint32_t edge) const {
    const int sign = product_sign(a_directions_.normals, face, b_directions_.edges, edge);
    return (sign != 0
                ? sign
                : turned_sign(a_directions_.normals.approximate[face], b_directions_.edges.approximate[edge])) > 0;
  }
  /// Side of a normal of B with respect to an edge of A: turning normals by the inverse transpose of I + E is turning
  /// the edge by I - E.
  [[nodiscard]] bool face_of_b_beyond(std::uint32_t face, std::uint32_t edge) const {
    const int sign = product_sign(b_directions_.normals, face, a_directions_.edges, edge);
    return (sign != 0
                ? sign
                : -turned_sign(b_directions_.normals.approximate[face], a_directions_.edges.approximate[edge])) > 0;
  }

  void find_crossings() {
    BitRows beyond(a_.faces.size(), b_.edges.size());
    tbb::parallel_for(std::uint32_t{0}, static_cast<std::uint32_t>(a_.faces.size()), [&](std::uint32_t f) {
      for (std::uint32_t g = 0; g < b_.edges.size(); ++g)
        if (face_of_a_beyond(f, g)) beyond.set(f, g);
    });
    beyond_ = std::make_unique<BitRows>(std::move(beyond));
    for (std::uint32_t e = 0; e < a_.edges.size(); ++e) {
      if (a_directions_.bend[e] == 0) continue;
      beyond_->differences(a_.edges[e].left, a_.edges[e].right, [&](std::uint32_t g) { add_crossing(e, g); });
    }
  }

  /// The great circles of two arcs cross in two opposite directions; both arcs must pass through the same one.
  void add_crossing(std::uint32_t e, std::uint32_t g) {
    if (b_directions_.bend[g] == 0) return;
    const bool left_of_a = beyond_->at(a_.edges[e].left, g);
    const SurfaceEdge& edge = b_.edges[g];
    if (edge.left == none) {
      crossings_.push_back({e, g, left_of_a, false});
      return;
    }
    const bool left_of_b = face_of_b_beyond(edge.left, e);
    if (left_of_b == face_of_b_beyond(edge.right, e)) return;
    const bool same_bend = a_directions_.bend[e] == b_directions_.bend[g];
    if ((left_of_a != left_of_b) == same_bend) crossings_.push_back({e, g, left_of_a, left_of_b});
  }

  /// The parallelogram's outward normal is e x g times the bend of g times the side of a's left face.
  void add_parallelograms() {
    for (const Crossing& c : crossings_) {
      const SurfaceEdge &e = a_.edges[c.a], &g = b_.edges[c.b];
      const std::uint32_t p = sums_.number(e.from, g.from), q = sums_.number(e.to, g.from),
                          r = sums_.number(e.to, g.to), s = sums_.number(e.from, g.to);
      const bool turned = c.left_of_a != (b_directions_.bend[c.b] > 0);
      if (is_flat(c)) continue;
      add_triangle({p, q, r}, turned);
      add_triangle({p, r, s}, turned);
    }
  }

  /// Edges in parallel: the parallelogram is a segment.
  [[nodiscard]] bool is_flat(const Crossing& c) const {
    const auto &u = a_directions_.edges.approximate[c.a], &v = b_directions_.edges.approximate[c.b];
    for (std::size_t i = 0; i < 3; ++i) {
      const double x = u[(i + 1) % 3] * v[(i + 2) % 3], y = u[(i + 2) % 3] * v[(i + 1) % 3];
      if (std::abs(x - y) > 16 * 0x1p-53 * (std::abs(x) + std::abs(y))) return false;
    }
    const auto n = cross(a_directions_.edges.exact[c.a], b_directions_.edges.exact[c.b]);
    return sign_number(n[0]) == 0 && sign_number(n[1]) == 0 && sign_number(n[2]) == 0;
  }

  void add_triangle(Triangle t, bool turned) {
    if (turned) std::swap(t[1], t[2]);
    triangles_.push_back(t);
  }

  /// Per fan of one operand, how its index changes over edges of the other.
  [[nodiscard]] std::vector<std::vector<Jump>> jumps(const Surface& surface, const Directions<N>& directions,
                                                     bool of_a) const {
    std::vector<std::vector<Jump>> result(surface.fans.size());
    for (const Crossing& c : crossings_) {
      const std::uint32_t own = of_a ? c.a : c.b, other = of_a ? c.b : c.a;
      const int by = (of_a ? c.left_of_b : c.left_of_a) ? directions.bend[own] : -directions.bend[own];
      result[surface.edges[own].fans[0]].push_back({other, by});
      result[surface.edges[own].fans[1]].push_back({other, -by});
    }
    return result;
  }

  /// The index of a fan for the normal of a face of the other surface, or a bound from above.
  struct Bound {
    int value = 0;
    bool is_exact = false;
  };

  template <class Beyond>
  [[nodiscard]] Bound bound(const Surface& surface, const Directions<N>& directions, const Fan& fan,
                            Beyond beyond) const {
    std::size_t above = 0, changes = 0, convex = 0, reflex = 0;
    for (std::size_t i = 0; i < fan.spokes.size(); ++i) {
      const auto is_above = [&](const Fan::Spoke& s) { return beyond(s.edge) == s.outgoing; };
      const bool here = is_above(fan.spokes[i]);
      above += here;
      changes += here != is_above(fan.spokes[(i + 1) % fan.spokes.size()]);
      convex += directions.bend[fan.spokes[i].edge] > 0;
      reflex += directions.bend[fan.spokes[i].edge] < 0;
    }
    if (surface.is_convex) return {above == 0 ? 1 : 0, true};
    if (changes == 2) return {0, true};
    if (changes > 2) return {0, false};
    if (reflex == 0) return {above == 0 ? 1 : 0, true};
    if (convex == 0) return {above == 0 ? 0 : 1, true};
    return {1, false};
  }
  [[nodiscard]] Bound bound_of_a(std::size_t fan, std::uint32_t face) const {
    return bound(a_, a_directions_, a_.fans[fan], [&](std::uint32_t e) { return face_of_b_beyond(face, e); });
  }
  [[nodiscard]] Bound bound_of_b(std::size_t fan, std::uint32_t face) const {
    return bound(b_, b_directions_, b_.fans[fan], [&](std::uint32_t g) { return beyond_->at(face, g); });
  }

  /// Faces of one surface at the vertices of the other, as often as their indices say.
  template <class BoundAt>
  void add_faces(const Surface& surface, const std::vector<std::vector<Jump>>& all_jumps, const Surface& other,
                 BoundAt bound_at, bool vertices_of_a) {
    const Sides sides(surface);
    std::vector<int> indices(surface.faces.size());
    for (std::size_t fan = 0; fan < all_jumps.size(); ++fan) {
      sides.follow(all_jumps[fan], indices);
      for (const auto& part : sides.parts()) {
        const int base = base_of(part, indices, [&](std::uint32_t face) { return bound_at(fan, face); });
        for (const std::uint32_t f : part)
          if (const int index = indices[f] + base; index != 0)
            add_face(surface.faces[f], other.fans[fan].vertex, index, vertices_of_a);
      }
    }
  }

  /// What is to be added to indices that start with 0: from a face where the index is known, or from bounds.
  template <class BoundAt>
  static int base_of(const std::vector<std::uint32_t>& part, const std::vector<int>& indices, BoundAt bound_at) {
    std::optional<int> least;
    for (const std::uint32_t f : part) {
      const Bound found = bound_at(f);
      const int base = found.value - indices[f];
      if (found.is_exact) return base;
      if (!least || base < *least) least = base;
    }
    return least.value_or(0);
  }

  void add_face(const std::vector<std::uint32_t>& loop, std::uint32_t vertex, int index, bool vertex_of_a) {
    std::vector<std::uint32_t> corners;
    for (const std::uint32_t v : loop)
      corners.push_back(vertex_of_a ? sums_.number(vertex, v) : sums_.number(v, vertex));
    for (int copies = std::abs(index); copies > 0; --copies)
      for (std::size_t i = 2; i < corners.size(); ++i)
        add_triangle({corners[0], corners[i - 1], corners[i]}, index < 0);
  }

  /// Faces from neighbour to neighbour, in each connected part.
  class Sides {
   public:
    explicit Sides(const Surface& surface) : steps_(surface.faces.size()) {
      if (surface.faces.empty()) return;
      std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>> next(surface.faces.size());
      for (std::uint32_t e = 0; e < surface.edges.size(); ++e) {
        next[surface.edges[e].left].push_back({surface.edges[e].right, e});
        next[surface.edges[e].right].push_back({surface.edges[e].left, e});
      }
      std::vector<bool> seen(surface.faces.size(), false);
      for (std::uint32_t start = 0; start < seen.size(); ++start) {
        if (seen[start]) continue;
        parts_.emplace_back(1, start);
        seen[start] = true;
        for (std::size_t i = 0; i < parts_.back().size(); ++i) {
          const std::uint32_t f = parts_.back()[i];
          for (const auto& [g, e] : next[f]) {
            if (seen[g]) continue;
            seen[g] = true;
            parts_.back().push_back(g);
            steps_[g] = {f, e, surface.edges[e].left == f ? 1 : -1};
          }
        }
      }
    }

    [[nodiscard]] const std::vector<std::vector<std::uint32_t>>& parts() const { return parts_; }

    /// Indices that are 0 at the first face of each part.
    void follow(const std::vector<Jump>& jumps, std::vector<int>& indices) const {
      if (jumps.empty()) {
        std::fill(indices.begin(), indices.end(), 0);
        return;
      }
      std::map<std::uint32_t, int> by_edge;
      for (const Jump& j : jumps) by_edge[j.edge] += j.by;
      for (const auto& part : parts_) {
        indices[part[0]] = 0;
        for (std::size_t i = 1; i < part.size(); ++i) {
          const Step& step = steps_[part[i]];
          const auto at = by_edge.find(step.edge);
          indices[part[i]] = indices[step.from] + (at == by_edge.end() ? 0 : step.sign * at->second);
        }
      }
    }

   private:
    struct Step {
      std::uint32_t from = 0, edge = 0;
      int sign = 1;
    };
    std::vector<std::vector<std::uint32_t>> parts_;
    std::vector<Step> steps_;
  };

  const Surface& a_;
  const Surface& b_;
  const Directions<N> a_directions_, b_directions_;
  SumPoints sums_;
  const Monitor& monitor_;
  std::unique_ptr<BitRows> beyond_;  ///< faces of A beyond edges of B
  std::vector<Crossing> crossings_;
  std::vector<Triangle> triangles_;
};

}  // namespace

Convolution convolution(const Surface& a, const Surface& b, const Monitor& monitor) {
  const LatticePoints on_a = lattice_points(a.points), on_b = lattice_points(b.points);
  const int bits = 3 * std::max(on_a.bits, on_b.bits) + 7;
  if (bits <= 128) return Convolver<__int128>(a, on_a, b, on_b, monitor).run();
  if (bits <= 256) return Convolver<WideInt<4>>(a, on_a, b, on_b, monitor).run();
  return Convolver<Integer>(a, on_a, b, on_b, monitor).run();
}

}  // namespace strata::convex
