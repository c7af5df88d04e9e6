#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "core/exact/compensated_sum.h"
#include "core/exact/pairwise_sum.h"
#include "core/exact/vector.h"
#include "core/mesh/closed_volume.h"
#include "core/mesh/lattice_sum.h"
#include "core/mesh/product_sum.h"
#include "core/mesh/split_vertices.h"
#include "strata/measure.h"

namespace strata {
namespace {

using Range = tbb::blocked_range<std::size_t>;
constexpr std::size_t triangles_at_once = 1 << 13;

/// Six times the volume of some triangles of doubles, most of which are on a lattice. With p, q and r, the corners of
/// another one truncated to the lattice,
///   det(a, b, c) = det(p, q, r) + det(a - p, b, c) + det(p, b - q, c) + det(p, q, c - r).
/// Each coordinate that is not on the lattice, often a single one, leaves two products.
class DoublesSum {
 public:
  explicit DoublesSum(double largest) : lattice_(largest) {}

  void add_determinant(const Vertex& a, const Vertex& b, const Vertex& c) {
    if (lattice_.add_determinant(a, b, c)) return;
    const Vertex p = lattice_.truncated(a), q = lattice_.truncated(b), r = lattice_.truncated(c);
    if (differences(a, p) + differences(b, q) + differences(c, r) > 2) return rest_.add_determinant(a, b, c);
    static_cast<void>(lattice_.add_determinant(p, q, r));
    rest_.add_determinant(minus(a, p), b, c);
    rest_.add_determinant(p, minus(b, q), c);
    rest_.add_determinant(p, q, minus(c, r));
  }
  void add(const DoublesSum& other) {
    lattice_.add(other.lattice_);
    rest_.add(other.rest_);
  }
  [[nodiscard]] Rational value() const { return lattice_.value() + rest_.value(); }

 private:
  /// In how many coordinates.
  static int differences(const Vertex& a, const Vertex& p) {
    return static_cast<int>(a[0] != p[0]) + static_cast<int>(a[1] != p[1]) + static_cast<int>(a[2] != p[2]);
  }

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

/// Six times the volume of some triangles whose vertices are sums of two doubles, with a bound on the error. Each
/// corner is a point of a lattice and a rest. The determinants of the former are exact, and so are the prisms that have
/// the same sum over a closed chain; to these the terms of first order in the rests are added, in doubles: what is
/// rounded depends on the order of the triangles.
class FirstOrderSum {
 public:
  FirstOrderSum(MeshView mesh, const SplitVertices& split, Closed closed, double largest, const Monitor& monitor)
      : mesh_(mesh), split_(split), closed_(closed), largest_(largest), monitor_(monitor), lattice_(largest) {}
  FirstOrderSum(FirstOrderSum& other, tbb::split)
      : FirstOrderSum(other.mesh_, other.split_, other.closed_, other.largest_, other.monitor_) {}

  void operator()(const Range& range) {
    monitor_.check();
    for (std::size_t f = range.begin(); f != range.end(); ++f) add(mesh_.triangles[f]);
  }
  void join(FirstOrderSum& other) {
    lattice_.add(other.lattice_);
    first_order_.add(other.first_order_);
    largest_rest_ = std::max(largest_rest_, other.largest_rest_);
    inexact_triangles_ += other.inexact_triangles_;
  }

  /// False where a rest is as large as the coordinates: then there is no bound. The rests of nearest doubles are small.
  [[nodiscard]] bool is_bounded() const { return largest_rest_ < coordinates_below; }
  /// The exact sum where all corners are on the lattice and three doubles.
  [[nodiscard]] Rational value() const {
    const long double first_order = first_order_.value();
    const auto high = static_cast<double>(first_order), low = static_cast<double>(first_order - high);
    return lattice_.value() + (to_rational(high) + to_rational(low)) * unit_volume();
  }

  /// How much the value is off, if it is bounded. In units of the lattice, let points be below L and rests at most D. A
  /// determinant with one rest has six products, of at most D L^2 each. Of these, 18 for a triangle, each is off by the
  /// rounding of the rest and by seven more. The sum of n triangles is off by 18 n D L^2 times 2^-53 and n^2 2^-106.
  /// What is left out is below 18 L D^2 + 6 D^3.
  [[nodiscard]] Rational error() const {
    const double n = static_cast<double>(inexact_triangles_), point = coordinates_below, rest = largest_rest_;
    const double rounding = (200 + n * n * 0x1p-48) * 0x1p-53;
    const double of_triangle = (rounding * point + 24 * rest) * point * rest;
    return to_rational(n * (of_triangle * 1.01 + 0x1p-900)) * unit_volume();
  }
  [[nodiscard]] std::uint64_t inexact_triangles() const { return inexact_triangles_; }  ///< those with a rest

