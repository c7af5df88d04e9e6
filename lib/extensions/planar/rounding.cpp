#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/kernel/grid_rounding.h"
#include "strata/planar.h"

namespace strata::planar {
namespace {

/// So often crossings are rounded to the nearest numbers of the grid. Then each time leaves out more bits, of all
/// vertices; without any bits, all are 0, and the region is empty. So it ends.
constexpr std::uint32_t full_rounds = 40;
constexpr int bits_per_round = 2;

int bits_less_in(std::uint32_t round) {
  return round < full_rounds ? 0 : bits_per_round * static_cast<int>(round - full_rounds + 1);
}

/// Rounds the vertices of regions, and adds up how far they move.
class VertexRounding {
 public:
  explicit VertexRounding(const CoordinateGrid& grid) : grid_(grid) {}

  [[nodiscard]] double largest_movement() const { return largest_movement_; }

  [[nodiscard]] bool holds(const Region& region) const {
    const Places& places = region.loops.places;
    return std::all_of(region.loops.vertices.begin(), region.loops.vertices.end(), [&](std::uint32_t v) {
      return places.is_double(v) && at(places.place[v], 0) == places.place[v];
    });
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
        const double error = places.is_double(v) ? 0 : places.error[v - places.doubles()][i];
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

  GridRounding grid_;
  double largest_movement_ = 0;
};

}  // namespace

RoundedRegion round_to_region(const Region& region, const CoordinateGrid& grid, const Monitor& monitor) {
  VertexRounding rounding(grid);
  if (rounding.holds(region)) return {region, 0, 0};
  RoundedRegion rounded{region, 0, 0};
  for (std::uint32_t round = 0;; ++round) {
    const Loops loops = rounding.round(rounded.region, bits_less_in(round));
    const Operand filled(loops, FillRule::positive);
    rounded.region = combine(std::span(&filled, 1), Operation::union_, monitor);
    if (rounding.holds(rounded.region)) break;
    ++rounded.rounds;
  }
  rounded.largest_movement = rounding.largest_movement();
  return rounded;
}

}  // namespace strata::planar
