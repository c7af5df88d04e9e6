#include "strata/measure.h"

#include <cmath>
#include <utility>
#include <vector>

#include "core/exact/big_integer.h"
#include "core/exact/pairwise_sum.h"
#include "core/exact/scaled_root.h"
#include "core/mesh/product_sum.h"

namespace strata {
namespace {

RationalPoint minus(const RationalPoint& a, const RationalPoint& b) {
  return {Rational(a[0] - b[0]), Rational(a[1] - b[1]), Rational(a[2] - b[2])};
}

RationalPoint cross(const RationalPoint& a, const RationalPoint& b) {
  return {Rational(a[1] * b[2] - a[2] * b[1]), Rational(a[2] * b[0] - a[0] * b[2]),
          Rational(a[0] * b[1] - a[1] * b[0])};
}

Rational dot(const RationalPoint& a, const RationalPoint& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Which vertices have an entry in `exact`; empty when none has.
std::vector<bool> exact_flags(ExactMeshView mesh) {
  std::vector<bool> flags(mesh.exact.empty() ? 0 : mesh.mesh.vertices.size(), false);
  for (const ExactVertex& e : mesh.exact) flags[e.vertex] = true;
  return flags;
}

bool any_exact(const std::vector<bool>& flags, const Triangle& t) {
  return !flags.empty() && (flags[t[0]] || flags[t[1]] || flags[t[2]]);
}

/// The square root of q >= 0, truncated to at least 64 bits and then rounded.
long double square_root(const Rational& q) {
  if (q == 0) return 0;
  const long k = (130 - binary_size(q)) / 2;  // q 4^k has about 130 bits
  const Integer root = scaled_root(q, k);
  return std::ldexp(to_nearest_long_double(root), static_cast<int>(-k));
}

long double exact_double_area(const ExactMesh& mesh, const Triangle& t) {
  const RationalPoint a = mesh.position(t[0]);
  const RationalPoint normal = cross(minus(mesh.position(t[1]), a), minus(mesh.position(t[2]), a));
  return square_root(dot(normal, normal));
}

/// |u x v| for u = b - a, v = c - a; negative when cancellation may have lost more than 8 bits. The relative error of a
/// difference is half a unit. So that of each product is 3 halves, and that of a component of the cross product at most
/// 5 halves of |u||v|. 8 of the 11 bits beyond a double's remain where |u x v| > |u||v| / 256.
long double fast_double_area(const Vertex& a, const Vertex& b, const Vertex& c) {
  using Real = long double;
  const Real ux = Real(b[0]) - a[0], uy = Real(b[1]) - a[1], uz = Real(b[2]) - a[2];
  const Real vx = Real(c[0]) - a[0], vy = Real(c[1]) - a[1], vz = Real(c[2]) - a[2];
  const Real nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
  const Real squared = nx * nx + ny * ny + nz * nz;
  const Real lengths = (ux * ux + uy * uy + uz * uz) * (vx * vx + vy * vy + vz * vz);
  return squared * 65536 > lengths ? std::sqrt(squared) : Real(-1);
}

}  // namespace

Rational volume(ExactMeshView mesh) {
  const std::vector<bool> flags = exact_flags(mesh);
  ProductSum doubles;
  PairwiseSum rationals;
  for (const Triangle& t : mesh.mesh.triangles) {
    if (any_exact(flags, t)) {
      rationals.add(dot(mesh.position(t[0]), cross(mesh.position(t[1]), mesh.position(t[2]))));
    } else {
      doubles.add_determinant(mesh.mesh.vertices[t[0]], mesh.mesh.vertices[t[1]], mesh.mesh.vertices[t[2]]);
    }
  }
  return (doubles.value() + rationals.value()) / 6;
}

double area(const ExactMesh& mesh) {
  const std::vector<bool> flags = exact_flags(mesh);
  long double sum = 0;
  long double lost = 0;  // Neumaier: the rounding errors of `sum`
  for (const Triangle& t : mesh.mesh.triangles) {
    const auto& v = mesh.mesh.vertices;
    long double term = any_exact(flags, t) ? -1 : fast_double_area(v[t[0]], v[t[1]], v[t[2]]);
    if (term < 0) term = exact_double_area(mesh, t);
    const long double next = sum + term;
    lost += sum >= term ? (sum - next) + term : (term - next) + sum;
    sum = next;
  }
  return static_cast<double>((sum + lost) / 2);
}

}  // namespace strata
