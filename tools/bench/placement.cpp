#include "placement.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bench {
namespace {

using strata::Mesh;
using strata::Vertex;

double dot(const Vertex& a, const Vertex& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vertex scaled(const Vertex& v, double factor) { return {v[0] * factor, v[1] * factor, v[2] * factor}; }

/// Of the unit quaternion w + x i + y j + z k.
Rotation of_quaternion(double w, double x, double y, double z) {
  return {{{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
           {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
           {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}}};
}

}  // namespace

Rotation rotation(const Vertex& axis, double degrees) {
  const double half = degrees * std::numbers::pi / 360;
  const Vertex v = scaled(axis, std::sin(half) / std::sqrt(dot(axis, axis)));
  return of_quaternion(std::cos(half), v[0], v[1], v[2]);
}

Rotation random_rotation(Random& random) {  // Shoemake 1992
  const double first = random.uniform(0, 2 * std::numbers::pi);
  const double second = random.uniform(0, 2 * std::numbers::pi);
  const double share = random.uniform(0, 1);
  const double r = std::sqrt(1 - share);
  const double s = std::sqrt(share);
  return of_quaternion(r * std::sin(first), r * std::cos(first), s * std::sin(second), s * std::cos(second));
}

Mesh shifted(Mesh mesh, const Vertex& by) {
  for (Vertex& v : mesh.vertices)
    for (std::size_t k = 0; k < 3; ++k) v[k] += by[k];
  return mesh;
}

Mesh scaled(Mesh mesh, double factor) {
  for (Vertex& v : mesh.vertices) v = scaled(v, factor);
  return mesh;
}

Mesh rotated(Mesh mesh, const Rotation& rotation) {
  for (Vertex& v : mesh.vertices) v = {dot(rotation[0], v), dot(rotation[1], v), dot(rotation[2], v)};
  return mesh;
}

Mesh turned_copy(const Mesh& mesh) {
  Vertex lower = mesh.vertices.front();
  Vertex upper = lower;
  for (const Vertex& v : mesh.vertices)
    for (std::size_t k = 0; k < 3; ++k) {
      lower[k] = std::min(lower[k], v[k]);
      upper[k] = std::max(upper[k], v[k]);
    }
  Vertex to_middle{};
  Vertex diagonal{};
  for (std::size_t k = 0; k < 3; ++k) {
    to_middle[k] = -(lower[k] + upper[k]) / 2;
    diagonal[k] = upper[k] - lower[k];
  }
  const Vertex direction = {1, 0.7, 0.4};
  Vertex back = scaled(direction, 0.1 * std::sqrt(dot(diagonal, diagonal) / dot(direction, direction)));
  for (std::size_t k = 0; k < 3; ++k) back[k] -= to_middle[k];
  return shifted(rotated(shifted(mesh, to_middle), rotation({1, 2, 3}, 30)), back);
}

}  // namespace bench
