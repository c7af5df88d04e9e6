#include "extensions/openscad/offset.h"

#include <cmath>
#include <stdexcept>
#include <vector>

#include "core/mesh/circle.h"
#include "extensions/openscad/primitives.h"

namespace strata::openscad {
namespace {

using planar::PlanePoint;

/// The unit normal to the right of a directed edge: outwards, for a region on the left.
PlanePoint normal_of(const PlanePoint& from, const PlanePoint& to) {
  const double x = to[0] - from[0], y = to[1] - from[1], length = std::hypot(x, y);
  return {y / length, -x / length};
}

class OffsetLoop {
 public:
  OffsetLoop(double distance, OffsetJoin join, std::uint32_t sides) : distance_(distance), join_(join), sides_(sides) {}

  std::vector<PlanePoint> of(const std::vector<PlanePoint>& corners) {
    points_.clear();
    const std::size_t n = corners.size();
    for (std::size_t i = 0; i < n; ++i)
      corner(corners[i], normal_of(corners[(i + n - 1) % n], corners[i]), normal_of(corners[i], corners[(i + 1) % n]));
    return points_;
  }

 private:
  void add(const PlanePoint& p, double x, double y) { points_.push_back({p[0] + distance_ * x, p[1] + distance_ * y}); }

  void corner(const PlanePoint& p, const PlanePoint& before, const PlanePoint& after) {
    const double sine = before[0] * after[1] - before[1] * after[0];
    const double cosine = before[0] * after[0] + before[1] * after[1];
    if (sine == 0 && cosine > 0) return add(p, after[0], after[1]);
    if (sine * distance_ < 0) {  // reaches in
      add(p, before[0], before[1]);
      points_.push_back(p);
      return add(p, after[0], after[1]);
    }
    switch (join_) {
      case OffsetJoin::round:
        return arc(p, before, after, std::atan2(sine, cosine));
      case OffsetJoin::miter:
        if (const double scale = 1 + cosine; scale > 2e-12)
          return add(p, (before[0] + after[0]) / scale, (before[1] + after[1]) / scale);
        return chamfer(p, before, after, std::tan(std::atan2(sine, cosine) / 4));
      case OffsetJoin::chamfer:
        return chamfer(p, before, after, std::tan(std::atan2(sine, cosine) / 4));
    }
  }
  void chamfer(const PlanePoint& p, const PlanePoint& before, const PlanePoint& after, double along) {
    add(p, before[0] - before[1] * along, before[1] + before[0] * along);
    add(p, after[0] + after[1] * along, after[1] - after[0] * along);
  }
  void arc(const PlanePoint& p, const PlanePoint& before, const PlanePoint& after, double angle) {
    constexpr double turn = 2 * 3.14159265358979323846;
    const double steps = std::max(std::round(sides_ / turn * std::abs(angle)), 1.0);
    for (double k = 0; k < steps; ++k) {
      CosineSine d = cosine_sine(std::fmod(360 * k / sides_, 360));
      if (distance_ < 0) d.sine = -d.sine;
      add(p, before[0] * d.cosine - before[1] * d.sine, before[1] * d.cosine + before[0] * d.sine);
    }
    add(p, after[0], after[1]);
  }

  double distance_;
  OffsetJoin join_;
  std::uint32_t sides_;
  std::vector<PlanePoint> points_;
};

}  // namespace

planar::Region offset(const planar::Region& region, double distance, OffsetJoin join, const Resolution& resolution) {
  if (sides_of_circle(std::abs(distance), resolution) > most_corners / 10)
    throw std::length_error("an offset with arcs of more than a million sides");
  OffsetLoop offset_loop(distance, join, sides_of_circle(std::abs(distance), resolution));
  planar::Loops loops;
  for (std::uint32_t l = 0; l < region.loops.size(); ++l) {
    std::vector<PlanePoint> corners;
    for (const std::uint32_t v : region.loops.loop(l))
      if (const PlanePoint& p = region.loops.places.place[v]; corners.empty() || corners.back() != p)
        corners.push_back(p);
    while (corners.size() > 1 && corners.back() == corners.front()) corners.pop_back();
    if (corners.size() >= 2) loops.add(offset_loop.of(corners));
  }
  return planar::fill({loops, planar::FillRule::positive});
}

}  // namespace strata::openscad
