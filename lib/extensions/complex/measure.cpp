#include <cmath>
#include <stdexcept>

#include "extensions/complex/face_geometry.h"
#include "strata/complex.h"

namespace strata::complex {
namespace {

using Index = std::uint32_t;

/// Six times the volume between a face and the origin, positive where the origin is below.
Rational volume_to_origin(const Cells& cells, std::span<const Wing> wings) {
  const RationalPoint area = area_vector(cells, wings);
  const RationalPoint p = cells.position(cells.edges[wings.front().edge][0]);
  return area[0] * p[0] + area[1] * p[1] + area[2] * p[2];
}

/// Correct to a few units in the last place, even where the square is beyond all doubles.
double square_root(const Rational& square) {
  if (square == 0) return 0;
  const long size =
      static_cast<long>(bit_length(numerator(square))) - static_cast<long>(bit_length(denominator(square)));
  const long half = size / 2;
  Rational scaled = square;
  if (half > 0) scaled /= Rational(Integer(1) << static_cast<std::size_t>(2 * half));
  if (half < 0) scaled *= Rational(Integer(1) << static_cast<std::size_t>(-2 * half));
  return std::ldexp(std::sqrt(to_nearest_double(scaled)), static_cast<int>(half));
}

/// Volumes; that of the unbounded cell is minus the sum of all others.
std::vector<Rational> volumes(const Cells& cells) {
  std::vector<Rational> result(cells.count(3), 0);
  const WingsOfFaces wings(cells);
  for (Index f = 0; f < cells.sides.size(); ++f) {
    const auto [above, below] = cells.sides[f];
    if (above == below) continue;
    const Rational part = volume_to_origin(cells, wings[f]) / 6;
    result[below] += part;
    result[above] -= part;
  }
  return result;
}

}  // namespace

std::optional<Rational> volume_of_cell(const SelectiveComplex& s, Index volume) {
  if (s.dimension() != 3) throw std::invalid_argument("a complex of the plane has no volumes");
  if (volume == 0) return std::nullopt;
  return volumes(s.cells()).at(volume);
}

std::optional<Rational> volume(const SelectiveComplex& s) {
  if (s.dimension() == 2) return Rational(0);
  if (!s.is_bounded()) return std::nullopt;
  Rational sum = 0;
  const std::vector<Rational> all = volumes(s.cells());
  for (Index v = 0; v < all.size(); ++v)
    if (s.mark({3, v})) sum += all[v];
  return sum;
}

std::optional<double> area(const SelectiveComplex& s) {
  if (s.dimension() == 2) {
    const auto exact = exact_area(s);
    return exact ? std::optional(to_nearest_double(*exact)) : std::nullopt;
  }
  double sum = 0;
  const WingsOfFaces wings(s.cells());
  for (Index f = 0; f < s.count(2); ++f) {
    if (!s.mark({2, f})) continue;
    const RationalPoint twice = area_vector(s.cells(), wings[f]);
    sum += square_root(twice[0] * twice[0] + twice[1] * twice[1] + twice[2] * twice[2]) / 2;
  }
  return sum;
}

std::optional<Rational> exact_area(const SelectiveComplex& s) {
  if (s.dimension() != 2) throw std::invalid_argument("areas in space are not rational");
  if (!s.is_bounded()) return std::nullopt;
  Rational sum = 0;
  const WingsOfFaces wings(s.cells());
  for (Index f = 1; f < s.count(2); ++f)
    if (s.mark({2, f})) sum += area_vector(s.cells(), wings[f])[2] / 2;
  return sum;
}

double length(const SelectiveComplex& s) {
  double sum = 0;
  for (Index e = 0; e < s.count(1); ++e)
    if (s.mark({1, e})) sum += square_root(squared_length_of_cell(s, e));
  return sum;
}

Rational squared_length_of_cell(const SelectiveComplex& s, Index edge) {
  const auto [low, high] = s.cells().edges.at(edge);
  const RationalPoint p = s.cells().position(low), q = s.cells().position(high);
  Rational sum = 0;
  for (std::size_t i = 0; i < 3; ++i) sum += (q[i] - p[i]) * (q[i] - p[i]);
  return sum;
}

}  // namespace strata::complex
