#include "strata/bsp/measure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "strata/bsp/determinant.h"

namespace strata::bsp {
namespace {

/// D points of the boundary in an order that looks outwards: with the origin they span a simplex with a sign.
template <int D>
using Simplex = std::array<RationalVector<D>, D>;

/// The boundary in simplices. A point of the line counts as it is where the region ends, and as its opposite where it
/// begins, which needs a sign of its own.
template <int D>
struct SignedSimplex {
  Simplex<D> corners;
  int sign = 1;
};

template <int D>
std::vector<SignedSimplex<D>> simplices(const Partition<D>& region) {
  std::vector<SignedSimplex<D>> result;
  for (const Facet<D>& f : region.boundary()) {
    std::vector<RationalVector<D>> p;
    for (const Corner<D>& c : f.piece.corners) p.push_back(region.table().position(c));
    if constexpr (D == 1) {
      result.push_back({{p[0]}, f.faces_plus ? 1 : -1});
    } else if constexpr (D == 2) {
      if (f.faces_plus) std::swap(p[0], p[1]);
      result.push_back({{p[0], p[1]}, 1});
    } else {
      if (!f.faces_plus) std::reverse(p.begin(), p.end());
      for (std::size_t i = 2; i < p.size(); ++i) result.push_back({{p[0], p[i - 1], p[i]}, 1});
    }
  }
  return result;
}

constexpr int factorial(int n) { return n <= 1 ? 1 : n * factorial(n - 1); }

double length(const std::array<double, 3>& v) { return std::hypot(v[0], v[1], v[2]); }

/// To a double only once differences are taken, so that nothing cancels.
template <int D>
std::array<double, 3> difference(const RationalVector<D>& p, const RationalVector<D>& q) {
  std::array<double, 3> d{};
  for (std::size_t i = 0; i < D; ++i) d[i] = to_nearest_double(p[i] - q[i]);
  return d;
}

double size_of(const Simplex<1>&) { return 1; }
double size_of(const Simplex<2>& s) { return length(difference<2>(s[1], s[0])); }
double size_of(const Simplex<3>& s) {
  std::array<double, 3> normal{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    normal[i] =
        to_nearest_double((s[1][j] - s[0][j]) * (s[2][k] - s[0][k]) - (s[1][k] - s[0][k]) * (s[2][j] - s[0][j]));
  }
  return length(normal) / 2;
}

}  // namespace

template <int D>
std::optional<Rational> size(const Partition<D>& region) {
  if (!region.is_bounded()) return std::nullopt;
  Rational sum = 0;
  for (const SignedSimplex<D>& s : simplices(region)) sum += s.sign * determinant(s.corners);
  return sum / factorial(D);
}

template <int D>
std::optional<RationalVector<D>> barycentre(const Partition<D>& region) {
  if (region.is_empty() || !region.is_bounded()) return std::nullopt;
  Rational total = 0;
  RationalVector<D> sum{};
  for (const SignedSimplex<D>& s : simplices(region)) {
    const Rational weight = s.sign * determinant(s.corners);
    total += weight;
    for (const RationalVector<D>& p : s.corners)
      for (std::size_t i = 0; i < D; ++i) sum[i] += weight * p[i];
  }
  for (Rational& x : sum) x /= total * (D + 1);  // the origin is one more corner of each simplex
  return sum;
}

template <int D>
double boundary_size(const Partition<D>& region) {
  for (const Facet<D>& f : region.boundary())
    if (!f.piece.is_bounded()) return HUGE_VAL;
  double sum = 0;
  for (const SignedSimplex<D>& s : simplices(region)) sum += size_of(s.corners);
  return sum;
}

#define STRATA_INSTANTIATE(D)                                                   \
  template std::optional<Rational> size(const Partition<D>&);                   \
  template std::optional<RationalVector<D>> barycentre<D>(const Partition<D>&); \
  template double boundary_size(const Partition<D>&);
STRATA_INSTANTIATE(1)
STRATA_INSTANTIATE(2)
STRATA_INSTANTIATE(3)
#undef STRATA_INSTANTIATE

}  // namespace strata::bsp