 private:
  static constexpr double coordinates_below = 0x1p+61;  ///< in units of the lattice
  using Corners = std::array<Vertex, 3>;

  void add(const Triangle& t) {
    Corners points{mesh_.vertices[t[0]], mesh_.vertices[t[1]], mesh_.vertices[t[2]]}, rests{};
    const bool is_on_lattice = add_exactly(points);
    if (is_on_lattice && !split_.any_low(t)) return;
    if (!is_on_lattice) {
      for (std::size_t i = 0; i < 3; ++i) {
        const Vertex point = lattice_.truncated(points[i]);
        rests[i] = minus(points[i], point);
        points[i] = point;
      }
      static_cast<void>(add_exactly(points));
    }
    for (std::size_t i = 0; i < 3; ++i)
      if (const Vertex* const low = split_.low(t[i]); low != nullptr)
        for (std::size_t k = 0; k < 3; ++k) rests[i][k] += (*low)[k];
    add_first_order(points, rests);
  }

  /// Returns false, and adds nothing, where a corner is not on the lattice.
  [[nodiscard]] bool add_exactly(const Corners& points) {
    const auto& [a, b, c] = points;
    return closed_ == Closed::known ? lattice_.add_prism(a, b, c) : lattice_.add_determinant(a, b, c);
  }

  void add_first_order(Corners points, Corners rests) {
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        points[i][k] *= lattice_.scale();
        rests[i][k] *= lattice_.scale();
        largest_rest_ = std::max(largest_rest_, std::abs(rests[i][k]));
      }
    first_order_.add(dot(rests[0], cross(points[1], points[2])) + dot(rests[1], cross(points[2], points[0])) +
                     dot(rests[2], cross(points[0], points[1])));
    ++inexact_triangles_;
  }

  [[nodiscard]] Rational unit_volume() const {
    const Rational unit = to_rational(lattice_.unit());
    return unit * unit * unit;
  }

  MeshView mesh_;
  const SplitVertices& split_;
  Closed closed_;
  double largest_;
  const Monitor& monitor_;
  LatticeSum lattice_;
  CompensatedSum first_order_;  ///< in units of the lattice
  double largest_rest_ = 0;     ///< in the same
  std::uint64_t inexact_triangles_ = 0;
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

Rational volume_of(ExactMeshView mesh, const Monitor& monitor) {
  std::vector<bool> is_exact(mesh.exact.empty() ? 0 : mesh.mesh.vertices.size(), false);
  for (const ExactVertex& e : mesh.exact) is_exact[e.vertex] = true;
  VolumeSum sum(mesh, is_exact, largest_coordinate(mesh.mesh.vertices), monitor);
  tbb::parallel_reduce(Range(0, mesh.mesh.triangles.size(), triangles_at_once), sum);
  return sum.value() / 6;
}

double nearest_volume_of(ExactMeshView mesh, Closed closed, const Monitor& monitor) {
  if (const auto volume = decided_volume(mesh.mesh, SplitVertices(mesh), closed, monitor)) return *volume;
  return to_nearest_double(volume_of(mesh, monitor));
}

}  // namespace

// If coordinates are below L in magnitude and change by at most e, a determinant, of six products, changes by at most
// 6 ((L + e)^3 - L^3) <= 18 (L + e)^2 e.
std::optional<double> decided_volume(MeshView mesh, const SplitVertices& split, Closed closed, const Monitor& monitor) {
  const double largest = largest_coordinate(mesh.vertices);
  FirstOrderSum sum(mesh, split, closed, largest, monitor);
  tbb::parallel_deterministic_reduce(Range(0, mesh.triangles.size(), triangles_at_once), sum);
  if (!sum.is_bounded()) return std::nullopt;
  const Rational error = to_rational(split.error()), size = 2 * to_rational(largest) + 2 * error;
  const Rational bound = 18 * Rational(sum.inexact_triangles()) * size * size * error + sum.error();
  const double lower = to_nearest_double(Rational((sum.value() - bound) / 6));
  const double upper = to_nearest_double(Rational((sum.value() + bound) / 6));
  return lower == upper ? std::optional(lower) : std::nullopt;
}

Rational volume(ExactMeshView mesh) { return volume_of(mesh, {}); }
double nearest_volume(ExactMeshView mesh) { return nearest_volume_of(mesh, Closed::unknown, {}); }

ClosedVolume volume_of_closed(ExactMeshView mesh, const Monitor& monitor) {
  if (mesh.exact.size() > most_rational_vertices)
    return {nearest_volume_of(mesh, Closed::known, monitor), std::nullopt};
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

}  // namespace strata
