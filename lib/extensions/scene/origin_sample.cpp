#include "extensions/scene/origin_sample.h"

#include <algorithm>
#include <cmath>

#include "core/exact/vector.h"
#include "core/kernel/input_complex.h"
#include "extensions/scene/scene_data.h"

namespace strata {
namespace {

using Vector = OriginSample::Vector;
constexpr std::uint32_t most_faces = 2048, most_rays = 32, inside_places = 6;

Vector operator-(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vector along(const Vector& a, double t, const Vector& d) { return {a[0] + t * d[0], a[1] + t * d[1], a[2] + t * d[2]}; }

Vector middle(const std::array<Vector, 3>& f) {
  Vector m{};
  for (const Vector& corner : f) m = along(m, 1.0 / 3, corner);
  return m;
}

/// The i-th of numbers below n that are evenly distributed and independent of patterns in the mesh: multiples of the
/// golden section.
std::size_t spread(std::size_t i, std::size_t n) {
  const double orientations = static_cast<double>(i) * 0.6180339887498949;
  return static_cast<std::size_t>((orientations - std::floor(orientations)) * static_cast<double>(n));
}

/// A face as seen from a position: normals of the planes through the position and the face's sides, inwards.
struct Cone {
  std::array<Vector, 3> sides;

  /// A face that is seen edge-on has no interior, and no normals.
  Cone(const std::array<Vector, 3>& face, const Vector& from) {
    const Vector a = face[0] - from, b = face[1] - from, c = face[2] - from;
    sides = {cross(a, b), cross(b, c), cross(c, a)};
    const double volume = dot(a, sides[1]);
    const double orientation = volume == 0 ? std::nan("") : volume < 0 ? -1 : 1;
    for (Vector& side : sides)
      for (double& x : side) x *= orientation;
  }
  [[nodiscard]] bool holds(const Vector& direction) const {
    const bool u = dot(sides[0], direction) >= 0, v = dot(sides[1], direction) >= 0, w = dot(sides[2], direction) >= 0;
    return u & v & w;
  }
};

}  // namespace

OriginSample::OriginSample(const Scene& scene) {
  find_frame(scene);
  const InputComplex& input = input_complex_of(scene);
  const std::uint64_t all = input.face_count(), count = std::min<std::uint64_t>(all, most_faces);
  for (std::uint64_t i = 0; i < count; ++i) {
    const auto v = input.face(static_cast<std::uint32_t>(i * all / count));
    faces_.push_back({in_frame(input.vertex(v[0])), in_frame(input.vertex(v[1])), in_frame(input.vertex(v[2]))});
  }
}

void OriginSample::find_frame(const Scene& scene) {
  Vector lower, upper;
  lower.fill(HUGE_VAL);
  upper.fill(-HUGE_VAL);
  double largest = 0;
  for (std::uint32_t s = 0; s < scene.solid_count(); ++s)
    for (const Vertex& v : scene.solid(s).mesh.vertices)
      for (std::size_t i = 0; i < 3; ++i) {
        lower[i] = std::min(lower[i], v[i]);
        upper[i] = std::max(upper[i], v[i]);
        largest = std::max(largest, std::abs(v[i]));
      }
  exponent_ = std::ilogb(largest) + 1;
  size_ = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double low = std::ldexp(lower[i], -exponent_), high = std::ldexp(upper[i], -exponent_);
    centre_[i] = (low + high) / 2;
    size_ = std::max(size_, (high - low) / 2);
  }
}

Vector OriginSample::in_frame(const InputComplex::Coordinates& v) const {
  Vector p;
  for (std::size_t i = 0; i < 3; ++i) p[i] = (std::ldexp(v[i], -exponent_) - centre_[i]) / size_;
  return p;
}

Vector OriginSample::in_scene(const Vector& place) const {
  Vector p;
  for (std::size_t i = 0; i < 3; ++i) p[i] = std::ldexp(centre_[i] + place[i] * size_, exponent_);
  return p;
}

int OriginSample::size_exponent() const { return exponent_ + std::ilogb(size_); }

std::vector<Vector> OriginSample::places() const {
  Vector mean{};
  for (const Face& f : faces_) mean = along(mean, 1.0 / static_cast<double>(faces_.size()), middle(f));
  std::vector<Vector> places{{0, 0, 0}, mean};
  for (std::size_t i = 0; i < inside_places; ++i)
    if (const auto place = place_behind(spread(i, faces_.size()))) places.push_back(*place);
  constexpr double outside = 3;
  for (const Vector& place : {Vector{outside, 0, 0}, Vector{0, outside, 0}, Vector{0, 0, outside}})
    places.push_back(place);
  return places;
}

/// The midpoint between a face and the next one behind it.
std::optional<Vector> OriginSample::place_behind(std::size_t face) const {
  const auto& [a, b, c] = faces_[face];
  const Vector from = middle(faces_[face]), normal = cross(b - a, c - a),
               inwards = {-normal[0], -normal[1], -normal[2]};
  double nearest = HUGE_VAL;
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    if (i == face || !Cone(faces_[i], from).holds(inwards)) continue;
    const auto& [p, q, r] = faces_[i];
    const Vector n = cross(q - p, r - p);
    nearest = std::min(nearest, dot(n, p - from) / dot(n, inwards));
  }
  if (!std::isfinite(nearest)) return std::nullopt;
  return along(from, nearest / 2, inwards);
}

std::uint64_t OriginSample::cost(const Vector& place) const {
  std::vector<Cone> cones;
  cones.reserve(faces_.size());
  for (const Face& f : faces_) cones.emplace_back(f, place);
  const std::size_t rays = std::min<std::size_t>(faces_.size(), most_rays);
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < rays; ++i) {
    const Vector direction = middle(faces_[spread(i, faces_.size())]) - place;
    std::uint64_t met = 0;
    for (const Cone& cone : cones) met += cone.holds(direction);
    sum += met * met * met * met;
  }
  return sum;
}

}  // namespace strata
