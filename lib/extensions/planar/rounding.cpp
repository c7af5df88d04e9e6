#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "core/kernel/grid_rounding.h"
#include "strata/planar.h"

namespace strata::planar {
namespace {

/// So often crossings are rounded to the nearest numbers of the grid. Then edges are snapped to pixels, too. As a rule
/// that is the last round. If it is not so for long, each time leaves out more bits, of all vertices; without any bits,
/// all are 0, and the region is empty. So it ends.
constexpr std::uint32_t plain_rounds = 3;
constexpr std::uint32_t full_rounds = 40;
constexpr int bits_per_round = 2;

int bits_less_in(std::uint32_t round) {
  return round < full_rounds ? 0 : bits_per_round * static_cast<int>(round - full_rounds + 1);
}

/// At least the rounding error of a coordinate rounded to the nearest double.
double half_unit(double x) {
  const double size = std::abs(x), next = std::nextafter(size, std::numeric_limits<double>::infinity());
  const double unit = std::isfinite(next) ? next - size : size - std::nextafter(size, 0.0);
  return std::max(unit / 2, std::numeric_limits<double>::denorm_min());
}

/// Squares of one size that have vertices of a region in them.
class Pixels {
 public:
  /// `middle_of` gives the middle of the pixel that a coordinate is in.
  template <class MiddleOf>
  Pixels(const Region& region, const Rational& size, const MiddleOf& middle_of)
      : places_(region.loops.places), middle_(places_.place), half_(size / 2), reach_(to_nearest_double(half_)) {
    for (const std::uint32_t v : region.loops.vertices) {
      for (double& x : middle_[v]) x = middle_of(x);
      middles_.push_back(middle_[v]);
    }
    std::sort(middles_.begin(), middles_.end());
    middles_.erase(std::unique(middles_.begin(), middles_.end()), middles_.end());
  }

  [[nodiscard]] const Rational& half() const { return half_; }
  [[nodiscard]] const PlanePoint& middle(std::uint32_t vertex) const { return middle_[vertex]; }

  /// The middles of the pixels that the edge between two vertices meets, but for theirs, in the order along it.
  [[nodiscard]] std::vector<PlanePoint> between(std::uint32_t a, std::uint32_t b) const {
    const PlanePoint &p = places_.place[a], &q = places_.place[b];
    const double dx = q[0] - p[0], dy = q[1] - p[1];
    // Doubles are off by less than this from what is exact: half a pixel for each end, and a few for products.
    const double wide = 16 * reach_ * (std::abs(dx) + std::abs(dy)), around = 2 * reach_;
    std::vector<std::pair<double, PlanePoint>> met;
    const PlanePoint first{std::min(p[0], q[0]) - around, -std::numeric_limits<double>::infinity()};
    std::optional<Ends> ends;
    for (auto m = std::lower_bound(middles_.begin(), middles_.end(), first);
         m != middles_.end() && (*m)[0] <= std::max(p[0], q[0]) + around; ++m) {
      const PlanePoint& c = *m;
      if (c[1] < std::min(p[1], q[1]) - around || c[1] > std::max(p[1], q[1]) + around) continue;
      if (std::abs(dx * (c[1] - p[1]) - dy * (c[0] - p[0])) > wide || c == middle_[a] || c == middle_[b]) continue;
      if (!ends) ends.emplace(Ends{exact_position(places_, a), exact_position(places_, b)});
      if (meets(*ends, c)) met.emplace_back((c[0] - p[0]) * dx + (c[1] - p[1]) * dy, c);
    }
    std::sort(met.begin(), met.end());
    std::vector<PlanePoint> middles;
    for (const auto& [along, c] : met) middles.push_back(c);
    return middles;
  }

 private:
  struct Ends {
    RationalPlacement p, q;
  };
  /// Does the segment have a point in the closed pixel?
  [[nodiscard]] bool meets(const Ends& ends, const PlanePoint& c) const {
    const auto& [p, q] = ends;
    std::array<std::array<Rational, 2>, 2> bounds;  // per axis
    for (std::size_t i = 0; i < 2; ++i) {
      bounds[i] = {to_rational(c[i]) - half_, to_rational(c[i]) + half_};
      if ((p[i] < bounds[i][0] && q[i] < bounds[i][0]) || (p[i] > bounds[i][1] && q[i] > bounds[i][1])) return false;
    }
    bool is_above = false, is_below = false;
    for (const Rational& x : bounds[0])
      for (const Rational& y : bounds[1]) {
        const Rational side = (q[0] - p[0]) * (y - p[1]) - (q[1] - p[1]) * (x - p[0]);
        is_above = is_above || side >= 0;
        is_below = is_below || side <= 0;
      }
    return is_above && is_below;
  }

