#include "core/round/moving_mesh.h"

#include <catch2/catch.hpp>
#include <numeric>
#include <utility>
#include <vector>

#include "core/containers/box_cover.h"
#include "core/mesh/equal_vertices.h"
#include "core/overlap/self_intersections.h"
#include "core/round/wrong_faces.h"
#include "support/random.h"
#include "support/shapes.h"

using namespace strata;

namespace {

double between(test::Random& random, double lower, double upper) { return lower + (upper - lower) * random.unit(); }

MovingMesh moving(Mesh mesh) {
  std::vector<std::uint32_t> source(mesh.triangles.size());
  std::iota(source.begin(), source.end(), 0U);
  std::vector<double> moved(source.size(), 0);
  return {std::move(mesh), std::move(source), std::move(moved)};
}

/// A cube with bumps, all of which has moved and was searched.
MovingMesh searched(test::Random& random) {
  const Mesh cube = test::cube_grid(12);
  MovingMesh mesh = moving(cube);
  std::vector<VertexMove> moves;
  for (std::uint32_t v = 0; v < cube.vertices.size(); ++v) {
    Vertex to = cube.vertices[v];
    for (double& x : to) x += between(random, -0.2, 0.2);
    moves.push_back({v, v, to, 0.2});
  }
  mesh.move(moves);
  REQUIRE(!mesh.swept());
  ChangedRegion region(mesh, {});
  REQUIRE(region.is_all());
  const std::vector<std::uint32_t> wrong = region.wrong_faces({});
  mesh.set_searched(wrong, region.stars_of_mesh());
  return mesh;
}

std::uint32_t face_that_is_left(const MovingMesh& mesh, test::Random& random) {
  for (;;) {
    const auto f = static_cast<std::uint32_t>(random.below(mesh.mesh().triangles.size()));
    if (mesh.is_left(f)) return f;
  }
}

/// One of the changes that repairs make, about a face.
void change(MovingMesh& mesh, std::uint32_t f, test::Random& random) {
  const Triangle t = mesh.mesh().triangles[f];
  const std::uint32_t other = mesh.mesh().triangles[face_that_is_left(mesh, random)][0];
  const std::span<const Vertex> points = mesh.mesh().vertices;
  switch (random.below(5)) {
    case 0: {  // a vertex elsewhere
      Vertex to = points[t[0]];
      for (double& x : to) x += between(random, -0.5, 0.5);
      return mesh.move(std::vector<VertexMove>{{t[0], t[0], to, 0.5}});
    }
    case 1:  // a vertex goes to its neighbour, and becomes it
      return mesh.move(std::vector<VertexMove>{{t[0], t[1], points[t[1]], 1}});
    case 2:  // or to another one
      if (other == t[0]) return;
      return mesh.move(std::vector<VertexMove>{{t[0], other, points[other], 1}});
    case 3: {  // or first goes there, and is found there later
      if (other == t[0]) return;
      mesh.move(std::vector<VertexMove>{{t[0], t[0], points[other], 1}});
      return mesh.move(std::vector<VertexMove>{{std::max(t[0], other), std::min(t[0], other), points[other], 0}});
    }
    default: {  // a flip of one of its sides
      for (std::uint32_t g = 0; g < mesh.mesh().triangles.size(); ++g) {
        const Triangle u = mesh.mesh().triangles[g];
        if (!mesh.is_left(g) || g == f) continue;
        for (std::size_t i = 0; i < 3; ++i)
          if (u[i] == t[2] && u[(i + 1) % 3] == t[1] && u[(i + 2) % 3] != t[0])
            return mesh.flip(std::vector<FlatFlip>{{f, g, 0, 1}});
      }
    }
  }
}

}  // namespace

TEST_CASE("faces near boxes are found after all changes", "[round][property]") {
  test::Random random(41);
  for (int n = 0; n < 10; ++n) {
    MovingMesh mesh = searched(random);
    for (int k = 0; k < 60; ++k) {
      const std::uint32_t f = face_that_is_left(mesh, random);
      change(mesh, f, random);
      std::vector<Box> boxes(3);
      for (std::size_t i = 0; i < 3; ++i) boxes[i].include(mesh.mesh().vertices[mesh.mesh().triangles[f][i]]);
      const BoxCover cover(boxes);
      std::vector<std::uint32_t> expected;
      for (std::uint32_t f = 0; f < mesh.mesh().triangles.size(); ++f)
        if (mesh.is_left(f) && cover.meets(mesh.box(f))) expected.push_back(f);
      REQUIRE(mesh.faces_that_meet(cover) == expected);
    }
  }
}

TEST_CASE("stars that are known after changes are embedded", "[round][property]") {
  test::Random random(43);
  std::size_t known = 0;
  for (int n = 0; n < 20; ++n) {
    MovingMesh mesh = searched(random);
    for (int k = 0; k < 20; ++k) {
      change(mesh, face_that_is_left(mesh, random), random);
      REQUIRE(mesh.stars());
      Mesh now{{mesh.mesh().vertices.begin(), mesh.mesh().vertices.end()},
               on_first_vertices(ExactMeshView(mesh.mesh(), {}))};
      std::erase_if(now.triangles, repeats_vertex);
      const EmbeddedStars all(complex_of(now), {});
      for (const Triangle& t : now.triangles)
        for (const std::uint32_t v : t) {
          if (!mesh.stars()->at(v)) continue;
          ++known;
          REQUIRE(all.at(v));
        }
    }
  }
  CHECK(known > 100'000);
}

TEST_CASE("stars stay known where most vertices are moved to where they are", "[round]") {
  test::Random random(44);
  MovingMesh mesh = searched(random);
  const auto embedded = [&] {
    std::size_t count = 0;
    for (std::uint32_t v = 0; v < mesh.mesh().vertices.size(); ++v) count += mesh.stars()->at(v) ? 1 : 0;
    return count;
  };
  const std::size_t before = embedded();
  std::vector<VertexMove> moves;
  for (std::uint32_t v = 0; v < mesh.mesh().vertices.size(); ++v) moves.push_back({v, v, mesh.mesh().vertices[v], 0});
  mesh.move(moves);
  REQUIRE(mesh.stars());
  CHECK(embedded() == before);
}
