#include "strata/measure.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "core/exact/big_integer.h"
#include "core/exact/double_double.h"
#include "core/exact/pairwise_sum.h"
#include "core/exact/scaled_root.h"
#include "core/exact/vector.h"
#include "core/mesh/closed_volume.h"
#include "core/mesh/lattice_sum.h"
#include "core/mesh/product_sum.h"
#include "core/mesh/split_vertices.h"

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

/// |u x v|; negative when cancellation may have lost more than 8 bits. Requires that u and v are off by at most 3
/// halves of a unit in the last place of their lengths. So a component of the cross product is off by at most 4 units
/// of |u||v|. 8 of the 11 bits beyond a double's remain where |u x v| > |u||v| / 256.
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

using Range = tbb::blocked_range<std::size_t>;
constexpr std::size_t triangles_at_once = 1 << 13;

/// Six times the volume of some triangles of doubles, most of which are on a lattice.
class DoublesSum {
 public:
  explicit DoublesSum(double largest) : lattice_(largest) {}

  void add_determinant(const Vertex& a, const Vertex& b, const Vertex& c) {
    if (!lattice_.add_determinant(a, b, c)) rest_.add_determinant(a, b, c);
  }
  void add(const DoublesSum& other) {
    lattice_.add(other.lattice_);
    rest_.add(other.rest_);
  }
  [[nodiscard]] Rational value() const { return lattice_.value() + rest_.value(); }

 private:
  LatticeSum lattice_;
  ProductSum rest_;
};

/// Six times the volume of some triangles.
class VolumeSum {
 public:
  VolumeSum(ExactMeshView mesh, const std::vector<bool>& is_exact, double largest, const Monitor& monitor)
      : mesh_(mesh), is_exact_(is_exact), largest_(largest), monitor_(monitor), doubles_(largest) {}
  VolumeSum(VolumeSum& other, tbb::split) : VolumeSum(other.mesh_, other.is_exact_, other.largest_, other.monitor_) {}

  void operator()(const Range& range) {
    monitor_.check();
    for (std::size_t f = range.begin(); f != range.end(); ++f) add(mesh_.mesh.triangles[f]);
  }
  void join(VolumeSum& other) {
    doubles_.add(other.doubles_);
    rationals_.add(other.rationals_);
  }
  [[nodiscard]] Rational value() const { return doubles_.value() + rationals_.value(); }

 private:
  void add(const Triangle& t) {
    const auto& v = mesh_.mesh.vertices;
    if (!is_exact_.empty() && (is_exact_[t[0]] || is_exact_[t[1]] || is_exact_[t[2]]))
      rationals_.add(dot(mesh_.position(t[0]), cross(mesh_.position(t[1]), mesh_.position(t[2]))));
    else
      doubles_.add_determinant(v[t[0]], v[t[1]], v[t[2]]);
  }

  ExactMeshView mesh_;
  const std::vector<bool>& is_exact_;  ///< empty when all vertices are doubles
  double largest_;
  const Monitor& monitor_;
  DoublesSum doubles_;
  PairwiseSum rationals_;
};

/// Six times the volume of some triangles whose vertices are sums of two doubles: a determinant of sums is the sum of
/// the determinants of all choices of parts.
class SplitVolumeSum {
 public:
  SplitVolumeSum(MeshView mesh, const SplitVertices& split, double largest, const Monitor& monitor)
      : mesh_(mesh), split_(split), largest_(largest), monitor_(monitor), sum_(largest) {}
  SplitVolumeSum(SplitVolumeSum& other, tbb::split)
      : SplitVolumeSum(other.mesh_, other.split_, other.largest_, other.monitor_) {}

