#include "core/io/exact_polygon.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <numeric>
#include <optional>
#include <utility>

#include "core/kernel/predicates.h"
#include "core/mesh/polygon_sweep.h"

namespace strata::io {
namespace {

/// The corners of a face as points, projected along an axis such that the first loop is counter-clockwise.
class CornerPoints {
 public:
  /// Throws NoRegion when the corners are on a line or not in one plane.
  CornerPoints(std::span<const std::uint32_t> corners, const ExactVertices& vertices) {
    for (const std::uint32_t v : corners) {
      const auto found = std::lower_bound(vertices.exact.begin(), vertices.exact.end(), v,
                                          [](const ExactVertex& e, std::uint32_t w) { return e.vertex < w; });
      if (found != vertices.exact.end() && found->vertex == v)
        exact_.push_back({static_cast<std::uint32_t>(rounded_.size()), found->position});
      rounded_.push_back(vertices.rounded[v]);
    }
    input_.add(rounded_, {}, exact_);
    for (std::uint32_t i = 0; i < rounded_.size(); ++i) points_.push_back(make_point(input_, SymbolicPoint::input(i)));
    find_plane();
  }
  CornerPoints(const CornerPoints&) = delete;
  CornerPoints& operator=(const CornerPoints&) = delete;

  void mirror() { std::swap(view_.u, view_.v); }
  [[nodiscard]] Sign orientation(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
    return orient2d(input_, view_, points_[i], points_[j], points_[k]);
  }
  /// From left to right, then upwards.
  [[nodiscard]] Sign compare(std::uint32_t i, std::uint32_t j) const {
    const Sign sign = strata::compare(input_, view_.u, points_[i], points_[j]);
    return sign != Sign::zero ? sign : strata::compare(input_, view_.v, points_[i], points_[j]);
  }
  /// The sign of the area of the corners first..last - 1 as a closed polygon, every part counted with its winding
  /// number.
  [[nodiscard]] Sign area_sign(std::uint32_t first, std::uint32_t last) const {
    constexpr std::uint32_t most = 1u << 16;  // corners for which the error bounds hold
    const std::optional<Sign> filtered = last - first <= most ? bounded_area(first, last).sign() : std::nullopt;
    return filtered ? *filtered : exact_area_sign(first, last);
  }

 private:
  [[nodiscard]] Bounded bounded_area(std::uint32_t first, std::uint32_t last) const {
    Bounded area;
    const auto at = [&](std::uint32_t i, int axis) { return points_[i].at[static_cast<std::size_t>(axis)]; };
    for (std::uint32_t i = first; i < last; ++i) {
      const std::uint32_t j = i + 1 < last ? i + 1 : first;
      area = area + ((at(i, view_.u) - at(first, view_.u)) * (at(j, view_.v) - at(first, view_.v)) -
                     (at(j, view_.u) - at(first, view_.u)) * (at(i, view_.v) - at(first, view_.v)));
    }
    return area;
  }
  void find_plane() {
    const auto count = static_cast<std::uint32_t>(points_.size());
    std::uint32_t b = 1, c = 2;
    while (b < count && equal(input_, points_[0], points_[b])) ++b;
    for (c = b + 1; c < count; ++c)
      if (find_view(b, c)) break;
    if (c >= count) throw NoRegion("has no area: its corners are on one line");
    for (std::uint32_t d = b + 1; d < count; ++d)
      if (d != c && orient3d(input_, 0, b, c, d) != Sign::zero)
        throw NoRegion("has corners that are not in one plane, exactly");
  }
  /// Finds axes in which the corners 0, b and c are not collinear.
  bool find_view(std::uint32_t b, std::uint32_t c) {
    for (int axis = 2; axis >= 0; --axis) {
      view_ = {(axis + 1) % 3, (axis + 2) % 3};
      if (orientation(0, b, c) != Sign::zero) return true;
    }
    return false;
  }
  [[nodiscard]] Sign exact_area_sign(std::uint32_t first, std::uint32_t last) const {
    std::vector<std::array<Rational, 2>> p;
    for (std::uint32_t i = first; i < last; ++i) p.push_back({coordinate(i, view_.u), coordinate(i, view_.v)});
    std::vector<Rational> terms;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const auto& q = p[i + 1 < p.size() ? i + 1 : 0];
      terms.emplace_back(p[i][0] * q[1] - q[0] * p[i][1]);
    }
    // In pairs, so that most denominators stay small.
    for (std::size_t step = 1; step < terms.size(); step *= 2)
      for (std::size_t i = 0; i + step < terms.size(); i += 2 * step) terms[i] += terms[i + step];
    return sign_of(terms[0].sign());
  }
  [[nodiscard]] Rational coordinate(std::uint32_t i, int axis) const {
    const auto k = static_cast<std::size_t>(axis);
    const RationalPoint* exact = input_.exact(i);
    return exact != nullptr ? (*exact)[k] : to_rational(rounded_[i][k]);
  }

