#include "extensions/openscad/tessellation.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/io/triangulate.h"

namespace strata::openscad {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double root_of_half = 0.70710678118654752440;            // sqrt(1/2)
constexpr double root_of_three_quarters = 0.86602540378443864676;  // sqrt(3/4)

/// For angles in [0, 90].
Direction in_first_quadrant(double degrees) {
  if (degrees == 30) return {root_of_three_quarters, 0.5};
  if (degrees == 45) return {root_of_half, root_of_half};
  if (degrees == 60) return {0.5, root_of_three_quarters};
  if (degrees > 45) {
    const double rest = (90 - degrees) * (pi / 180);
    return {std::sin(rest), std::cos(rest)};
  }
  const double angle = degrees * (pi / 180);
  return {std::cos(angle), std::sin(angle)};
}

/// Of 0 it is 0, not -0.
double opposite(double x) { return 0 - x; }

/// Builds a mesh from rings and the faces between them.
class Stack {
 public:
  Stack(std::span<const Ring> rings, std::uint32_t sides) : sides_(sides) {
    for (std::uint32_t i = 0; i < sides; ++i) directions_.push_back(direction(360.0 * i / sides));
    add_ring(rings[0]);
    if (!lower_.is_point) add_cap(false);
    for (const Ring& ring : rings.subspan(1)) {
      add_ring(ring);
      add_wall();
    }
    if (!upper_.is_point) add_cap(true);
  }
  Mesh take() { return std::move(mesh_); }

 private:
  /// Numbers of a ring's corners.
  struct Corners {
    std::uint32_t first = 0;
    bool is_point = false;
    [[nodiscard]] std::uint32_t at(std::uint32_t side) const { return is_point ? first : first + side; }
  };

  /// The ring that was the upper one becomes the lower one.
  void add_ring(const Ring& ring) {
    const Corners corners{static_cast<std::uint32_t>(mesh_.vertices.size()), ring.radius == 0};
    lower_ = mesh_.vertices.empty() ? corners : upper_;
    upper_ = corners;
    if (corners.is_point) {
      mesh_.vertices.push_back({0, 0, ring.z});
      return;
    }
    for (const Direction& d : directions_)
      mesh_.vertices.push_back({ring.radius * d.cosine, ring.radius * d.sine, ring.z});
  }
  void add_cap(bool above) {
    const Corners& ring = above ? upper_ : lower_;
    const std::size_t first = mesh_.triangles.size();
    mesh_.triangles.resize(first + sides_ - 2);
    const std::span<Triangle> cap = std::span(mesh_.triangles).subspan(first);
    io::triangulate(std::span(mesh_.vertices).subspan(ring.first, sides_), cap);
    for (Triangle& t : cap) {
      for (std::uint32_t& v : t) v += ring.first;
      if (!above) std::swap(t[1], t[2]);
    }
  }
  void add_wall() {
    for (std::uint32_t i = 0; i < sides_; ++i) {
      const std::uint32_t j = i + 1 == sides_ ? 0 : i + 1;
      if (!lower_.is_point) mesh_.triangles.push_back({lower_.at(i), lower_.at(j), upper_.at(j)});
      if (!upper_.is_point) mesh_.triangles.push_back({lower_.at(i), upper_.at(j), upper_.at(i)});
    }
  }

  std::uint32_t sides_;
  std::vector<Direction> directions_;
  Mesh mesh_;
  Corners lower_, upper_;
};

}  // namespace

std::uint32_t sides_of_circle(double radius, const Resolution& resolution) {
  constexpr double finest = 1.0 / (1 << 20), most = 1U << 31, least = 0.01;
  if (radius < finest || !std::isfinite(resolution.fn)) return 3;
  double sides = std::ceil(std::max(resolution.fn, 3.0));
  if (resolution.fn <= 0) {
    const double by_angle = 360 / std::max(resolution.fa, least);
    const double by_length = radius * 2 * pi / std::max(resolution.fs, least);
    sides = std::ceil(std::max(std::min(by_angle, by_length), 5.0));
  }
  return static_cast<std::uint32_t>(std::min(sides, most));
}

Direction direction(double degrees) {
  const double quadrant = std::floor(degrees / 90);
  const Direction d = in_first_quadrant(degrees - 90 * quadrant);  // exact
  if (quadrant == 0) return d;
  if (quadrant == 1) return {opposite(d.sine), d.cosine};
  if (quadrant == 2) return {opposite(d.cosine), opposite(d.sine)};
  return {d.sine, opposite(d.cosine)};
}

Mesh stack(std::span<const Ring> rings, std::uint32_t sides) { return Stack(rings, sides).take(); }

}  // namespace strata::openscad
