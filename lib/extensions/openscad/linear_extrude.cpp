#include "extensions/openscad/linear_extrude.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

#include "core/mesh/circle.h"
#include "extensions/openscad/cap.h"
#include "extensions/openscad/outline_segments.h"
#include "extensions/openscad/primitives.h"
#include "extensions/openscad/rational_mesh.h"

namespace strata::openscad {
namespace {

constexpr double finest = 1.0 / (1 << 20);

/// At least as many layers as keep a twist of one below 120 degrees.
double least_slices(double twist) { return std::max(std::ceil(twist / 120), 1.0); }

/// The length of r = a theta from 0 to an angle.
double spiral_length(double a, double angle) {
  return a / 2 * (angle * std::sqrt(1 + angle * angle) + std::asinh(angle));
}

/// By $fn, or the smaller of what $fa and $fs ask for.
double slices_for(double twist, double length, const Resolution& r) {
  if (r.fn > 0) return std::max(std::ceil(twist / 360 * r.fn), least_slices(twist));
  return std::max(std::min(std::ceil(twist / std::max(r.fa, 0.01)), std::ceil(length / std::max(r.fs, 0.01))),
                  least_slices(twist));
}

/// Of the path of a point at that distance from the axis.
double helix_slices(double radius, const LinearExtrusion& e) {
  const double twist = std::abs(e.twist), turn = twist * std::numbers::pi / 180,
               height = std::hypot(e.along[0], e.along[1], e.along[2]);
  if (radius < finest || !std::isfinite(e.resolution.fn)) return least_slices(twist);
  const double pitch = height / turn;
  return slices_for(twist, turn * std::sqrt(radius * radius + pitch * pitch), e.resolution);
}

/// Of one that comes nearer to the axis, or goes away from it, on the way.
double conical_slices(double radius, const LinearExtrusion& e) {
  const double twist = std::abs(e.twist), turn = twist * std::numbers::pi / 180,
               height = std::hypot(e.along[0], e.along[1], e.along[2]);
  if (radius < finest || !std::isfinite(e.resolution.fn)) return least_slices(twist);
  const double scale = e.scale[0], end = scale > 1 ? turn * scale / (scale - 1) : turn / (1 - scale);
  const double a = radius / end, flat = spiral_length(a, end) - spiral_length(a, end - turn);
  return slices_for(twist, std::hypot(flat, height), e.resolution);
}

/// Of a straight path to where scaling moves a point that far.
double diagonal_slices(double distance, const LinearExtrusion& e) {
  const Resolution& r = e.resolution;
  if (distance < finest || !std::isfinite(r.fn)) return 1;
  if (r.fn > 0) return std::max(std::ceil(r.fn), 1.0);
  const double height = std::hypot(e.along[0], e.along[1], e.along[2]);
  return std::max(std::ceil(std::hypot(distance, height) / std::max(r.fs, 0.01)), 1.0);
}

class Extruder {
 public:
  Extruder(Cap cap, const LinearExtrusion& extrusion, std::uint32_t slices)
      : cap_(std::move(cap)), extrusion_(extrusion), slices_(slices) {}

  ExactMesh extrude() {
    const std::vector<Triangle> ends = triangles_of(cap_);
    std::vector<std::uint32_t> lower = layer(0);
    for (const auto& [a, b, c] : ends) mesh_.triangle(lower[a], lower[c], lower[b]);
    for (std::uint32_t j = 1; j <= slices_; ++j) {
      const bool is_flat = j == slices_ && (extrusion_.scale[0] == 0 || extrusion_.scale[1] == 0);
      const std::vector<std::uint32_t> upper = is_flat ? flat_layer() : layer(j);
      walls(lower, upper);
      lower = upper;
      if (j < slices_ || is_flat) continue;
      for (const auto& [a, b, c] : ends) mesh_.triangle(upper[a], upper[b], upper[c]);
    }
    return mesh_.take();
  }

 private:
  [[nodiscard]] RationalPoint centre(std::uint32_t j) const {
    RationalPoint p;
    const Rational part{Integer(j), Integer(slices_)};
    for (std::size_t i = 0; i < 3; ++i) {
      const Rational along = to_rational(extrusion_.along[i]);
      p[i] = along * part - (extrusion_.is_centred ? along / 2 : Rational(0));
    }
    return p;
  }
  /// The factor by which layer j is scaled along an axis.
  [[nodiscard]] Rational factor(std::uint32_t j, std::size_t axis) const {
    if (extrusion_.scale[axis] == 1) return 1;
    return 1 - (1 - to_rational(extrusion_.scale[axis])) * Rational(Integer(j), Integer(slices_));
  }
  /// Vertex v in layer j, in doubles.
  [[nodiscard]] Vertex turned(std::uint32_t v, std::uint32_t j) const {
    const double turn = std::fmod(extrusion_.twist * j / slices_, 360);
    const CosineSine d = cosine_sine(turn < 0 ? turn + 360 : turn);
    const auto& [x, y] = cap_.nearest[v];
    const RationalPoint at = centre(j);
    Vertex p{to_nearest_double(at[0]), to_nearest_double(at[1]), to_nearest_double(at[2])};
    p[0] += (x * d.cosine + y * d.sine) * to_nearest_double(factor(j, 0));
    p[1] += (y * d.cosine - x * d.sine) * to_nearest_double(factor(j, 1));
    return p;
  }

