#include "extensions/contact/nearest_candidates.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/kernel/point.h"
#include "core/kernel/rational_point.h"
#include "extensions/contact/root.h"

namespace strata::contact {
namespace {

using Kind = MeshFeature::Kind;

MeshFeature vertex(std::uint32_t v) { return {Kind::vertex, {v, 0, 0}}; }
MeshFeature edge(std::uint32_t v, std::uint32_t w) { return {Kind::edge, {std::min(v, w), std::max(v, w), 0}}; }
MeshFeature face(InputComplex::Indices v) {
  std::sort(v.begin(), v.end());
  return {Kind::face, v};
}

/// The distance of the interior of one feature from that of another, by a function from vertices to positions.
template <class Real, class Place>
FeatureDistance<Real> distance_of(const MeshFeature& a, const MeshFeature& b, const Place& place) {
  const auto p = [&](std::size_t i) { return place(a.vertices[i]); };
  const auto q = [&](std::size_t i) { return place(b.vertices[i]); };
  if (a.kind == Kind::vertex) {
    if (b.kind == Kind::vertex) return vertex_vertex<Real>(p(0), q(0));
    return b.kind == Kind::edge ? vertex_edge<Real>(p(0), q(0), q(1)) : vertex_face<Real>(p(0), q(0), q(1), q(2));
  }
  if (a.kind == Kind::face) return vertex_face<Real>(q(0), p(0), p(1), p(2));
  return b.kind == Kind::vertex ? vertex_edge<Real>(q(0), p(0), p(1)) : edge_edge<Real>(p(0), p(1), q(0), q(1));
}

RationalPoint moved(const RationalPoint& p, const Rational& t, const RationalPoint& d) {
  RationalPoint r;
  for (std::size_t i = 0; i < 3; ++i) r[i] = p[i] + t * d[i];
  return r;
}

}  // namespace

std::size_t NearestCandidates::Hash::operator()(const Pair& p) const {
  std::uint64_t h = static_cast<std::uint64_t>(p.a.kind) * 3 + static_cast<std::uint64_t>(p.b.kind);
  for (const MeshFeature* f : {&p.a, &p.b})
    for (const std::uint32_t v : f->vertices) h = (h ^ v) * 0x9e3779b97f4a7c15u + (h >> 29);
  return h;
}

/// Coordinates of two faces times a power of two, such that the largest are about one: relevant products neither
/// overflow nor underflow.
class NearestCandidates::Scale {
 public:
  Scale(const InputComplex& input, const InputComplex::Indices& f, const InputComplex::Indices& g) : input_(input) {
    double most = 0;
    for (const InputComplex::Indices& face : {f, g})
      for (const std::uint32_t v : face)
        for (const double x : input.vertex(v)) most = std::max(most, std::abs(x));
    int exponent = 0;
    std::frexp(most, &exponent);
    factor_ = std::ldexp(1.0, std::clamp(-exponent, -1023, 1023));
  }
  [[nodiscard]] double factor() const { return factor_; }
  [[nodiscard]] BoundedPoint operator()(std::uint32_t v) const {
    BoundedPoint p = approximate_vertex(v);
    for (Bounded& x : p) {
      const double value = x.value * factor_;
      const double lost = value / factor_ == x.value ? 0 : Bounded::underflow;
      x = {value, x.error * factor_ * (1 + 0x1p-50) + (x.error > 0 ? Bounded::underflow : 0) + lost};
    }
    return p;
  }

 private:
  [[nodiscard]] BoundedPoint approximate_vertex(std::uint32_t v) const {
    const auto& p = input_.vertex(v);
    BoundedPoint r{p[0], p[1], p[2]};
    if (!input_.has_doubles(v))
      for (Bounded& x : r) x.error = std::abs(x.value) * Bounded::rounding + Bounded::underflow;
    return r;
  }
  const InputComplex& input_;
  double factor_ = 1;
};

void NearestCandidates::look_at(std::uint32_t f, std::uint32_t g) {
  const InputComplex::Indices vf = input_.face(f), vg = input_.face(g);
  const Scale scale(input_, vf, vg);
  if (are_apart_along_best(vf, vg, scale)) return;
  const auto try_pair = [&](const MeshFeature& a, const MeshFeature& b) {
    const Pair pair{a, b};
    if (may_be_best(pair, scale) && decided_.insert(pair).second) decide(pair);
  };
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      try_pair(vertex(vf[i]), vertex(vg[k]));
      try_pair(vertex(vf[i]), edge(vg[k], vg[(k + 1) % 3]));
      try_pair(edge(vf[i], vf[(i + 1) % 3]), vertex(vg[k]));
      try_pair(edge(vf[i], vf[(i + 1) % 3]), edge(vg[k], vg[(k + 1) % 3]));
    }
  for (std::size_t i = 0; i < 3; ++i) {
    try_pair(vertex(vf[i]), face(vg));
    try_pair(face(vf), vertex(vg[i]));
  }
}

