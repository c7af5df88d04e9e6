#include "common/view.h"

#include <algorithm>
#include <cmath>

namespace {

using strata::Vertex;

Vertex minus(const Vertex& a, const Vertex& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double dot(const Vertex& a, const Vertex& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vertex cross(const Vertex& a, const Vertex& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vertex unit(const Vertex& a) {
  const double length = std::hypot(a[0], a[1], a[2]);
  return length > 0 ? Vertex{a[0] / length, a[1] / length, a[2] / length} : Vertex{};
}

/// Between a and b, where the third coordinate is z.
Vertex at_depth(const Vertex& a, const Vertex& b, double z) {
  const double t = (z - a[2]) / (b[2] - a[2]);
  return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), z};
}

}  // namespace

View::View(const strata::Origin& origin, const Vertex& towards, const Vertex& up)
    : perspective_(origin.is_point()), eye_(origin.is_point() ? origin.at : towards) {
  forward_ = unit(perspective_ ? minus(towards, eye_) : origin.at);
  if (forward_ == Vertex{}) forward_ = {0, 0, -1};
  right_ = cross(forward_, up);
  if (std::hypot(right_[0], right_[1], right_[2]) < 1e-9 * std::hypot(up[0], up[1], up[2]))
    right_ = cross(forward_, std::abs(forward_[1]) < .9 ? Vertex{0, 1, 0} : Vertex{1, 0, 0});
  right_ = unit(right_);
  up_ = cross(right_, forward_);
  if (perspective_) {
    const Vertex way = minus(towards, eye_);
    near_ = std::max(1e-3 * std::hypot(way[0], way[1], way[2]), 1e-300);
  }
}

Vertex View::from_eye(const Vertex& p) const {
  const Vertex r = minus(p, eye_);
  return {dot(r, right_), dot(r, up_), dot(r, forward_)};
}

PaperPoint View::project(const Vertex& e) const {
  return perspective_ ? PaperPoint{e[0] / e[2], -e[1] / e[2]} : PaperPoint{e[0], -e[1]};
}

std::optional<PaperPoint> View::place(const Vertex& p) const {
  const Vertex e = from_eye(p);
  if (perspective_ && e[2] < near_) return std::nullopt;
  return project(e);
}

PaperPath View::segment(Vertex a, Vertex b) const {
  a = from_eye(a);
  b = from_eye(b);
  if (perspective_) {
    if (a[2] < near_ && b[2] < near_) return {};
    if (a[2] < near_) a = at_depth(a, b, near_);
    if (b[2] < near_) b = at_depth(b, a, near_);
  }
  return {project(a), project(b)};
}

PaperPath View::polygon(const std::vector<Vertex>& corners) const {
  PaperPath path;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vertex a = from_eye(corners[i]), b = from_eye(corners[(i + 1) % corners.size()]);
    const bool a_before = !perspective_ || a[2] >= near_, b_before = !perspective_ || b[2] >= near_;
    if (a_before) path.push_back(project(a));
    if (a_before != b_before) path.push_back(project(at_depth(a, b, near_)));
  }
  return path;
}

double View::brightness(const Vertex& unit_normal) const {
  const Vertex light = unit({-.45, .65, -1});  // right, up, forwards
  const double lit =
      dot(unit_normal, right_) * light[0] + dot(unit_normal, up_) * light[1] + dot(unit_normal, forward_) * light[2];
  return .25 + .75 * std::max(lit, 0.0);
}
