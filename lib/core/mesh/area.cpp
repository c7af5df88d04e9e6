#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/exact/big_integer.h"
#include "core/exact/compensated_sum.h"
#include "core/exact/double_double.h"
#include "core/exact/scaled_root.h"
#include "core/exact/vector.h"
#include "core/mesh/closed_volume.h"
#include "core/mesh/split_vertices.h"
#include "strata/measure.h"

namespace strata {
namespace {

using LongVector = std::array<long double, 3>;

LongVector difference(const Vertex& a, const Vertex& b) {
  using Real = long double;
  return {Real(a[0]) - b[0], Real(a[1]) - b[1], Real(a[2]) - b[2]};
}

long double squared_length(const LongVector& u) { return u[0] * u[0] + u[1] * u[1] + u[2] * u[2]; }

/// The square root of q >= 0, truncated to at least 64 bits and then rounded.
long double square_root(const Rational& q) {
  if (q == 0) return 0;
  const long k = (130 - binary_size(q)) / 2;  // q 4^k has about 130 bits
  const Integer root = scaled_root(q, k);
  return std::ldexp(to_nearest_long_double(root), static_cast<int>(-k));
}

long double exact_double_area(ExactMeshView mesh, const Triangle& t) {
  const RationalPoint a = mesh.position(t[0]);
  const RationalPoint normal = cross(minus(mesh.position(t[1]), a), minus(mesh.position(t[2]), a));
  return square_root(dot(normal, normal));
}

/// Twice the area of a triangle of doubles whose angle at `a` is between 30 and 150 degrees; negative for others, and
/// where squares are beyond the range of doubles. With e = 2^-53, components of the sides u and v are off by e of
/// themselves, products of two by 3 e, and the cross product by (3 sqrt(2) |u||v| + |u x v|) e, which is below
/// 9.5 e |u x v|. With square and root the area is off by less than 12 e of itself.
double plain_double_area(const Vertex& a, const Vertex& b, const Vertex& c) {
  const Vertex u = minus(b, a), v = minus(c, a), normal = cross(u, v);
  const double squared = dot(normal, normal), uu = dot(u, u), vv = dot(v, v);
  constexpr double least = 0x1p-450, most = 0x1p+450;
  const bool is_plain = squared * 4 > uu * vv && std::min(uu, vv) > least && std::max(uu, vv) < most;
  return is_plain ? std::sqrt(squared) : -1;
}

/// |u x v|; negative when cancellation may have lost more than 8 bits. Requires that u and v are off by at most 3
/// halves of a unit in the last place of their lengths. So a component of the cross product is off by at most 4 units
/// of |u||v|, and where |u x v| > |u||v| / 256 by 2^10 of its own, which are half a unit of a double.
long double fast_double_area(const LongVector& u, const LongVector& v) {
  const long double x = u[1] * v[2] - u[2] * v[1], y = u[2] * v[0] - u[0] * v[2], z = u[0] * v[1] - u[1] * v[0];
  const long double squared = x * x + y * y + z * z;
  return squared * 65536 > squared_length(u) * squared_length(v) ? std::sqrt(squared) : -1;
}

/// The same for a triangle of doubles. A difference is off by half a unit.
long double fast_double_area(const Vertex& a, const Vertex& b, const Vertex& c) {
  return fast_double_area(difference(b, a), difference(c, a));
}

/// The same for a triangle with rational vertices. The first sum of each difference is off by half a unit where it is
/// not exact, and is then far larger than the second parts; the last sum by half a unit; and what the parts leave out
/// is below a quarter of a unit, or the answer is negative.
long double fast_double_area(MeshView mesh, const SplitVertices& split, const Triangle& t) {
  const auto side = [&](std::size_t i) {
    LongVector u = difference(mesh.vertices[t[i]], mesh.vertices[t[0]]);
    const Vertex *to = split.low(t[i]), *from = split.low(t[0]);
    for (std::size_t k = 0; k < 3; ++k)
      u[k] += (to != nullptr ? static_cast<long double>((*to)[k]) : 0) - (from != nullptr ? (*from)[k] : 0);
    return u;
  };
  const LongVector u = side(1), v = side(2);
  const long double least = std::ldexp(static_cast<long double>(split.error()), 67);
  if (squared_length(u) < least * least || squared_length(v) < least * least) return -1;
  return fast_double_area(u, v);
}

struct BoundedArea {
  long double value, error;
};

/// The same for any triangle, with a bound on the error, by sums of two doubles that carry such bounds.
BoundedArea bounded_double_area(MeshView mesh, const SplitVertices& split, const Triangle& t) {
  const auto corner = [&](std::size_t i) {
    const Vertex& high = mesh.vertices[t[i]];
    const Vertex* const low = split.low(t[i]);
    std::array<DoubleDouble, 3> point;
    for (std::size_t k = 0; k < 3; ++k)
      point[k] = low != nullptr ? DoubleDouble(high[k], (*low)[k], split.error()) : DoubleDouble(high[k]);
    return point;
  };
  const auto a = corner(0), normal = cross(minus(corner(1), a), minus(corner(2), a));
  const DoubleDouble squared = dot(normal, normal);
  // Roots of numbers that differ by e differ by at most the root of e, and by e over the root of the larger one.
  const long double error = squared.error, area = std::sqrt(std::max<long double>(squared.value, 0));
  return {std::sqrt(std::max<long double>(static_cast<long double>(squared.value) + squared.low, 0)),
          squared.value > 0 ? std::min(std::sqrt(error), error / area) : std::sqrt(error)};
}

/// Twice the area of some triangles, and a bound on the errors of those whose areas are not sure.
struct DoubleArea {
  CompensatedSum value;
  long double error = 0;
};

/// Twice the area. Triangles whose rational corners are too near each other for sums of two doubles are measured in
/// the exact mesh, if there is one. Ranges are divided in the same places for any number of threads, so that roundings
/// are the same.
DoubleArea double_area_of(MeshView mesh, const SplitVertices& split, const ExactMeshView* exact,
                          const Monitor& monitor) {
  const std::span<const Vertex> v = mesh.vertices;
  const auto add = [&](const tbb::blocked_range<std::size_t>& range, DoubleArea sum) {
    monitor.check();
    for (std::size_t f = range.begin(); f != range.end(); ++f) {
      const Triangle& t = mesh.triangles[f];
      const Vertex &a = v[t[0]], &b = v[t[1]], &c = v[t[2]];
      const bool has_low = split.any_low(t);
      long double term = has_low ? -1 : plain_double_area(a, b, c);
      if (term < 0) term = has_low ? fast_double_area(mesh, split, t) : fast_double_area(a, b, c);
      if (term < 0) {
        const BoundedArea bounded = bounded_double_area(mesh, split, t);
        const bool is_sure = bounded.error <= bounded.value * 0x1p-56L;
        term = is_sure || exact == nullptr ? bounded.value : exact_double_area(*exact, t);
        if (!is_sure && exact == nullptr) sum.error += bounded.error;
      }
      sum.value.add(term);
    }
    return sum;
  };
  const auto join = [](DoubleArea a, const DoubleArea& b) {
    a.value.add(b.value);
    a.error += b.error;
    return a;
  };
  const tbb::blocked_range<std::size_t> all(0, mesh.triangles.size(), 1 << 13);
  return tbb::parallel_deterministic_reduce(all, DoubleArea{}, add, join);
}

double area(const DoubleArea& twice) { return static_cast<double>(twice.value.value() / 2); }

}  // namespace

// The errors of triangles that are thinner than two doubles tell matter only where nearly all are so thin.
std::optional<double> decided_area(MeshView mesh, const SplitVertices& split, const Monitor& monitor) {
  const DoubleArea total = double_area_of(mesh, split, nullptr, monitor);
  return total.error <= total.value.value() * 0x1p-56L ? std::optional(area(total)) : std::nullopt;
}

double area_of(ExactMeshView mesh, const Monitor& monitor) {
  const SplitVertices split(mesh);
  if (const auto decided = decided_area(mesh.mesh, split, monitor)) return *decided;
  return area(double_area_of(mesh.mesh, split, &mesh, monitor));
}

double area(const ExactMesh& mesh) { return area_of(mesh, {}); }

}  // namespace strata
