#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "core/exact/finite.h"
#include "core/exact/vector.h"
#include "core/kernel/rational_point.h"
#include "extensions/complex/face_geometry.h"
#include "strata/complex.h"

namespace strata::complex {
namespace {

using Index = std::uint32_t;

class Locator {
 public:
  Locator(const Cells& cells, const RationalPoint& p)
      : cells_(cells), p_(p), rounded_{to_nearest_double(p[0]), to_nearest_double(p[1]), to_nearest_double(p[2])} {}

  Cell locate() {
    for (Index v = 0; v < cells_.count(0); ++v)
      if (cells_.points[v] == rounded_ && cells_.position(v) == p_) return {0, v};
    for (Index e = 0; e < cells_.count(1); ++e)
      if (is_on_edge(e)) return {1, e};
    return cells_.dimension == 2 ? Cell{2, face_in_plane()} : face_or_volume();
  }

 private:
  /// Rounding is monotone: if a point is outside the box of an edge after rounding, it is outside before.
  [[nodiscard]] bool is_on_edge(Index e) const {
    const auto [low, high] = cells_.edges[e];
    const Vertex &a = cells_.points[low], &b = cells_.points[high];
    for (std::size_t i = 0; i < 3; ++i)
      if (rounded_[i] < std::min(a[i], b[i]) || rounded_[i] > std::max(a[i], b[i])) return false;
    const RationalPoint u = cells_.position(low), v = cells_.position(high);
    const RationalPoint d = minus(v, u), q = minus(p_, u);
    return d[0] * q[1] == d[1] * q[0] && d[1] * q[2] == d[2] * q[1] && d[0] * q[2] == d[2] * q[0] && u < p_ && p_ < v;
  }

  /// The side of p, translated by (e, e^2), relative to the projected edge: positive on its left.
  [[nodiscard]] int side(const RationalPoint& u, const RationalPoint& v, std::size_t i, std::size_t j) const {
    const Rational orientation = (v[i] - u[i]) * (p_[j] - u[j]) - (v[j] - u[j]) * (p_[i] - u[i]);
    if (orientation != 0) return orientation.sign();
    const Rational first = u[j] - v[j];
    return first != 0 ? first.sign() : Rational(v[i] - u[i]).sign();
  }

  /// True if the ray from the translated p along axis i crosses an edge, seen along the third axis.
  [[nodiscard]] bool crosses(Index e, std::size_t i, std::size_t j) const {
    const RationalPoint u = cells_.position(cells_.edges[e][0]), v = cells_.position(cells_.edges[e][1]);
    // The translated p has a second coordinate above p's.
    const bool u_above = u[j] > p_[j], v_above = v[j] > p_[j];
    if (u_above == v_above) return false;
    return side(u, v, i, j) == (v_above ? 1 : -1);
  }

  /// The face on the lower side of the nearest edge on the ray, as seen along the ray.
  [[nodiscard]] Index face_in_plane() const {
    std::optional<Rational> nearest;
    Rational nearest_slope;
    Index face = 0;
    for (const Wing& w : cells_.wings) {
      const RationalPoint u = cells_.position(cells_.edges[w.edge][0]), v = cells_.position(cells_.edges[w.edge][1]);
      if (!crosses(w.edge, 0, 1) || w.left != (v[1] > u[1])) continue;
      const Rational slope = (v[0] - u[0]) / (v[1] - u[1]);
      const Rational x = u[0] + slope * (p_[1] - u[1]);
      // If they are equal at the height of p, they separate just above it.
      if (nearest && (x > *nearest || (x == *nearest && slope > nearest_slope))) continue;
      nearest = x;
      nearest_slope = slope;
      face = w.face;
    }
    return face;
  }

  /// True if the line along the axis through the translated p crosses the face: it crosses its edges an odd number of
  /// times; an edge with the face on both sides counts twice.
  [[nodiscard]] bool passes(std::span<const Wing> wings, std::size_t axis) const {
    bool odd = false;
    for (const Wing& w : wings)
      if (crosses(w.edge, (axis + 1) % 3, (axis + 2) % 3)) odd = !odd;
    return odd;
  }

  [[nodiscard]] Cell face_or_volume() const {
    const WingsOfFaces wings(cells_);
    std::optional<std::array<Rational, 3>> nearest;  // x, and how it grows with y and z
    Index volume = 0;
    for (Index f = 0; f < cells_.count(2); ++f) {
      if (!may_be_beyond(wings[f])) continue;
      const RationalPoint n = area_vector(cells_, wings[f]);
      const RationalPoint q = minus(p_, cells_.position(cells_.edges[wings[f].front().edge][0]));
      const Rational height = n[0] * q[0] + n[1] * q[1] + n[2] * q[2];
      if (height == 0 && passes(wings[f], n[0] != 0 ? 0 : n[1] != 0 ? 1 : 2)) return {2, f};
      if (n[0] == 0 || !passes(wings[f], 0)) continue;
      // n . (q + (t, y, z)) = 0: what t is at p, and how it changes.
      const std::array<Rational, 3> t{-height / n[0], -n[1] / n[0], -n[2] / n[0]};
      if (t < std::array<Rational, 3>{0, 0, 0} || (nearest && *nearest < t)) continue;
      nearest = t;
      volume = cells_.sides[f][1];  // n[0] > 0: the ray arrives from below
    }
    return {3, volume};
  }

  [[nodiscard]] bool may_be_beyond(std::span<const Wing> wings) const {
    std::array<bool, 3> below{}, above{};
    for (const Wing& w : wings)
      for (const Index v : cells_.edges[w.edge])
        for (std::size_t i = 0; i < 3; ++i) {
          below[i] = below[i] || cells_.points[v][i] <= rounded_[i];
          above[i] = above[i] || cells_.points[v][i] >= rounded_[i];
        }
    return above[0] && below[1] && above[1] && below[2] && above[2];
  }

  const Cells& cells_;
  const RationalPoint& p_;
  Vertex rounded_;
};

RationalPoint exact(const Vertex& p) {
  if (!is_finite(p)) throw std::invalid_argument("the point is not finite");
  return to_rational(p);
}

}  // namespace

Cell locate(const SelectiveComplex& s, const RationalPoint& p) {
  if (s.dimension() == 2 && p[2] != 0) throw std::invalid_argument("the point is not in the plane");
  return Locator(s.cells(), p).locate();
}
Cell locate(const SelectiveComplex& s, const Vertex& p) { return locate(s, exact(p)); }
bool contains(const SelectiveComplex& s, const RationalPoint& p) { return s.mark(locate(s, p)); }
bool contains(const SelectiveComplex& s, const Vertex& p) { return contains(s, exact(p)); }

}  // namespace strata::complex
