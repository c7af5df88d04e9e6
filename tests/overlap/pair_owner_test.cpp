#include <catch2/catch.hpp>
#include <map>
#include <utility>

#include "core/cells/cell_tree.h"
#include "core/overlap/meeting.h"
#include "strata/mesh.h"
#include "support/shapes.h"

using namespace strata;

namespace {

/// Every two faces of different operands whose boxes overlap are one cell's business, unless they are apart for
/// certain.
void check_pairs(const InputComplex& input, const CellTree& tree) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> owners;
  for (const Cell& cell : tree.cells())
    for (const CellFace& f : cell.faces)
      for (const CellFace& g : cell.faces)
        if (f.face < g.face && f.box.overlaps(g.box) && tree.owns(cell, f, g)) ++owners[{f.face, g.face}];
  const auto box = [&](std::uint32_t f) {
    const auto v = input.face(f);
    return tree.grid().box(input.vertex(v[0]), input.vertex(v[1]), input.vertex(v[2]));
  };
  int owned = 0, apart = 0;
  for (std::uint32_t f = 0; f < input.face_count(0); ++f)
    for (std::uint32_t g = input.first_face(1); g < input.face_count(); ++g) {
      if (!box(f).overlaps(box(g))) continue;
      const int times = owners[{f, g}];
      REQUIRE(times <= 1);
      PairIntersections intersections;
      if (times == 1) {
        ++owned;
      } else {
        ++apart;
        REQUIRE_FALSE(meet_faces(input, FilteredFace(input, f), FilteredFace(input, g), intersections));
      }
    }
  CHECK(owned > 0);
  INFO(apart);
}

}  // namespace

TEST_CASE("two faces that meet are the business of one cell", "[cells][property]") {
  const auto check = [](const Mesh& a, const Mesh& b, std::size_t leaf_faces) {
    InputComplex input;
    input.add(a.vertices, a.triangles);
    input.add(b.vertices, b.triangles);
    const CellTree tree(input, {.leaf_faces = leaf_faces});
    REQUIRE(tree.cells().size() > 2);
    check_pairs(input, tree);
  };
  const Mesh ball = test::icosphere({0, 0, 0}, 1, 3);
  check(ball, test::icosphere({.3, .1, .05}, 1, 3), 4);
  check(ball, test::icosphere({.02, .01, .03}, 1, 3), 4);
  check(ball, test::icosphere({.02, .01, .03}, 1, 3), 64);
  // Large tilted faces are in the bricks near their planes only.
  Mesh wedge{{{-2, -1.5, -1.1}, {2.2, -1.4, -.9}, {.1, 2.1, -.2}, {.3, .2, 2.3}},
             {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  check(ball, wedge, 4);
  check(ball, wedge, 32);
}