/// True when, along the vector between the closest points so far, the faces are farther apart than these. Scaled
/// coordinates and components are at most 1, so 2^-48 exceeds all rounding errors; theory.md, section 7.
bool NearestCandidates::are_apart_along_best(const InputComplex::Indices& f, const InputComplex::Indices& g,
                                             const Scale& scale) const {
  if (!has_best_) return false;
  const auto along = [&](std::uint32_t v) {
    const auto& p = input_.vertex(v);
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) sum += direction_[i] * (p[i] * scale.factor());
    return sum;
  };
  const double end_of_f = std::max({along(f[0]), along(f[1]), along(f[2])});
  const double start_of_g = std::min({along(g[0]), along(g[1]), along(g[2])});
  const double length =
      std::sqrt(direction_[0] * direction_[0] + direction_[1] * direction_[1] + direction_[2] * direction_[2]);
  return start_of_g - end_of_f - 0x1p-48 > half_bound_ * scale.factor() * 2 * length * (1 + 0x1p-40);
}

/// By running errors: false when the closest points are certainly not inside the features, or certainly too far apart.
bool NearestCandidates::may_be_best(const Pair& pair, const Scale& scale) const {
  const auto d = distance_of<Bounded>(pair.a, pair.b, scale);
  for (int i = 0; i < d.conditions; ++i) {
    const auto sign = d.inside[static_cast<std::size_t>(i)].sign();
    if (sign && *sign != Sign::positive) return false;
  }
  const double bound = half_bound_ * scale.factor() * 2;
  const double most = bound * bound * (1 + 0x1p-40) + Bounded::underflow;
  return !((d.over / d.under).lower() > most);
}

void NearestCandidates::decide(const Pair& pair) {
  const auto place = [this](std::uint32_t v) { return position(v); };
  const auto d = distance_of<Rational>(pair.a, pair.b, place);
  for (int i = 0; i < d.conditions; ++i)
    if (d.inside[static_cast<std::size_t>(i)].sign() <= 0) return;
  const Rational squared = d.over / d.under;
  if (has_best_ && squared > best_.squared) return;
  const RationalPoint p = place(pair.a.vertices[0]), q = place(pair.b.vertices[0]);
  const auto foot_on = [&](const MeshFeature& feature, const RationalPoint& first, const RationalPoint& x) {
    if (feature.kind == Kind::edge)
      return moved(first, d.inside[0] / d.under, RationalPoint(place(feature.vertices[1]) - first));
    const RationalPoint n = cross<Rational>(place(feature.vertices[1]) - first, place(feature.vertices[2]) - first);
    return moved(x, -dot<Rational>(n, x - first) / d.under, n);
  };
  if (pair.a.kind == Kind::edge && pair.b.kind == Kind::edge)
    offer(pair, squared, moved(p, d.inside[0] / d.under, RationalPoint(place(pair.a.vertices[1]) - p)),
          moved(q, d.inside[2] / d.under, RationalPoint(place(pair.b.vertices[1]) - q)));
  else
    offer(pair, squared, pair.a.kind == Kind::vertex ? p : foot_on(pair.a, p, q),
          pair.b.kind == Kind::vertex ? q : foot_on(pair.b, q, p));
}

/// One pair of points never has two names of features, because a point is inside one feature only. Coincident vertices
/// do have several names; then the lower numbers are used.
void NearestCandidates::offer(const Pair& pair, const Rational& squared, const RationalPoint& on_a,
                              const RationalPoint& on_b) {
  if (has_best_ && squared == best_.squared &&
      std::tie(best_.on_a, best_.on_b, best_.feature_a, best_.feature_b) <= std::tie(on_a, on_b, pair.a, pair.b))
    return;
  const bool is_nearer = !has_best_ || squared < best_.squared;
  has_best_ = true;
  best_.on_a = on_a;
  best_.on_b = on_b;
  best_.feature_a = pair.a;
  best_.feature_b = pair.b;
  if (!is_nearer) return;
  best_.squared = squared;
  const RationalPoint way = on_b - on_a;
  const Rational longest = std::max({Rational(abs(way[0])), Rational(abs(way[1])), Rational(abs(way[2]))});
  for (std::size_t i = 0; i < 3; ++i) direction_[i] = to_nearest_double(way[i] / longest);
  half_bound_ = root(squared / 4) * (1 + 0x1p-50) + 0x1p-1073;
}

RationalPoint NearestCandidates::position(std::uint32_t vertex) const {
  if (const RationalPoint* p = input_.exact(vertex)) return *p;
  const auto& p = input_.vertex(vertex);
  return to_rational(p);
}

}  // namespace strata::contact
