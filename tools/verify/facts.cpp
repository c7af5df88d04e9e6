#include "verify/facts.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "common/sha256.h"
#include "strata/measure.h"
#include "strata/transform.h"

namespace verify {
namespace {

using strata::Integer;
using strata::Rational;
using strata::RationalPoint;

/// 2^exponent.
Rational power_of_two(int exponent) {
  const Integer power = Integer(1) << std::abs(exponent);
  return exponent >= 0 ? Rational(power) : Rational(Integer(1), power);
}

/// The exponent of the largest coordinate where doubles could not hold areas; else 0.
int awkward_exponent(const strata::ExactMesh& mesh) {
  double largest = 0;
  for (const strata::Vertex& v : mesh.mesh.vertices)
    for (const double x : v) largest = std::max(largest, std::abs(x));
  const int exponent = largest > 0 ? std::ilogb(largest) : 0;
  return std::abs(exponent) > 100 ? exponent : 0;
}

double length(const RationalPoint& a, const RationalPoint& b, const Rational& scale) {
  double d[3];
  for (std::size_t i = 0; i < 3; ++i) d[i] = strata::to_nearest_double(Rational((b[i] - a[i]) * scale));
  return std::hypot(d[0], d[1], d[2]);
}

int exponent_of(const strata::CanonicalForm& form) {
  Rational largest = 0;
  for (const RationalPoint& p : form.vertices)
    for (const Rational& x : p) largest = std::max(largest, Rational(abs(x)));
  if (largest == 0) return 0;
  return static_cast<int>(bit_length(numerator(largest))) - static_cast<int>(bit_length(denominator(largest)));
}

Rational edge_length(const strata::CanonicalForm& form) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const strata::CanonicalFacets& facets : form.planes)
    for (const auto& loop : facets.loops)
      for (std::size_t i = 0; i < loop.size(); ++i)
        edges.insert(std::minmax(loop[i], loop[i + 1 == loop.size() ? 0 : i + 1]));
  const int exponent = exponent_of(form);
  const Rational scale = power_of_two(-exponent);
  double sum = 0;
  for (const auto& [a, b] : edges) sum += length(form.vertices[a], form.vertices[b], scale);
  return strata::to_rational(sum) * power_of_two(exponent);
}

}  // namespace

FormFacts facts_of(const strata::CanonicalForm& form) {
  return {form.vertices.size(), form.edge_count(), form.facet_count(), form.hash(), edge_length(form)};
}

Rational area_of(const strata::ExactMesh& mesh) {
  const int exponent = awkward_exponent(mesh);
  if (exponent == 0) return strata::to_rational(strata::area(mesh));
  const Rational scale = power_of_two(-exponent);
  const auto map = strata::Transform::scaling({scale, scale, scale});
  const double scaled = strata::area(strata::transform(mesh, map, strata::Placement::exact));
  return strata::to_rational(scaled) * power_of_two(2 * exponent);
}

Facts facts_of(const strata::ExactMesh& mesh) {
  const strata::Topology topology = strata::topology(mesh);
  return {strata::volume(mesh), area_of(mesh),  facts_of(strata::canonical_form(mesh)),
          topology.components,  topology.euler, non_manifold(mesh)};
}

std::string volume_text(const Rational& volume) {
  constexpr std::size_t longest = 1000;
  std::string text = volume.str();
  return text.size() <= longest ? text : "sha256:" + sha256(text);
}

}  // namespace verify
