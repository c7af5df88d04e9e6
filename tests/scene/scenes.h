#pragma once
#include <utility>
#include <vector>

#include "strata/mesh.h"
#include "strata/query.h"
#include "support/random.h"
#include "support/shapes.h"
#include "support/touching.h"

namespace strata::test {

inline Scene scene_of(const std::vector<Mesh>& meshes) {
  std::vector<ExactMesh> solids;
  for (const Mesh& m : meshes) solids.push_back({m, {}});
  return Scene(std::move(solids));
}

/// Points that are likely to be degenerate against a mesh: corners, points on edges and faces, on lines through a point
/// and a corner, and points nowhere in particular.
inline Vertex awkward_point(const std::vector<Mesh>& meshes, const Vertex& origin, Random& random) {
  const Mesh& m = random.pick(meshes);
  const Triangle& t = random.pick(m.triangles);
  const Vertex &a = m.vertices[t[0]], &b = m.vertices[t[1]], &c = m.vertices[t[2]];
  Vertex q;
  const int kind = random.between(0, 6);
  for (std::size_t i = 0; i < 3; ++i) {
    switch (kind) {
      case 0:
        q[i] = a[i];
        break;
      case 1:
        q[i] = (a[i] + b[i]) / 2;
        break;
      case 2:
        q[i] = (2 * a[i] + b[i] + c[i]) / 4;
        break;
      case 3:
        q[i] = 2 * a[i] - origin[i];
        break;
      case 4:
        q[i] = (a[i] + origin[i]) / 2;
        break;
      case 5:
        q[i] = a[i] + b[i] - origin[i];
        break;
      default:
        q[i] = random.between(-8, 40) / 8.0;
        break;
    }
  }
  return q;
}

/// Origins in general and in special places: corners, on edges and faces, along axes, far away, at infinity.
inline Origin awkward_origin(const std::vector<Mesh>& meshes, Random& random) {
  const int kind = random.between(0, 3);
  if (kind == 0) {
    Vertex d{};
    while (d == Vertex{})
      for (double& x : d) x = random.between(-2, 2);
    return Origin::direction(d);
  }
  if (kind == 1)
    return Origin::point({random.between(-3, 7) / 1.0, random.between(-3, 7) / 1.0, random.between(-3, 7) / 1.0});
  return Origin::point(
      awkward_point(meshes, {random.unit() * 9 - 2, random.unit() * 9 - 2, random.unit() * 9 - 2}, random));
}

}  // namespace strata::test