  void operator()(const Range& range) {
    monitor_.check();
    for (std::size_t f = range.begin(); f != range.end(); ++f) add(mesh_.triangles[f]);
  }
  void join(SplitVolumeSum& other) {
    sum_.add(other.sum_);
    rounded_triangles_ += other.rounded_triangles_;
  }
  [[nodiscard]] Rational value() const { return sum_.value(); }
  [[nodiscard]] std::uint64_t rounded_triangles() const { return rounded_triangles_; }  ///< with a rational vertex

 private:
  void add(const Triangle& t) {
    std::array<std::array<const Vertex*, 2>, 3> parts;
    for (std::size_t i = 0; i < 3; ++i) parts[i] = {&mesh_.vertices[t[i]], split_.low(t[i])};
    if (split_.any_low(t)) ++rounded_triangles_;
    for (const Vertex* a : parts[0])
      for (const Vertex* b : parts[1])
        for (const Vertex* c : parts[2])
          if (a != nullptr && b != nullptr && c != nullptr) sum_.add_determinant(*a, *b, *c);
  }

  MeshView mesh_;
  const SplitVertices& split_;
  double largest_;
  const Monitor& monitor_;
  DoublesSum sum_;
  std::uint64_t rounded_triangles_ = 0;
};

/// Six times the volume between some triangles and the plane z = 0.
class PrismSum {
 public:
  PrismSum(MeshView mesh, double largest, const Monitor& monitor)
      : mesh_(mesh), largest_(largest), monitor_(monitor), sum_(largest) {}
  PrismSum(PrismSum& other, tbb::split) : PrismSum(other.mesh_, other.largest_, other.monitor_) {}

  void operator()(const Range& range) {
    monitor_.check();
    for (std::size_t f = range.begin(); f != range.end() && is_complete_; ++f) {
      const Triangle& t = mesh_.triangles[f];
      is_complete_ = sum_.add_prism(mesh_.vertices[t[0]], mesh_.vertices[t[1]], mesh_.vertices[t[2]]);
    }
  }
  void join(const PrismSum& other) {
    sum_.add(other.sum_);
    is_complete_ = is_complete_ && other.is_complete_;
  }
  [[nodiscard]] bool is_complete() const { return is_complete_; }  ///< all coordinates are on the lattice
  [[nodiscard]] Rational value() const { return sum_.value(); }

 private:
  MeshView mesh_;
  double largest_;
  const Monitor& monitor_;
  LatticeSum sum_;
  bool is_complete_ = true;
};

/// A sum with what its roundings lost (Neumaier 1974), and a bound on the errors of its terms.
struct CompensatedSum {
  long double sum = 0, lost = 0, error = 0;

  void add(long double term) {
    const long double next = sum + term;
    lost += sum >= term ? (sum - next) + term : (term - next) + sum;
    sum = next;
  }
};

/// Twice the area. Triangles whose rational corners are too near each other for sums of two doubles are measured in
/// the exact mesh, if there is one. Ranges are divided in the same places for any number of threads, so that roundings
/// are the same.
CompensatedSum double_area_of(MeshView mesh, const SplitVertices& split, const ExactMeshView* exact,
                              const Monitor& monitor) {
  const std::span<const Vertex> v = mesh.vertices;
  const auto add = [&](const Range& range, CompensatedSum sum) {
    monitor.check();
    for (std::size_t f = range.begin(); f != range.end(); ++f) {
      const Triangle& t = mesh.triangles[f];
      long double term =
          split.any_low(t) ? fast_double_area(mesh, split, t) : fast_double_area(v[t[0]], v[t[1]], v[t[2]]);
      if (term < 0) {
        const BoundedArea bounded = bounded_double_area(mesh, split, t);
        const bool is_sure = bounded.error <= bounded.value * 0x1p-56L;
        term = is_sure || exact == nullptr ? bounded.value : exact_double_area(*exact, t);
        if (!is_sure && exact == nullptr) sum.error += bounded.error;
      }
      sum.add(term);
    }
    return sum;
  };
  const auto join = [](CompensatedSum a, const CompensatedSum& b) {
    a.add(b.sum);
    a.lost += b.lost;
    a.error += b.error;
    return a;
  };
  return tbb::parallel_deterministic_reduce(Range(0, mesh.triangles.size(), triangles_at_once), CompensatedSum{}, add,
                                            join);
}

