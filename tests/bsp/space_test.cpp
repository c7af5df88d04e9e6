#include <catch2/catch.hpp>
#include <cmath>

#include "extensions/bsp/partition_data.h"
#include "strata/measure.h"
#include "support/random.h"
#include "support/rounds.h"
#include "support/shapes.h"
#include "support/touching.h"
#include "support/transform.h"

namespace strata::bsp {
namespace {

using test::Random;

Partition<3> region(const Mesh& mesh) { return partition_of(ExactMesh{mesh, {}}); }
Partition<3> unit_cube() { return region(test::box({0, 0, 0}, {1, 1, 1})); }

/// x >= 0, with random normals of small integers and through points of a small lattice otherwise.
Partition<3> random_half_space(Random& random) {
  std::array<Integer, 4> form{};
  while (form[0] == 0 && form[1] == 0 && form[2] == 0)
    for (Integer& x : form) x = random.between(-2, 2);
  return behind(oriented_hyperplane<3>(form));
}

/// Touching solids and half-spaces, one seldom turned inside out.
Partition<3> random_region(Random& random) {
  if (random.once_in(3)) return random_half_space(random);
  const Partition<3> r = region(test::lattice_solid(random));
  return random.once_in(4) ? complement(r) : r;
}

/// Every node divides its part of space, children are not the same leaf, no node is reached twice, and next to a leaf
/// there is boundary on the cut.
void check_invariants(const Partition<3>& r) {
  const Tree& tree = tree_of(r);
  std::vector<int> reached(tree.nodes.size());
  Path path;
  const auto visit = [&](const auto& self, Link link) -> void {
    if (is_leaf(link)) return;
    const Node& node = tree.nodes[link];
    CHECK(++reached[link] == 1);
    CHECK_FALSE((node.minus == node.plus && is_leaf(node.minus)));
    CHECK_NOTHROW(part_within(table_of(r), node.hyperplane, path));
    std::size_t facets = 0;
    for_each_facet<3>(table_of(r), tree, link, path, [&](const Facet<3>&) { ++facets; });
    CHECK((facets > 0 || !(is_leaf(node.minus) || is_leaf(node.plus))));
    path.push_back({node.hyperplane, Sign::negative});
    self(self, node.minus);
    path.back().side = Sign::positive;
    self(self, node.plus);
    path.pop_back();
  };
  visit(visit, tree.root);
}

}  // namespace

TEST_CASE("a cube is six nodes, and points are where they are", "[bsp]") {
  const Partition<3> cube = unit_cube();
  CHECK(tree_of(cube).nodes.size() == 6);
  CHECK(cube.classify({0.5, 0.5, 0.5}) == Where::in);
  CHECK(cube.classify({0.5, 0.5, 1}) == Where::on);
  CHECK(cube.classify({1, 1, 1}) == Where::on);
  CHECK(cube.classify({1, 1, std::nextafter(1, 2)}) == Where::out);
  CHECK(cube.classify_exact(RationalVector<3>{Rational(1, 3), Rational(1, 3), Rational(1, 3)}) == Where::in);
  CHECK(size(cube) == Rational(1));
  CHECK(barycentre(cube) == RationalVector<3>{Rational(1, 2), Rational(1, 2), Rational(1, 2)});
  CHECK(boundary_size(cube) == 6);
  CHECK(cube.is_bounded());
  CHECK_FALSE(complement(cube).is_bounded());
}

TEST_CASE("empty and full space", "[bsp]") {
  const Partition<3> nothing, all = Partition<3>::all();
  CHECK(nothing.is_empty());
  CHECK(all.is_full());
  CHECK(nothing.is_bounded());
  CHECK_FALSE(all.is_bounded());
  CHECK(size(nothing) == Rational(0));
  CHECK_FALSE(size(all).has_value());
  CHECK_FALSE(barycentre(nothing).has_value());
  CHECK(boundary_size(all) == 0);
  CHECK(complement(all).is_empty());
  CHECK((unit_cube() | complement(unit_cube())).is_full());
  CHECK((unit_cube() & complement(unit_cube())).is_empty());
  CHECK(all.classify({1, 2, 3}) == Where::in);
  CHECK(exact_mesh_of(nothing).mesh.triangles.empty());
  CHECK(partition_of(ExactMesh{}).is_empty());
}

TEST_CASE("meshes become trees and come back as the same solids, cavities and touching parts included", "[bsp]") {
  for (const Mesh& mesh :
       {test::box_with_cavity(1), test::box_with_hole(), test::edge_sharing_cells(), test::vertex_sharing_cells(),
        test::octahedron({2, 2, 2}, 1), test::icosphere({0.1, 0.2, 0.3}, 1, 2), test::l_shape()}) {
    const Partition<3> r = region(mesh);
    check_invariants(r);
    CHECK(canonical_form_of(r) == canonical_form(ExactMesh{mesh, {}}));
    const ExactMesh back = exact_mesh_of(r);
    CHECK(canonical_form(back) == canonical_form(ExactMesh{mesh, {}}));
    CHECK(topology(back).open_edges == 0);
    CHECK(size(r) == volume(ExactMesh{mesh, {}}));
    CHECK(boundary_size(r) == Approx(area(ExactMesh{mesh, {}})));
    CHECK(rebuilt(r) == r);
  }
}

TEST_CASE("planes of coordinates of any width are exact", "[bsp][property]") {
  for (const int spread : {0, 28, 29, 30, 31, 40, 60, 100, 300})
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
      CAPTURE(spread, seed);
      Random random(seed);
      Mesh mesh{{}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
      mesh.vertices.resize(4);
      for (Vertex& v : mesh.vertices)
        for (double& x : v) x = std::ldexp(random.unit() - 0.5, random.between(0, spread));
      const Rational size_of_mesh = volume(ExactMesh{mesh, {}});
      if (size_of_mesh == 0) continue;
      CHECK(size(region(mesh)) == (size_of_mesh > 0 ? std::optional(size_of_mesh) : std::nullopt));
      if (size_of_mesh > 0) CHECK(canonical_form_of(region(mesh)) == canonical_form(ExactMesh{mesh, {}}));
    }
}

TEST_CASE("what is behind many half-spaces is not a deep tree, and points are where the planes say",
          "[bsp][property]") {
  Random random(7);
  std::vector<OrientedHyperplane<3>> planes;
  const auto coordinate = [&] { return std::ldexp(std::floor(std::ldexp(2 * random.unit() - 1, 10)), -10); };
  while (planes.size() < 600) {
    const std::array<double, 3> n{coordinate(), coordinate(), coordinate()};
    const double length = std::hypot(n[0], n[1], n[2]);
    if (length < 0.1) continue;
    const double c = -std::ceil(1024 * length) / 1024;  // nearly at distance 1
    planes.push_back(oriented_hyperplane<3>(
        std::array<Rational, 4>{to_rational(n[0]), to_rational(n[1]), to_rational(n[2]), to_rational(c)}));
  }
  const Partition<3> ball = behind_all<3>(planes);
  check_invariants(ball);
  CHECK(size_of_tree(ball).depth < 120);
  CHECK(to_nearest_double(size(ball).value()) == Approx(4.19).epsilon(0.03));
  for (int k = 0; k < 1000; ++k) {
    const std::array<double, 3> p{coordinate(), coordinate(), coordinate()};
    bool is_behind = true, is_on = false;
    for (const OrientedHyperplane<3>& plane : planes) {
      Rational value = plane.hyperplane.exact()[3];
      for (std::size_t i = 0; i < 3; ++i) value += plane.hyperplane.exact()[i] * to_rational(p[i]);
      if (plane.is_reversed) value = -value;
      is_behind &= value <= 0;
      is_on |= value == 0;
    }
    CHECK(ball.classify(p) == (!is_behind ? Where::out : is_on ? Where::on : Where::in));
  }
}

TEST_CASE("a mesh turned inside out bounds all but the solid", "[bsp]") {
  const Mesh box = test::box({0, 0, 0}, {1, 2, 3});
  Mesh turned = box;
  for (Triangle& t : turned.triangles) std::swap(t[0], t[1]);
  CHECK(region(turned) == complement(region(box)));
}

TEST_CASE("laws of sets hold for regions that touch, bounded or not", "[bsp][property]") {
  for (std::uint64_t seed = 0; seed < test::rounds(300); ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Partition<3> a = random_region(random), b = random_region(random), c = random_region(random);
    const Partition<3> both = a & b, any = a | b, odd = a ^ b, rest = a - b;
    for (const Partition<3>& r : {both, any, odd, rest}) check_invariants(r);
    CHECK(complement(any) == (complement(a) & complement(b)));
    CHECK(complement(both) == (complement(a) | complement(b)));
    CHECK(complement(complement(a)) == a);
    CHECK((a ^ a).is_empty());
    CHECK(rest == (a & complement(b)));
    CHECK(odd == (rest | (b - a)));
    CHECK((a & (b | c)) == (both | (a & c)));
    CHECK(((a | b) | c) == (a | (b | c)));
    CHECK(any.contains(a));
    CHECK(any.contains(both));
    CHECK(a.contains(rest));
    CHECK(rebuilt(odd) == odd);
    const auto volume_of = [](const Partition<3>& r) { return size(r); };
    if (a.is_bounded() && b.is_bounded()) CHECK(*volume_of(a) + *volume_of(b) == *volume_of(any) + *volume_of(both));
  }
}

TEST_CASE("points are in combinations as they are in operands", "[bsp][property]") {
  for (std::uint64_t seed = 0; seed < test::rounds(200); ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Partition<3> a = random_region(random), b = random_region(random);
    const Partition<3> both = a & b, any = a | b;
    for (int k = 0; k < 50; ++k) {
      std::array<double, 3> p{};
      for (double& x : p) x = random.between(-2, 10) * 0.5;
      const Where in_a = a.classify(p), in_b = b.classify(p);
      CHECK(any.classify(p) >= std::max(in_a, in_b));  // two boundaries may make an inside
      CHECK(both.classify(p) <= std::min(in_a, in_b));
      if (in_a == Where::on || in_b == Where::on) continue;
      CHECK(any.classify(p) == std::max(in_a, in_b));
      CHECK(both.classify(p) == std::min(in_a, in_b));
    }
  }
}

TEST_CASE("a half-space without a cube is unbounded and has a hole", "[bsp]") {
  const auto half = behind<3>({axis_hyperplane<3>(2, 3), false});  // z <= 3
  const Partition<3> rest = half - unit_cube();
  CHECK_FALSE(size(rest).has_value());
  CHECK(std::isinf(boundary_size(rest)));
  CHECK_THROWS_AS(exact_mesh_of(rest), std::domain_error);
  CHECK(rest.classify({0.5, 0.5, 0.5}) == Where::out);
  CHECK(rest.classify({0, 0, 0}) == Where::on);
  CHECK(rest.classify({1e300, -1e300, 3}) == Where::on);
  CHECK(rest.classify({1e300, -1e300, -1e300}) == Where::in);
  CHECK((half - rest) == unit_cube());
  CHECK(size(half - rest) == Rational(1));
}

TEST_CASE("wedges that meet very far away meet", "[bsp]") {
  // z <= 0 and z >= x / 2^200 - 1 overlap for x < 2^200 only.
  const Integer steep = Integer(1) << 200;
  const auto below = behind<3>({axis_hyperplane<3>(2, 0), false});
  const auto wedge = below & behind(oriented_hyperplane<3>(std::array<Integer, 4>{1, 0, -steep, -steep}));
  CHECK_FALSE(wedge.is_empty());
  const auto beyond = behind<3>({axis_hyperplane<3>(0, Rational(steep)), true});
  CHECK((wedge & beyond).is_empty());
  CHECK_FALSE((wedge & behind<3>({axis_hyperplane<3>(0, Rational(steep - 1)), true})).is_empty());
}

TEST_CASE("half-spaces make a tetrahedron with its volume, or nothing", "[bsp]") {
  const std::array<RationalVector<3>, 4> v{{{1, 2, 3}, {2, 2, 4}, {2, 3, 3}, {1, 3, 4}}};
  const std::array planes{plane_through(v[0], v[2], v[1]), plane_through(v[0], v[3], v[2]),
                          plane_through(v[0], v[1], v[3]), plane_through(v[1], v[2], v[3])};
  Partition<3> tetrahedron = behind_all<3>(planes);
  if (tetrahedron.is_empty() || !tetrahedron.is_bounded()) {  // the vertices are the other way round
    std::vector<OrientedHyperplane<3>> turned(planes.begin(), planes.end());
    for (auto& p : turned) p.is_reversed = !p.is_reversed;
    tetrahedron = behind_all<3>(turned);
  }
  CHECK(size(tetrahedron) == Rational(1, 3));
  CHECK(barycentre(tetrahedron) == RationalVector<3>{Rational(3, 2), Rational(5, 2), Rational(7, 2)});
  CHECK(boundary_size(tetrahedron) == Approx(2 * std::sqrt(3)));
  for (const auto& p : v) CHECK(tetrahedron.classify_exact(p) == Where::on);
  const std::array opposite{OrientedHyperplane<3>{axis_hyperplane<3>(0, 0), false},
                            OrientedHyperplane<3>{axis_hyperplane<3>(0, 1), true}};
  CHECK(behind_all<3>(opposite).is_empty());
  const std::array touching{OrientedHyperplane<3>{axis_hyperplane<3>(0, 0), false},
                            OrientedHyperplane<3>{axis_hyperplane<3>(0, 0), true}};
  CHECK(behind_all<3>(touching).is_empty());  // a plane is no region
}

TEST_CASE("lines and rays are cut at the boundary, exactly", "[bsp]") {
  const Partition<3> two = unit_cube() | region(test::box({2, 0, 0}, {3, 1, 1}));
  const ParametricLine<3> line{{-1, Rational(1, 2), Rational(1, 3)}, {2, 0, 0}};
  CHECK(intersection(two, line) == std::vector<Interval>{{Rational(1, 2), Rational(1)}, {Rational(3, 2), Rational(2)}});
  const ParametricLine<3> back{{Rational(1, 2), Rational(1, 2), Rational(1, 2)}, {-1, 0, 0}};
  CHECK(ray_intersection(two, back) == std::vector<Interval>{{Rational(0), Rational(1, 2)}});
  const ParametricLine<3> along_edge{{0, 0, -5}, {0, 0, 1}};
  CHECK(intersection(two, along_edge) == std::vector<Interval>{{Rational(5), Rational(6)}});
  const ParametricLine<3> through_corner{{0, 0, 0}, {1, -1, 0}};
  CHECK(intersection(two, through_corner) == std::vector<Interval>{{Rational(0), Rational(0)}});
  CHECK(intersection(two, {{5, 5, 5}, {1, 0, 0}}).empty());
  CHECK(intersection(complement(two), line).size() == 3);
}

TEST_CASE("images under exact maps have the volume of the determinant", "[bsp][property]") {
  for (std::uint64_t seed = 0; seed < test::rounds(100); ++seed) {
    CAPTURE(seed);
    Random random(seed);
    AffineMap<3> map;
    for (auto& row : map.matrix)
      for (Rational& x : row) x = Rational(random.between(-3, 3), random.between(1, 3));
    for (Rational& x : map.shift) x = Rational(random.between(-9, 9), 7);
    const auto& m = map.matrix;
    const Rational determinant = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                                 m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                                 m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
    const Partition<3> a = region(test::lattice_solid(random)), b = region(test::lattice_solid(random));
    if (determinant == 0) {
      CHECK_THROWS_AS(transformed(a, map), std::invalid_argument);
      continue;
    }
    CHECK(*size(transformed(a, map)) == *size(a) * abs(determinant));
    CHECK(transformed(a - b, map) == (transformed(a, map) - transformed(b, map)));
  }
}

TEST_CASE("nodes are shown front to back: none is hidden by a later one", "[bsp]") {
  Random random(7);
  const Partition<3> r = region(test::lattice_solid(random)) | region(test::lattice_solid(random));
  const RationalVector<3> eye{Rational(-7, 3), Rational(-5, 3), Rational(-11, 3)};
  std::vector<Link> order;
  for_each_node_front_to_back<3>(r, eye, [&](Link node) { order.push_back(node); });
  CHECK(order.size() == tree_of(r).nodes.size());
  // What is on the eye's side of a node comes before it.
  std::vector<std::size_t> place(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) place[order[i]] = i;
  for (Link n = 0; n < order.size(); ++n) {
    const Node& node = tree_of(r).nodes[n];
    const bool is_plus = table_of(r).side(node.hyperplane, eye) == Sign::positive;
    const Link front = is_plus ? node.plus : node.minus, back = is_plus ? node.minus : node.plus;
    if (!is_leaf(front)) CHECK(place[front] < place[n]);
    if (!is_leaf(back)) CHECK(place[back] > place[n]);
  }
}

TEST_CASE("part of a plane inside a region", "[bsp]") {
  const Partition<3> r = unit_cube() | region(test::box({2, 0, 0}, {3, 1, 1}));
  HyperplaneTable<3> table = table_of(r);
  const std::uint32_t middle = table.add(axis_hyperplane<3>(2, Rational(1, 2))),
                      top = table.add(axis_hyperplane<3>(2, 1)), above = table.add(axis_hyperplane<3>(2, 2));
  const auto same = partition_from(table, tree_of(r));
  CHECK(part_inside(same, whole(table, middle)).size() == 2);
  CHECK(part_inside(same, whole(table, top)).size() == 2);  // in the boundary
  CHECK(part_inside(same, whole(table, above)).empty());
}

}  // namespace strata::bsp
