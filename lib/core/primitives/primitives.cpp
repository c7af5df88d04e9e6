#include "strata/primitives.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "core/io/triangulate.h"
#include "core/kernel/predicates.h"
#include "core/mesh/circle.h"
#include "core/primitives/stack.h"
#include "strata/check.h"

namespace strata {
namespace {

constexpr std::uint64_t most_vertices = 10'000'000;

void require(bool holds, const char* what) {
  if (!holds) throw std::invalid_argument(what);
}

void require_finite(std::initializer_list<double> numbers) {
  for (const double x : numbers) require(std::isfinite(x), "a number of a primitive is not finite");
}

void require_sides(std::uint64_t sides, std::uint64_t rings) {
  require(sides >= 3, "a circle needs at least 3 sides");
  require(sides * rings <= most_vertices, "a primitive has at most 10,000,000 vertices");
}

bool is_radius(double x) { return x == 0 || x >= least_radius; }

/// A quadrilateral as two triangles, along the diagonal from its first corner.
void add_quadrilateral(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  mesh.triangles.push_back({a, b, c});
  mesh.triangles.push_back({a, c, d});
}

}  // namespace

Solid make_box(const Vertex& lower, const Vertex& upper) {
  for (std::size_t i = 0; i < 3; ++i) {
    require_finite({lower[i], upper[i]});
    require(lower[i] < upper[i], "a box without volume");
  }
  Mesh mesh;
  for (const double z : {lower[2], upper[2]})
    for (const auto& [x, y] :
         {std::array{lower[0], lower[1]}, {upper[0], lower[1]}, {upper[0], upper[1]}, {lower[0], upper[1]}})
      mesh.vertices.push_back({x, y, z});
  add_quadrilateral(mesh, 0, 3, 2, 1);
  add_quadrilateral(mesh, 4, 5, 6, 7);
  for (std::uint32_t i = 0; i < 4; ++i) add_quadrilateral(mesh, i, (i + 1) % 4, (i + 1) % 4 + 4, i + 4);
  return Solid(std::move(mesh), InputClass::solid);
}

Solid make_tetrahedron(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& d) {
  for (const Vertex& v : {a, b, c, d}) require_finite({v[0], v[1], v[2]});
  const Sign side = orient3d(a, b, c, d);
  require(side != Sign::zero, "a tetrahedron without volume");
  Mesh mesh{{a, b, c, d}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  if (side == Sign::negative)
    for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  return Solid(std::move(mesh), InputClass::solid);
}

Solid make_cylinder(double radius, double height, std::uint32_t sides) {
  return make_cone(radius, radius, height, sides);
}

Solid make_cone(double lower_radius, double upper_radius, double height, std::uint32_t sides) {
  require_finite({lower_radius, upper_radius, height});
  require(height > 0, "a cone needs a positive height");
  require(is_radius(lower_radius) && is_radius(upper_radius), "a radius is negative or too small");
  require(lower_radius > 0 || upper_radius > 0, "a cone needs a positive radius");
  require_sides(sides, 2);
  return Solid(stack(std::array{Ring{lower_radius, 0}, Ring{upper_radius, height}}, sides), InputClass::solid);
}

Solid make_sphere(double radius, std::uint32_t sides) {
  require_finite({radius});
  require(radius >= 1e-280, "the radius of a sphere is not positive, or too small");
  const std::uint32_t steps = std::max(sides / 2, 2U);  // from pole to pole
  require_sides(sides, steps);
  std::vector<Ring> rings;
  for (std::uint32_t i = 0; i <= steps; ++i) {
    const CosineSine angle = cosine_sine(180.0 * (steps - i) / steps);  // from the upper pole
    rings.push_back({radius * angle.sine, radius * angle.cosine});
  }
  return Solid(stack(rings, sides), InputClass::solid);
}

Solid make_torus(double radius, double tube_radius, std::uint32_t sides, std::uint32_t tube_sides) {
  require_finite({radius, tube_radius});
  require(tube_radius > 0 && tube_radius < radius, "a torus needs 0 < tube radius < radius");
  require_sides(sides, tube_sides);
  require_sides(tube_sides, sides);
  Mesh mesh;
  for (std::uint32_t i = 0; i < sides; ++i) {
    const CosineSine around = cosine_sine(360.0 * i / sides);
    for (std::uint32_t j = 0; j < tube_sides; ++j) {
      const CosineSine tube = cosine_sine(360.0 * j / tube_sides);
      const double r = radius + tube_radius * tube.cosine;
      mesh.vertices.push_back({r * around.cosine, r * around.sine, tube_radius * tube.sine});
    }
  }
  const auto number = [&](std::uint32_t i, std::uint32_t j) { return (i % sides) * tube_sides + j % tube_sides; };
  for (std::uint32_t i = 0; i < sides; ++i)
    for (std::uint32_t j = 0; j < tube_sides; ++j)
      add_quadrilateral(mesh, number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1));
  require(std::isfinite(radius + tube_radius) && check(mesh).empty(), "a torus that crosses itself in doubles");
  return Solid(std::move(mesh), InputClass::solid);
}

Solid make_prism(std::span<const std::array<double, 2>> polygon, double lower, double upper) {
  require_finite({lower, upper});
  require(lower < upper, "a prism without height");
  require_sides(polygon.size(), 2);
  const auto sides = static_cast<std::uint32_t>(polygon.size());
  for (const auto& [x, y] : polygon) require_finite({x, y});
  const Sign area = area_sign(std::vector<PlanePoint>(polygon.begin(), polygon.end()));
  require(area != Sign::zero, "a polygon without area");
  Mesh mesh;
  for (const double z : {lower, upper})
    for (std::uint32_t i = 0; i < sides; ++i) {
      const auto& [x, y] = polygon[area == Sign::positive ? i : sides - 1 - i];
      mesh.vertices.push_back({x, y, z});
    }
  std::vector<Triangle> cap(sides - 2);
  (void)io::triangulate(std::span(mesh.vertices).first(sides), cap);
  for (const auto& [a, b, c] : cap) {
    mesh.triangles.push_back({a, c, b});
    mesh.triangles.push_back({a + sides, b + sides, c + sides});
  }
  for (std::uint32_t i = 0; i < sides; ++i) {
    const std::uint32_t j = (i + 1) % sides;
    add_quadrilateral(mesh, i, j, j + sides, i + sides);
  }
  std::vector<Defect> defects = check(mesh);
  if (!defects.empty()) throw InputError(std::move(defects));
  return Solid(std::move(mesh), InputClass::solid);
}

}  // namespace strata