Rational volume_of(ExactMeshView mesh, const Monitor& monitor) {
  std::vector<bool> is_exact(mesh.exact.empty() ? 0 : mesh.mesh.vertices.size(), false);
  for (const ExactVertex& e : mesh.exact) is_exact[e.vertex] = true;
  VolumeSum sum(mesh, is_exact, largest_coordinate(mesh.mesh.vertices), monitor);
  tbb::parallel_reduce(Range(0, mesh.mesh.triangles.size(), triangles_at_once), sum);
  return sum.value() / 6;
}

double nearest_volume_of(ExactMeshView mesh, const Monitor& monitor) {
  if (const auto volume = decided_volume(mesh.mesh, SplitVertices(mesh), monitor)) return *volume;
  return to_nearest_double(volume_of(mesh, monitor));
}

double area(const CompensatedSum& twice) { return static_cast<double>((twice.sum + twice.lost) / 2); }

}  // namespace

// If coordinates are below L in magnitude and change by at most e, a determinant, of six products, changes by at most
// 6 ((L + e)^3 - L^3) <= 18 (L + e)^2 e.
std::optional<double> decided_volume(MeshView mesh, const SplitVertices& split, const Monitor& monitor) {
  const double largest = largest_coordinate(mesh.vertices);
  SplitVolumeSum sum(mesh, split, largest, monitor);
  tbb::parallel_reduce(Range(0, mesh.triangles.size(), triangles_at_once), sum);
  const Rational error = to_rational(split.error()), size = 2 * to_rational(largest) + 2 * error;
  const Rational bound = 18 * Rational(sum.rounded_triangles()) * size * size * error;
  const double lower = to_nearest_double(Rational((sum.value() - bound) / 6));
  const double upper = to_nearest_double(Rational((sum.value() + bound) / 6));
  return lower == upper ? std::optional(lower) : std::nullopt;
}

// The errors of triangles that are thinner than two doubles tell matter only where nearly all are so thin.
std::optional<double> decided_area(MeshView mesh, const SplitVertices& split, const Monitor& monitor) {
  const CompensatedSum total = double_area_of(mesh, split, nullptr, monitor);
  return total.error <= total.sum * 0x1p-56L ? std::optional(area(total)) : std::nullopt;
}

Rational volume(ExactMeshView mesh) { return volume_of(mesh, {}); }
double nearest_volume(ExactMeshView mesh) { return nearest_volume_of(mesh, {}); }
double area(const ExactMesh& mesh) { return area_of(mesh, {}); }

ClosedVolume volume_of_closed(ExactMeshView mesh, const Monitor& monitor) {
  if (mesh.exact.size() > most_rational_vertices) return {nearest_volume_of(mesh, monitor), std::nullopt};
  if (!mesh.exact.empty()) {
    Rational exact = volume_of(mesh, monitor);
    const double nearest = to_nearest_double(exact);
    return {nearest, std::move(exact)};
  }
  PrismSum prisms(mesh.mesh, largest_coordinate(mesh.mesh.vertices), monitor);
  tbb::parallel_reduce(Range(0, mesh.mesh.triangles.size(), triangles_at_once), prisms);
  Rational exact = prisms.is_complete() ? Rational(prisms.value() / 6) : volume_of(mesh, monitor);
  const double nearest = to_nearest_double(exact);
  return {nearest, std::move(exact)};
}

double area_of(ExactMeshView mesh, const Monitor& monitor) {
  const SplitVertices split(mesh);
  if (const auto decided = decided_area(mesh.mesh, split, monitor)) return *decided;
  return area(double_area_of(mesh.mesh, split, &mesh, monitor));
}

}  // namespace strata
