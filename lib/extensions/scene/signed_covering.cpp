#include "extensions/scene/signed_covering.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "core/cells/walk.h"
#include "extensions/scene/scene_data.h"
#include "extensions/scene/sight.h"

namespace strata {
namespace {

const Origin& checked(const Origin& origin) {
  for (const double x : origin.at)
    if (!std::isfinite(x)) throw std::invalid_argument("the origin's coordinates are not finite");
  if (!origin.is_point() && origin.at == InputComplex::Coordinates{})
    throw std::invalid_argument("the direction to an origin at infinity is zero");
  return origin;
}

}  // namespace

SignedCovering::SignedCovering(Scene scene, const Origin& origin, bool keep_footprints, const Monitor& monitor)
    : scene_(std::move(scene)), origin_(checked(origin)), index_(scene_, origin_, monitor) {
  if (!keep_footprints) index_.forget_footprints();
  const InputComplex& input = input_complex_of(scene_);
  const Sight sight(input, origin_);
  orientations_.resize(input.face_count());
  starts_.resize(input.face_count());
  tbb::parallel_for(std::uint32_t{0}, input.face_count(), [&](std::uint32_t f) {
    monitor.check();
    orientations_[f] = starts_[f] = sight.orientation(input.face(f));
    if (starts_[f] == Sign::zero)
      starts_[f] = origin_.is_point() ? side_of_origin(input, f, origin_.at) : side_of_infinity(input, f, origin_.at);
  });
  find_windings_of_origin();
  make_cones();
}

void SignedCovering::make_cones() {
  const InputComplex& input = input_complex_of(scene_);
  if (!origin_.is_point() || input.has_rationals()) return;
  double largest = 0;
  for (std::uint32_t s = 0; s < scene_.solid_count(); ++s)
    for (const Vertex& v : input.points(s))
      for (std::size_t i = 0; i < 3; ++i) largest = std::max(largest, std::abs(v[i] - origin_.at[i]));
  if (!std::isfinite(largest) || largest == 0) return;
  scale_ = largest;
  cones_.resize(input.face_count());
  tbb::parallel_for(std::uint32_t{0}, input.face_count(), [&](std::uint32_t f) {
    const auto v = input.face(f);
    cones_[f] = ConeFilter(origin_.at, {input.vertex(v[0]), input.vertex(v[1]), input.vertex(v[2])}, scale_);
  });
}

int SignedCovering::crossing(std::uint32_t face, const Point& q) const {
  return origin_.is_point() ? strata::crossing(input_complex_of(scene_), face, origin_.at, q)
                            : crossing_from_infinity(input_complex_of(scene_), face, origin_.at, q);
}

/// Calls `visit` for every face that the walk to q may cross or on which it may end.
template <class Visit>
void SignedCovering::for_each_face_of_walk(const Vertex& q, const Visit& visit) const {
  for (const std::uint32_t f : index_.faces_at_origin()) visit(f);
  if (!origin_.is_point() || q != origin_.at) index_.for_each_towards({q[0], q[1], q[2]}, visit);
}

/// By a walk from a point outside of everything, where all are zero.
void SignedCovering::find_windings_of_origin() {
  if (!origin_.is_point() || scene_.face_count() == 0) return;
  Vertex far = origin_.at;
  bool found = false;
  for (std::size_t axis = 0; axis < 3 && !found; ++axis)
    for (const double end : {HUGE_VAL, -HUGE_VAL}) {
      double most = far[axis];
      for (std::uint32_t s = 0; s < scene_.solid_count(); ++s)
        for (const Vertex& v : scene_.solid(s).mesh.vertices)
          most = end > 0 ? std::max(most, v[axis]) : std::min(most, v[axis]);
      // Two steps: a rational may be half a step beyond its nearest double.
      const double beyond = std::nextafter(std::nextafter(most, end), end);
      if (!std::isfinite(beyond)) continue;
      far[axis] = beyond;
      found = true;
      break;
    }
  if (!found) throw std::invalid_argument("the scene leaves no double outside of it");
  const Point q = Point::free(far);
  for_each_face_of_walk(
      far, [&](std::uint32_t f) { at_origin_.add(input_complex_of(scene_).operand_of_face(f), -crossing(f, q)); });
}

/// Tests in floats first.
WalkStep SignedCovering::step(std::uint32_t face, const Vertex& vertex, const Point& q, const ConeRay& ray) const {
  if (!cones_.empty()) switch (cones_[face].ask(ray)) {
      case ConeFilter::Answer::passes:
        return {};
      case ConeFilter::Answer::crosses:
        return {to_int(starts_[face]), false};
      case ConeFilter::Answer::unknown:
        break;
    }
  return walk_step(
      input_complex_of(scene_), face, vertex, q, [&](const FilteredPlane&) { return to_int(starts_[face]); },
      [&] { return crossing(face, q); });
}

Where SignedCovering::membership(const Vertex& q) const {
  const Point point = Point::free(q);
  const ConeRay ray = cone_ray(origin_.at, q, scale_);
  bool on = false;
  if (scene_.solid_count() == 1) {
    int w = at_origin_[0];
    for_each_face_of_walk(q, [&](std::uint32_t f) {
      const WalkStep s = step(f, q, point, ray);
      on = on || s.on;
      w += s.change;
    });
    return on ? Where::on : w == 0 ? Where::out : Where::in;
  }
  Windings w = at_origin_;
  for_each_face_of_walk(q, [&](std::uint32_t f) {
    const WalkStep s = step(f, q, point, ray);
    on = on || s.on;
    w.add(input_complex_of(scene_).operand_of_face(f), s.change);
  });
  if (on) return Where::on;
  return w.begin() == w.end() ? Where::out : Where::in;
}

Location SignedCovering::locate(const Vertex& q) const {
  const Point point = Point::free(q);
  const ConeRay ray = cone_ray(origin_.at, q, scale_);
  Windings windings = at_origin_;
  std::vector<Contact> faces;
  for_each_face_of_walk(q, [&](std::uint32_t f) {
    const WalkStep s = step(f, q, point, ray);
    windings.add(input_complex_of(scene_).operand_of_face(f), s.change);
    if (s.on) faces.push_back({input_complex_of(scene_).operand_of_face(f), f});
  });
  return location_of(std::move(windings), std::move(faces));
}

void SignedCovering::membership(std::span<const Vertex> q, std::span<Where> answers) const {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, std::min(q.size(), answers.size()), 256),
                    [&](const auto& range) {
                      for (std::size_t i = range.begin(); i < range.end(); ++i) answers[i] = membership(q[i]);
                    });
}

std::vector<Location> SignedCovering::locate(std::span<const Vertex> q) const {
  std::vector<Location> answers(q.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, q.size(), 256), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) answers[i] = locate(q[i]);
  });
  return answers;
}

}  // namespace strata
