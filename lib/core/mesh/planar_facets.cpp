#include "core/mesh/planar_facets.h"

#include <optional>
#include <stdexcept>
#include <unordered_set>
#include <utility>

#include "core/exact/big_integer.h"

namespace strata::facets {
namespace {

struct HashCoefficients {
  std::size_t operator()(const Coefficients& plane) const {
    std::uint64_t h = 0;
    for (const Integer& c : plane) {
      h = (h ^ (limb_or_zero(limbs_of(c), 0) + (c.sign() < 0))) * 0x9E3779B97F4A7C15U;
      h ^= h >> 29;
    }
    return h;
  }
};

/// A plane in coprime integers, the first nonzero coefficient positive. `flipped` if this required a change of sign.
struct Unoriented {
  Coefficients plane;
  bool flipped;
};

/// Nullopt when the normal vanishes.
std::optional<Unoriented> unoriented(Coefficients plane) {
  int leading = 0;
  while (leading < 3 && plane[leading] == 0) ++leading;
  if (leading == 3) return std::nullopt;
  Integer divisor = gcd(gcd(plane[0], plane[1]), gcd(plane[2], plane[3]));
  const bool flipped = plane[leading] < 0;
  if (flipped) divisor = -divisor;
  if (divisor != 1) {
    for (Integer& c : plane) c = exact_quotient(c, divisor);
  }
  return Unoriented{std::move(plane), flipped};
}

/// Groups facets by their planes.
class PlaneIndex {
 public:
  PlaneIndex() = default;
  PlaneIndex(const PlaneIndex&) = delete;
  PlaneIndex& operator=(const PlaneIndex&) = delete;

  PlaneFacets& facets_in(Unoriented&& key) {
    auto found = numbers_.find(key.plane);
    if (found == numbers_.end()) {
      planes_.push_back({std::move(key.plane), {}, false, false});
      found = numbers_.insert(planes_.size() - 1).first;
    }
    PlaneFacets& facets = planes_[*found];
    (key.flipped ? facets.has_back : facets.has_front) = true;
    return facets;
  }
  /// In the order in which they were first asked for.
  [[nodiscard]] std::vector<PlaneFacets> take() && { return std::move(planes_); }

 private:
  /// A plane of the list stands for its coefficients, which are kept there alone: there may be millions.
  struct Hash {
    using is_transparent = void;  // NOLINT(readability-identifier-naming): the standard's name
    const std::vector<PlaneFacets>& planes;
    std::size_t operator()(const Coefficients& plane) const { return HashCoefficients()(plane); }
    std::size_t operator()(std::size_t n) const { return HashCoefficients()(planes[n].plane); }
  };
  struct Equal {
    using is_transparent = void;  // NOLINT(readability-identifier-naming): the standard's name
    const std::vector<PlaneFacets>& planes;
    bool operator()(std::size_t n, std::size_t m) const { return n == m; }
    bool operator()(const Coefficients& plane, std::size_t n) const { return plane == planes[n].plane; }
    bool operator()(std::size_t n, const Coefficients& plane) const { return plane == planes[n].plane; }
  };

  std::vector<PlaneFacets> planes_;
  std::unordered_set<std::size_t, Hash, Equal> numbers_{0, Hash{planes_}, Equal{planes_}};
};

/// (q - p) times a positive number.
std::array<Integer, 3> direction(const HPoint<Integer>& p, const HPoint<Integer>& q) {
  std::array<Integer, 3> d;
  const bool same = p.w == q.w;
  for (int i = 0; i < 3; ++i) d[i] = same ? Integer(q[i] - p[i]) : Integer(q[i] * p.w - p[i] * q.w);
  return d;
}

Coefficients plane_through(const HPoint<Integer>& a, const HPoint<Integer>& b, const HPoint<Integer>& c) {
  const std::array<Integer, 3> u = direction(a, b);
  const std::array<Integer, 3> v = direction(a, c);
  Coefficients plane{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0], 0};
  for (int i = 0; i < 3; ++i) plane[3] += plane[i] * a[i];
  if (a.w != 1) {
    for (int i = 0; i < 3; ++i) plane[i] *= a.w;
  }
  return plane;
}

/// Points of the vertices that triangles use. The others remain zero, whatever their coordinates are.
std::vector<HPoint<Integer>> points_of(const ExactMesh& mesh) {
  std::vector<Vertex> used(mesh.mesh.vertices.size(), Vertex{0, 0, 0});
  for (const Triangle& t : mesh.mesh.triangles) {
    for (const std::uint32_t v : t) used[v] = mesh.mesh.vertices[v];
  }
  std::vector<HPoint<Integer>> points = homogeneous(used);
  for (const ExactVertex& e : mesh.exact) points[e.vertex] = homogeneous(e.position);
  return points;
}

/// The loops of one facet.
class Loops {
 public:
  Loops(const IndexedFacets& facets, std::size_t first, std::size_t count)
      : facets_(facets), first_(first), count_(count) {}

