#include <strata/strata.h>

#include <iostream>

int main() {
  const strata::Mesh corner{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
  strata::Mesh moved = corner;
  for (strata::Vertex& vertex : moved.vertices) vertex[0] += 1;
  const strata::Solid rest = strata::Solid(corner) - strata::Solid(moved);
  std::cout << rest.mesh().triangles.size() << " triangles, volume " << rest.volume() << '\n';
}
