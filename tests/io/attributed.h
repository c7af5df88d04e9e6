#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "strata/io.h"

namespace strata::test {

inline std::vector<std::byte> bytes_of(std::string_view text) {
  const auto* data = reinterpret_cast<const std::byte*>(text.data());
  return {data, data + text.size()};
}

/// Two tetrahedra apart, each an object. The first one has a plain material and a colour at each vertex, the second one
/// a texture that has a seam.
inline MeshFile two_objects() {
  MeshFile file;
  file.mesh = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {3, 0, 0}, {4, 0, 0}, {3, 1, 0}, {3, 0, 1}},
               {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {4, 6, 5}, {4, 5, 7}, {5, 6, 7}, {6, 4, 7}}};
  file.unit = Unit::inch;
  Attributes& a = file.attributes;
  a.objects = {"left", "right <&>"};
  a.images = {{"wood.png", "image/png", bytes_of("\x89PNG, or so")}};
  Material plain, wood;
  plain.name = "red \"brick\"";
  plain.color = {1, 0, 0, 1};
  wood.image = 0;
  a.materials = {plain, wood};
  const std::vector<std::int32_t> sides{0, 0, 0, 0, 1, 1, 1, 1};
  a.channels.push_back({"material", Element::face, Interpolation::nearest, 1, sides});
  std::vector<std::uint8_t> colors;
  for (std::uint8_t i = 0; i < 32; ++i) colors.push_back(i < 16 ? static_cast<std::uint8_t>(10 * i) : 255);
  a.channels.push_back({"color", Element::vertex, Interpolation::linear, 4, colors});
  std::vector<double> texcoords(48);
  for (std::size_t i = 24; i < 48; ++i) texcoords[i] = static_cast<double>(i - 24) / 32;
  a.channels.push_back({"texcoord", Element::corner, Interpolation::linear, 2, texcoords});
  a.channels.push_back({"object", Element::face, Interpolation::nearest, 1, sides});
  return file;
}

inline std::string written(const MeshFile& file, Format format) {
  WriteOptions options;
  options.format = format;
  options.attributes = &file.attributes;
  options.unit = file.unit;
  return to_string(ExactMesh{file.mesh, {}}, options);
}

/// A channel's value at a corner of a triangle, component k.
inline double value_at(const MeshFile& file, std::string_view channel, std::size_t face, std::size_t corner,
                       std::size_t k) {
  const Channel& c = *file.attributes.find(channel);
  const std::size_t element = c.element == Element::vertex   ? file.mesh.triangles[face][corner]
                              : c.element == Element::corner ? 3 * face + corner
                                                             : face;
  return std::visit([&](const auto& v) { return static_cast<double>(v[element * c.components + k]); }, c.values);
}

}  // namespace strata::test
