#include "support/touching.h"

#include <algorithm>
#include <array>

#include "support/shapes.h"
#include "support/transform.h"

namespace strata::test {
namespace {

double half_lattice(Random& random, int highest) { return random.between(0, 2 * highest) * 0.5; }

Mesh lattice_box(Random& random) {
  const bool halves = random.once_in(3);
  Vertex lower{};
  Vertex upper{};
  for (int k = 0; k < 3; ++k) {
    do {
      lower[k] = halves ? half_lattice(random, 4) : random.between(0, 4);
      upper[k] = halves ? half_lattice(random, 4) : random.between(0, 4);
    } while (lower[k] == upper[k]);
    if (lower[k] > upper[k]) std::swap(lower[k], upper[k]);
  }
  return box(lower, upper);
}

Mesh lattice_hull(Random& random, int most_points) {
  const int highest = random.between(1, 4);
  Mesh hull;
  while (hull.triangles.empty()) {
    std::vector<Vertex> points(random.between(4, most_points));
    for (Vertex& p : points) {
      for (double& x : p) x = random.between(0, highest);
    }
    hull = convex_hull(points);
  }
  return hull;
}

Mesh random_cells(Random& random) {
  CellGrid grid(random.between(1, 3), random.between(1, 2), random.between(1, 2), false);
  for (std::size_t i = 0; i < grid.filled.size(); ++i) grid.filled[i] = !random.once_in(2);
  grid.filled[random.below(grid.filled.size())] = true;
  return cell_solid(grid);
}

Mesh separate_parts(Random& random) {
  const Mesh parts[] = {lattice_hull(random, 6),
                        translated(lattice_hull(random, 6), {5, 0, random.between(-2, 2) * 1.0})};
  return merged(parts);
}

Mesh fixed_shape(Random& random) {
  static constexpr std::array<std::array<double, 2>, 5> pentagon{{{0, 1}, {1, 0}, {3, 0}, {4, 2}, {1, 3}}};
  switch (random.below(8)) {
    case 0:
      return octahedron({2, 2, 2}, random.between(1, 2));
    case 1:
      return box_with_hole();
    case 2:
      return l_shape();
    case 3:
      return edge_sharing_cells();
    case 4:
      return vertex_sharing_cells();
    case 5:
      return box_with_cavity(random.between(1, 3));
    case 6:
      return prism(pentagon, 0, random.between(1, 3));
    default:
      return pyramid(pentagon, 0, {random.between(0, 4) * 1.0, random.between(0, 4) * 1.0, 2});
  }
}

Vertex middle(const Vertex& a, const Vertex& b) {
  return {a[0] / 2 + b[0] / 2, a[1] / 2 + b[1] / 2, a[2] / 2 + b[2] / 2};
}

Vertex difference(const Vertex& a, const Vertex& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

/// A vertex, the middle of an edge, or a point inside a face.
Vertex feature_point(Random& random, const Mesh& mesh) {
  const auto& [a, b, c] = random.pick(mesh.triangles);
  const Vertex& p = mesh.vertices[a];
  const Vertex q = middle(mesh.vertices[b], mesh.vertices[c]);
  switch (random.below(3)) {
    case 0:
      return p;
    case 1:
      return q;
    default:
      return middle(p, q);
  }
}

/// The second solid moved so that a feature of it lies on a feature of the first.
Mesh placed_on(Random& random, const Mesh& fixed, const Mesh& moving) {
  return translated(moving, difference(feature_point(random, fixed), feature_point(random, moving)));
}

/// A convex solid over points of one face of `mesh`, in part its corners; the apex is on either side.
Mesh solid_on_face(Random& random, const Mesh& mesh) {
  Mesh result;
  while (result.triangles.empty()) {
    const auto& [a, b, c] = random.pick(mesh.triangles);
    const std::array<Vertex, 3> corner{mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
    std::vector<Vertex> points;
    for (std::size_t i = 0; i < 3; ++i) {
      points.push_back(random.once_in(3) ? middle(corner[i], corner[(i + 1) % 3]) : corner[i]);
    }
    Vertex apex{};
    for (double& x : apex) x = half_lattice(random, 4);
    points.push_back(apex);
    if (random.once_in(3)) points.push_back(feature_point(random, mesh));
    result = convex_hull(points);
  }
  return result;
}

/// The hull of features of `mesh`: inside it when it is convex, touching it from inside.
Mesh hull_of_features(Random& random, const Mesh& mesh) {
  Mesh result;
  while (result.triangles.empty()) {
    std::vector<Vertex> points;
    for (int i = random.between(4, 7); i > 0; --i) points.push_back(feature_point(random, mesh));
    result = convex_hull(points);
  }
  return result;
}

Mesh shifted_copy(Random& random, const Mesh& mesh) {
  Vertex by{};
  for (double& x : by) x = random.between(-2, 2) * 0.5;
  return translated(mesh, by);
}

/// Coordinates that are no nice numbers, with all contacts through equal vertices or copies of planes.
Operands awkward_pair(Random& random) {
  const Vertex centre{random.unit(), random.unit(), random.unit()};
  const Mesh ball = icosphere(centre, 1 + random.unit(), 0);
  switch (random.below(4)) {
    case 0:
      return {"icosahedron, hull of its vertices", {ball, [&] {
                                                      Mesh hull;
                                                      while (hull.triangles.empty()) {
                                                        std::vector<Vertex> points;
                                                        for (int i = 0; i < 6; ++i)
                                                          points.push_back(random.pick(ball.vertices));
                                                        hull = convex_hull(points);
                                                      }
                                                      return hull;
                                                    }()}};
    case 1:
      return {"icosahedron, turned copy", {ball, turned(ball, random.between(1, 47))}};
    case 2:
      return {"icosahedron, ball inside the vertices", {ball, icosphere(centre, 1, 1)}};
    default: {
      const Mesh a = box(centre, {centre[0] + random.unit(), centre[1] + 1, centre[2] + random.unit()});
      const Vertex& corner = a.vertices[random.below(a.vertices.size())];
      return {"boxes with a common corner",
              {a, box(difference(corner, {0.5, 0.25, 0.3}), {corner[0] + 0.1, corner[1], corner[2] + 0.7})}};
    }
  }
}

Operands unscaled_pair(Random& random) {
  const Mesh a = turned(lattice_solid(random), random.between(0, 47));
  switch (random.below(9)) {
    case 0:
      return {"same lattice", {a, lattice_solid(random)}};
    case 1:
      return {"shifted copy", {a, shifted_copy(random, a)}};
    case 2:
      return {"turned copy", {a, shifted_copy(random, turned(a, random.between(0, 47)))}};
    case 3:
      return {"identical", {a, relisted(a)}};
    case 4:
    case 5:
      return {"feature on feature", {a, placed_on(random, a, turned(lattice_solid(random), random.between(0, 47)))}};
    case 6:
      return {"solid on a face", {a, solid_on_face(random, a)}};
    case 7:
      return {"hull of features", {a, hull_of_features(random, a)}};
    default:
      return awkward_pair(random);
  }
}

}  // namespace

Mesh lattice_solid(Random& random) {
  switch (random.below(8)) {
    case 0:
      return lattice_box(random);
    case 1:
    case 2:
      return lattice_hull(random, 8);
    case 3:
      return kuhn_solid(random, {1, 1, 1}, 2);
    case 4:
      return kuhn_solid(random, {2, 1, random.between(1, 2)}, 3);
    case 5:
      return random_cells(random);
    case 6:
      return random.once_in(2) ? separate_parts(random) : lattice_hull(random, 5);
    default:
      return fixed_shape(random);
  }
}

Operands touching_pair(std::uint64_t seed) {
  Random random(seed);
  Operands operands = unscaled_pair(random);
  if (random.once_in(2)) std::swap(operands.meshes[0], operands.meshes[1]);
  stretch(random, operands);
  return operands;
}

Operands touching_operands(std::uint64_t seed) {
  Random random(~seed);
  Operands operands;
  const bool one_point = random.once_in(2);
  operands.kind = one_point ? "through one point" : "same lattice";
  for (int i = random.between(3, 5); i > 0; --i) {
    Mesh mesh = random.once_in(2) ? lattice_hull(random, 6) : lattice_solid(random);
    if (one_point) mesh = translated(mesh, difference({2, 2, 2}, feature_point(random, mesh)));
    operands.meshes.push_back(std::move(mesh));
  }
  if (random.once_in(6)) operands.meshes.push_back(operands.meshes[random.below(operands.meshes.size())]);
  stretch(random, operands);
  return operands;
}

// Two corners lie on one side of the line in the plane of the face, the third on the other, or on the line.
Operands about_a_line(Random& random) {
  Operands operands{"about a line", {}};
  const auto vector = [&] {
    return Vertex{static_cast<double>(random.between(-2, 2)), static_cast<double>(random.between(-2, 2)),
                  static_cast<double>(random.between(-2, 2))};
  };
  const auto at = [](const Vertex& along, double s, const Vertex& aside, double t) {
    return Vertex{s * along[0] + t * aside[0], s * along[1] + t * aside[1], s * along[2] + t * aside[2]};
  };
  const Vertex line = [&] {
    for (;;)
      if (const Vertex v = vector(); v != Vertex{}) return v;
  }();
  const std::size_t count = 3 + random.below(4);
  while (operands.meshes.size() < count) {
    const Vertex aside = vector();
    const double beyond = random.once_in(4) ? 0 : -random.between(1, 2);
    const std::array<Vertex, 4> corners = {
        at(line, random.between(-2, 2), aside, random.between(1, 2)),
        at(line, random.between(-2, 2), aside, beyond == 0 ? 0 : random.between(1, 2)),
        at(line, random.between(-2, 2), aside, beyond), vector()};
    Mesh tetrahedron = convex_hull(corners);
    if (!tetrahedron.triangles.empty()) operands.meshes.push_back(std::move(tetrahedron));
  }
  stretch(random, operands);
  return operands;
}

void stretch(Random& random, Operands& operands) {
  if (!random.once_in(4)) return;
  std::array<int, 3> exponents{};
  if (random.once_in(2)) {
    exponents[random.below(3)] = random.between(-40, 40);
    operands.kind += ", slivers";
  } else {
    exponents.fill(random.once_in(2) ? random.between(-300, -100) : random.between(100, 300));
    operands.kind += ", scaled";
  }
  for (Mesh& mesh : operands.meshes) mesh = scaled(std::move(mesh), exponents);
}

}  // namespace strata::test
