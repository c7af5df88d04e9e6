#include "core/attributes/face_frame.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace strata {
namespace {

bool is_certainly_negative(const DoubleDouble& x) { return x.value + x.low < -x.error * Bounded::slack; }

bool is_certainly_not_zero(const DoubleDouble& x) {
  return std::abs(x.value) * (1 - 0x1p-50) > x.error * Bounded::slack && std::isfinite(x.value);
}

/// A determinant of differences from p.
DoubleDouble determinant(const std::array<DoubleDouble, 3>& p, const std::array<DoubleDouble, 3>& q,
                         const std::array<DoubleDouble, 3>& r, std::size_t u, std::size_t v) {
  return (q[u] - p[u]) * (r[v] - p[v]) - (q[v] - p[v]) * (r[u] - p[u]);
}

Rational determinant(const RationalPoint& p, const RationalPoint& q, const RationalPoint& r, std::size_t u,
                     std::size_t v) {
  return (q[u] - p[u]) * (r[v] - p[v]) - (q[v] - p[v]) * (r[u] - p[u]);
}

}  // namespace

FaceFrame::FaceFrame(const MeshPoints& points, const Triangle& corners) : points_(points), corners_(corners) {
  for (std::size_t i = 0; i < 3; ++i) fine_[i] = points.fine(corners[i]);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    const DoubleDouble d = determinant(fine_[0], fine_[1], fine_[2], u, v);
    if (!is_certainly_not_zero(d) || (has_certain_area_ && std::abs(d.value) <= std::abs(area_.value))) continue;
    has_certain_area_ = true;
    area_ = d;
    u_ = u;
    v_ = v;
  }
  if (has_certain_area_) return;
  const auto& [a, b, c] = exact_corners();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    u_ = (axis + 1) % 3;
    v_ = (axis + 2) % 3;
    if (exact_area(a, b, c) != 0) return;
  }
}

DoubleDouble FaceFrame::area(const Fine& p, const Fine& q, const Fine& r) const { return determinant(p, q, r, u_, v_); }

const std::array<RationalPoint, 3>& FaceFrame::exact_corners() const {
  if (!exact_) exact_ = {points_.exact(corners_[0]), points_.exact(corners_[1]), points_.exact(corners_[2])};
  return *exact_;
}

Rational FaceFrame::exact_area(const RationalPoint& p, const RationalPoint& q, const RationalPoint& r) const {
  return determinant(p, q, r, u_, v_);
}

std::optional<FaceFrame::Weights> FaceFrame::exact_weights(const RationalPoint& p) const {
  const auto& [a, b, c] = exact_corners();
  const Rational whole = exact_area(a, b, c);
  if (whole == 0) return std::nullopt;
  const Rational second = exact_area(a, p, c) / whole, third = exact_area(a, b, p) / whole;
  return Weights{1 - second - third, second, third};
}

bool FaceFrame::is_opposite(const MeshPoints& points, const Triangle& t) const {
  if (has_certain_area_) {
    const DoubleDouble d = area(points.fine(t[0]), points.fine(t[1]), points.fine(t[2]));
    if (is_certainly_not_zero(d)) return (d.value < 0) != (area_.value < 0);
  }
  const auto& [a, b, c] = exact_corners();
  return exact_area(a, b, c).sign() * exact_area(points.exact(t[0]), points.exact(t[1]), points.exact(t[2])).sign() < 0;
}

std::array<double, 3> FaceFrame::unit_normal() const {
  std::array<double, 3> n{};
  double longest = 0, error = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const DoubleDouble d = determinant(fine_[0], fine_[1], fine_[2], (i + 1) % 3, (i + 2) % 3);
    n[i] = d.value;
    longest = std::max(longest, std::abs(d.value));
    error = std::max(error, d.error);
  }
  const bool is_certain = std::isfinite(longest) && error < longest * 0x1p-70;
  if (!is_certain && !has_exact_normal(n)) return {};
  double square = 0;
  for (double& x : n) {
    if (is_certain) x /= longest;
    square += x * x;
  }
  for (double& x : n) x /= std::sqrt(square);
  return n;
}

