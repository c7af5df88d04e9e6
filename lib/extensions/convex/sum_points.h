#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <unordered_map>
#include <utility>

#include "core/exact/two_sum.h"
#include "strata/mesh.h"

namespace strata::convex {

/// Sums of vertices of two operands, each pair computed once: doubles where these are exact, rationals elsewhere.
class SumPoints {
 public:
  SumPoints(const ExactMesh& a, const ExactMesh& b) : a_(a), b_(b) {}

  [[nodiscard]] std::uint32_t number(std::uint32_t a, std::uint32_t b) {
    const auto next = static_cast<std::uint32_t>(points_.mesh.vertices.size());
    const auto [at, is_new] = numbers_.emplace(std::uint64_t{a} << 32 | b, next);
    if (is_new) add(a, b, next);
    return at->second;
  }
  [[nodiscard]] ExactMesh& points() { return points_; }

 private:
  void add(std::uint32_t a, std::uint32_t b, std::uint32_t number) {
    const Vertex &p = a_.mesh.vertices[a], &q = b_.mesh.vertices[b];
    const bool are_doubles = !is_rational(a_, a) && !is_rational(b_, b);
    const Vertex sum = are_doubles ? add_doubles(p, q, number) : add_exactly(a_.position(a), b_.position(b), number);
    for (const double x : sum)
      if (!std::isfinite(x)) throw std::overflow_error("a sum of coordinates is beyond all doubles");
    points_.mesh.vertices.push_back(sum);
  }

  Vertex add_doubles(const Vertex& p, const Vertex& q, std::uint32_t number) {
    Vertex sum, rest;
    for (std::size_t i = 0; i < 3; ++i) {
      const WithRest s = two_sum(p[i], q[i]);
      sum[i] = s.value;
      rest[i] = s.rest;
    }
    const bool is_finite = std::isfinite(sum[0]) && std::isfinite(sum[1]) && std::isfinite(sum[2]);
    if (!is_finite || rest == Vertex{0, 0, 0}) return sum;
    ExactVertex& exact = points_.exact.emplace_back(ExactVertex{number, {}});
    for (std::size_t i = 0; i < 3; ++i) {
      exact.position[i] = to_rational(sum[i]);
      if (rest[i] != 0) exact.position[i] += to_rational(rest[i]);
    }
    return sum;
  }

  Vertex add_exactly(const RationalPoint& p, const RationalPoint& q, std::uint32_t number) {
    RationalPoint sum;
    Vertex nearest;
    bool is_double = true;
    for (std::size_t i = 0; i < 3; ++i) {
      sum[i] = p[i] + q[i];
      nearest[i] = to_nearest_double(sum[i]);
      is_double = is_double && std::isfinite(nearest[i]) && to_rational(nearest[i]) == sum[i];
    }
    if (!is_double) points_.exact.push_back({number, std::move(sum)});
    return nearest;
  }

  static bool is_rational(const ExactMesh& mesh, std::uint32_t vertex) {
    const auto at = std::lower_bound(mesh.exact.begin(), mesh.exact.end(), vertex,
                                     [](const ExactVertex& e, std::uint32_t v) { return e.vertex < v; });
    return at != mesh.exact.end() && at->vertex == vertex;
  }

  const ExactMesh& a_;
  const ExactMesh& b_;
  ExactMesh points_;
  std::unordered_map<std::uint64_t, std::uint32_t> numbers_;
};

}  // namespace strata::convex