  [[nodiscard]] std::size_t size() const { return count_; }
  [[nodiscard]] std::span<const std::uint32_t> operator[](std::size_t n) const {
    const std::size_t loop = first_ + n, begin = loop == 0 ? 0 : facets_.loop_ends[loop - 1];
    return std::span(facets_.corners).subspan(begin, facets_.loop_ends[loop] - begin);
  }
  [[nodiscard]] const RationalPoint& point(std::uint32_t corner) const { return facets_.points[corner]; }

 private:
  const IndexedFacets& facets_;
  std::size_t first_, count_;
};

/// Twice the vector area of a facet: the normal from which it is seen counter-clockwise.
RationalPoint vector_area(const Loops& facet) {
  RationalPoint sum{0, 0, 0};
  for (std::size_t n = 0; n < facet.size(); ++n) {
    const auto loop = facet[n];
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const RationalPoint& p = facet.point(loop[i]);
      const RationalPoint& q = facet.point(loop[i + 1 == loop.size() ? 0 : i + 1]);
      for (int k = 0; k < 3; ++k) {
        const int l = (k + 1) % 3, m = (k + 2) % 3;
        sum[k] += p[l] * q[m] - p[m] * q[l];
      }
    }
  }
  return sum;
}

Rational height(const RationalPoint& normal, const RationalPoint& p) {
  return normal[0] * p[0] + normal[1] * p[1] + normal[2] * p[2];
}

/// Nullopt when the area is zero.
std::optional<Unoriented> plane_of(const Loops& facet) {
  const RationalPoint normal = vector_area(facet);
  if (normal == RationalPoint{0, 0, 0}) return std::nullopt;
  const Rational d = height(normal, facet.point(facet[0].front()));
  for (std::size_t n = 0; n < facet.size(); ++n) {
    for (const std::uint32_t corner : facet[n]) {
      if (height(normal, facet.point(corner)) != d)
        throw std::invalid_argument("a facet of a canonical form is not planar");
    }
  }
  Integer common = denominator(d);
  for (const Rational& c : normal) common = lcm(common, denominator(c));
  const auto scaled = [&](const Rational& q) -> Integer { return numerator(q) * (common / denominator(q)); };
  return unoriented({scaled(normal[0]), scaled(normal[1]), scaled(normal[2]), scaled(d)});
}

}  // namespace

FacetsByPlane facets_by_plane(const ExactMesh& mesh, const Monitor& monitor) {
  std::vector<std::uint32_t> name;
  PointTable points(points_of(mesh), name, monitor);
  PlaneIndex index;
  for (const Triangle& t : mesh.mesh.triangles) {
    monitor.check();
    const std::uint32_t a = name[t[0]], b = name[t[1]], c = name[t[2]];
    if (a == b || b == c || c == a) continue;
    auto key = unoriented(plane_through(points[a], points[b], points[c]));
    if (!key) continue;
    std::vector<Side>& sides = index.facets_in(*std::move(key)).sides;
    sides.insert(sides.end(), {{a, b}, {b, c}, {c, a}});
  }
  return {std::move(points), std::move(index).take()};
}

FacetsByPlane facets_by_plane(const IndexedFacets& facets, const Monitor& monitor) {
  std::vector<HPoint<Integer>> all;
  for (const RationalPoint& p : facets.points) {
    monitor.check();
    all.push_back(homogeneous(p));
  }
  std::vector<std::uint32_t> name;
  PointTable points(std::move(all), name, monitor);
  PlaneIndex index;
  std::size_t first = 0;
  for (const std::uint32_t count : facets.facet_loops) {
    monitor.check();
    const Loops facet(facets, first, count);
    first += count;
    auto key = plane_of(facet);
    if (!key) continue;
    std::vector<Side>& sides = index.facets_in(*std::move(key)).sides;
    for (std::size_t n = 0; n < facet.size(); ++n) {
      const auto loop = facet[n];
      for (std::size_t i = 0; i < loop.size(); ++i)
        sides.push_back({name[loop[i]], name[loop[i + 1 == loop.size() ? 0 : i + 1]]});
    }
  }
  return {std::move(points), std::move(index).take()};
}

}  // namespace strata::facets
