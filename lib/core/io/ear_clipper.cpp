#include "core/io/ear_clipper.h"

#include <algorithm>
#include <cmath>

namespace strata::io {

EarClipper::EarClipper(std::span<const PlanePoint> points)
    : points_(points),
      previous_(points.size()),
      next_(points.size()),
      shape_(points.size()),
      obstacle_(points.size(), none),
      cut_(points.size(), false),
      remaining_(static_cast<std::uint32_t>(points.size())) {
  for (std::uint32_t i = 0; i < remaining_; ++i) {
    previous_[i] = i == 0 ? remaining_ - 1 : i - 1;
    next_[i] = i + 1 == remaining_ ? 0 : i + 1;
  }
  for (std::uint32_t i = 0; i < remaining_; ++i) shape_[i] = orientation_at(i);
  build_grid();
}

Sign EarClipper::orientation_at(std::uint32_t corner) const {
  return orient2d(points_[previous_[corner]], points_[corner], points_[next_[corner]]);
}

/// Column or row of a coordinate. Monotone, so a box of points maps into a box of cells. Nothing is decided from it.
std::uint32_t EarClipper::cell(double x, std::size_t axis) const {
  const double place = (x - lower_[axis]) * scale_[axis];
  return place > 0 ? static_cast<std::uint32_t>(std::min(place, static_cast<double>(side_ - 1))) : 0;
}

void EarClipper::build_grid() {
  std::vector<std::uint32_t> candidates;
  for (std::uint32_t i = 0; i < points_.size(); ++i)
    if (shape_[i] != Sign::positive) candidates.push_back(i);
  side_ = std::max(1u, static_cast<std::uint32_t>(std::sqrt(static_cast<double>(candidates.size()))));
  PlanePoint upper = lower_ = points_[0];
  for (const auto& p : points_)
    for (std::size_t k = 0; k < 2; ++k) {
      lower_[k] = std::min(lower_[k], p[k]);
      upper[k] = std::max(upper[k], p[k]);
    }
  for (std::size_t k = 0; k < 2; ++k) {
    const double extent = upper[k] - lower_[k];
    const double scale = side_ / extent;
    scale_[k] = std::isfinite(extent) && std::isfinite(scale) ? scale : 0;
  }
  const auto cell_of = [&](std::uint32_t i) { return cell(points_[i][1], 1) * side_ + cell(points_[i][0], 0); };
  first_.assign(std::size_t{side_} * side_ + 1, 0);
  for (const std::uint32_t i : candidates) ++first_[cell_of(i) + 1];
  for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
  in_cell_.resize(candidates.size());
  auto place = first_;
  for (const std::uint32_t i : candidates) in_cell_[place[cell_of(i)]++] = i;
}

bool EarClipper::is_in_the_way(std::uint32_t candidate, std::uint32_t corner) const {
  const PlanePoint &u = points_[previous_[corner]], &v = points_[corner], &w = points_[next_[corner]];
  const PlanePoint& p = points_[candidate];
  if (p == u || p == v || p == w) return false;
  return orient2d(u, v, p) != Sign::negative && orient2d(v, w, p) != Sign::negative &&
         orient2d(w, u, p) != Sign::negative;
}

std::uint32_t EarClipper::find_obstacle(std::uint32_t corner) const {
  const PlanePoint &u = points_[previous_[corner]], &v = points_[corner], &w = points_[next_[corner]];
  const auto [x_low, x_high] = std::minmax({u[0], v[0], w[0]});
  const auto [y_low, y_high] = std::minmax({u[1], v[1], w[1]});
  const std::uint32_t left = cell(x_low, 0), right = cell(x_high, 0), top = cell(y_high, 1);
  for (std::uint32_t row = cell(y_low, 1); row <= top; ++row)
    for (std::uint32_t k = first_[row * side_ + left]; k < first_[row * side_ + right + 1]; ++k) {
      const std::uint32_t i = in_cell_[k];
      if (cut_[i] || shape_[i] == Sign::positive) continue;
      const PlanePoint& p = points_[i];
      if (p[0] < x_low || p[0] > x_high || p[1] < y_low || p[1] > y_high) continue;
      if (is_in_the_way(i, corner)) return i;
    }
  return none;
}

bool EarClipper::is_ear(std::uint32_t corner) {
  if (shape_[corner] != Sign::positive) return false;
  const std::uint32_t known = obstacle_[corner];
  if (known != none && !cut_[known] && shape_[known] != Sign::positive) return false;
  obstacle_[corner] = find_obstacle(corner);
  return obstacle_[corner] == none;
}

void EarClipper::cut(std::uint32_t corner, Triangle& triangle) {
  const std::uint32_t u = previous_[corner], w = next_[corner];
  triangle = {u, corner, w};
  next_[u] = w;
  previous_[w] = u;
  cut_[corner] = true;
  --remaining_;
  for (const std::uint32_t i : {u, w}) {
    shape_[i] = orientation_at(i);
    obstacle_[i] = none;
  }
}

/// A corner without area, which can be cut without an overlap; `start` if there is none.
std::uint32_t EarClipper::flat_corner(std::uint32_t start) const {
  std::uint32_t i = start;
  do {
    if (shape_[i] == Sign::zero) return i;
    i = next_[i];
  } while (i != start);
  return start;
}

bool EarClipper::clip(std::span<Triangle> triangles) {
  // A round without an ear proves a defect. After a few of them the rest becomes a fan: linear time for any input.
  constexpr int most_failures = 16;
  int failures = 0;
  std::uint32_t i = 0, since_last = 0;
  for (Triangle& triangle : triangles) {
    while (failures < most_failures && !is_ear(i) && since_last < remaining_) {
      i = next_[i];
      ++since_last;
    }
    if (since_last == remaining_) {
      ++failures;
      i = flat_corner(i);
    }
    since_last = 0;
    cut(i, triangle);
    // Skipping a corner distributes the cuts and avoids many triangles at one vertex.
    i = next_[next_[i]];
  }
  return failures == 0;
}

}  // namespace strata::io
