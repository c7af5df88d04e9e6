#include "strata/contact/relation.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "contact/parts.h"
#include "support/random.h"
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
    for (const int turn : {9, 22, 47})
      CHECK(relation(Solid(test::turned(two.meshes[0], turn)), Solid(test::turned(two.meshes[1], turn))) == found);
    for (const int exponent : {3, -800, 900})
      if (is_exact_when_scaled(two.meshes[0], exponent) && is_exact_when_scaled(two.meshes[1], exponent))
        CHECK(relation(Solid(test::scaled(two.meshes[0], exponent)), Solid(test::scaled(two.meshes[1], exponent))) ==
              found);
  }
  for (const std::size_t n : seen) CHECK(n > 20);
}

}  // namespace
}  // namespace strata::contact
