#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <random>
#include <span>

#include "strata/combine.h"
#include "strata/measure.h"
#include "strata/solid.h"
#include "support/shapes.h"

using namespace strata;

namespace {

Solid box(const Vertex& lower, const Vertex& upper) { return Solid(test::box(lower, upper)); }
Solid unit(double x, double y, double z) { return box({x, y, z}, {x + 1, y + 1, z + 1}); }

/// What `measure` finds against `topology`, with facets and without.
void check_topology(const ExactMesh& mesh) {
  const Topology t = topology(mesh);
  for (const bool with_facets : {false, true}) {
    const Topology found = measure(mesh, {}, with_facets).topology;
    CHECK(found.components == t.components);
    CHECK(found.euler == t.euler);
    CHECK(found.non_manifold_edges == t.non_manifold_edges);
    CHECK(found.non_manifold_vertices == t.non_manifold_vertices);
    CHECK(found.open_edges == t.open_edges);
  }
}

/// `measure` against the functions of which it is made; facets against those of the canonical form.
void check_measures(const Solid& solid) {
  const ExactMesh& mesh = solid.exact_mesh();
  const Measures m = measure(mesh);
  REQUIRE(m.volume.has_value());
  CHECK(*m.volume == to_nearest_double(solid.volume()));
  CHECK(m.area == solid.area());
  CHECK(m.facets == canonical_form(mesh).facet_count());
  check_topology(mesh);
}

/// Bars along x, side by side, turned about z and then tilted about x.
Mesh comb(int bars, double turn, double tilt) {
  Mesh all;
  for (int k = 0; k < bars; ++k) {
    const double y = 2.0 * k / bars - 1, width = 1.2 / bars;
    const Mesh bar = test::box({-1, y, -0.1}, {1, y + width, 0.1});
    const auto first = static_cast<std::uint32_t>(all.vertices.size());
    for (const Vertex& v : bar.vertices) {
      const Vertex t{v[0] * std::cos(turn) - v[1] * std::sin(turn), v[0] * std::sin(turn) + v[1] * std::cos(turn),
                     v[2]};
      all.vertices.push_back({t[0], t[1] - tilt * t[2], t[2] + tilt * t[1]});
    }
    for (const Triangle& t : bar.triangles) all.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  return all;
}

/// What `combine` tells of a result against `measure` of its exact mesh. Returns how many vertices are rational.
std::size_t check_measured(Operation operation, std::span<const Operand> operands) {
  const BooleanResult exact = combine(operation, operands, {.input = InputClass::solid, .exact_vertices = true});
  const ExactMesh mesh{exact.mesh, exact.exact};
  const Measures expected = measure(mesh);
  CHECK(expected.facets == canonical_form(mesh).facet_count());
  for (const bool is_rounded : {false, true}) {
    Options options{.input = InputClass::solid, .measure = true};
    if (is_rounded) options.rounding = CoordinateGrid{CoordinateGrid::Format::float32};
    const BooleanResult result = combine(operation, operands, options);
    CHECK(result.exact.empty());
    REQUIRE(result.measured.has_value());
    CHECK(result.measured->vertices == mesh.mesh.vertices.size());
    CHECK(result.measured->triangles == mesh.mesh.triangles.size());
    const Measures& m = result.measured->measures;
    CHECK(m.volume == expected.volume);
    CHECK(m.exact_volume == expected.exact_volume);
    CHECK(m.area == Approx(expected.area).epsilon(1e-15));
    CHECK(m.facets == expected.facets);
    CHECK(m.topology.components == expected.topology.components);
    CHECK(m.topology.euler == expected.topology.euler);
    CHECK(m.topology.non_manifold_edges == expected.topology.non_manifold_edges);
    CHECK(m.topology.non_manifold_vertices == expected.topology.non_manifold_vertices);
    CHECK(m.topology.open_edges == 0);
  }
  return mesh.exact.size();
}

}  // namespace

TEST_CASE("the topology of starlike meshes, and of some that nearly are", "[csg][measure]") {
  const std::vector<std::array<double, 2>> star = {{4, 0},  {1, 1},   {0, 4},  {-1, 1},
                                                   {-4, 0}, {-1, -1}, {0, -4}, {1, -1}};
  for (const Mesh& mesh :
       {test::box({0, 0, 0}, {3, 2, 1}), test::octahedron({1, 2, 3}, 5), test::icosphere({0, 0, 0}, 1, 4),
        test::prism(star, -2, 2), test::pyramid(star, 0, {0, 0, 3}), test::cube_grid(9), test::l_shape(),
        test::box_with_hole(), test::box_with_cavity(2), test::edge_sharing_cells(), test::vertex_sharing_cells()}) {
    check_topology({mesh, {}});
    Mesh more = mesh;
    more.vertices.push_back({0, 0, 0});  // not used
    check_topology({more, {}});
    Mesh open = mesh;
    open.triangles.pop_back();
    check_topology({open, {}});
    Mesh doubled = mesh;  // every face twice
    doubled.triangles.insert(doubled.triangles.end(), mesh.triangles.begin(), mesh.triangles.end());
    check_topology({doubled, {}});
  }
}

TEST_CASE("facets are joined over edges, not over vertices", "[csg]") {
  CHECK(measure(unit(0, 0, 0).exact_mesh()).facets == 6);
  // In one plane, with a vertex in common: two facets.
  CHECK(measure((unit(0, 0, 0) | unit(1, 1, 0)).exact_mesh()).facets == 12);
  // A tetrahedron stands with an edge on top of a box: the top is one facet, over an edge of four triangles.
  const Solid standing(test::tetrahedron({1, 1, 1}, {2, 1, 1}, {1.5, 1.5, 2}, {1.5, 0.5, 2}));
  const Solid both = box({0, 0, 0}, {3, 2, 1}) | standing;
  CHECK(measure(both.exact_mesh()).topology.non_manifold_edges > 0);
  check_measures(both);
  // A hole that touches the rim of its facet in a vertex, and one that divides it.
  check_measures(box({0, 0, 0}, {4, 4, 1}) -
                 Solid(test::prism(std::array<std::array<double, 2>, 3>{{{0, 0}, {2, 1}, {1, 2}}}, -1, 2)));
  check_measures(box({0, 0, 0}, {4, 4, 1}) -
                 Solid(test::prism(std::array<std::array<double, 2>, 4>{{{0, 0}, {3, 1}, {4, 4}, {1, 3}}}, -1, 2)));
}

TEST_CASE("a mesh that is not closed has no volume", "[csg]") {
  Mesh mesh = test::box({0, 0, 0}, {1, 1, 1});
  mesh.triangles.pop_back();
  const Measures m = measure({mesh, {}});
  CHECK_FALSE(m.volume.has_value());
  CHECK(m.topology.open_edges == 3);
  CHECK(measure({}).facets == 0);
  CHECK(measure({}).volume == 0.0);
}

TEST_CASE("measures of random sets of boxes agree with the canonical form", "[csg][property]") {
  for (unsigned seed = 0; seed < 60; ++seed) {
    std::mt19937 random(seed);
    std::uniform_int_distribution<int> at(0, 4), size(1, 3);
    Solid solid;
    for (int k = 0; k < 7; ++k) {
      const Vertex lower{double(at(random)), double(at(random)), double(at(random))};
      const Vertex upper{lower[0] + size(random), lower[1] + size(random), lower[2] + size(random)};
      const Transform turn = seed % 3 == 0
                                 ? Transform()
                                 : Transform({{{1, Rational(1, 3), 0, 0}, {0, 1, Rational(1, 7), 0}, {0, 0, 1, 0}}});
      const Solid next = box(lower, upper).transformed(turn);
      solid = k % 3 == 2 ? solid - next : k % 3 == 1 ? solid ^ next : solid | next;
    }
    check_measures(solid);
  }
}

namespace {

/// A plate whose upper side is a grid of cells, at these heights; its other sides are flat.
ExactMesh plate(int cells, const std::function<Rational(int, int)>& height) {
  ExactMesh mesh;
  const int side = cells + 1;
  for (const bool is_upper : {false, true})
    for (int j = 0; j < side; ++j)
      for (int i = 0; i < side; ++i) {
        const Rational z = is_upper ? height(i, j) : Rational(-1);
        const Vertex nearest{double(i), double(j), to_nearest_double(z)};
        if (to_rational(nearest[2]) != z)
          mesh.exact.push_back({static_cast<std::uint32_t>(mesh.mesh.vertices.size()), {Rational(i), Rational(j), z}});
        mesh.mesh.vertices.push_back(nearest);
      }
  const auto at = [&](int i, int j, bool is_upper) {
    return static_cast<std::uint32_t>((is_upper ? side * side : 0) + j * side + i);
  };
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    mesh.mesh.triangles.insert(mesh.mesh.triangles.end(), {{a, b, c}, {a, c, d}});
  };
  for (int j = 0; j < cells; ++j)
    for (int i = 0; i < cells; ++i) {
      add(at(i, j, true), at(i + 1, j, true), at(i + 1, j + 1, true), at(i, j + 1, true));
      add(at(i, j, false), at(i, j + 1, false), at(i + 1, j + 1, false), at(i + 1, j, false));
    }
  for (int i = 0; i < cells; ++i) {
    add(at(i, 0, false), at(i + 1, 0, false), at(i + 1, 0, true), at(i, 0, true));
    add(at(i + 1, cells, false), at(i, cells, false), at(i, cells, true), at(i + 1, cells, true));
    add(at(0, i + 1, false), at(0, i, false), at(0, i, true), at(0, i + 1, true));
    add(at(cells, i, false), at(cells, i + 1, false), at(cells, i + 1, true), at(cells, i, true));
  }
  return mesh;
}

}  // namespace

