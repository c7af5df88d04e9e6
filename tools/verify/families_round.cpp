#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "verify/families.h"
#include "verify/json_number.h"

namespace verify {
namespace {

using strata::Mesh;
using strata::Triangle;
using strata::Vertex;

Vertex cross(const Vertex& a, const Vertex& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vertex minus(const Vertex& a, const Vertex& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

double dot(const Vertex& a, const Vertex& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vertex on_unit_sphere(const Vertex& v) {
  const double length = std::sqrt(dot(v, v));
  return {v[0] / length, v[1] / length, v[2] / length};
}

Mesh icosahedron() {
  const double g = (1 + std::sqrt(5.0)) / 2;
  Mesh mesh;
  mesh.vertices = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                   {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  mesh.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                    {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                    {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  for (Vertex& v : mesh.vertices) v = on_unit_sphere(v);
  return mesh;
}

/// Every triangle in four, the new vertices on the unit sphere.
Mesh refined(Mesh mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const auto [at, is_new] = middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(mesh.vertices.size()));
    const Vertex p = mesh.vertices[a], q = mesh.vertices[b];
    if (is_new) mesh.vertices.push_back(on_unit_sphere({p[0] + q[0], p[1] + q[1], p[2] + q[2]}));
    return at->second;
  };
  std::vector<Triangle> triangles;
  for (const auto& [a, b, c] : mesh.triangles) {
    const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    triangles.insert(triangles.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
  }
  mesh.triangles = std::move(triangles);
  return mesh;
}

/// SplitMix64 (Steele, Lea, Flood 2014) as a multiple of 2^-53 in [0, 1).
double next_unit(std::uint64_t& state) {
  std::uint64_t z = (state += 0x9e3779b97f4a7c15U);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
  return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

/// The point of the unit circle at which `turn` (0 to 1) of it is passed, nearly: quarters by the rational
/// parametrization, so that no function of a library is involved.
std::array<double, 2> on_unit_circle(double orientation) {
  const int quarter = static_cast<int>(orientation * 4);
  const double s = orientation * 4 - quarter,
               t = s * (0.8284271247461901 + s * 0.1715728752538099);  // about tan(s pi / 4)
  const double c = (1 - t * t) / (1 + t * t), d = 2 * t / (1 + t * t);
  const std::array<std::array<double, 2>, 4> places = {{{c, d}, {-d, c}, {-c, -d}, {d, -c}}};
  return places[static_cast<std::size_t>(quarter % 4)];
}

}  // namespace

Mesh make_tetrahedron(const JsonLocation& line) {
  line.expect_keys({"generate", "corners"});
  const std::vector<JsonLocation> corners = line.at("corners").items();
  if (corners.size() != 4) line.at("corners").fail_expected("four points");
  Mesh mesh;
  for (const JsonLocation& place : corners) mesh.vertices.push_back(point(place));
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  const auto& v = mesh.vertices;
  if (dot(cross(minus(v[1], v[0]), minus(v[2], v[0])), minus(v[3], v[0])) < 0)
    for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

Mesh make_octahedron(const JsonLocation& line) {
  line.expect_keys({"generate", "centre", "radius"});
  const Vertex centre = point(line.at("centre"));
  const double radius = number(line.at("radius"));
  Mesh mesh;
  for (std::size_t i = 0; i < 6; ++i) {
    Vertex v = centre;
    v[i / 2] += i % 2 == 0 ? radius : -radius;
    mesh.vertices.push_back(v);
  }
  mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  return mesh;
}

namespace {

/// GCC 12 at -O3 leaves the conversion out where it is inlined into the loop below.
double rounded_to_float(double x) {
  const volatile float nearest = static_cast<float>(x);
  return nearest;
}

}  // namespace

Mesh make_sphere(const JsonLocation& line) {
  line.expect_keys({"generate", "centre", "radius", "level", "noise", "seed", "float"});
  const Vertex centre = point(line.at("centre"));
  const double radius = number(line.at("radius"));
  const auto noise_place = line.find("noise"), seed_place = line.find("seed"), float_place = line.find("float");
  const double noise = noise_place ? number(*noise_place) : 0;
  std::uint64_t state = seed_place ? static_cast<std::uint64_t>(integer(*seed_place, 0, INT64_MAX)) : 0;
  const bool floats = float_place && float_place->value().is_boolean() && float_place->value().get<bool>();
  Mesh mesh = icosahedron();
  for (std::int64_t level = integer(line.at("level"), 0, 7); level > 0; --level) mesh = refined(std::move(mesh));
  for (Vertex& v : mesh.vertices) {
    const double r = noise == 0 ? radius : radius * (1 + noise * (next_unit(state) - 0.5));
    for (std::size_t i = 0; i < 3; ++i) {
      const double x = centre[i] + r * v[i];
      v[i] = floats ? rounded_to_float(x) : x;
    }
  }
  return mesh;
}

Mesh make_prism(const JsonLocation& line) {
  line.expect_keys({"generate", "sides", "radius", "centre", "bottom", "top"});
  const auto n = static_cast<std::uint32_t>(integer(line.at("sides"), 3, 100'000));
  const double radius = number(line.at("radius"));
  const std::vector<double> centre = numbers(line.at("centre"), 2);
  Mesh mesh;
  for (const double z : {number(line.at("bottom")), number(line.at("top"))})
    for (std::uint32_t i = 0; i < n; ++i) {
      const auto [x, y] = on_unit_circle(static_cast<double>(i) / n);
      mesh.vertices.push_back({centre[0] + radius * x, centre[1] + radius * y, z});
    }
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    mesh.triangles.insert(mesh.triangles.end(), {{i, j, n + j}, {i, n + j, n + i}});
    if (i != 0 && j != 0) mesh.triangles.insert(mesh.triangles.end(), {{0, j, i}, {n, n + i, n + j}});
  }
  return mesh;
}

}  // namespace verify
