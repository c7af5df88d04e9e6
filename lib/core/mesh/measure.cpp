#include "strata/measure.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <cmath>
#include <utility>
#include <vector>

#include "core/exact/big_integer.h"
#include "core/exact/pairwise_sum.h"
#include "core/exact/scaled_root.h"
#include "core/mesh/lattice_sum.h"
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

using Range = tbb::blocked_range<std::size_t>;
constexpr std::size_t grain = 1 << 13;

/// Six times the volume of some triangles: most are on a lattice, others consist of doubles or have rational vertices.
class VolumeSum {
 public:
  VolumeSum(ExactMeshView mesh, const std::vector<bool>& is_exact, double largest)
      : mesh_(mesh), is_exact_(is_exact), largest_(largest), lattice_(largest) {}
  VolumeSum(VolumeSum& other, tbb::split) : VolumeSum(other.mesh_, other.is_exact_, other.largest_) {}

  void operator()(const Range& range) {
    for (std::size_t f = range.begin(); f != range.end(); ++f) add(mesh_.mesh.triangles[f]);
  }
  void join(VolumeSum& other) {
    lattice_.add(other.lattice_);
    doubles_.add(other.doubles_);
    rationals_.add(other.rationals_);
  }
  [[nodiscard]] Rational value() const { return lattice_.value() + doubles_.value() + rationals_.value(); }

 private:
  void add(const Triangle& t) {
    const auto& v = mesh_.mesh.vertices;
    if (any_exact(is_exact_, t))
      rationals_.add(dot(mesh_.position(t[0]), cross(mesh_.position(t[1]), mesh_.position(t[2]))));
    else if (!lattice_.add_determinant(v[t[0]], v[t[1]], v[t[2]]))
      doubles_.add_determinant(v[t[0]], v[t[1]], v[t[2]]);
  }

  ExactMeshView mesh_;
  const std::vector<bool>& is_exact_;
  double largest_;
  LatticeSum lattice_;
  ProductSum doubles_;
  PairwiseSum rationals_;
};

/// A sum with what its roundings lost (Neumaier 1974).
struct CompensatedSum {
  long double sum = 0, lost = 0;

  void add(long double term) {
    const long double next = sum + term;
    lost += sum >= term ? (sum - next) + term : (term - next) + sum;
    sum = next;
  }
};

}  // namespace

Rational volume(ExactMeshView mesh) {
  const std::vector<bool> is_exact = exact_flags(mesh);
  VolumeSum sum(mesh, is_exact, largest_coordinate(mesh.mesh.vertices));
  tbb::parallel_reduce(Range(0, mesh.mesh.triangles.size(), grain), sum);
  return sum.value() / 6;
}

// Ranges are divided in the same places for any number of threads, so that roundings are the same.
double area(const ExactMesh& mesh) {
  const std::vector<bool> is_exact = exact_flags(mesh);
  const auto& v = mesh.mesh.vertices;
  const auto add = [&](const Range& range, CompensatedSum sum) {
    for (std::size_t f = range.begin(); f != range.end(); ++f) {
      const Triangle& t = mesh.mesh.triangles[f];
      long double term = any_exact(is_exact, t) ? -1 : fast_double_area(v[t[0]], v[t[1]], v[t[2]]);
      if (term < 0) term = exact_double_area(mesh, t);
      sum.add(term);
    }
    return sum;
  };
  const auto join = [](CompensatedSum a, const CompensatedSum& b) {
    a.add(b.sum);
    a.lost += b.lost;
    return a;
  };
  const CompensatedSum total =
      tbb::parallel_deterministic_reduce(Range(0, mesh.mesh.triangles.size(), grain), CompensatedSum{}, add, join);
  return static_cast<double>((total.sum + total.lost) / 2);
}

}  // namespace strata
