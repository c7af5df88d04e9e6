#include "core/overlap/separation.h"

#include <algorithm>
#include <array>
#include <boost/container/static_vector.hpp>
#include <cmath>
#include <limits>

#include "core/exact/vector.h"
#include "core/mesh/lattice_sum.h"

namespace strata {
namespace {

Vertex plus(const Vertex& a, double t, const Vertex& u) { return {a[0] + t * u[0], a[1] + t * u[1], a[2] + t * u[2]}; }

using Corners = boost::container::static_vector<Vertex, 4>;

/// The corners of a simplex among which the point nearest to the origin lies, and that point. In doubles, without a
/// bound: what is made of it is tested.
class Nearest {
 public:
  explicit Nearest(const Corners& corners) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
      try_corner(corners[i]);
      for (std::size_t j = 0; j < i; ++j) {
        try_edge(corners[i], corners[j]);
        for (std::size_t k = 0; k < j; ++k) try_triangle(corners[i], corners[j], corners[k]);
      }
    }
  }
  [[nodiscard]] const Vertex& point() const { return point_; }
  [[nodiscard]] const Corners& corners() const { return corners_; }
  [[nodiscard]] double squared_distance() const { return squared_distance_; }

 private:
  void keep(const Vertex& p, const Corners& corners) {
    if (!(dot(p, p) < squared_distance_)) return;
    squared_distance_ = dot(p, p);
    point_ = p;
    corners_ = corners;
  }
  void try_corner(const Vertex& a) { keep(a, {a}); }
  void try_edge(const Vertex& a, const Vertex& b) {
    const Vertex u = minus(b, a);
    const double t = -dot(a, u) / dot(u, u);
    if (t > 0 && t < 1) keep(plus(a, t, u), {a, b});
  }
  void try_triangle(const Vertex& a, const Vertex& b, const Vertex& c) {
    const Vertex u = minus(b, a), v = minus(c, a);
    const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), au = -dot(a, u), av = -dot(a, v);
    const double determinant = uu * vv - uv * uv;
    const double s = (au * vv - av * uv) / determinant, t = (av * uu - au * uv) / determinant;
    if (s > 0 && t > 0 && s + t < 1) keep(plus(plus(a, s, u), t, v), {a, b, c});
  }

  Vertex point_{};
  Corners corners_;
  double squared_distance_ = std::numeric_limits<double>::infinity();
};

}  // namespace

bool are_separated(std::span<const Vertex> points, std::span<const Vertex> others) {
  if (points.empty() || others.empty()) return true;
  const double largest = std::max(largest_coordinate(points), largest_coordinate(others));
  constexpr int most_directions = 32;
  Corners corners{minus(others[0], points[0])};
  double last = std::numeric_limits<double>::infinity();
  for (int i = 0; i < most_directions; ++i) {
    const Nearest nearest(corners);
    if (!(nearest.squared_distance() < last)) return false;  // the hulls meet, or are too near
    last = nearest.squared_distance();
    const Vertex& direction = nearest.point();
    const double size = std::abs(direction[0]) + std::abs(direction[1]) + std::abs(direction[2]);
    if (!(size * largest < 0x1p1000)) return false;  // products may overflow
    const auto is_before = [&](const Vertex& a, const Vertex& b) { return dot(direction, a) < dot(direction, b); };
    const Vertex& from = *std::max_element(points.begin(), points.end(), is_before);
    const Vertex& to = *std::min_element(others.begin(), others.end(), is_before);
    // A product of sums has an error of 3 * 2^-53 of its terms' sizes; there are two, and coordinates have errors.
    if (dot(direction, to) - dot(direction, from) > 0x1p-48 * (size * largest) + 0x1p-1000) return true;
    corners = nearest.corners();
    corners.push_back(minus(to, from));
  }
  return false;
}

}  // namespace strata
