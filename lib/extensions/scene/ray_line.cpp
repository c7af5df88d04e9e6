#include "extensions/scene/ray_line.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/exact/finite.h"
#include "core/exact/vector.h"
#include "core/kernel/rational_point.h"
#include "extensions/scene/closed_face.h"

namespace strata {
namespace {

/// The interval of a rational around its nearest double.
Bounded bounded(const Rational& x) {
  const double value = to_nearest_double(x);
  return {value, std::abs(value) * Bounded::rounding + Bounded::underflow};
}

}  // namespace

RayLine::RayLine(const InputComplex& input, const Ray& ray)
    : input_(input), from_(ray.from), direction_(ray.direction) {
  if (!is_finite(ray.from) || !is_finite(ray.direction))
    throw std::invalid_argument("a coordinate of a ray is not a finite number");
  if (ray.direction == Vertex{}) throw std::invalid_argument("the direction of a ray is zero");
  find_shear();
}

RayLine::RayLine(const InputComplex& input, const Segment& segment)
    : input_(input), from_(segment.from), to_(segment.to), is_segment_(true), end_(1) {
  if (!is_finite(segment.from) || !is_finite(segment.to))
    throw std::invalid_argument("a coordinate of a segment is not a finite number");
  for (std::size_t i = 0; i < 3; ++i) direction_[i] = to_[i] - from_[i];
  find_shear();
}

void RayLine::find_shear() {
  std::size_t longest = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (std::abs(direction_[i]) > std::abs(direction_[longest])) longest = i;
  axis_ = {(longest + 1) % 3, (longest + 2) % 3, longest};
  // A segment of one point has no slopes: NaN leaves everything undecided.
  for (std::size_t i = 0; i < 2; ++i) slope_[i] = direction_[axis_[i]] / direction_[longest];
  vertex_error_ = input_.has_rationals() ? Bounded::rounding : 0;
}

/// Edge functions of the triangle sheared along the direction (Woop, Benthin and Wald 2013), with a bound on all three.
RayLine::Look RayLine::look_at(const InputComplex::Indices& corners) const {
  std::array<double, 3> x, y;
  Look look;
  double reach = 0, size = 0, largest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vertex& p = input_.vertex(corners[i]);
    const double dx = p[axis_[0]] - from_[axis_[0]], dy = p[axis_[1]] - from_[axis_[1]],
                 dz = p[axis_[2]] - from_[axis_[2]];
    x[i] = dx - slope_[0] * dz;
    y[i] = dy - slope_[1] * dz;
    look.depth[i] = dz;
    reach = std::max(reach, std::max(std::abs(dx), std::abs(dy)) + std::abs(dz));
    size = std::max(size, std::max(std::abs(x[i]), std::abs(y[i])));
    if (vertex_error_ > 0) largest = std::max({largest, std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
  }
  constexpr double u = 0x1p-53;
  const double moved = 10 * u * reach + 2 * vertex_error_ * largest + 0x1p-1060;
  const double bound = (4 * size * (moved + u * size) + 2 * moved * moved) * Bounded::slack + 0x1p-1000;
  int above = 0, below = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    look.weight[i] = x[j] * y[k] - y[j] * x[k];
    above += look.weight[i] > bound;
    below += -look.weight[i] > bound;
  }
  if (above > 0 && below > 0) {
    look.orientation = Turn::apart;
  } else if (above == 3 || below == 3) {
    look.orientation = (above == 3) == (direction_[axis_[2]] > 0) ? Turn::leaves : Turn::enters;
  }
  look.weight_error = bound;
  look.depth_error = (u * reach + vertex_error_ * largest) * 2 + 0x1p-1000;
  return look;
}

bool RayLine::settle(const Look& look, std::uint32_t face, FaceHit& hit) const {
  Bounded depth, weight;
  for (std::size_t i = 0; i < 3; ++i) {
    const Bounded w{look.weight[i], look.weight_error};
    depth = depth + w * Bounded{look.depth[i], look.depth_error};
    weight = weight + w;
  }
  const double d = direction_[axis_[2]];
  hit.t = depth / weight / Bounded{d, is_segment_ ? std::abs(d) * Bounded::rounding : 0};
  const bool is_certain =
      (hit.t.lower() > 0 && (hit.t.upper() < end_ || !is_segment_)) || hit.t.upper() < 0 || hit.t.lower() > end_;
  hit.face = face;
  hit.change = look.orientation == Turn::enters ? 1 : -1;
  hit.is_inside = true;
  return is_certain && std::isfinite(hit.t.upper());
}

RationalPoint RayLine::position(std::uint32_t vertex) const {
  const RationalPoint* exact = input_.exact(vertex);
  return exact != nullptr ? *exact : to_rational(input_.vertex(vertex));
}

RationalPoint RayLine::rational_direction() const {
  return is_segment_ ? minus(to_rational(to_), to_rational(from_)) : to_rational(direction_);
}

/// Sign of ((a - from) x (b - from)) . direction.
Sign RayLine::orientation(std::uint32_t a, std::uint32_t b) const {
  const Point p = make_point(input_, SymbolicPoint::input(a)), q = make_point(input_, SymbolicPoint::input(b));
  const Point o = Point::free(from_);
  return is_segment_ ? orient3d(input_, o, p, q, Point::free(to_)) : normal_along(input_, o, p, q, direction_);
}

/// The same with from + (e, e^2, e^3): the derivative in `from` is direction x (b - a).
Sign RayLine::moved_turn(std::uint32_t a, std::uint32_t b) const {
  const RationalPoint derivative = cross(rational_direction(), minus(position(b), position(a)));
  for (const Rational& x : derivative)
    if (x != 0) return sign_of(x);
  return Sign::zero;
}

Rational RayLine::crossing_parameter(std::uint32_t face) const {
  const auto v = input_.face(face);
  const RationalPoint a = position(v[0]);
  const RationalPoint normal = cross(minus(position(v[1]), a), minus(position(v[2]), a));
  return dot(normal, minus(a, to_rational(from_))) / dot(normal, rational_direction());
}

const Rational& RayLine::exact(FaceHit& hit) const {
  if (!hit.exact) hit.exact = crossing_parameter(hit.face);
  return *hit.exact;
}

RayLine::Hits RayLine::at(std::uint32_t face, const Rational& t, std::int8_t change, bool is_inside) const {
  if (t < 0 || (is_segment_ && t > 1)) return {};
  FaceHit hit;
  hit.face = face;
  hit.t = bounded(t);
  hit.exact = t;
  hit.change = change;
  hit.is_inside = is_inside;
  return {hit, std::nullopt};
}

/// Where no turn is zero, the line meets the interior or passes by. Where one or two are zero, it meets an edge or a
/// corner, or passes by. Where all are zero, it is in the plane: rays.md.
RayLine::Hits RayLine::meet_exactly(std::uint32_t face) const {
  const auto v = input_.face(face);
  if (is_segment_ && from_ == to_)
    return is_on_closed_face(input_, face, Point::free(from_)) ? at(face, 0, 0, false) : Hits{};
  int left = 0, right = 0;
  std::array<Sign, 3> orientations;
  for (std::size_t i = 0; i < 3; ++i) {
    orientations[i] = orientation(v[(i + 1) % 3], v[(i + 2) % 3]);
    left += orientations[i] == Sign::positive;
    right += orientations[i] == Sign::negative;
    if (left > 0 && right > 0) return {};
  }
  if (left + right == 0) return meet_within(face);
  // Where it leaves, the line sees the face counter-clockwise.
  const std::int8_t change = left > 0 ? -1 : 1;
  const Sign all = left > 0 ? Sign::positive : Sign::negative;
  bool is_crossed = true;
  for (std::size_t i = 0; i < 3; ++i)
    if (orientations[i] == Sign::zero) is_crossed = is_crossed && moved_turn(v[(i + 1) % 3], v[(i + 2) % 3]) == all;
  return at(face, crossing_parameter(face), is_crossed ? change : std::int8_t{0}, left + right == 3);
}

/// A line in the plane of a triangle, clipped by the half-planes of the triangle's edges.
RayLine::Hits RayLine::meet_within(std::uint32_t face) const {
  const auto v = input_.face(face);
  const RationalPoint o = to_rational(from_), d = rational_direction();
  const std::array<RationalPoint, 3> corner{position(v[0]), position(v[1]), position(v[2])};
  const RationalPoint normal = cross(minus(corner[1], corner[0]), minus(corner[2], corner[0]));
  std::optional<Rational> first, last;
  for (std::size_t i = 0; i < 3; ++i) {
    const RationalPoint inwards = cross(normal, minus(corner[(i + 1) % 3], corner[i]));
    const Rational height = dot(inwards, minus(o, corner[i])), growth = dot(inwards, d);
    if (growth == 0 && height < 0) return {};
    if (growth == 0) continue;
    const Rational t = -height / growth;
    if (growth > 0 && (!first || t > *first)) first = t;
    if (growth < 0 && (!last || t < *last)) last = t;
  }
  if (*first > *last) return {};
  if (*first == *last) return at(face, *first, 0, false);
  Hits hits;
  const bool begins_before = *first < 0;
  hits[0] = at(face, begins_before && *last > 0 ? Rational(0) : *first, 0, false)[0];
  hits[1] = at(face, *last, 0, false)[0];
  if (hits[0] && !begins_before) hits[0]->stretch = 1;
  if (hits[1]) hits[1]->stretch = -1;
  return hits;
}

RationalPoint RayLine::place_at(const Rational& t) const {
  RationalPoint p = to_rational(from_);
  const RationalPoint d = rational_direction();
  for (std::size_t i = 0; i < 3; ++i) p[i] += t * d[i];
  return p;
}

std::pair<double, Vertex> RayLine::rounded(FaceHit& hit) const {
  if (!hit.exact && !input_.has_rationals() && !is_segment_) {
    const auto v = input_.face(hit.face);
    const auto point = [](const Vertex& p) { return RealPoint<DoubleDouble>{p[0], p[1], p[2]}; };
    const RealPoint<DoubleDouble> a = point(input_.vertex(v[0])), o = point(from_), d = point(direction_);
    const RealPoint<DoubleDouble> normal =
        cross<DoubleDouble>(point(input_.vertex(v[1])) - a, point(input_.vertex(v[2])) - a);
    const DoubleDouble t = dot<DoubleDouble>(normal, a - o) / dot<DoubleDouble>(normal, d);
    Vertex place;
    bool is_nearest = t.rounds_to_value();
    for (std::size_t i = 0; i < 3 && is_nearest; ++i) {
      const DoubleDouble x = d[i].value == 0 ? o[i] : o[i] + t * d[i];
      is_nearest = x.rounds_to_value();
      place[i] = x.value;
    }
    if (is_nearest) return {t.value, place};
  }
  const Rational& t = exact(hit);
  const RationalPoint p = place_at(t);
  return {to_nearest_double(t), {to_nearest_double(p[0]), to_nearest_double(p[1]), to_nearest_double(p[2])}};
}

}  // namespace strata