/// Writes the normal divided by its longest component. False for a face without area.
bool FaceFrame::has_exact_normal(std::array<double, 3>& normal) const {
  const auto& [a, b, c] = exact_corners();
  std::array<Rational, 3> n;
  Rational longest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    n[i] = determinant(a, b, c, (i + 1) % 3, (i + 2) % 3);
    longest = std::max(longest, abs(n[i]));
  }
  if (longest == 0) return false;
  for (std::size_t i = 0; i < 3; ++i) normal[i] = to_nearest_double(n[i] / longest);
  return true;
}

FaceFrame::Place::Place(const FaceFrame& frame, const MeshPoints& points, std::uint32_t vertex)
    : frame_(frame), points_(points), vertex_(vertex), fine_(points.fine(vertex)) {
  const DoubleDouble unknown(std::numeric_limits<double>::quiet_NaN(), 0, HUGE_VAL);
  second_ = third_ = unknown;
  if (frame.has_certain_area_) {
    second_ = frame.area(frame.fine_[0], fine_, frame.fine_[2]) / frame.area_;
    third_ = frame.area(frame.fine_[0], frame.fine_[1], fine_) / frame.area_;
    const DoubleDouble first = DoubleDouble(1.0) - second_ - third_;
    is_inside_ = !is_certainly_negative(first) && !is_certainly_negative(second_) && !is_certainly_negative(third_);
  } else {
    exact_ = frame.exact_weights(points.exact(vertex));
    is_inside_ = exact_ && std::none_of(exact_->begin(), exact_->end(), [](const Rational& w) { return w < 0; });
  }
  if (!is_inside_) clamp();
}

const FaceFrame::Weights& FaceFrame::Place::exact() const {
  if (!exact_) exact_ = frame_.exact_weights(points_.exact(vertex_));
  return *exact_;
}

/// Distances are relative to the largest difference of coordinates, so that nothing overflows but differences.
void FaceFrame::Place::clamp() {
  const Vertex& p = points_.nearest(vertex_);
  std::array<std::array<double, 3>, 3> from_p{};  // per corner
  double size = 0;
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < 3; ++i) {
      from_p[k][i] = frame_.points_.nearest(frame_.corners_[k])[i] / 2 - p[i] / 2;
      size = std::max(size, std::abs(from_p[k][i]));
    }
  for (auto& q : from_p)
    for (double& x : q) x = size > 0 ? x / size : 0;
  double least = HUGE_VAL;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto &a = from_p[k], &b = from_p[(k + 1) % 3];
    double along = 0, square = 0, distance = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      along -= a[i] * (b[i] - a[i]);
      square += (b[i] - a[i]) * (b[i] - a[i]);
    }
    const double t = square > 0 ? std::clamp(along / square, 0.0, 1.0) : 0;
    for (std::size_t i = 0; i < 3; ++i) distance += std::pow(a[i] + t * (b[i] - a[i]), 2);
    if (distance >= least) continue;
    least = distance;
    clamped_ = {};
    clamped_[k] = 1 - t;
    clamped_[(k + 1) % 3] = t;
  }
}

std::size_t FaceFrame::Place::nearest_corner() const {
  const auto square = [](const auto& p, const auto& q) {
    const auto x = q[0] - p[0], y = q[1] - p[1], z = q[2] - p[2];
    return x * x + y * y + z * z;
  };
  std::optional<RationalPoint> exact;
  std::size_t nearest = 0;
  for (std::size_t k = 1; k < 3; ++k) {
    const DoubleDouble difference = square(fine_, frame_.fine_[k]) - square(fine_, frame_.fine_[nearest]);
    bool is_nearer = difference.value < 0;
    if (!is_certainly_not_zero(difference)) {
      if (!exact) exact = points_.exact(vertex_);
      const auto& corners = frame_.exact_corners();
      is_nearer = square(*exact, corners[k]) < square(*exact, corners[nearest]);
    }
    if (is_nearer) nearest = k;
  }
  return nearest;
}

}  // namespace strata
