#include <catch2/catch.hpp>
#include <string>

#include "convex/decomposition_check.h"
#include "corpus/corpus.h"

namespace strata::test {

namespace {

const std::string coref = "csg/cgal-tests/Polygon_mesh_processing/test/Polygon_mesh_processing/data-coref/";
const std::string hull = "csg/cgal-tests/Nef_3/archive/Visual_hull/Nef_3/", trimesh = "meshes/trimesh/models/";

struct Part {
  std::string path;
  std::size_t most;  ///< pieces
};

// Catches: pieces that are not convex, overlap or leave gaps; walls and triangles that are not covered once.
void check_parts(const std::vector<Part>& parts) {
  const auto root = corpus_or_skip();
  if (!root) return;
  for (const auto& [path, most] : parts) {
    CAPTURE(path);
    const Solid solid(load(*root, path));
    const convex::Decomposition d = convex::decompose(solid);
    CHECK(fault_of(d, solid).empty());
    CHECK(d.pieces.size() <= most);
  }
}

}  // namespace

TEST_CASE("corpus parts fall into convex pieces that make them again", "[corpus][convex]") {
  check_parts({{hull + "corner.off", 2},
               {hull + "hole.off", 4},
               {hull + "mpi.off", 80},
               {hull + "mpi_triang.off", 60},
               {coref + "nested_cubes.off", 68},
               {coref + "coplanar_with_cube3.off", 2},
               {trimesh + "20mm-xyz-cube.stl", 38},
               {trimesh + "mirror.ply", 10},
               {trimesh + "round.stl", 37},
               {trimesh + "tube.obj", 14},
               {trimesh + "ico4.obj", 1},
               {"csg/manifold/test/models/Havocglass8_left.obj", 58},
               {"csg/manifold/test/models/Offset2.obj", 164},
               {"csg/irmb/data/spheres/105.obj", 1},
               {"bad/tinyobjloader/models/catmark_torus_creases0.obj", 8}});
}

TEST_CASE("larger corpus parts fall into convex pieces that make them again", "[corpus][convex][slow]") {
  check_parts({{trimesh + "fuze.obj", 302},
               {trimesh + "quadknot.obj", 1128},
               {"meshes/libigl-tutorial-data/decimated-knight.off", 308},
               {"csg/thingiCSG/DATABASE/QuickCSG/T1/t1_13.off", 731}});
}

}  // namespace strata::test