  const Places& places_;
  std::vector<PlanePoint> middle_;   ///< by vertex
  std::vector<PlanePoint> middles_;  ///< sorted, each once
  Rational half_;
  double reach_;
};

/// Rounds the vertices of regions, and adds up how far they move.
class VertexRounding {
 public:
  explicit VertexRounding(const CoordinateGrid& grid) : grid_(grid), step_(grid.step) {}

  [[nodiscard]] double largest_movement() const { return largest_movement_; }

  [[nodiscard]] bool holds(const Region& region) const {
    const Places& places = region.loops.places;
    return std::all_of(region.loops.vertices.begin(), region.loops.vertices.end(), [&](std::uint32_t v) {
      return places.is_double(v) && at(places.place[v], 0) == places.place[v];
    });
  }

  /// The loops of the region, snapped to pixels of one size (Hobby 1999): every edge goes through the middles of all
  /// pixels that it meets and that have a vertex in them.
  [[nodiscard]] Loops snap(const Region& region, const Monitor& monitor) {
    double largest = 0;
    const Places& places = region.loops.places;
    for (const std::uint32_t v : region.loops.vertices)
      for (const double x : places.place[v]) largest = std::max(largest, std::abs(x));
    const Pixels pixels(region, step_ > 0 ? step_ : to_rational(grid_.unit_at(largest)),
                        [&](double x) { return step_ > 0 ? grid_(x) : to_unit(x, grid_.unit_at(largest)); });
    LoopsBuilder loops;
    double moved = to_nearest_double(pixels.half());
    for (std::uint32_t l = 0; l < region.loops.size(); ++l) {
      monitor.check();
      const auto loop = region.loops.loop(l);
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const PlanePoint &from = places.place[loop[i]], middle = pixels.middle(loop[i]);
        for (std::size_t k = 0; k < 2; ++k) moved = std::max(moved, std::abs(middle[k] - from[k]) + half_unit(from[k]));
        loops.add_vertex(middle);
        for (const PlanePoint& p : pixels.between(loop[i], loop[(i + 1) % loop.size()])) loops.add_vertex(p);
      }
      loops.end_loop();
    }
    largest_movement_ += moved;
    return loops.finish();
  }

  /// The loops of the region with their vertices on the grid.
  [[nodiscard]] Loops round(const Region& region, int bits_less) {
    const Places& places = region.loops.places;
    double largest = 0;
    Loops loops;
    loops.places.place = places.place;
    for (const std::uint32_t v : region.loops.vertices) {
      const PlanePoint& from = places.place[v];
      const PlanePoint to = at(from, bits_less);
      for (std::size_t i = 0; i < 2; ++i) {
        if (!std::isfinite(to[i]))
          throw std::invalid_argument("the coordinate " + std::to_string(from[i]) +
                                      " is beyond the largest number of the format");
        const double error = places.is_double(v) ? 0 : half_unit(from[i]);
        largest = std::max(largest, std::abs(to[i] - from[i]) + error);
      }
      loops.places.place[v] = to;
    }
    largest_movement_ += largest;
    loops.vertices = region.loops.vertices;
    loops.edge_line.assign(loops.vertices.size(), none);
    loops.first_vertex = region.loops.first_vertex;
    return loops;
  }

 private:
  [[nodiscard]] PlanePoint at(const PlanePoint& p, int bits_less) const {
    return {grid_(p[0], bits_less), grid_(p[1], bits_less)};
  }

  [[nodiscard]] static double to_unit(double x, double unit) { return std::nearbyint(x / unit) * unit; }

  GridRounding grid_;
  Rational step_;
  double largest_movement_ = 0;
};

}  // namespace

RoundedRegion round_to_region(const Region& region, const CoordinateGrid& grid, const Monitor& monitor) {
  VertexRounding rounding(grid);
  if (rounding.holds(region)) return {region, 0, 0};
  RoundedRegion rounded{region, 0, 0};
  for (std::uint32_t round = 0;; ++round) {
    const bool is_snapped = round >= plain_rounds && round < full_rounds;
    const Loops loops =
        is_snapped ? rounding.snap(rounded.region, monitor) : rounding.round(rounded.region, bits_less_in(round));
    const Operand filled(loops, FillRule::positive);
    rounded.region = combine(std::span(&filled, 1), Operation::union_, monitor);
    if (rounding.holds(rounded.region)) break;
    ++rounded.rounds;
  }
  rounded.largest_movement = rounding.largest_movement();
  return rounded;
}

}  // namespace strata::planar
