#include "extensions/contact/relation.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <iterator>

#include "contact/parts.h"
#include "support/random.h"
#include "support/subdivision.h"
#include "support/touching.h"

namespace strata::contact {
namespace {

using namespace test_parts;

constexpr Relation apart = Relation::apart, contact = Relation::contact, interfering = Relation::interfering;

TEST_CASE("boxes that touch in a face, an edge or a vertex are in contact", "[contact]") {
  const Solid a = box({0, 0, 0}, {1, 1, 1});
  CHECK(relation(a, box({1, 0, 0}, {2, 1, 1})) == contact);
  CHECK(relation(a, box({1, 1, 0}, {2, 2, 1})) == contact);
  CHECK(relation(a, box({1, 1, 1}, {2, 2, 2})) == contact);
  CHECK(relation(a, box({1 + 0x1p-52, 0, 0}, {2, 1, 1})) == apart);
  CHECK(relation(a, box({1 - 0x1p-53, 0, 0}, {2, 1, 1})) == interfering);
}

TEST_CASE("a solid interferes with itself, with its like and with what is nested in it", "[contact]") {
  const Solid a = box({0, 0, 0}, {4, 4, 4});
  CHECK(relation(a, a) == interfering);
  CHECK(relation(a, Solid(test::relisted(a.mesh()))) == interfering);
  CHECK(relation(a, box({1, 1, 1}, {2, 2, 2})) == interfering);
  CHECK(relation(box({1, 1, 1}, {2, 2, 2}), a) == interfering);
  CHECK(relation(a, box({0, 0, 0}, {2, 2, 2})) == interfering);  // nested, and touching from inside
}

// Catches: components that are not looked at one by one; winding numbers of the wrong side.
TEST_CASE("a part in the cavity of another is apart from it, or in contact with its wall", "[contact]") {
  const Solid shell(test::box_with_cavity(2));  // [1, 3]^3 is empty
  CHECK(relation(shell, box({1.5, 1.5, 1.5}, {2.5, 2.5, 2.5})) == apart);
  CHECK(relation(shell, box({1, 1, 1}, {2, 2, 2})) == contact);
  CHECK(relation(shell, box({1, 1, 1}, {3, 3, 3})) == contact);
  CHECK(relation(shell, box({1, 1, 1}, {3, 3, 3.25})) == interfering);
  const Mesh parts[] = {test::box({1.5, 1.5, 1.5}, {2, 2, 2}), test::box({0.25, 0.25, 0.25}, {0.5, 0.5, 0.5})};
  CHECK(relation(shell, Solid(test::merged(parts))) == interfering);  // its second component is in the wall
}

TEST_CASE("an empty part is apart from everything", "[contact]") {
  CHECK(relation(Solid(), box({0, 0, 0}, {1, 1, 1})) == apart);
  CHECK(relation(Solid(), Solid()) == apart);
}

// Catches: a verdict from single pairs of faces where edges or vertices are reflex: no faces cross properly here.
TEST_CASE("parts interfere although none of their faces cross in their insides", "[contact][degenerate]") {
  const Solid l(test::l_shape());
  const Solid cell = box({0, 0, 0}, {1, 1, 1});
  CHECK(relation(l, cell) == interfering);
  SECTION("a bar through the corners of a star of tetrahedra") {
    // The planes x = 0 and y = 0 divide the octahedron's faces at its vertices: all that meets are edges and vertices.
    const Solid octahedron(test::octahedron({0, 0, 0}, 1));
    const Solid bar(test::tetrahedron({0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {0, 1, 0}));
    CHECK(relation(octahedron, bar) == interfering);
  }
  SECTION("an edge inside a part that ends on its boundary's vertices") {
    const Solid cube = box({0, 0, 0}, {2, 2, 2});
    const Solid thin(test::tetrahedron({0, 0, 0}, {2, 2, 2}, {0, 0, 2}, {0, 2, 2}));
    CHECK(relation(cube, thin) == interfering);
  }
}

TEST_CASE("a tip in a notch of its shape is in contact, one that is blunter interferes", "[contact][degenerate]") {
  const std::array<double, 2> square[] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  const Solid cone(test::pyramid(square, 1, {0, 0, 0}));  // a tip that points down
  const Solid block = box({-2, -2, -2}, {2, 2, 1}) - cone;
  CHECK(relation(block, cone) == contact);
  const std::array<double, 2> narrow[] = {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}};
  const Solid sharp(test::pyramid(narrow, 1, {0, 0, 0}));
  CHECK(relation(block, sharp) == contact);
  CHECK(counts(region(block, sharp)) == std::vector<std::size_t>{0, 0, 1});
  const std::array<double, 2> wide[] = {{-1, -1.5}, {1, -1.5}, {1, 1.5}, {-1, 1.5}};
  CHECK(relation(block, Solid(test::pyramid(wide, 1, {0, 0, 0}))) == interfering);
}

// Catches: a plane that keeps surfaces apart, taken for one that keeps solids apart.
TEST_CASE("a notch whose tip touches a part from inside of both interferes", "[contact][degenerate]") {
  const std::array<double, 2> square[] = {{-3, -3}, {3, -3}, {3, 3}, {-3, 3}};
  const Solid block = box({-4, -4, -4}, {4, 4, 4}) - Solid(test::pyramid(square, 5, {0, 0, 0}));
  CHECK(relation(block, box({-1, -1, -1}, {1, 1, 0})) == interfering);
  CHECK(relation(box({-1, -1, -1}, {1, 1, 0}), block) == interfering);
}

TEST_CASE("a peg in its hole is in contact", "[contact]") {
  std::vector<std::array<double, 2>> round;
  for (const auto& [x, y] : {std::pair{2, 0}, {1, 1}, {0, 2}, {-1, 1}, {-2, 0}, {-1, -1}, {0, -2}, {1, -1}})
    round.push_back({x + 3.0 / 7, y + 1.0 / 3});
  const Solid peg(test::prism(std::vector<std::array<double, 2>>{round[0], round[2], round[4], round[6]}, 0, 1));
  const Solid plate = box({-5, -5, 0}, {5, 5, 1}) - peg;
  CHECK(relation(plate, peg) == contact);
  CHECK(counts(region(plate, peg)) == std::vector<std::size_t>{4, 0, 0});
}

/// A block of 3 x 3 x 1 cells of `width` units with a hole of one cell in the middle.
Solid plate_with_hole(double width) {
  return box({0, 0, 0}, {3 * width, 3 * width, width}) - box({width, width, -1}, {2 * width, 2 * width, 2 * width});
}

// No plane separates these. Catches: interior sides that are asked where they are not defined; vertices on the other
// surface that join faces; a face on which nothing lies taken for one that is covered.
TEST_CASE("parts that interlock are told apart without a plane between", "[contact][degenerate]") {
  const Solid plate = plate_with_hole(4);  // the hole is [4, 8]^2
  const double up = 0x1p-40;
  CHECK(relation(plate, box({4, 4, -3}, {8, 8, 9})) == contact);  // all round, through
  CHECK(relation(plate, box({4, 4, 1}, {8, 8, 3})) == contact);   // all round, within
  CHECK(relation(plate, box({4 + up, 4 + up, -3}, {8 - up, 8 - up, 9})) == apart);
  CHECK(relation(plate, box({4, 4 + up, -3}, {8 - up, 8 - up, 9})) == contact);  // on one side
  CHECK(relation(plate, box({4, 4, -3}, {8, 8 + up, 9})) == interfering);
  CHECK(relation(plate, box({4 - up, 4, 1}, {8, 8, 3})) == interfering);
  const Solid headed = box({4, 4, 0}, {8, 8, 8}) | box({2, 2, 4}, {10, 10, 8});  // a peg with a head on the plate
  CHECK(relation(plate, headed) == contact);
  CHECK(counts(region(plate, headed)) == std::vector<std::size_t>{5, 0, 0});
  const Solid sunk = box({4, 4, 0}, {8, 8, 8}) | box({2, 2, 4 - up}, {10, 10, 8});
  CHECK(relation(plate, sunk) == interfering);
  const Solid diamond(test::octahedron({6, 6, 2}, 2));  // touches the walls in vertices, and nothing else
  CHECK(relation(plate, diamond) == contact);
  CHECK(relation(plate, Solid(test::octahedron({6, 6, 2}, 2 + up))) == interfering);
}

// Catches: faces that are joined by a vertex on the other surface.
TEST_CASE("parts interfere where one goes through the other's surface in a vertex only", "[contact][degenerate]") {
  const Solid two_tips(Mesh{{{0, 0, 0}, {1, 0, -1}, {-1, 1, -1}, {-1, -1, -1}, {1, 0, 1}, {-1, 1, 1}, {-1, -1, 1}},
                            {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {3, 2, 1}, {0, 5, 4}, {0, 6, 5}, {0, 4, 6}, {4, 5, 6}}});
  CHECK(two_tips.volume() > 0);
  const Solid below = box({-4, -5, -8}, {5, 7, 0});  // no edge of it goes through the tips
  CHECK(relation(two_tips, below) == interfering);
  CHECK(relation(below, two_tips) == interfering);
  const Solid under = box({-4, -5, -8}, {5, 7, -1});
  CHECK(relation(two_tips, under) == contact);
}

TEST_CASE("two links of a chain are apart, in contact or interfering", "[contact]") {
  const Solid link = box({0, 0, 0}, {12, 8, 2}) - box({2, 2, -1}, {10, 6, 3});
  const auto other = [](double x) {  // goes through the first one's hole
    return box({x, 3, -5}, {x + 12, 5, 7}) - box({x + 2, 2, -3}, {x + 10, 6, 5});
  };
  CHECK(relation(link, other(7)) == apart);
  CHECK(relation(link, other(8)) == contact);
  CHECK(relation(link, other(8 + 0x1p-40)) == interfering);
}

/// True when what two solids have in common is what their relation says.
void check_relation(const Solid& a, const Solid& b, std::size_t (&seen)[3]) {
  const Relation found = relation(a, b);
  ++seen[static_cast<std::size_t>(found)];
  CHECK((found == interfering) == !(a & b).is_empty());
  CHECK(relation(b, a) == found);
}

// Solids without what others take of them, blocks around them, and the same in other triangles. Catches: as above.
TEST_CASE("relations of solids made to fit are those of their overlaps", "[contact][property][degenerate]") {
  std::size_t seen[3] = {};
  for (std::uint64_t seed = 10'000; seed < 11'000; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    const test::Operands two = test::touching_pair(seed);
    const Solid a{two.meshes[0]}, b{two.meshes[1]};
    const Solid fine(test::subdivided(two.meshes[0], random, 6));
    check_relation(fine, b, seen);
    const Solid rest = b - a, common = a & b;
    CHECK((rest.is_empty() || relation(fine, rest) != interfering));
    CHECK((common.is_empty() || (relation(fine, common) == interfering && relation(common, b) == interfering)));
    if (!rest.is_empty()) check_relation(rest, a ^ b, seen);
    const BoundingBox bounds = a.bounding_box();
    const double x = bounds.upper[0] - bounds.lower[0];
    if (!std::isfinite(4 * x) || x < 0x1p-1000) continue;
    Vertex lower = bounds.lower, upper = bounds.upper;
    lower[0] -= random.between(0, 1) * x;
    upper[2] += random.between(0, 1) * x;
    const Solid block = box(lower, upper) - a;
    if (block.is_empty()) continue;
    CHECK(relation(block, fine) == contact);
    check_relation(block, b, seen);
  }
  for (const std::size_t n : seen) CHECK(n > 100);
}

/// By a matrix of integers whose rows are orthogonal and equally long.
Mesh off_the_axes(Mesh mesh) {
  for (Vertex& v : mesh.vertices)
    v = {2 * v[0] - v[1] + 2 * v[2], 2 * v[0] + 2 * v[1] - v[2], -v[0] + 2 * v[1] + 2 * v[2]};
  return mesh;
}

/// Two sets of tetrahedra: the second is what the first leaves, or some of that, and now and then one of the first.
std::array<std::vector<bool>, 2> fitting_sets(test::Random& random, std::size_t size) {
  std::array<std::vector<bool>, 2> sets{std::vector<bool>(size), std::vector<bool>(size)};
  const int density = random.between(2, 4);
  const bool is_all = random.once_in(2);
  for (std::size_t i = 0; i < size; ++i) {
    sets[0][i] = random.once_in(static_cast<std::uint64_t>(density));
    sets[1][i] = !sets[0][i] && (is_all || random.once_in(4));
  }
  if (random.once_in(4)) {
    const std::size_t i = random.below(size);
    sets[0][i] = sets[1][i] = true;
  }
  return sets;
}

/// Vertices of a solid, sorted.
std::vector<Vertex> corners_of(const Mesh& mesh) {
  std::vector<Vertex> corners = mesh.vertices;
  std::sort(corners.begin(), corners.end());
  return corners;
}

// Simplices of one subdivision: sets without a common tetrahedron are in contact exactly when some corner is in both.
// Corners that are inside of a set are no vertices of its surface, and in no other set's corners without a common
// tetrahedron. Catches: pairs of faces that are left out because of their coincident faces, but have something to tell.
TEST_CASE("sets of tetrahedra of one subdivision lie to each other as the sets do", "[contact][property][degenerate]") {
  std::size_t seen[3] = {};
  for (std::uint64_t seed = 0; seed < 1200; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    const std::array<int, 3> size{random.between(1, 3), random.between(1, 3), random.between(1, 3)};
    const auto sets = fitting_sets(random, 6 * static_cast<std::size_t>(size[0] * size[1] * size[2]));
    Mesh a = test::kuhn_solid(size, sets[0]), b = test::kuhn_solid(size, sets[1]);
    if (a.triangles.empty() || b.triangles.empty()) continue;
    std::vector<Vertex> common;
    const auto of_a = corners_of(a), of_b = corners_of(b);
    std::set_intersection(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(), std::back_inserter(common));
    bool do_interfere = false;
    for (std::size_t i = 0; i < sets[0].size(); ++i) do_interfere = do_interfere || (sets[0][i] && sets[1][i]);
    const Relation expected = do_interfere ? interfering : common.empty() ? apart : contact;
    if (seed % 2 == 0) a = off_the_axes(std::move(a));
    if (seed % 2 == 0) b = off_the_axes(std::move(b));
    const Solid first(a), second(b);
    ++seen[static_cast<std::size_t>(expected)];
    CHECK(relation(first, second) == expected);
    CHECK(relation(second, first) == expected);
    CHECK(relation(Solid(test::relisted(a)), second) == expected);
    CHECK(relation(Solid(test::subdivided(a, random, 10)), second) == expected);
  }
  CHECK(seen[static_cast<std::size_t>(contact)] > 300);
  CHECK(seen[static_cast<std::size_t>(interfering)] > 200);
}

/// No overflow, and nothing lost to underflow.
bool is_exact_when_scaled(const Mesh& mesh, int exponent) {
  for (const Vertex& v : mesh.vertices)
    for (const double x : v)
      if (std::ldexp(std::ldexp(x, exponent), -exponent) != x) return false;
  return true;
}

// The Boolean engine computes volumes by other means than pairs of faces.
TEST_CASE("parts interfere exactly where what they have in common has a volume", "[contact][property]") {
  std::size_t seen[3] = {};
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    CAPTURE(seed);
    const test::Operands two = test::touching_pair(seed);
    const Solid a{two.meshes[0]}, b{two.meshes[1]};
    const Relation found = relation(a, b);
    ++seen[static_cast<std::size_t>(found)];
    CHECK((found == interfering) == ((a & b).volume() > 0));
    CHECK(relation(b, a) == found);
    if (found == apart) {
      CHECK(region(a, b).is_empty());
      CHECK(nearest(a, b).squared > 0);
    }
    if (found == contact) CHECK_FALSE(region(a, b).is_empty());
    for (const int orientation : {9, 22, 47})
      CHECK(relation(Solid(test::turned(two.meshes[0], orientation)),
                     Solid(test::turned(two.meshes[1], orientation))) == found);
    for (const int exponent : {3, -800, 900})
      if (is_exact_when_scaled(two.meshes[0], exponent) && is_exact_when_scaled(two.meshes[1], exponent))
        CHECK(relation(Solid(test::scaled(two.meshes[0], exponent)), Solid(test::scaled(two.meshes[1], exponent))) ==
              found);
  }
  for (const std::size_t n : seen) CHECK(n > 20);
}

/// The hull of four to six points of a small lattice.
Mesh lattice_hull(test::Random& random) {
  for (;;) {
    std::vector<Vertex> points;
    for (int i = random.between(4, 6); i > 0; --i)
      points.push_back({double(random.between(0, 4)), double(random.between(0, 4)), double(random.between(0, 4))});
    if (Mesh hull = test::convex_hull(points); !hull.triangles.empty()) return hull;
  }
}

std::vector<Mesh> lattice_pile(test::Random& random) {
  std::vector<Mesh> pile;
  Solid whole;
  for (int i = 0; i < 12; ++i) {
    const Mesh shape = lattice_hull(random);
    if (!(whole & Solid(shape)).is_empty()) continue;
    whole = whole | Solid(shape);
    pile.push_back(shape);
  }
  return pile;
}

bool shares_area(const Solid& a, const Solid& b) { return relation(a, b) != apart && region(a, b).area() > 0; }

/// Shapes whose interiors are disjoint, to be listed as one mesh. Cavities of a block are among them, turned over, if
/// they touch its surface and one another in edges and vertices only.
std::vector<Mesh> loose_shapes(test::Random& random, const std::vector<Mesh>& pile) {
  std::vector<Mesh> shapes;
  if (random.once_in(2)) {
    for (const Mesh& shape : pile)
      if (random.once_in(2)) shapes.push_back(shape);
    return shapes;
  }
  const Mesh block = test::box({0, 0, 0}, {4, 4, 4});
  shapes.push_back(block);
  const Solid around = Solid(test::box({-1, -1, -1}, {5, 5, 5})) - Solid(block);
  std::vector<Solid> cavities;
  for (const Mesh& shape : pile) {
    const Solid cavity(shape);
    const auto is_beside = [&](const Solid& other) { return shares_area(other, cavity); };
    if (is_beside(around) || std::any_of(cavities.begin(), cavities.end(), is_beside)) continue;
    cavities.push_back(cavity);
    shapes.push_back(test::reversed(shape));
  }
  return shapes;
}

/// Points, loops, edges and vertices: equal for equal sets.
bool are_equal(const ContactRegion& r, const ContactRegion& s) {
  const auto facets_are = [](const ContactFacet& f, const ContactFacet& g) { return f.loops == g.loops; };
  const auto edges_are = [](const ContactEdge& e, const ContactEdge& f) { return e.ends == f.ends; };
  return r.points == s.points && r.vertices == s.vertices &&
         std::equal(r.facets.begin(), r.facets.end(), s.facets.begin(), s.facets.end(), facets_are) &&
         std::equal(r.edges.begin(), r.edges.end(), s.edges.begin(), s.edges.end(), edges_are);
}

/// Parts as they are given lie to each other as the same resolved.
void check_loose_parts(const Mesh& a, const Mesh& b, std::size_t (&seen)[3]) {
  const Solid first(a), second(b);
  const Solid resolved_first(a, InputClass::overlapping), resolved_second(b, InputClass::overlapping);
  const Relation expected = relation(resolved_first, resolved_second);
  REQUIRE((expected == interfering) == !(resolved_first & resolved_second).is_empty());
  ++seen[static_cast<std::size_t>(expected)];
  CHECK(relation(first, second) == expected);
  CHECK(relation(second, first) == expected);
  if (expected == contact) CHECK(are_equal(region(first, second), region(resolved_first, resolved_second)));
}

// Parts that touch themselves inside of faces, with walls in them and cavities that reach their surface. Catches:
// proofs by faces that are not alone where they are; edges of a contact that are inside of its facets.
TEST_CASE("parts may touch themselves anywhere", "[contact][property][degenerate]") {
  std::size_t seen[3] = {};
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    const std::vector<Mesh> pile = lattice_pile(random);
    std::vector<Mesh> rest;
    for (const Mesh& shape : pile)
      if (random.once_in(3)) rest.push_back(shape);
    check_loose_parts(test::merged(loose_shapes(random, pile)), test::merged(rest), seen);
  }
  for (const std::size_t n : seen) CHECK(n > 20);
}

}  // namespace
}  // namespace strata::contact
