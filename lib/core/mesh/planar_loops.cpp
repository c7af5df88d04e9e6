#include "core/mesh/planar_loops.h"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

namespace strata::facets {
namespace {

/// Traces the sides of one region.
class Tracer {
 public:
  Tracer(const PointTable& points, Projection axes, const Region& region)
      : points_(points), axes_(axes), facing_(region.facing), sides_(region.sides), used_(sides_.size(), false) {
    std::sort(sides_.begin(), sides_.end(),
              [](const Side& a, const Side& b) { return std::tie(a.from, a.to) < std::tie(b.from, b.to); });
  }

  std::vector<Loop> loops() {
    std::vector<Loop> result;
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      if (used_[i]) continue;
      Loop loop = without_straight_vertices(walk(i));
      if (loop.size() >= 3) result.push_back(std::move(loop));
    }
    return result;
  }

 private:
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  /// The orientation as seen from outside.
  [[nodiscard]] int orientation_at(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    const int sign = orientation(points_, axes_, a, b, c);
    return facing_ == Facing::front ? sign : -sign;
  }

  [[nodiscard]] std::pair<std::size_t, std::size_t> leaving(std::uint32_t vertex) const {
    const auto less = [](const Side& side, std::uint32_t v) { return side.from < v; };
    const auto begin = std::lower_bound(sides_.begin(), sides_.end(), vertex, less);
    auto end = begin;
    while (end != sides_.end() && end->from == vertex) ++end;
    return {begin - sides_.begin(), end - sides_.begin()};
  }

  /// After a side with the region on its left, the boundary of the same sector continues along the first side in
  /// clockwise rotation from the reverse of the arriving side: the sharpest turn to the left.
  [[nodiscard]] std::size_t next(const Side& arriving) const {
    const auto [begin, end] = leaving(arriving.to);
    std::size_t best = none;
    for (std::size_t i = begin; i < end; ++i) {
      if (!used_[i] && (best == none || is_sharper(arriving, sides_[i].to, sides_[best].to))) best = i;
    }
    return best;
  }

  [[nodiscard]] bool is_sharper(const Side& arriving, std::uint32_t a, std::uint32_t b) const {
    const int turn_a = orientation_at(arriving.from, arriving.to, a);
    const int turn_b = orientation_at(arriving.from, arriving.to, b);
    return turn_a != turn_b ? turn_a > turn_b : orientation_at(arriving.to, b, a) > 0;
  }

  [[nodiscard]] Loop walk(std::size_t start) {
    Loop loop;
    for (std::size_t i = start; i != none; i = next(sides_[i])) {
      used_[i] = true;
      loop.push_back(sides_[i].from);
      if (closes(sides_[i], start)) break;
    }
    return loop;
  }

  /// True if the sector of arrival at the start is the one of departure.
  [[nodiscard]] bool closes(const Side& arriving, std::size_t start) const {
    if (arriving.to != sides_[start].from) return false;
    const std::size_t other = next(arriving);
    return other == none || is_sharper(arriving, sides_[start].to, sides_[other].to);
  }

  [[nodiscard]] Loop without_straight_vertices(const Loop& loop) const {
    Loop corners;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const std::uint32_t before = loop[i == 0 ? loop.size() - 1 : i - 1];
      const std::uint32_t after = loop[i + 1 == loop.size() ? 0 : i + 1];
      const auto [begin, end] = leaving(loop[i]);
      if (end - begin > 1 || orientation_at(before, loop[i], after) != 0) corners.push_back(loop[i]);
    }
    return corners;
  }

  const PointTable& points_;
  Projection axes_;
  Facing facing_;
  std::vector<Side> sides_;
  std::vector<bool> used_;
};

}  // namespace

std::vector<Loop> boundary_loops(const PointTable& points, Projection axes, const Region& region) {
  return Tracer(points, axes, region).loops();
}

}  // namespace strata::facets
