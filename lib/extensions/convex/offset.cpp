#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>
#include <vector>

#include "core/exact/failure.h"
#include "core/exact/vector.h"
#include "core/kernel/rational_point.h"
#include "extensions/convex/convex_solid.h"
#include "extensions/convex/surface.h"
#include "strata/convex.h"

namespace strata::convex {
namespace {

/// The icosahedron with edges of length 2.
Mesh icosahedron() {
  const double g = (1 + std::sqrt(5.0)) / 2;
  return {{{-1, g, 0},
           {1, g, 0},
           {-1, -g, 0},
           {1, -g, 0},
           {0, -1, g},
           {0, 1, g},
           {0, -1, -g},
           {0, 1, -g},
           {g, 0, -1},
           {g, 0, 1},
           {-g, 0, -1},
           {-g, 0, 1}},
          {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
           {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
           {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
}

/// Its faces subdivided into triangles, with corners moved approximately to the unit sphere.
Mesh geodesic_sphere(int frequency) {
  const Mesh coarse = icosahedron();
  Mesh fine;
  std::map<std::array<std::pair<std::uint32_t, int>, 3>, std::uint32_t> numbers;
  for (const Triangle& t : coarse.triangles) {
    const auto corner = [&](int i, int j) {  // frequency - i - j, i and j parts of the three corners
      std::array<std::pair<std::uint32_t, int>, 3> name{{{t[0], frequency - i - j}, {t[1], i}, {t[2], j}}};
      for (auto& [vertex, weight] : name)
        if (weight == 0) vertex = 0xffff'ffff;
      std::sort(name.begin(), name.end());
      const auto [at, is_new] = numbers.emplace(name, static_cast<std::uint32_t>(fine.vertices.size()));
      if (!is_new) return at->second;
      Vertex v{};
      for (const auto& [vertex, weight] : name)
        for (std::size_t k = 0; k < 3 && weight != 0; ++k) v[k] += weight * coarse.vertices[vertex][k];
      const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
      for (double& x : v) x /= length;
      fine.vertices.push_back(v);
      return at->second;
    };
    for (int i = 0; i < frequency; ++i)
      for (int j = 0; i + j < frequency; ++j) {
        fine.triangles.push_back({corner(i, j), corner(i + 1, j), corner(i, j + 1)});
        if (i + j + 1 < frequency) fine.triangles.push_back({corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)});
      }
  }
  return fine;
}

RationalPoint position(const Mesh& mesh, std::uint32_t v) { return to_rational(mesh.vertices[v]); }

/// n and n . v of a face with corner v: its plane is at the distance n . v / |n| from the origin.
struct Support {
  Rational square_of_normal;
  Rational height;
};

Support support(const Mesh& mesh, const Triangle& t) {
  const RationalPoint a = position(mesh, t[0]), b = position(mesh, t[1]), c = position(mesh, t[2]);
  const RationalPoint u{b[0] - a[0], b[1] - a[1], b[2] - a[2]}, v{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
  const RationalPoint n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  return {dot(n, n), dot(n, a)};
}

bool contains_ball(const Mesh& mesh, double radius) {
  const Rational r = to_rational(radius);
  return std::all_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const Triangle& t) {
    const Support s = support(mesh, t);
    return s.height > 0 && s.height * s.height >= r * r * s.square_of_normal;
  });
}

/// The least distance of a plane of the sphere's faces from the origin, approximately.
double inner_radius(const Mesh& sphere) {
  double least = 1;
  for (const Triangle& t : sphere.triangles) {
    const Support s = support(sphere, t);
    least = std::min(least, to_nearest_double(s.height) / std::sqrt(to_nearest_double(s.square_of_normal)));
  }
  return least;
}

/// The smallest double found for which all vertices are proven to be within (1 + it) * radius.
double proven_excess(const Mesh& mesh, double radius) {
  const Rational r = to_rational(radius);
  Rational furthest = 0;
  for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
    const RationalPoint p = position(mesh, v);
    furthest = std::max(furthest, dot(p, p));
  }
  const Rational square = furthest / (r * r);
  double excess = std::max(0.0, std::sqrt(to_nearest_double(square)) - 1);
  const auto suffices = [&] {
    const Rational whole = 1 + to_rational(excess);
    return whole * whole >= square;
  };
  for (double step = 0x1p-52; !suffices(); step *= 2) excess += step;
  return excess;
}

}  // namespace

Ball ball(double radius, std::uint32_t facets) {
  if (!(radius >= 0x1p-900) || !std::isfinite(radius))
    throw std::invalid_argument("the radius of a ball is a finite number of at least 2^-900");
  if (radius > 0x1p1000) throw std::overflow_error("the radius of a ball is too large");
  if (facets < 20 || facets > 500'000) throw std::invalid_argument("a ball has 20 to 500,000 facets");
  const int frequency = std::max(1, static_cast<int>(std::lround(std::sqrt(facets / 20.0))));
  const Mesh sphere = geodesic_sphere(frequency);
  const double inner = inner_radius(sphere);
  const double unit = std::ldexp(1.0, std::ilogb(radius) - 14 - 2 * std::ilogb(2.0 * frequency));
  for (double size = radius / inner;; size += unit) {
    Mesh mesh = sphere;
    for (Vertex& v : mesh.vertices)
      for (double& x : v) x = std::nearbyint(x * (size / unit)) * unit;
    if (!contains_ball(mesh, radius)) continue;
    const auto polytope = convex_solid(surface_of(ExactMesh{mesh, {}}));
    if (!polytope) throw LogicError("a ball is not convex");
    return {*polytope, proven_excess(mesh, radius)};
  }
}

Offset offset(const Solid& solid, double radius, std::uint32_t facets, const Options& options) {
  if (radius == 0) return {solid, 0};
  const Ball tool = ball(std::abs(radius), facets);
  if (radius > 0) return {minkowski_sum(solid, tool.polytope, options), tool.excess};
  return {erosion(solid, tool.polytope, options), tool.excess};
}

}  // namespace strata::convex
