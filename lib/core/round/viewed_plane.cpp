#include "core/round/viewed_plane.h"

#include <cmath>

#include "core/exact/two_sum.h"
#include "core/kernel/box.h"
#include "core/round/distances.h"

namespace strata {
namespace {

/// (x - y) / 2^exponent.
DoubleDouble scaled_difference(double x, double y, int exponent) {
  const WithRest d = two_sum(x, -y);
  return {std::ldexp(d.value, -exponent), std::ldexp(d.rest, -exponent), 0};
}

/// Coordinates are lifted by this exponent where products of small ones would underflow or those of large ones
/// overflow.
int lift_for(double largest) {
  constexpr double small = 0x1p-800, large = 0x1p900;
  if (largest < small) return 600;
  return largest > large ? -200 : 0;
}

}  // namespace

ViewedPlane::ViewedPlane(const Vertex& a, const Vertex& b, const Vertex& c) : at_(a) {
  const double scale = std::max(distance(a, b), distance(a, c));
  if (!(scale > 0) || !std::isfinite(scale)) return;
  const int exponent = std::ilogb(scale);
  std::array<DoubleDouble, 3> u, v;
  for (std::size_t i = 0; i < 3; ++i) {
    u[i] = scaled_difference(b[i], a[i], exponent);
    v[i] = scaled_difference(c[i], a[i], exponent);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    fine_normal_[i] = u[j] * v[k] - u[k] * v[j];
    normal_[i] = fine_normal_[i].value;
  }
  const double largest = size(normal_);
  if (!(largest > 0)) return;
  area_.fraction = std::frexp(largest, &area_.exponent);
  area_.exponent += 2 * exponent;
  axis_ = static_cast<std::size_t>(
      std::find_if(normal_.begin(), normal_.end(), [&](double x) { return std::abs(x) == largest; }) - normal_.begin());
  const DoubleDouble divisor = normal_[axis_] < 0 ? -fine_normal_[axis_] : fine_normal_[axis_];
  for (std::size_t i = 0; i < 3; ++i) {
    const DoubleDouble component = fine_normal_[i] / divisor;
    fine_normal_[i] = {component.value, component.low, 0};  // exact: it is this plane that heights refer to
    normal_[i] = component.value;
  }
}

Range ViewedPlane::height(const Vertex& p) const {
  const int lift = lift_for(std::max(size(at_), size(p)));
  DoubleDouble h;
  for (std::size_t i = 0; i < 3; ++i)
    h = h + fine_normal_[i] * scaled_difference(std::ldexp(p[i], lift), std::ldexp(at_[i], lift), 0);
  const Bounded height = h.bounded();
  if (lift == 0) return {height.lower(), height.upper()};
  Range range{std::ldexp(height.lower(), -lift), std::ldexp(height.upper(), -lift)};
  if (std::ldexp(range.lower, lift) > height.lower()) range.lower = std::nextafter(range.lower, -Box::infinity);
  if (std::ldexp(range.upper, lift) < height.upper()) range.upper = std::nextafter(range.upper, Box::infinity);
  return range;
}

bool ViewedPlane::may_be_within(const Vertex& p, double reach) const {
  double h = 0;
  for (std::size_t i = 0; i < 3; ++i) h += normal_[i] * (p[i] - at_[i]);
  constexpr double rounding = 0x1p-48;  // that of the sum is below 24 units
  return !(std::abs(h) > reach + (size(p) + size(at_)) * rounding + 0x1p-1070);
}

Vertex ViewedPlane::point(double first, double second) const {
  Vertex p{};
  p[this->first()] = first;
  p[this->second()] = second;
  const int lift = lift_for(std::max(size(at_), size(p)));
  DoubleDouble rise;
  for (const std::size_t i : {this->first(), this->second()})
    rise = rise + fine_normal_[i] * scaled_difference(std::ldexp(p[i], lift), std::ldexp(at_[i], lift), 0);
  const double way = std::ldexp(rise.value, -lift);
  p[axis_] = normal_[axis_] < 0 ? at_[axis_] + way : at_[axis_] - way;
  return p;
}

}  // namespace strata
