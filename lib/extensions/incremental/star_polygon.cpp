#include "extensions/incremental/star_polygon.h"

#include <cmath>

#include "core/kernel/predicates.h"

namespace strata {
namespace {

/// Axes in which the plane has its own orientation.
Projection projection_of(const SourcePlane& plane) {
  std::size_t axis = 0;
  const auto& n = plane.normal();
  for (std::size_t i = 1; i < 3; ++i)
    if (std::abs(n[i].value) > std::abs(n[axis].value)) axis = i;
  const int u = static_cast<int>((axis + 1) % 3), v = static_cast<int>((axis + 2) % 3);
  return n[axis].value > 0 ? Projection{u, v} : Projection{v, u};
}

class EarCutter {
 public:
  EarCutter(const InputComplex& input, const PointTable& points, Projection projection,
            std::span<const PointId> polygon)
      : input_(input), projection_(projection), ids_(polygon.begin(), polygon.end()) {
    for (const PointId id : polygon) points_.push_back(points.point(id));
  }

  std::optional<std::vector<std::array<PointId, 3>>> cut() {
    std::vector<std::array<PointId, 3>> triangles;
    while (ids_.size() > 3) {
      const std::optional<std::size_t> ear = best_ear();
      if (!ear) return std::nullopt;
      triangles.push_back({ids_[before(*ear)], ids_[*ear], ids_[after(*ear)]});
      ids_.erase(ids_.begin() + static_cast<std::ptrdiff_t>(*ear));
      points_.erase(points_.begin() + static_cast<std::ptrdiff_t>(*ear));
    }
    if (ids_.size() < 3 || orientation(0, 1, 2) != Sign::positive) return std::nullopt;
    triangles.push_back({ids_[0], ids_[1], ids_[2]});
    return triangles;
  }

 private:
  [[nodiscard]] std::size_t before(std::size_t i) const { return (i + ids_.size() - 1) % ids_.size(); }
  [[nodiscard]] std::size_t after(std::size_t i) const { return (i + 1) % ids_.size(); }
  [[nodiscard]] Sign orientation(std::size_t a, std::size_t b, std::size_t c) const {
    return orient2d(input_, projection_, points_[a], points_[b], points_[c]);
  }

  [[nodiscard]] std::optional<std::size_t> best_ear() const {
    std::optional<std::size_t> best;
    double roundest = -1;
    for (std::size_t i = 0; i < ids_.size(); ++i) {
      const double round = roundness(before(i), i, after(i));
      if (round > roundest && is_ear(i)) {
        best = i;
        roundest = round;
      }
    }
    return best;
  }

  [[nodiscard]] bool is_ear(std::size_t i) const {
    const std::size_t a = before(i), c = after(i);
    if (orientation(a, i, c) != Sign::positive) return false;
    for (std::size_t k = after(c); k != a; k = after(k))
      if (orientation(a, i, k) != Sign::negative && orientation(i, c, k) != Sign::negative &&
          orientation(c, a, k) != Sign::negative)
        return false;
    return true;
  }

  /// Area divided by the square of the longest side, in doubles: 0 for a sliver.
  [[nodiscard]] double roundness(std::size_t a, std::size_t b, std::size_t c) const {
    const auto u = difference(a, b), v = difference(b, c), w = difference(c, a);
    const double longest = std::max({length2(u), length2(v), length2(w)});
    const double area = std::abs(u[0] * v[1] - u[1] * v[0]);
    return longest > 0 ? area / longest : 0;
  }
  [[nodiscard]] std::array<double, 2> difference(std::size_t a, std::size_t b) const {
    const auto u = static_cast<std::size_t>(projection_.u), v = static_cast<std::size_t>(projection_.v);
    return {points_[b].at[u].value - points_[a].at[u].value, points_[b].at[v].value - points_[a].at[v].value};
  }
  static double length2(const std::array<double, 2>& d) { return d[0] * d[0] + d[1] * d[1]; }

  const InputComplex& input_;
  const Projection projection_;
  std::vector<PointId> ids_;
  std::vector<Point> points_;
};

}  // namespace

std::optional<std::vector<std::array<PointId, 3>>> triangulate_star(const InputComplex& input, const PointTable& points,
                                                                    const SourcePlane& plane,
                                                                    std::span<const PointId> polygon) {
  return EarCutter(input, points, projection_of(plane), polygon).cut();
}

}  // namespace strata
