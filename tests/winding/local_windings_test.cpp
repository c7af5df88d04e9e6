#include "core/winding/local_windings.h"

#include <catch2/catch.hpp>

#include "strata/mesh.h"
#include "support/random.h"
#include "support/shapes.h"

using namespace strata;

namespace {

/// A tiny box around a point: an operand of its own, since winding numbers are asked for at points of operands.
Mesh probe(double x, double y, double z) {
  return test::box({x - 0.0625, y - 0.0625, z - 0.0625}, {x + 0.0625, y + 0.0625, z + 0.0625});
}

/// Winding numbers about everything else at a vertex of operand `own`.
Windings at_vertex_of(const InputComplex& input, const LocalWindings& layers, std::uint32_t own) {
  return layers.around(make_point(input, SymbolicPoint::input(input.first_vertex(own))), own);
}

}  // namespace

TEST_CASE("winding numbers of a scene are those of its boxes", "[layers][property]") {
  test::Random random(2);
  constexpr std::uint32_t boxes = 40, probes = 400;
  std::vector<Mesh> meshes;
  std::vector<std::array<int, 6>> bounds;
  for (std::uint32_t i = 0; i < boxes; ++i) {
    std::array<int, 6> b;
    for (std::size_t k = 0; k < 3; ++k) {
      b[k] = random.between(0, 8);
      b[k + 3] = b[k] + random.between(1, 4);
    }
    bounds.push_back(b);
    meshes.push_back(test::box({double(b[0]), double(b[1]), double(b[2])}, {double(b[3]), double(b[4]), double(b[5])}));
  }
  std::vector<Vertex> where;
  for (std::uint32_t n = 0; n < probes; ++n) {
    where.push_back({random.between(-1, 12) + 0.5, random.between(-1, 12) + 0.5, random.between(-1, 12) + 0.5});
    meshes.push_back(probe(where.back()[0], where.back()[1], where.back()[2]));
  }
  InputComplex input;
  for (const Mesh& m : meshes) input.add(m.vertices, m.triangles);
  const CellTree cells(input, {});
  const LocalWindings layers(input, cells);
  for (std::uint32_t n = 0; n < probes; ++n) {
    const Windings w = at_vertex_of(input, layers, boxes + n);
    for (std::uint32_t i = 0; i < boxes; ++i) {
      bool in = true;
      for (std::size_t k = 0; k < 3; ++k) in = in && bounds[i][k] < where[n][k] && where[n][k] < bounds[i][k + 3];
      REQUIRE(w[i] == (in ? 1 : 0));
    }
  }
}

TEST_CASE("just above every face of a solid is outside", "[layers][degenerate]") {
  const std::vector<Mesh> solids{test::box_with_hole(), test::box_with_cavity(2), test::octahedron({0, 0, 0}, 2),
                                 test::edge_sharing_cells(), test::l_shape()};
  for (const Mesh& m : solids) {
    InputComplex input;
    input.add(m.vertices, m.triangles);
    const CellTree cells(input, {.self = true, .leaf_faces = 4});
    const LocalWindings layers(input, cells);
    for (std::uint32_t f = 0; f < input.face_count(); ++f)
      REQUIRE(layers.above(f, make_point(input, SymbolicPoint::weighted(f, 1)), {&f, 1})[0] == 0);
  }
}

TEST_CASE("faces that dominate one another in a ring are no obstacle", "[layers][degenerate]") {
  // Three bars around a corner, each over the next: no order by depth exists from (9, 9, 9).
  const std::vector<Mesh> meshes{test::box({0, 0, 2}, {6, 1, 3}),
                                 test::box({2, 0, 0}, {3, 6, 1}),
                                 test::box({0, 2, 0}, {1, 3, 6}),
                                 probe(5.5, .5, 2.5),
                                 probe(2.5, 5.5, .5),
                                 probe(.5, 2.5, 5.5),
                                 probe(1.5, 1.5, 1.5)};
  InputComplex input;
  for (const Mesh& m : meshes) input.add(m.vertices, m.triangles);
  const CellTree cells(input, {});
  const LocalWindings layers(input, cells);
  for (std::uint32_t bar = 0; bar < 3; ++bar) {
    Windings only;
    only.add(bar, 1);
    CHECK(at_vertex_of(input, layers, 3 + bar) == only);
  }
  CHECK(at_vertex_of(input, layers, 6) == Windings{});
}