  std::vector<std::uint32_t> layer(std::uint32_t j) {
    std::vector<std::uint32_t> numbers;
    const RationalPoint at = centre(j);
    const Rational x = factor(j, 0), y = factor(j, 1);
    for (std::uint32_t v = 0; v < cap_.exact.size(); ++v) {
      if (extrusion_.twist != 0) {
        numbers.push_back(mesh_.add(turned(v, j)));
      } else {
        numbers.push_back(mesh_.add(RationalPoint{cap_.exact[v][0] * x + at[0], cap_.exact[v][1] * y + at[1], at[2]}));
      }
    }
    return numbers;
  }

  /// A layer without area: equal positions have one vertex. Their numbers increase along the ridge.
  std::vector<std::uint32_t> flat_layer() {
    const std::size_t axis = extrusion_.scale[0] == 0 ? 1 : 0;
    const RationalPoint at = centre(slices_);
    std::map<Rational, std::uint32_t> number_at;
    std::vector<Rational> places;
    for (std::uint32_t v = 0; v < cap_.exact.size(); ++v) {
      const Rational along = extrusion_.twist != 0 ? to_rational(turned(v, slices_)[axis])
                                                   : cap_.exact[v][axis] * factor(slices_, axis) + at[axis];
      number_at.try_emplace(along, 0);
      places.push_back(along);
    }
    for (auto& [along, number] : number_at) {
      RationalPoint p = at;
      p[axis] = along;
      number = mesh_.add(std::move(p));
    }
    std::vector<std::uint32_t> numbers;
    has_ridge_ = true;
    for (const Rational& along : places) numbers.push_back(number_at.at(along));
    return numbers;
  }

  /// The triangles of a point and a straight stretch of the ridge from one vertex to another, or of one edge.
  void fan(std::uint32_t point, std::uint32_t from, std::uint32_t to) {
    if (!has_ridge_) return mesh_.triangle(point, from, to);
    for (; from < to; ++from) mesh_.triangle(point, from, from + 1);  // vertices of the ridge are numbered along it
    for (; from > to; --from) mesh_.triangle(point, from, from - 1);
  }

  void walls(const std::vector<std::uint32_t>& lower, const std::vector<std::uint32_t>& upper) {
    std::size_t next = 0;
    for (const std::uint32_t count : cap_.loops_of_polygon)
      for (std::uint32_t l = 0; l < count; ++l) wall(cap_.loops[next++], lower, upper, l == 0);
  }
  void wall(const std::vector<std::uint32_t>& loop, const std::vector<std::uint32_t>& lower,
            const std::vector<std::uint32_t>& upper, bool is_outer) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const std::uint32_t p = loop[i], q = loop[(i + 1) % loop.size()];
      if (splits_from_first(lower[p], lower[q], upper[p], upper[q], is_outer)) {
        mesh_.triangle(lower[p], lower[q], upper[q]);
        fan(lower[p], upper[q], upper[p]);
      } else {
        mesh_.triangle(lower[p], lower[q], upper[p]);
        fan(lower[q], upper[q], upper[p]);
      }
    }
  }

  /// Whether the diagonal from p below to q above is shorter; of nearly equal ones, by the direction of the twist.
  [[nodiscard]] bool splits_from_first(std::uint32_t p, std::uint32_t q, std::uint32_t above_p, std::uint32_t above_q,
                                       bool is_outer) const {
    const double first = flat_distance(p, above_q), second = flat_distance(q, above_p);
    constexpr double nearly = 1e5;
    if (2 * std::abs(first - second) * nearly > first + second) return first < second;
    return is_outer == (extrusion_.twist >= 0);
  }
  [[nodiscard]] double flat_distance(std::uint32_t a, std::uint32_t b) const {
    const Vertex &p = mesh_.mesh().mesh.vertices[a], &q = mesh_.mesh().mesh.vertices[b];
    return std::hypot(p[0] - q[0], p[1] - q[1]);
  }

  Cap cap_;
  const LinearExtrusion& extrusion_;
  std::uint32_t slices_;
  VertexCollector mesh_;
  bool has_ridge_ = false;  ///< the layer above has no area
};

}  // namespace

std::uint32_t slices_of(const planar::Region& region, const LinearExtrusion& e) {
  if (e.slices) return std::max(*e.slices, 1U);
  double radius = 0, moved = 0;
  for (const std::uint32_t v : region.loops.vertices) {
    const auto& [x, y] = region.loops.places.place[v];
    radius = std::max(radius, std::hypot(x, y));
    moved = std::max(moved, std::hypot(x - x * e.scale[0], y - y * e.scale[1]));
  }
  const bool is_uniform = e.scale[0] == e.scale[1];
  double slices = 1;
  if (e.twist != 0) {
    slices = is_uniform && e.scale[0] != 1 ? conical_slices(radius, e) : helix_slices(radius, e);
  }
  if (!is_uniform) slices = std::max(slices, diagonal_slices(moved, e));
  return static_cast<std::uint32_t>(std::min(slices, 1e6));
}

Solid linear_extrude(const planar::Region& region, const LinearExtrusion& extrusion, const Options& options) {
  const std::uint32_t slices = slices_of(region, extrusion);
  Cap cap = cap_of(region);
  divide_outlines(cap, extrusion, slices);
  if (cap.exact.size() > most_corners / (slices + std::size_t{1}))
    throw std::length_error("an extrusion of more than ten million corners");
  Options checked = options;
  const bool is_plain = extrusion.twist == 0 && extrusion.scale[0] == extrusion.scale[1] && extrusion.scale[0] != 0;
  checked.input = is_plain ? InputClass::solid : InputClass::automatic;
  return Solid(Extruder(std::move(cap), extrusion, slices).extrude(), checked);
}

}  // namespace strata::openscad