TEST_CASE("facets of planes that doubles do not hold, and of bends that they hardly tell", "[csg]") {
  CHECK(measure(plate(6, [](int i, int j) { return Rational(i, 3) + Rational(j, 7); })).facets == 6);
  CHECK(measure(plate(6, [](int i, int j) { return Rational(i, 3) * i + Rational(j, 7); })).facets == 11);
  for (unsigned seed = 0; seed < 40; ++seed) {
    std::mt19937 random(seed);
    std::uniform_int_distribution<int> kind(0, 7), exponent(20, 1100);
    const ExactMesh mesh = plate(5, [&](int i, int j) {
      const int k = i % 5 == 0 || j % 5 == 0 ? 0 : kind(random);
      const Rational bend = Rational(1) / (Rational(Integer(1) << (seed % 2 == 0 ? 52 : exponent(random))));
      return Rational(i, 3) - Rational(j, 5) + (k < 5 ? Rational(0) : k == 5 ? bend : Rational(bend / (k - 9)));
    });
    CHECK(measure(mesh).facets == canonical_form(mesh).facet_count());
  }
}

TEST_CASE("measures are the same for any number of threads", "[csg]") {
  const Solid solid(test::icosphere({0, 0, 0}, 1, 5));
  Options one;
  one.threads = 1;
  const Measures a = measure(solid.exact_mesh(), one), b = measure(solid.exact_mesh());
  CHECK(a.area == b.area);
  CHECK(a.volume == b.volume);
  CHECK(a.facets == b.facets);
  CHECK(a.area == Approx(12.566370614).epsilon(0.01));
}

