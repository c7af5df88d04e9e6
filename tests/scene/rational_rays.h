#pragma once
#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "strata/mesh.h"
#include "strata/rational.h"
#include "support/random.h"

/// The slow and plain answers: every triangle, in rationals.
namespace strata::test {

using RationalVector = std::array<Rational, 3>;

inline RationalVector minus(const RationalVector& a, const RationalVector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline RationalVector cross(const RationalVector& u, const RationalVector& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}
inline Rational dot(const RationalVector& u, const RationalVector& v) {
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}
inline RationalPoint rational(const Vertex& p) { return {to_rational(p[0]), to_rational(p[1]), to_rational(p[2])}; }

using RationalTriangle = std::array<RationalPoint, 3>;

inline std::vector<RationalTriangle> triangles_of(const ExactMesh& mesh) {
  std::vector<RationalTriangle> list;
  for (const Triangle& t : mesh.mesh.triangles)
    list.push_back({mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2])});
  return list;
}

inline bool is_on(const RationalTriangle& t, const RationalPoint& q) {
  const RationalVector n = cross(minus(t[1], t[0]), minus(t[2], t[0]));
  if (dot(n, minus(q, t[0])) != 0) return false;
  for (std::size_t i = 0; i < 3; ++i)
    if (dot(n, cross(minus(t[(i + 1) % 3], t[i]), minus(q, t[i]))) < 0) return false;
  return true;
}

/// A line meets a triangle inside, at q + t * direction.
struct RationalHit {
  Rational t;
  bool leaves = false;  ///< through the face to its outer side
};

enum class RayMeets { nothing, inside, rim_or_plane };

inline RayMeets meet(const RationalTriangle& f, const RationalPoint& q, const RationalVector& d, RationalHit& hit) {
  const RationalVector n = cross(minus(f[1], f[0]), minus(f[2], f[0]));
  const Rational along = dot(n, d);
  int left = 0, right = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Rational s = dot(d, cross(minus(f[i], q), minus(f[(i + 1) % 3], q)));
    left += s > 0;
    right += s < 0;
  }
  if (left > 0 && right > 0) return RayMeets::nothing;
  if (left + right < 3 || along == 0) return RayMeets::rim_or_plane;
  hit = {dot(n, minus(f[0], q)) / along, along > 0};
  return RayMeets::inside;
}

/// Winding number of the triangles about q, which is on none of them, by a ray in general position.
inline int winding_number(const std::vector<RationalTriangle>& triangles, const RationalPoint& q, Random& random) {
  while (true) {
    const RationalVector d{random.between(-1000, 1000), random.between(-1000, 1000), random.between(-1000, 1000)};
    int sum = 0;
    bool general = true;
    for (const RationalTriangle& f : triangles) {
      RationalHit hit;
      const RayMeets m = meet(f, q, d, hit);
      general = general && m != RayMeets::rim_or_plane;
      if (m == RayMeets::inside && hit.t > 0) sum += hit.leaves ? 1 : -1;
    }
    if (general) return sum;
  }
}

}  // namespace strata::test
