#include "textured_face.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace {

using strata::Vertex;

constexpr int most_divisions = 10;  ///< of a triangle; more are asked for only right before the eye
constexpr double steps = 31;        ///< of colors

template <class Point>
Point middle(const Point& a, const Point& b) {
  return {a[0] / 2 + b[0] / 2, a[1] / 2 + b[1] / 2, a[2] / 2 + b[2] / 2};
}

/// Into three triangles at the corners and one between them.
std::array<TexturedTriangle, 4> quarters(const TexturedTriangle& t) {
  TexturedTriangle inner;  // corner k is opposite to corner k
  for (std::size_t k = 0; k < 3; ++k) {
    inner.corners[k] = middle(t.corners[(k + 1) % 3], t.corners[(k + 2) % 3]);
    inner.places[k] = middle(t.places[(k + 1) % 3], t.places[(k + 2) % 3]);
  }
  std::array<TexturedTriangle, 4> parts{inner, inner, inner, inner};
  for (std::size_t k = 0; k < 3; ++k) {
    parts[k].corners[k] = t.corners[k];
    parts[k].places[k] = t.places[k];
  }
  return parts;
}

class Divider {
 public:
  Divider(const FaceColors& colors, std::uint32_t face, const View& view, double longest_side)
      : colors_(colors), face_(face), view_(view), longest_side_(longest_side) {}

  /// Adds the parts of a triangle.
  void divide(const TexturedTriangle& t, int divisions) {
    if (divisions == most_divisions || is_small(t.corners)) return parts_.push_back({t.corners, average(t)});
    const std::size_t first = parts_.size();
    for (const TexturedTriangle& part : quarters(t)) divide(part, divisions + 1);
    const auto is_like_first = [&](const ColoredTriangle& part) { return part.color == parts_[first].color; };
    if (parts_.size() != first + 4 ||
        !std::all_of(parts_.begin() + static_cast<std::ptrdiff_t>(first), parts_.end(), is_like_first))
      return;
    parts_.resize(first + 1);
    parts_.back().corners = t.corners;
  }

  [[nodiscard]] std::vector<ColoredTriangle> parts() && {
    std::stable_sort(parts_.begin(), parts_.end(), [](const auto& p, const auto& q) { return p.color < q.color; });
    return std::move(parts_);
  }

 private:
  [[nodiscard]] bool is_small(const std::array<Vertex, 3>& corners) const {
    std::array<PaperPoint, 3> at{};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::optional<PaperPoint> place = view_.place(corners[k]);
      if (!place) return false;
      at[k] = *place;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const PaperPoint &p = at[k], &q = at[(k + 1) % 3];
      if (std::hypot(p[0] - q[0], p[1] - q[1]) > longest_side_) return false;
    }
    return true;
  }

  [[nodiscard]] ScreenColor average(const TexturedTriangle& t) const {
    ScreenColor sum{};
    for (const TexturedTriangle& part : quarters(t)) {
      FaceColors::Weights centre{};
      for (const FaceColors::Weights& place : part.places)
        for (std::size_t i = 0; i < 3; ++i) centre[i] += place[i] / 3;
      const ScreenColor color = colors_.at(face_, centre);
      for (std::size_t i = 0; i < 3; ++i) sum[i] += color[i] / 4;
    }
    for (double& x : sum) x = std::round(x * steps) / steps;
    return sum;
  }

  const FaceColors& colors_;
  std::uint32_t face_;
  const View& view_;
  double longest_side_;
  std::vector<ColoredTriangle> parts_;
};

}  // namespace

FaceColors::Weights place_in(const std::array<Vertex, 3>& face, const Vertex& p) {
  const auto minus = [](const Vertex& a, const Vertex& b) { return Vertex{a[0] - b[0], a[1] - b[1], a[2] - b[2]}; };
  const auto dot = [](const Vertex& a, const Vertex& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
  const Vertex u = minus(face[1], face[0]), v = minus(face[2], face[0]), w = minus(p, face[0]);
  const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), wu = dot(w, u), wv = dot(w, v);
  const double d = uu * vv - uv * uv;
  if (!(d > 0)) return {1, 0, 0};
  const double second = (wu * vv - wv * uv) / d, third = (wv * uu - wu * uv) / d;
  return {1 - second - third, second, third};
}

std::vector<ColoredTriangle> divided(const TexturedTriangle& triangle, const FaceColors& colors, std::uint32_t face,
                                     const View& view, double longest_side) {
  Divider divider(colors, face, view, longest_side);
  divider.divide(triangle, 0);
  return std::move(divider).parts();
}
