#include "extensions/convex/point_cloud.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "core/exact/finite.h"
#include "core/exact/lattice.h"
#include "core/kernel/box.h"
#include "core/kernel/filtered_orientation.h"
#include "core/kernel/filters.h"
#include "core/kernel/rational_point.h"

namespace strata::convex {
namespace {

bool is_rounded(const RationalPoint& place, const Vertex& at) {
  for (std::size_t i = 0; i < 3; ++i)
    if (to_nearest_double(place[i]) != at[i]) return false;
  return true;
}

bool is_double(const RationalPoint& place, const Vertex& at) {
  for (std::size_t i = 0; i < 3; ++i)
    if (place[i] != to_rational(at[i])) return false;
  return true;
}

/// Converts a point in units of 1 to units of 2^unit.
HPoint<Integer> in_units(HPoint<Integer> p, int unit) {
  if (unit > 0) {
    p.w <<= static_cast<unsigned>(unit);
    p.unit = false;
  }
  if (unit < 0)
    for (Integer* x : {&p.x, &p.y, &p.z}) *x <<= static_cast<unsigned>(-unit);
  return p;
}

/// The largest distance between a position and its nearest double.
double rounding_of(double x) { return std::abs(x) * Bounded::rounding + Bounded::underflow; }

/// True if the coordinates are integers of at most 15 bits times one power of two, far from overflow and underflow.
/// Then differences have 16 bits, minors 33, the value 51, and doubles represent them all.
bool fit_small_lattice(std::span<const Vertex> points) {
  constexpr int small = 15, least_unit = -300, largest_unit = 300;
  Lattice lattice;
  for (const Vertex& v : points) {
    for (const double x : v) lattice.add(x);
    if (lattice.bits() > small) return false;
  }
  return lattice.unit() >= least_unit && lattice.unit() <= largest_unit;
}

}  // namespace

PointCloud::PointCloud(ExactMeshView points) : at_(points.mesh.vertices) {
  if (at_.size() >= std::numeric_limits<std::uint32_t>::max()) throw std::length_error("convex hull: too many points");
  if (!std::all_of(at_.begin(), at_.end(), is_finite))
    throw std::invalid_argument("convex hull: a coordinate is not finite");
  read_exact(points);
  measure();
}

void PointCloud::read_exact(ExactMeshView points) {
  std::size_t after = 0;
  for (const ExactVertex& e : points.exact) {
    if (e.vertex < after || e.vertex >= at_.size())
      throw std::invalid_argument("convex hull: exact places are not by increasing index");
    after = std::size_t{e.vertex} + 1;
    if (!is_rounded(e.position, at_[e.vertex]))
      throw std::invalid_argument("convex hull: a point is not the nearest to its exact place");
    if (!is_double(e.position, at_[e.vertex])) rounded_.push_back({e.vertex, &e.position, homogeneous(e.position)});
  }
}

void PointCloud::measure() {
  Box box;
  for (const Vertex& v : at_) box.include(v);
  std::array<double, 3> error{};
  for (const Rounded& r : rounded_)
    for (std::size_t i = 0; i < 3; ++i) error[i] = std::max(error[i], rounding_of(at_[r.point][i]));
  if (box.empty()) return;
  lowest_ = box.lower;
  for (std::size_t i = 0; i < 3; ++i) extent_[i] = Bounded(box.upper[i], error[i]) - Bounded(box.lower[i], error[i]);
  small_lattice_ = rounded_.empty() && fit_small_lattice(at_);
}

const PointCloud::Rounded* PointCloud::rounded(std::uint32_t p) const {
  if (rounded_.empty()) return nullptr;
  const auto found = std::lower_bound(rounded_.begin(), rounded_.end(), p,
                                      [](const Rounded& r, std::uint32_t point) { return r.point < point; });
  return found != rounded_.end() && found->point == p ? &*found : nullptr;
}

const RationalPoint* PointCloud::exact(std::uint32_t p) const {
  const Rounded* const r = rounded(p);
  return r == nullptr ? nullptr : r->place;
}

std::array<Bounded, 3> PointCloud::bounded(std::uint32_t p) const {
  const Vertex& v = at_[p];
  if (rounded(p) == nullptr) return {v[0], v[1], v[2]};
  return {Bounded(v[0], rounding_of(v[0])), Bounded(v[1], rounding_of(v[1])), Bounded(v[2], rounding_of(v[2]))};
}

Sign PointCloud::compare(std::uint32_t p, std::uint32_t q, std::size_t axis) const {
  const double x = at_[p][axis], y = at_[q][axis];
  if (x != y) return x < y ? Sign::negative : Sign::positive;  // rounding is monotone
  const Rounded *const r = rounded(p), *const s = rounded(q);
  if (r == nullptr && s == nullptr) return Sign::zero;
  return sign_of(Rational((r ? (*r->place)[axis] : to_rational(x)) - (s ? (*s->place)[axis] : to_rational(y))));
}

Sign PointCloud::compare(std::uint32_t p, std::uint32_t q) const {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (const Sign s = compare(p, q, axis); s != Sign::zero) return s;
  return Sign::zero;
}

template <class Int, std::size_t N>
std::array<HPoint<Int>, N> PointCloud::integers(const std::array<std::uint32_t, N>& points,
                                                const Lattice& lattice) const {
  std::array<HPoint<Int>, N> result;
  for (std::size_t i = 0; i < N; ++i) {
    const Vertex& v = at_[points[i]];
    if constexpr (std::is_same_v<Int, Integer>) {
      if (const Rounded* r = rounded(points[i])) {
        result[i] = in_units(r->homogeneous, lattice.unit());
        continue;
      }
    }
    result[i] = {lattice.integer<Int>(v[0]), lattice.integer<Int>(v[1]), lattice.integer<Int>(v[2]), Int(1), true};
  }
  return result;
}

/// The sign of `value` of the points in exact integers that are wide enough: on a lattice of b bits values have 3b + 7
/// bits (core/kernel/theory.md, "Widths"); a shifted magnitude needs b + 65.
template <std::size_t N, class Value>
Sign PointCloud::decide(const std::array<std::uint32_t, N>& points, const Value& value) const {
  Lattice lattice;
  bool rational = false;
  for (const std::uint32_t p : points) {
    if (rounded(p) != nullptr) {
      rational = true;
    } else {
      for (const double x : at_[p]) lattice.add(x);
    }
  }
  const int bits = std::max(3 * lattice.bits() + 8, lattice.bits() + 65);
  const auto sign_with = [&]<class Int>(const Int&) { return sign_of_integer(value(integers<Int>(points, lattice))); };
  if (rational || bits > 512) return sign_with(Integer());
  if (bits > 256) return sign_with(WideInt<8>());
  if (bits > 128) return sign_with(WideInt<4>());
  return sign_with(WideInt<2>());
}

Sign PointCloud::side(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t p) const {
  if (p == a || p == b || p == c) return Sign::zero;
  if (small_lattice_) return sign_of(orient3d_of<double>(at_[a], at_[b], at_[c], at_[p]));
  if (const auto sign = orient3d_of<Bounded>(bounded(a), bounded(b), bounded(c), bounded(p)).sign()) return *sign;
  return decide<4>({a, b, c, p}, [](const auto& q) { return value_at(plane_through(q[0], q[1], q[2]), q[3]); });
}

Sign PointCloud::orientation(std::uint32_t p, std::uint32_t q, std::uint32_t r, std::size_t axis) const {
  const int u = static_cast<int>((axis + 1) % 3), v = static_cast<int>((axis + 2) % 3);
  if (const auto sign = orientation_of<Bounded>(bounded(p), bounded(q), bounded(r), u, v).sign()) return *sign;
  if (rounded_.empty()) {
    const auto seen = [&](std::uint32_t point) { return PlanePoint{at_[point][u], at_[point][v]}; };
    if (const auto sign = orientation_by_differences(seen(p), seen(q), seen(r))) return *sign;
  }
  return decide<3>({p, q, r}, [&](const auto& t) { return strata::orientation(t[0], t[1], t[2], u, v); });
}

}  // namespace strata::convex