TEST_CASE("results are measured without their exact vertices", "[csg]") {
  const Mesh flat = comb(13, 0, 0);
  std::size_t most_rational = 0;
  for (const auto& [turn, tilt] :
       {std::pair(1.0, 0.01), {1.0, 0.0}, {1.5, 1e-12}, {1e-9, 0.0}, {std::acos(0.0), 0.0}, {0.0, 0.0}}) {
    CAPTURE(turn, tilt);
    const Mesh turned = comb(13, turn, tilt);
    const Operand operands[] = {{flat, {}}, {turned, {}}};
    for (const Operation operation : all_operations)
      most_rational = std::max(most_rational, check_measured(operation, operands));
  }
  CHECK(most_rational > 2000);  // of few, fractions are computed
}

TEST_CASE("results of results are measured without their exact vertices", "[csg]") {
  const Solid crossed = Solid(comb(9, 0.3, 0)) - Solid(comb(9, 1.7, 0.2));
  const Mesh tool = comb(9, 1.1, 0.1);
  const Operand operands[] = {{crossed.exact_mesh().mesh, crossed.exact_mesh().exact}, {tool, {}}};
  for (const Operation operation : all_operations) CHECK(check_measured(operation, operands) > 1000);
}

TEST_CASE("solids thinner than their place is precise are measured", "[csg]") {
  // Far from the origin, sums of two doubles do not decide about the volume.
  Mesh near = comb(13, 0.7, 0), far = comb(13, 1.9, 0);
  for (Mesh* m : {&near, &far})
    for (Vertex& v : m->vertices) v = {v[0] + 1e6, v[1] - 1e6, std::ldexp(v[2], -90)};
  const Operand operands[] = {{near, {}}, {far, {}}};
  CHECK(check_measured(Operation::intersection, operands) > 1000);
}
