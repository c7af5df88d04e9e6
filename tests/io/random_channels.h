#pragma once
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "strata/io.h"

namespace strata::test {

/// Any number of the type but NaN: infinities, subnormals and both zeros as well.
template <class T>
T random_value(std::mt19937_64& random) {
  if constexpr (std::is_integral_v<T>) return static_cast<T>(random());
  if constexpr (std::is_floating_point_v<T>) {
    using Bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
    const auto x = std::bit_cast<T>(static_cast<Bits>(random()));
    if (random() % 8 == 0) return random() % 2 == 0 ? std::numeric_limits<T>::infinity() : T{-0.0};
    return std::isnan(x) ? T{1} : x;
  }
}

template <class T>
Channel random_channel(std::mt19937_64& random, const Mesh& mesh, std::string name, Element element, Interpolation how,
                       std::uint32_t components) {
  const std::size_t elements = element == Element::vertex   ? mesh.vertices.size()
                               : element == Element::corner ? 3 * mesh.triangles.size()
                                                            : mesh.triangles.size();
  std::vector<T> values(elements * components);
  for (T& x : values) x = random_value<T>(random);
  return {std::move(name), element, how, components, std::move(values)};
}

/// A channel of any kind that check_attributes allows.
inline Channel random_channel(std::mt19937_64& random, const Mesh& mesh, std::string name) {
  const auto element = static_cast<Element>(random() % 3);
  const auto components = static_cast<std::uint32_t>(1 + random() % 4);
  const auto how = static_cast<Interpolation>(random() % 3);
  switch (random() % 4) {
    case 0:
      return random_channel<float>(random, mesh, std::move(name), element, how, components);
    case 1:
      return random_channel<double>(random, mesh, std::move(name), element, how, components);
    case 2:
      return random_channel<std::uint8_t>(random, mesh, std::move(name), element,
                                          how == Interpolation::spherical ? Interpolation::linear : how, components);
    default:
      return random_channel<std::int32_t>(random, mesh, std::move(name), element, Interpolation::nearest, components);
  }
}

/// Triangles over some points.
inline Mesh random_soup(std::mt19937_64& random, std::size_t vertices, std::size_t triangles) {
  Mesh mesh;
  for (std::size_t i = 0; i < vertices; ++i)
    mesh.vertices.push_back({static_cast<double>(random() % 100) / 8, static_cast<double>(i), 0.0});
  for (std::size_t i = 0; i < triangles; ++i) {
    const auto v = static_cast<std::uint32_t>(random() % (vertices - 2));
    mesh.triangles.push_back({v, v + 1, v + 2});
  }
  return mesh;
}

}  // namespace strata::test
