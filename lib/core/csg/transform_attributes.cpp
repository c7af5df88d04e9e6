#include <algorithm>
#include <array>
#include <type_traits>
#include <utility>

#include "core/attributes/interpolate.h"
#include "strata/carry_attributes.h"

namespace strata {
namespace {

/// The inverse transpose of a map, times its determinant or minus that: a positive multiple, so that directions stay
/// outward.
std::array<std::array<Rational, 3>, 3> map_of_normals(const Transform& map) {
  const auto& rows = map.rows();
  const bool is_mirror = map.determinant() < 0;
  std::array<std::array<Rational, 3>, 3> cofactors;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t a = (i + 1) % 3, b = (i + 2) % 3, c = (j + 1) % 3, d = (j + 2) % 3;
      cofactors[i][j] = rows[a][c] * rows[b][d] - rows[a][d] * rows[b][c];
      if (is_mirror) cofactors[i][j] = -cofactors[i][j];
    }
  return cofactors;
}

/// Exact, and rounded once. What is not finite or 0 stays.
template <class T>
void map_direction(const std::array<std::array<Rational, 3>, 3>& map, T* n) {
  if (!std::all_of(n, n + 3, [](T x) { return std::isfinite(x); })) return;
  std::array<Rational, 3> image;
  Rational square = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) image[i] += map[i][j] * Rational(static_cast<double>(n[j]));
    square += image[i] * image[i];
  }
  if (square == 0) return;
  for (std::size_t i = 0; i < 3; ++i) n[i] = quotient_by_root<T>(image[i], square);
}

void map_directions(const std::array<std::array<Rational, 3>, 3>& map, Channel& channel) {
  std::visit(
      [&]<class T>(std::vector<T>& values) {
        if constexpr (std::is_floating_point_v<T>)
          for (std::size_t i = 0; i + 3 <= values.size(); i += 3) map_direction(map, &values[i]);
      },
      channel.values);
}

/// The second and the third corner of every triangle are exchanged.
void turn_round(Channel& channel) {
  std::visit(
      [&](auto& values) {
        const std::size_t n = channel.components;
        for (auto t = values.begin(); t != values.end(); t += static_cast<std::ptrdiff_t>(3 * n))
          std::swap_ranges(t + static_cast<std::ptrdiff_t>(n), t + static_cast<std::ptrdiff_t>(2 * n),
                           t + static_cast<std::ptrdiff_t>(2 * n));
      },
      channel.values);
}

bool keeps_directions(const Transform& map) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if (map.rows()[i][j] != (i == j ? map.rows()[0][0] : Rational(0))) return false;
  return map.rows()[0][0] > 0;
}

}  // namespace

Attributes transform(const Attributes& attributes, const Transform& map) {
  Attributes image = attributes;
  const bool is_mirror = map.determinant() < 0, keeps = keeps_directions(map);
  const auto normals = map_of_normals(map);
  for (Channel& channel : image.channels) {
    if (!keeps && channel.interpolation == Interpolation::spherical && channel.components == 3)
      map_directions(normals, channel);
    if (is_mirror && channel.element == Element::corner) turn_round(channel);
  }
  return image;
}

}  // namespace strata
