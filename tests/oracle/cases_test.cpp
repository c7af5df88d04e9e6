#include <catch2/catch.hpp>

#include "oracle/comparison.h"
#include "oracle/nef.h"
#include "support/mesh_text.h"
#include "support/transform.h"

// Cases that random seeds found, made small.
namespace strata::oracle {
namespace {

void compare(const std::string& kind, std::vector<Mesh> meshes) {
  std::vector<Compared> engines = all_engines();
  compare_with_nef({kind, std::move(meshes)}, 0, engines);
  for (const Compared& compared : engines) {
    CAPTURE(compared.name);
    CHECK(compared.tally.equal == 4);
  }
}

}  // namespace

// Catches: the side of a merged facet divided on one side of an edge only, so that the boundary is not closed.
TEST_CASE("four tetrahedra about one edge, three of them with coplanar faces", "[oracle][several]") {
  const std::string faces = "f 0 1 2; f 0 3 1; f 0 2 3; f 1 3 2";
  compare("about one edge", {test::mesh_from_text("v 0 0 0; v 0 0 1; v 0 1 0; v 2 3 0;" + faces),
                             test::mesh_from_text("v 0 0 0; v 0 0 1; v 0 1 0; v 1 0 0;" + faces),
                             test::mesh_from_text("v 0 0 0; v 0 0 1; v 0 1 0; v 3 0 1;" + faces),
                             test::mesh_from_text("v 0 0 0; v 0 0 1; v 1 2 1; v 2 2.5 0;" + faces)});
}

// Catches: the same where the coplanar faces share a vertex and no edge is common to all.
TEST_CASE("four tetrahedra with faces in one plane and corners on one another", "[oracle][several]") {
  compare("in one plane",
          {test::mesh_from_text("v 0 0 0; v 1 0 2; v 0 0 1; v 1 1 0; f 0 1 2; f 0 2 3; f 0 3 1; f 2 1 3"),
           test::mesh_from_text("v 0 0 1; v 1 0 1; v 0 1 1; v 1 1 0; f 0 1 2; f 0 2 3; f 0 3 1; f 2 1 3"),
           test::mesh_from_text("v 0 0 0; v 0 1 0; v 1 0 0; v 1 1 1; f 0 1 2; f 0 3 1; f 0 2 3; f 1 3 2"),
           test::mesh_from_text("v 0 0 0; v 0 0 1; v 0 1 0; v 2 0 1; f 0 1 2; f 0 3 1; f 0 2 3; f 1 3 2")});
}

// CGAL's regularization() makes this difference empty.
TEST_CASE("two pyramids that share a corner are cut from a tetrahedron", "[oracle]") {
  compare("shared corner",
          {test::mesh_from_text("v 0 0 0; v 3 2 0; v 3 0 0; v 3 3 3; f 0 1 2; f 0 2 3; f 0 3 1; f 2 1 3"),
           test::mesh_from_text("v 2 2.75 1.5; v 2 2.75 2.5; v 3 2.75 2.5; v 2 1.75 1.5; v 2 1.75 2.5;"
                                "v 3 2.75 1.5; v 4 2.75 2.5; v 3 1.75 1.5; v 3 1.75 2.5;"
                                "f 0 1 2; f 3 0 2; f 3 1 0; f 1 4 2; f 3 2 4; f 3 4 1;"
                                "f 5 2 6; f 7 5 6; f 7 2 5; f 2 8 6; f 7 6 8; f 7 8 2")});
}

}  // namespace strata::oracle