  std::vector<Vertex> rounded_;
  std::vector<ExactVertex> exact_;
  InputComplex input_;  ///< refers to the corners
  std::vector<Point> points_;
  Projection view_;
};

/// Coincident corners, identified.
struct Places {
  std::vector<std::uint32_t> of_corner;
  std::vector<std::uint32_t> corner;  ///< the first one at each position
};

Places find_places(const CornerPoints& points, std::size_t count) {
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t i, std::uint32_t j) { return points.compare(i, j) == Sign::negative; });
  Places places{std::vector<std::uint32_t>(count), {}};
  for (const std::uint32_t i : order) {
    if (places.corner.empty() || points.compare(places.corner.back(), i) != Sign::zero) places.corner.push_back(i);
    places.of_corner[i] = static_cast<std::uint32_t>(places.corner.size() - 1);
  }
  return places;
}

/// Calls `visit(first, last)` for every loop.
template <class Visit>
void for_each_loop(const LoopFace& face, const Visit& visit) {
  std::uint32_t first = 0;
  for (const std::size_t end : face.ends) {
    visit(first, static_cast<std::uint32_t>(end));
    first = static_cast<std::uint32_t>(end);
  }
}

/// The sides of all loops.
std::vector<PolygonSide> sides_of(const LoopFace& face, const Places& places) {
  std::vector<PolygonSide> sides;
  for_each_loop(face, [&](std::uint32_t first, std::uint32_t last) {
    for (std::uint32_t i = first; i < last; ++i) {
      const std::uint32_t j = i + 1 < last ? i + 1 : first;
      sides.push_back({places.of_corner[i], places.of_corner[j]});
      if (sides.back().from == sides.back().to)
        throw NoRegion("has a side without length, from vertex " + std::to_string(face.corners[i]) + " to vertex " +
                       std::to_string(face.corners[j]));
    }
  });
  return sides;
}

/// The sides without those that occur in both directions, which bound nothing. Every position must keep some.
std::vector<PolygonSide> without_keyholes(std::vector<PolygonSide> sides, std::size_t place_count) {
  const auto ends = [](const PolygonSide& s) { return std::minmax(s.from, s.to); };
  std::stable_sort(sides.begin(), sides.end(),
                   [&](const PolygonSide& a, const PolygonSide& b) { return ends(a) < ends(b); });
  std::vector<PolygonSide> kept;
  for (const PolygonSide& s : sides) {
    if (!kept.empty() && kept.back().from == s.to && kept.back().to == s.from)
      kept.pop_back();
    else
      kept.push_back(s);
  }
  std::vector<bool> used(place_count, false);
  for (const PolygonSide& s : kept) used[s.from] = true;
  if (std::find(used.begin(), used.end(), false) != used.end()) throw NoRegion("doubles back on itself");
  return kept;
}

/// Makes the first loop counter-clockwise; then all others are clockwise.
void orient(const LoopFace& face, CornerPoints& points) {
  std::size_t loop = 0;
  for_each_loop(face, [&](std::uint32_t first, std::uint32_t last) {
    const Sign sign = points.area_sign(first, last);
    if (loop == 0 && sign == Sign::zero) throw NoRegion("has a first loop that encloses no area");
    if (loop == 0 && sign == Sign::negative) points.mirror();
    if (loop > 0 && sign != Sign::negative)
      throw NoRegion("has a hole (number " + std::to_string(loop) + " of them) that is not clockwise");
    ++loop;
  });
}

std::vector<Triangle> divide(const LoopFace& face, const ExactVertices& vertices) {
  CornerPoints points(face.corners, vertices);
  orient(face, points);
  const Places places = find_places(points, face.corners.size());
  const auto orientation = [&](std::uint32_t p, std::uint32_t q, std::uint32_t r) {
    if (p == q || q == r || r == p) return Sign::zero;
    return points.orientation(places.corner[p], places.corner[q], places.corner[r]);
  };
  const auto sides = without_keyholes(sides_of(face, places), places.corner.size());
  std::vector<Triangle> triangles = PolygonSweep(sides, orientation).divide();
  for (Triangle& t : triangles)
    for (std::uint32_t& place : t) place = face.corners[places.corner[place]];
  return triangles;
}

}  // namespace

std::string divide_face(const LoopFace& face, const ExactVertices& vertices, std::vector<Triangle>& triangles) {
  try {
    const std::vector<Triangle> own = divide(face, vertices);
    triangles.insert(triangles.end(), own.begin(), own.end());
  } catch (const NoRegion& fault) {
    return fault.what();
  }
  return {};
}

}  // namespace strata::io
