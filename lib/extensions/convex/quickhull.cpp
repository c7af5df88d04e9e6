#include "extensions/convex/quickhull.h"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "core/exact/failure.h"
#include "core/kernel/filters.h"

namespace strata::convex {
namespace {

Bounded magnitude(const Bounded& x) { return {std::abs(x.value), x.error}; }

}  // namespace

Quickhull::Quickhull(const PointCloud& cloud, const std::array<std::uint32_t, 4>& simplex) : cloud_(cloud) {
  auto [a, b, c, d] = simplex;
  if (cloud.side(a, b, c, d) == Sign::positive) std::swap(a, b);
  for (const Face& face :
       {Face{{a, b, c}, {3, 1, 2}}, Face{{b, d, c}, {3, 2, 0}}, Face{{c, d, a}, {1, 3, 0}}, Face{{a, d, b}, {2, 1, 0}}})
    (void)new_face(face);
  next_.resize(cloud.size(), none);
}

/// The bound is that of the running errors of orient3d for the largest differences of coordinates. Rounding is
/// monotone, so those of smaller differences are smaller; theory.md, "Hulls".
Quickhull::Plane Quickhull::plane_of(const Face& face) const {
  const auto& [a, b, c] = face.corner;
  const BoundedPoint from = cloud_.bounded(a);
  const BoundedPoint normal = cross<Bounded>(cloud_.bounded(b) - from, cloud_.bounded(c) - from);
  Plane plane{cloud_.at(a), {normal[0].value, normal[1].value, normal[2].value}, 0};
  if (cloud_.is_small_lattice()) return plane;
  const BoundedPoint sizes{magnitude(normal[0]), magnitude(normal[1]), magnitude(normal[2])};
  plane.bound = dot<Bounded>(sizes, cloud_.extent()).error * Bounded::slack;
  return plane;
}

std::uint32_t Quickhull::new_face(const Face& face) {
  const Plane plane = plane_of(face);
  if (!unused_.empty()) {
    const std::uint32_t f = unused_.back();
    unused_.pop_back();
    faces_[f] = face;
    planes_[f] = plane;
    waiting_[f] = {};
    mark_[f] = 0;
    return f;
  }
  faces_.push_back(face);
  planes_.push_back(plane);
  waiting_.emplace_back();
  mark_.push_back(0);
  return static_cast<std::uint32_t>(faces_.size() - 1);
}

bool Quickhull::sees(std::uint32_t point, std::uint32_t face, double height) const {
  if (height > planes_[face].bound) return true;
  if (-height > planes_[face].bound) return false;
  const auto& [a, b, c] = faces_[face].corner;
  return cloud_.side(a, b, c, point) == Sign::positive;
}

bool Quickhull::sees(std::uint32_t point, std::uint32_t face) const {
  return sees(point, face, planes_[face].height(cloud_.at(point)));
}

void Quickhull::wait(std::uint32_t point, std::uint32_t face, double height) {
  Waiting& waiting = waiting_[face];
  if (waiting.first == none) pending_.push_back(face);
  next_[point] = std::exchange(waiting.first, point);
  if (waiting.farthest != none && !(height > waiting.height)) return;
  waiting.farthest = point;
  waiting.height = height;
}

void Quickhull::add(std::span<const std::uint32_t> points, const Monitor& monitor) {
  for (const std::uint32_t p : points) {
    monitor.check();
    for (std::uint32_t f = 0; f < faces_.size(); ++f) {
      if (mark_[f] == none) continue;
      const double height = planes_[f].height(cloud_.at(p));
      if (!sees(p, f, height)) continue;
      wait(p, f, height);
      break;
    }
  }
  run(monitor);
}

void Quickhull::run(const Monitor& monitor) {
  while (!pending_.empty()) {
    monitor.check();
    const std::uint32_t face = pending_.back();
    pending_.pop_back();
    if (mark_[face] != none && waiting_[face].first != none) insert(waiting_[face].farthest, face);
  }
}

void Quickhull::insert(std::uint32_t point, std::uint32_t face) {
  ++round_;
  find_horizon(point, face);
  make_cone(point);
  share_out(point);
  for (const std::uint32_t f : visible_) mark_[f] = none;
  unused_.insert(unused_.end(), visible_.begin(), visible_.end());
}

/// Depth first, through the edges of every face in their order, so that the edges of the rim are found in order.
void Quickhull::find_horizon(std::uint32_t point, std::uint32_t face) {
  const std::uint32_t hidden = 2 * round_, visible = hidden + 1;
  visible_.assign(1, face);
  horizon_.clear();
  visits_.assign(1, {face, 0, 3});
  mark_[face] = visible;
  while (!visits_.empty()) {
    Visit& visit = visits_.back();
    if (visit.left == 0) {
      visits_.pop_back();
      continue;
    }
    const std::uint32_t f = visit.face, edge = visit.edge;
    visit.edge = (edge + 1) % 3;
    --visit.left;
    const std::uint32_t beyond = faces_[f].neighbor[edge];
    if (mark_[beyond] == visible) continue;
    const std::uint32_t back = edge_to(faces_[beyond], f);
    if (mark_[beyond] != hidden && sees(point, beyond)) {
      mark_[beyond] = visible;
      visible_.push_back(beyond);
      visits_.push_back({beyond, (back + 1) % 3, 2});
    } else {
      mark_[beyond] = hidden;
      horizon_.push_back({faces_[f].corner[edge], faces_[f].corner[(edge + 1) % 3], beyond, back});
    }
  }
}

void Quickhull::make_cone(std::uint32_t point) {
  cone_.clear();
  for (const HorizonEdge& e : horizon_) cone_.push_back(new_face({{e.from, e.to, point}, {e.face, none, none}}));
  for (std::size_t i = 0; i < cone_.size(); ++i) {
    const std::size_t after = i + 1 < cone_.size() ? i + 1 : 0;
    const HorizonEdge& e = horizon_[i];
#ifdef STRATA_CHECKED
    if (e.to != horizon_[after].from) fail("convex hull: the horizon is no cycle", e.face);
#endif
    faces_[e.face].neighbor[e.edge] = cone_[i];
    faces_[cone_[i]].neighbor[1] = cone_[after];
    faces_[cone_[after]].neighbor[2] = cone_[i];
  }
}

void Quickhull::share_out(std::uint32_t point) {
  for (const std::uint32_t gone : visible_) {
    for (std::uint32_t p = waiting_[gone].first, after = none; p != none; p = after) {
      after = next_[p];
      if (p == point) continue;
      for (const std::uint32_t f : cone_) {
        const double height = planes_[f].height(cloud_.at(p));
        if (!sees(p, f, height)) continue;
        wait(p, f, height);
        break;
      }
    }
  }
}

std::vector<Quickhull::Plane> Quickhull::planes() const {
  std::vector<Plane> result;
  for (std::size_t f = 0; f < faces_.size(); ++f)
    if (mark_[f] != none) result.push_back(planes_[f]);
  return result;
}

bool Quickhull::is_flat(std::uint32_t face, std::uint32_t edge) const {
  const Face& beyond = faces_[faces_[face].neighbor[edge]];
  const std::uint32_t p = beyond.corner[(edge_to(beyond, face) + 2) % 3];
  const double height = planes_[face].height(cloud_.at(p));
  if (std::abs(height) > planes_[face].bound) return false;
  const auto& [a, b, c] = faces_[face].corner;
  return cloud_.side(a, b, c, p) == Sign::zero;
}

}  // namespace strata::convex
