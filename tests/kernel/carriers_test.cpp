#include "strata/kernel/carriers.h"

#include <catch2/catch.hpp>
#include <vector>

using namespace strata;

TEST_CASE("operands are numbered one after another", "[kernel]") {
  const std::vector<Carriers::Coordinates> two{{0, 0, 0}, {1, 0, 0}}, three{{2, 0, 0}, {3, 0, 0}, {4, 0, 0}};
  const std::vector<Carriers::Indices> one_face{{0, 1, 0}}, two_faces{{0, 1, 2}, {2, 1, 0}};
  Carriers carriers;
  carriers.add(two, one_face);
  carriers.add({}, {});
  carriers.add(three, two_faces);
  carriers.add({}, {});
  CHECK(carriers.operand_count() == 4);
  CHECK(carriers.vertex_count() == 5);
  CHECK(carriers.face_count() == 3);
  CHECK(carriers.first_vertex(2) == 2);
  CHECK(carriers.first_face(2) == 1);
  for (std::uint32_t v = 0; v < 5; ++v) {
    CHECK(carriers.vertex(v)[0] == v);
    CHECK(carriers.operand_of_vertex(v) == (v < 2 ? 0U : 2U));
  }
  CHECK(carriers.face(0) == Carriers::Indices{0, 1, 0});
  CHECK(carriers.face(2) == Carriers::Indices{4, 3, 2});
  CHECK(carriers.operand_of_face(0) == 0);
  CHECK(carriers.operand_of_face(1) == 2);
}

TEST_CASE("rational vertices are found in their own operand only", "[kernel]") {
  const std::vector<Carriers::Coordinates> points{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  const std::vector<ExactVertex> exact{{0, {Rational(1, 7), 0, 0}}, {2, {Rational(2, 7), 0, 0}}};
  Carriers carriers;
  carriers.add(points, {});
  CHECK_FALSE(carriers.has_rationals());
  CHECK(carriers.exact(0) == nullptr);
  carriers.add(points, {}, exact);
  CHECK(carriers.has_rationals());
  for (const std::uint32_t v : {0U, 1U, 2U, 4U}) CHECK(carriers.exact(v) == nullptr);
  REQUIRE(carriers.exact(3) != nullptr);
  REQUIRE(carriers.exact(5) != nullptr);
  CHECK((*carriers.exact(3))[0] == Rational(1, 7));
  CHECK((*carriers.exact(5))[0] == Rational(2, 7));
}
