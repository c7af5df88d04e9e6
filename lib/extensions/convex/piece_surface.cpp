#include "extensions/convex/piece_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "core/kernel/filters.h"

namespace strata::convex {
namespace {

using Side = std::pair<std::uint32_t, std::uint32_t>;  ///< from, to

/// Calls visit(from, to) for each side of a polygon.
template <class Visit>
void for_each_side(const std::vector<std::uint32_t>& corners, const Visit& visit) {
  for (std::size_t i = 0; i < corners.size(); ++i) visit(corners[i], corners[(i + 1) % corners.size()]);
}

/// Finds the points within sides: ends of other sides.
class SideDivider {
 public:
  SideDivider(const ExactMeshView& points, std::span<const PiecePolygon> polygons) : points_(points) {
    for (const PiecePolygon& p : polygons)
      for_each_side(p.corners, [&](std::uint32_t from, std::uint32_t to) { sides_.emplace_back(from, to); });
    std::sort(sides_.begin(), sides_.end());
    for (const auto& [from, to] : sides_)
      if (!is_shared(from, to)) ends_.insert(ends_.end(), {from, to});
    std::sort(ends_.begin(), ends_.end());
    ends_.erase(std::unique(ends_.begin(), ends_.end()), ends_.end());
  }

  /// The points strictly between the ends of a side, in its direction. Along a line points are in lexicographic order,
  /// in one direction or the other.
  [[nodiscard]] std::vector<std::uint32_t> within(std::uint32_t from, std::uint32_t to) const {
    if (is_shared(from, to)) return {};
    const auto [low, high] = std::minmax(from, to);
    std::vector<std::uint32_t> found;
    const auto last = std::lower_bound(ends_.begin(), ends_.end(), high);
    for (auto p = std::upper_bound(ends_.begin(), ends_.end(), low); p < last; ++p)
      if (are_collinear(low, high, *p)) found.push_back(*p);
    if (from > to) std::reverse(found.begin(), found.end());
    return found;
  }

 private:
  [[nodiscard]] bool is_shared(std::uint32_t from, std::uint32_t to) const {
    return std::binary_search(sides_.begin(), sides_.end(), Side(to, from));
  }

  [[nodiscard]] bool are_collinear(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    const BoundedPoint p = bounded(a);
    for (const Bounded& x : cross<Bounded>(bounded(b) - p, bounded(c) - p)) {
      const std::optional<Sign> sign = x.sign();
      if (sign && *sign != Sign::zero) return false;
    }
    return are_collinear_exactly(points_.position(a), points_.position(b), points_.position(c));
  }

  /// Products of integers: to bring fractions to lowest terms would take longer than all the rest.
  static bool are_collinear_exactly(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c) {
    std::array<Integer, 3> u, v, of_b, of_c;  // b - a and c - a without denominators; denominators of b and c
    for (std::size_t i = 0; i < 3; ++i) {
      const Integer of_a = denominator(a[i]);
      of_b[i] = denominator(b[i]);
      of_c[i] = denominator(c[i]);
      u[i] = numerator(b[i]) * of_a - numerator(a[i]) * of_b[i];
      v[i] = numerator(c[i]) * of_a - numerator(a[i]) * of_c[i];
    }
    for (std::size_t i = 0, j = 1; i < 3; ++i, j = (j + 1) % 3)
      if (u[i] * v[j] * of_b[j] * of_c[i] != u[j] * v[i] * of_b[i] * of_c[j]) return false;
    return true;
  }
  /// Bounds of the exact position of a point that is known by nearest doubles.
  [[nodiscard]] BoundedPoint bounded(std::uint32_t point) const {
    BoundedPoint p;
    for (std::size_t i = 0; i < 3; ++i) {
      const double x = points_.mesh.vertices[point][i];
      p[i] = Bounded(x, std::abs(x) * Bounded::rounding + Bounded::underflow);
    }
    return p;
  }

  const ExactMeshView& points_;
  std::vector<Side> sides_;          ///< of all polygons, sorted
  std::vector<std::uint32_t> ends_;  ///< of sides that are not shared as a whole, sorted
};

/// A convex polygon with points within its sides, during triangulation.
class DividedPolygon {
 public:
  DividedPolygon(const std::vector<std::uint32_t>& corners, const SideDivider& divider) {
    for_each_side(corners, [&](std::uint32_t from, std::uint32_t to) {
      loop_.push_back({from, false});
      for (const std::uint32_t p : divider.within(from, to)) loop_.push_back({p, true});
    });
  }

  /// Calls emit(triangle). A corner is cut off with its neighbours, which are then corners. When all other points are
  /// on one line, the triangles from the corner to this line are left. theory.md, "Pieces with attributes".
  template <class Emit>
  void triangulate(const Emit& emit) {
    for (std::size_t i = 1;; i = 1) {
      if (const auto apex = apex_of_fan()) return fan(*apex, emit);
      while (loop_[i].is_flat) ++i;
      LoopPoint &before = loop_[i - 1], &after = loop_[(i + 1) % loop_.size()];
      emit(Triangle{before.point, loop_[i].point, after.point});
      before.is_flat = after.is_flat = false;
      loop_.erase(loop_.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }

 private:
  struct LoopPoint {
    std::uint32_t point = 0;
    bool is_flat = false;  ///< within a side
  };

  /// The corner opposite to a line with all other points, the first of several.
  [[nodiscard]] std::optional<std::size_t> apex_of_fan() const {
    const std::size_t n = loop_.size();
    const auto flat = [](const LoopPoint& p) { return p.is_flat; };
    if (std::count_if(loop_.begin(), loop_.end(), flat) + 3 != static_cast<std::ptrdiff_t>(n)) return std::nullopt;
    for (std::size_t i = 0; i < n; ++i)
      if (!loop_[i].is_flat && !loop_[(i + 1) % n].is_flat && !loop_[(i + n - 1) % n].is_flat) return i;
    return std::nullopt;
  }

  template <class Emit>
  void fan(std::size_t apex, const Emit& emit) const {
    const std::size_t n = loop_.size();
    for (std::size_t k = 1; k + 1 < n; ++k)
      emit(Triangle{loop_[apex].point, loop_[(apex + k) % n].point, loop_[(apex + k + 1) % n].point});
  }

  std::vector<LoopPoint> loop_;
};

}  // namespace

PieceSurface piece_surface(ExactMeshView points, std::span<const PiecePolygon> polygons) {
  const SideDivider divider(points, polygons);
  PieceSurface surface;
  for (const PiecePolygon& p : polygons)
    DividedPolygon(p.corners, divider).triangulate([&](const Triangle& t) {
      surface.triangles.push_back(t);
      surface.sources.push_back(p.source);
    });
  return surface;
}

}  // namespace strata::convex
