#include "extensions/scene/pieces.h"

#include "core/exact/vector.h"
#include "core/kernel/rational_point.h"

namespace strata {
namespace {

using RationalVector = std::array<Rational, 3>;

RationalPlane plane_at(const RationalPoint& p, const RationalVector& u, const RationalVector& v) {
  RationalPlane plane{cross(u, v), 0};
  plane.offset = dot(plane.normal, p);
  return plane;
}

/// The point in which the segment from a to b meets a plane, given the plane's values at the ends, of opposite signs.
RationalPoint meet(const RationalPoint& a, const Rational& value_a, const RationalPoint& b, const Rational& value_b) {
  const Rational t = value_a / (value_a - value_b);
  RationalPoint x;
  for (std::size_t i = 0; i < 3; ++i) x[i] = a[i] + t * (b[i] - a[i]);
  return x;
}

}  // namespace

RationalPoint Pieces::position(std::uint32_t vertex) const {
  if (const RationalPoint* exact = input_.exact(vertex)) return *exact;
  return to_rational(input_.vertex(vertex));
}

RationalPlane Pieces::plane_of(std::uint32_t piece) const {
  const auto v = input_.face(face_of(piece));  // the whole face: its numbers are shorter
  const RationalPoint a = position(v[0]);
  return plane_at(a, minus(position(v[1]), a), minus(position(v[2]), a));
}

RationalPlane Pieces::plane_of_sight(const Origin& origin, std::uint32_t a, std::uint32_t b) const {
  const RationalPoint p = position(a), o = to_rational(origin.at);
  return plane_at(p, minus(position(b), p), origin.is_point() ? minus(o, p) : o);
}

bool Pieces::cut(std::uint32_t p, const RationalPlane& plane) {
  const Corners v = corners(p);
  std::array<RationalPoint, 3> at;
  std::array<Rational, 3> value;
  int above = 0, below = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    at[i] = position(v[i]);
    value[i] = dot(plane.normal, at[i]) - plane.offset;
    above += value[i] > 0;
    below += value[i] < 0;
  }
  if (above == 0 || below == 0) return false;
  const std::uint32_t face = face_of(p);
  const auto cross_side = [&](std::size_t i, std::size_t j) {
    return add_point(meet(at[i], value[i], at[j], value[j]));
  };
  if (above + below == 2) {  // through a corner
    std::size_t i = 0;
    while (value[i] != 0) ++i;
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    const std::uint32_t x = cross_side(j, k);
    parts_.push_back({{v[i], v[j], x}, face});
    parts_.push_back({{v[i], x, v[k]}, face});
  } else {  // one corner is alone on its side
    std::size_t i = 0;
    while (above == 1 ? value[i] < 0 : value[i] > 0) ++i;
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    const std::uint32_t x = cross_side(i, j), y = cross_side(k, i);
    parts_.push_back({{v[i], x, y}, face});
    parts_.push_back({{x, v[j], v[k]}, face});
    parts_.push_back({{x, v[k], y}, face});
  }
  replaced_.resize(count(), false);
  replaced_[p] = true;
  ++cuts_;
  renew_input();
  return true;
}

void Pieces::undo(std::uint32_t p, const Mark& before) {
  parts_.resize(before.parts);
  points_.resize(before.points);
  exact_.resize(before.exact);
  replaced_[p] = false;
  replaced_.resize(count());
  --cuts_;
  renew_input();
}

std::uint32_t Pieces::add_point(const RationalPoint& p) {
  const auto number = static_cast<std::uint32_t>(points_.size());
  points_.push_back({to_nearest_double(p[0]), to_nearest_double(p[1]), to_nearest_double(p[2])});
  if (to_rational(points_.back()) != p) exact_.push_back({number, p});
  return input_complex_of(scene_).vertex_count() + number;
}

void Pieces::renew_input() {
  input_ = input_complex_of(scene_);
  input_.add(points_, {}, exact_);
}

}  // namespace strata
